#!/usr/bin/env bash
# Derivative columns of scripts/sweep, against differences between the rows of the same sweep.   sweep_sensitivity.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
sweep=$here/../../scripts/sweep
needs parallel parallel

# difference COLUMN STEP FILE: central difference of the first and the third row;   middle COLUMN FILE: the value of the second row
difference() { column "$1" "$3" | awk -v h="$2" 'NR == 1 { a = $1 } NR == 3 { printf "%.12g", ($1 - a) / h }'; }
middle() { column "$1" "$2" | sed -n 2p; }
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { print a / b }'; }
compare() {   # compare DERIVATIVE COLUMN STEP FILE TOLERANCE
    local r
    r=$(ratio "$(middle "$1" "$4")" "$(difference "$2" "$3" "$4")")
    claim "$1 is the difference of two designs: $r" within "$r" "$(awk -v t="$5" 'BEGIN { print 1 - t }')" "$(awk -v t="$5" 'BEGIN { print 1 + t }')"
}

cat >walls.yaml <<'YAML'
design: designs/bellows.yaml
vary: {geometry.wall: [2.997 mm, 3 mm, 3.003 mm]}
set: {mesh.size: 3 mm, path.until.elongation: 60 mm}
at: [elongation=40mm, pressure=3kPa, end]
outputs: [pressure_kPa, elongation_mm]
sensitivity: [geometry.wall, material.mu]
YAML
runs "$sweep walls.yaml"
table=results/sweeps/walls/results.csv
claim "the columns have their units" [ "$(head -n 1 $table | cut -d, -f9-)" = \
    "pressure_by_geometry_wall_kPa_per_mm_at_elongation_40mm,pressure_by_material_mu_kPa_per_MPa_at_elongation_40mm,$(
    )elongation_by_geometry_wall_mm_per_mm_at_3kPa,elongation_by_material_mu_mm_per_MPa_at_3kPa,$(
    )pressure_by_geometry_wall_kPa_per_mm_at_end,pressure_by_material_mu_kPa_per_MPa_at_end,$(
    )elongation_by_geometry_wall_mm_per_mm_at_end,elongation_by_material_mu_mm_per_MPa_at_end,stop_reason,exit_code,error" ]
compare pressure_by_geometry_wall_kPa_per_mm_at_elongation_40mm pressure_kPa_at_elongation_40mm 0.006 $table 2e-3   # between rows
compare elongation_by_geometry_wall_mm_per_mm_at_3kPa elongation_mm_at_3kPa 0.006 $table 2e-3
compare pressure_by_geometry_wall_kPa_per_mm_at_end pressure_kPa_at_end 0.006 $table 1e-4
claim "the goal of the path is held" within "$(middle elongation_by_geometry_wall_mm_per_mm_at_end $table)" 0 0
id=$(sed -n '2s/,.*//p' $table)
claim "the design names them" grep -q '^# sensitivity: geometry.wall,material.mu$' "results/sweeps/walls/$id/design.yaml"
runs "mesh-gen -q results/sweeps/walls/$id/design.yaml --sensitivity geometry.wall | solve -q | postprocess -q --sensitivity -o own.csv"
claim "they are those of postprocess" within "$(ratio "$(column d_load own.csv | tail -n 1)" "$(column pressure_by_geometry_wall_kPa_per_mm_at_end $table | head -n 1)")" 0.999999 1.000001
runs "$sweep walls.yaml"
claim "nothing is computed again" grep -q ' 3 designs, 0 to compute ' "$seen/err"

# A wall is pushed against a bellows that is held at a pressure.
cat >pushed.yaml <<'YAML'
design: designs/bellows-at-wall.yaml
vary: {geometry.wall: [2.997 mm, 3 mm, 3.003 mm]}
set: {mesh.quality: draft, 'loads': '{cavity: {pressure: 5 kPa}, wall: {displacement: 4 mm, along: x}}',
      'path.stages': '{fill: {loads: {cavity: {pressure: 5 kPa}}}, push: {loads: {wall: {displacement: 4 mm}}}}'}
at: [end]
outputs: [push_N, elongation_mm]
sensitivity: [geometry.wall]
YAML
runs "$sweep pushed.yaml"
table=results/sweeps/pushed/results.csv
compare push_by_geometry_wall_N_per_mm_at_end push_N_at_end 0.006 $table 5e-3

# Limit pressures, which are proportional to mu.
cat >tubes.yaml <<'YAML'
design: designs/tube.yaml
vary: {material.mu: [100 kPa, 101 kPa, 102 kPa]}
set: {mesh.quality: draft, loads.cavity.pressure: 500 kPa, path.until.volume_ratio: 4}
at: [limit, end]
outputs: [pressure_kPa]
sensitivity: all
YAML
runs "$sweep tubes.yaml"
table=results/sweeps/tubes/results.csv
compare pressure_by_material_mu_kPa_per_kPa_at_limit pressure_kPa_at_limit 2 $table 1e-4
claim "only the load has derivatives there" [ -z "$(head -n 1 $table | tr , '\n' | grep '^elongation_by')" ]
claim "a path that ends at a volume has none" [ -z "$(middle pressure_by_material_mu_kPa_per_kPa_at_end $table)" ]
claim "the row has the reason" grep -q ',done,0,sensitivity at end: the path did not end at a load or an output$' $table

# Keys and points without derivatives, each reported with its location before anything is computed
faulty() {   # faulty PATTERN TEXT
    printf 'design: designs/%b' "$2" >bad.yaml
    refuses 65 "sweep: bad.yaml:$1" "$sweep bad.yaml"
    claim "nothing is written" [ ! -e results/sweeps/bad ]
}
faulty "3:14: sensitivity: 'geometry.wal' is not a number of the design that differs from 0; did you mean 'geometry.wall'[?]" \
    'bellows.yaml\nvary: {geometry.wall: [3 mm]}\nsensitivity: geometry.wal\n'
faulty "3:14: sensitivity: the list is empty; *" 'bellows.yaml\nvary: {geometry.wall: [3 mm]}\nsensitivity: []\n'
faulty "4:5: at: there are no sensitivities at a fixed volume; *" \
    'bellows.yaml\nvary: {geometry.wall: [3 mm]}\nsensitivity: geometry.wall\nat: volume=20mL\n'
faulty "3:14: sensitivity: none of the outputs has derivatives; *" \
    'bellows.yaml\nvary: {geometry.wall: [3 mm]}\nsensitivity: geometry.wall\noutputs: volume_mL\n'
