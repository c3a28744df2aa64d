#!/usr/bin/env bash
# Sensitivities pass through the pipeline: against runs with other values and closed forms, tolerances, resume, ranks, refusals.
#   sensitivities.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# cell NAME PARAMETER FILE: of the last line of a parameter
cell() { { head -n 1 "$3"; grep ",$2," "$3" | tail -n 1; } >one.csv && column "$1" one.csv; }
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { print a / b }'; }
# slope COLUMN KEY VALUE UNIT COMMAND: central difference of the last row of two runs with the value 0.1 % smaller and larger
slope() {
    local up down
    up=$(awk -v v="$3" 'BEGIN { printf "%.15g", v * 1.001 }')
    down=$(awk -v v="$3" 'BEGIN { printf "%.15g", v * 0.999 }')
    run "$5 --set $2=$up$4 | solve -q | postprocess -q -o up.csv; $5 --set $2=$down$4 | solve -q | postprocess -q -o down.csv"
    awk -v a="$(column "$1" up.csv | tail -n 1)" -v b="$(column "$1" down.csv | tail -n 1)" -v h="$(awk -v v="$3" 'BEGIN { print v * 0.002 }')" \
        'BEGIN { printf "%.12g", (a - b) / h }'
}
compare() {   # compare CELL COLUMN KEY VALUE UNIT COMMAND TOLERANCE
    local r
    r=$(ratio "$(cell "$1" "$3" table.csv)" "$(slope "$2" "$3" "$4" "$5" "$6")")
    claim "$1 by $3 is the difference of two runs: $r" within "$r" "$(awk -v t="$7" 'BEGIN { print 1 - t }')" "$(awk -v t="$7" 'BEGIN { print 1 + t }')"
}

# A fixed displacement: the load changes.
bellows='mesh-gen -q designs/bellows.yaml --set mesh.size=3mm --set path.until.elongation=40mm'
runs "$bellows -o plain.h5 && solve -q plain.h5 | postprocess -q -o plain.csv"
runs "$bellows --sensitivity geometry.wall,material.mu -o case.h5 && solve -q case.h5 -o k.h5 && postprocess -q k.h5 -o curve.csv"
claim "the end of the curve is unchanged" within "$(ratio "$(column pressure_kPa curve.csv | tail -n 1)" "$(column pressure_kPa plain.csv | tail -n 1)")" 0.99999999 1.00000001
runs 'solve -q plain.h5 -o plain-result.h5 && postprocess -q plain-result.h5 --at elongation=5mm,10mm,20mm,30mm -o plain-at.csv && postprocess -q k.h5 --at elongation=5mm,10mm,20mm,30mm -o at.csv'
claim "... and so is it between its rows, which may lie elsewhere" awk -v a="$(column pressure_kPa plain-at.csv | tr '\n' ' ')" -v b="$(column pressure_kPa at.csv | tr '\n' ' ')" \
    'BEGIN { n = split(a, x, " "); split(b, y, " "); for (i = 1; i <= n; ++i) if (!((x[i] / y[i] - 1) ^ 2 < 1e-3 ^ 2)) exit 1; exit n != 4 }'
cp k.h5 whole.h5
runs 'postprocess -q k.h5 --sensitivity -o table.csv'
claim "each row has a line for each number" [ "$(wc -l <table.csv)" = $((2 * $(wc -l <curve.csv) - 1)) ]
compare d_load pressure_kPa geometry.wall 3 mm "$bellows" 2e-4
compare d_load pressure_kPa material.mu 0.1644 MPa "$bellows" 1e-4
runs 'postprocess -q k.h5 --tolerances geometry.wall=0.1mm,material.mu=5% -o band.csv --plot band.svg'
claim "the band of the worst case is the sum" within "$(ratio "$(column band_worst_pressure_kPa band.csv | tail -n 1)" \
    "$(awk -v a="$(cell d_load geometry.wall table.csv)" -v b="$(cell d_load material.mu table.csv)" 'BEGIN { print 0.1 * a + 0.05 * 0.1644 * b }')")" 0.999999 1.000001
claim "the plot shows the band" grep -q 'uncertainty of the constants\|<path' band.svg

# A run that the limit of the file size stops after some rows, before which the file is larger than at the end; two ranks.
run "(ulimit -f $(($(stat -c %s whole.h5) / 1024 + 100)); exec solve -q case.h5 -o k.h5)"
claim "the run is stopped" exits 74
runs 'solve -q --resume k.h5 && cmp k.h5 whole.h5'
runs 'mpirun -n 2 solve -q case.h5 -o two.h5 && postprocess -q two.h5 --sensitivity -o two.csv'
claim "two ranks give the same derivatives" near <(cut -d, -f2,3,5,7-8 table.csv | grep -v ',,\|,$') <(cut -d, -f2,3,5,7-8 two.csv | grep -v ',,\|,$') 1e-6

# The force on an obstacle, which contact far stiffer than the rubber gives; an obstacle that moves at a constant pressure.
bellows='mesh-gen -q designs/bellows-at-wall.yaml --set mesh.quality=draft --set geometry.wall=2.41mm'
push='--set "outputs={push: {obstacle: wall, measure: force, along: x}}"'
moved() {   # moved LENGTH: inflated, then the wall moves
    echo "--set 'loads={cavity: {pressure: 5 kPa}, wall: {displacement: $1, along: x}}'" \
        "--set 'path.stages={inflate: {loads: {cavity: {pressure: 5 kPa}}}, move: {loads: {wall: {displacement: $1}}}}'"
}
runs "$bellows $push --sensitivity geometry.pitch,material.mu | solve -q | postprocess -q --sensitivity -o table.csv"
compare d_output push_N geometry.pitch 8 mm "$bellows $push" 2e-3
compare d_output push_N material.mu 0.1644 MPa "$bellows $push" 2e-3
pressed="$bellows $push $(moved '5 mm')"
runs "$pressed --sensitivity geometry.pitch,material.mu | solve -q -o k.h5 && postprocess -q k.h5 --sensitivity -o table.csv"
compare d_output push_N geometry.pitch 8 mm "$pressed" 5e-3
compare d_output push_N material.mu 0.1644 MPa "$pressed" 5e-3
claim "... and the constant pressure does not change" [ "$(cell d_load material.mu table.csv)" = 0 ]
runs 'postprocess -q k.h5 --sensitivity --at push=-0.614N -o between.csv'
claim "... nor between the stages" [ "$(cell d_load material.mu between.csv)" = 0 ]
runs 'postprocess -q k.h5 --tolerances material.mu=10% -o band.csv'
claim "... and the band is that of the output" within "$(ratio "$(column band_rss_push_N band.csv | tail -n 1)" "$(cell d_output material.mu table.csv)")" 0.01643 0.01645
withdrawn="$bellows $(moved '-10 mm')"
runs "$withdrawn --sensitivity material.mu | solve -q -o k.h5 && postprocess -q k.h5 --sensitivity -o table.csv && postprocess -q k.h5 --tolerances material.mu=10% -o band.csv"
compare d_output elongation_mm material.mu 0.1644 MPa "$withdrawn" 1e-3
claim "the band has numbers in all rows, also where the wall has left" not grep -qE "nan|inf|,," band.csv
# Nothing moves before an obstacle arrives.
rod_and_post
runs 'mesh-gen -q pressed.yaml --sensitivity material.mu | solve -q | postprocess -q --sensitivity -o table.csv'
claim "the derivative is 0 before an obstacle arrives" [ "$(sed -n 2p table.csv | cut -d, -f8)" = 0 ]
claim "the force at a given motion of the post is proportional to the modulus" within "$(ratio "$(cell d_output_percent material.mu table.csv)" 1)" 0.999 1.001

# A fixed load, in contact; several outputs; a follower pressure.
vacuum='mesh-gen -q designs/vacuum.yaml --set loads.cavity.pressure=-5kPa'
runs "$vacuum --sensitivity geometry.pitch,material.mu | solve -q | postprocess -q --sensitivity -o table.csv"
claim "the actuator touches itself" [ "$(wc -l <table.csv)" -gt 10 ]
compare d_output elongation_mm geometry.pitch "$(cell value geometry.pitch table.csv)" mm "$vacuum" 5e-4
compare d_output elongation_mm material.mu "$(cell value material.mu table.csv)" "$(cell unit material.mu table.csv)" "$vacuum" 5e-4

# Next to a bifurcation, of a rod under dead tension of its ends: p = mu (l^2 - 1/l), which does not depend on the width.
runs "mesh-gen -q designs/rod.yaml --set mesh.size=10mm --set 'material={law: neo-hookean, mu: 0.15 MPa, kappa: incompressible}' --sensitivity geometry.width,material.mu | solve -q --json solve.json -o rod.h5"
claim "there is a bifurcation" [ -n "$(json solve.json bifurcations 0 step)" ]
runs 'postprocess -q rod.h5 --at elongation=35mm,38mm,42mm -o rod.csv'
column pressure_kPa rod.csv >found
for exact in -162.2642 -176.9644 -196.8257; do
    read -r pressure; claim "beside it the curve is exact" within "$(ratio "$pressure" "$exact")" 0.9999 1.0001
done <found
runs "mesh-gen -q designs/rod.yaml --set mesh.size=10mm --set path.until.elongation=35mm --set 'material={law: neo-hookean, mu: 0.15 MPa, kappa: incompressible}' --sensitivity geometry.length,material.mu | solve -q | postprocess -q --sensitivity -o table.csv"
claim "d ln p / d ln mu = 1" within "$(cell d_load_percent material.mu table.csv)" 0.99999 1.00001
claim "dp/dL = -mu (2 l + 1 / l^2) u / L^2" within "$(ratio "$(cell d_load geometry.length table.csv)" 1.7055658)" 0.99999 1.00001
claim "without load there is no derivative" [ "$(postprocess -q rod.h5 --sensitivity | awk -F, '$1 == 0 && $4 == "material.mu" { print $7 }')" = 0 ]
runs 'postprocess -q rod.h5 --tolerances geometry.width=0.5mm --at elongation=39mm -o rod.csv'
claim "and the width has no influence there" within "$(column band_rss_pressure_kPa rod.csv)" 0 1e-3

# Displacements alone with a large bulk modulus, whose parts of the derivative nearly cancel.
stiff="mesh-gen -q designs/tube.yaml --set mesh.quality=draft --set mesh.formulation=displacement --set 'material={law: neo-hookean-compressible, mu: 0.1 MPa, kappa: 10 MPa}' --set loads.cavity.pressure=10kPa --set path.control=pressure --set path.until={}"
runs "$stiff --sensitivity geometry.outer_radius | solve -q | postprocess -q --sensitivity -o table.csv"
compare d_output elongation_mm geometry.outer_radius 10 mm "$stiff" 1e-4

# Thin sphere: the limit pressure is proportional to mu t / R (thin shell: 0.62 mu t / R x 2), so to mu, and to (b - a) / a.
shell="mesh-gen -q designs/sphere.yaml --set geometry.inner_radius=100mm --set geometry.outer_radius=101mm --set 'outputs={growth: {face: outer, along: r}}' --set path.until.volume_ratio=4"
runs "$shell --sensitivity all | solve -q --json solve.json | postprocess -q --sensitivity -o table.csv"
row=$(json solve.json limit_points 0 step)
grep "^step\|^$row," table.csv >limit.csv
claim "d ln p / d ln mu = 1" within "$(cell d_load_percent material.mu limit.csv)" 0.9999 1.0001
claim "d ln p / d ln b = b / t" within "$(ratio "$(cell d_load_percent geometry.outer_radius limit.csv)" 101)" 0.98 1.02
claim "d ln p / d ln a = -b / t" within "$(ratio "$(cell d_load_percent geometry.inner_radius limit.csv)" -101)" 0.98 1.02
claim "a limit point has no derivative of the output" [ -z "$(cell d_output material.mu limit.csv)" ]

# Before a membrane touches the wall no load gives another force on it, its first output; at a row and between rows.
runs 'mesh-gen -q designs/membrane-at-wall.yaml --set mesh.size=1mm --sensitivity material.mu | solve -q -o wall.h5 && postprocess -q --sensitivity wall.h5 -o rows.csv'
runs 'postprocess -q --sensitivity --at pressure=1kPa wall.h5 -o between.csv && postprocess -q --sensitivity --at pressure=5kPa wall.h5 -o touching.csv'
grep '^step\|^1,' rows.csv >free.csv
for table in free between; do
    claim "$table: no derivative of the load" [ -z "$(cell d_load material.mu $table.csv)" ]
    claim "$table: no change of the force" [ "$(cell d_output material.mu $table.csv)" = 0 ]
done
claim "in contact both exist" awk "BEGIN { exit !($(cell d_load material.mu touching.csv) > 0 && $(cell d_output material.mu touching.csv) < 0) }"

refuses 64 'mesh-gen: --sensitivity geometry.wal: not a number of the design that differs from 0; did you mean*' \
    'mesh-gen -q designs/bellows.yaml --sensitivity geometry.wal -o x.h5'
refuses 65 'mesh-gen: --sensitivity: paths with friction have no sensitivities; *' \
    'mesh-gen -q designs/bellows.yaml --set contact.friction=0.3 --sensitivity all -o x.h5'
refuses 64 'solve: --tolerance: error bars are not available with sensitivities; *' 'solve -q case.h5 --tolerance 1% -o x.h5'
refuses 64 'solve: --set: changes material.mu, by which the case has sensitivities; *' 'solve -q case.h5 --set material.mu=1MPa -o x.h5'
refuses 65 'solve: --sensitivity: paths with friction have no sensitivities; *' 'solve -q case.h5 --set contact.friction=0.3 -o x.h5'
refuses 65 'solve: --sensitivity: a motion in time has no sensitivities; *' \
    'solve -q case.h5 --set material.density=1080kg/m^3 --set path={} --set dynamics.duration=1ms -o x.h5'
refuses 64 'postprocess: --sensitivity: the result has no sensitivities; *' 'solve -q plain.h5 | postprocess -q --sensitivity'
refuses 64 'postprocess: --tolerances geometry.neck=1mm: the result has no sensitivity to this number*' 'postprocess -q whole.h5 --tolerances geometry.neck=1mm'
