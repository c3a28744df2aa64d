#!/usr/bin/env bash
# shellcheck disable=SC2016  # awk expands its own variables
# Derivatives of paths in time and of inelastic rubber against differences of whole runs; constants found from curves and tests in time.
#   inelastic_fits.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"

cat >pressure.yaml <<'END'
family: tube
geometry: {inner_radius: 7 mm, outer_radius: 10 mm, length: 60 mm}
material:
  law: neo-hookean
  mu: 100 kPa
  kappa: incompressible
  viscoelastic: {moduli: [0.3, 0.2], times: [0.5 s, 10 s]}
  softening: {r: 3, m: 5 kPa, beta: 0.1}
mesh: {size: 5 mm}
loads: {cavity: {pressure: 15 kPa}}
path:
  stages:
    inflate: {time: 0.5 s, loads: {cavity: {pressure: 15 kPa}}}
    hold:    {time: 5 s}
    vent:    {time: 0.5 s, loads: {cavity: {pressure: 2 kPa}}}
    again:   {time: 0.5 s, loads: {cavity: {pressure: 18 kPa}}}
solver: {steps: constant, first_step: 0.1}
END
# The volume holds still while the rubber relaxes: a point may then be loaded or unloaded.
sed -e 's/pressure: 1[58] kPa/volume: 9.4 mL/; s/pressure: 2 kPa/volume: 8.4 mL/' pressure.yaml >volume.yaml
sed -e 's/time: [0-9.]* s, //; /hold/d' pressure.yaml >slow.yaml   # untimed: only softening acts
# The rubber returns to its largest energy, in later cycles and while it is held: a point may count as loaded or unloaded.
sed -e '/again/d; s/^solver/  repeat: 3\nsolver/' slow.yaml >cycles.yaml
sed -e '/viscoelastic/d' pressure.yaml >held.yaml

# by_differences DESIGN KEY VALUE UNIT: the derivatives of all rows in time, the ends of the stages without
by_differences() {
    runs "mesh-gen -q $1.yaml --sensitivity $2 | solve -q -o $1.h5; postprocess -q $1.h5 -o rows.csv; postprocess -q $1.h5 --sensitivity -o table.csv"
    local sign
    for sign in - +; do
        runs "mesh-gen -q $1.yaml --set '$2=$(awk -v v="$3" "BEGIN { printf \"%.15g\", v * (1 $sign 1e-3) }") $4' | solve -q | postprocess -q -o moved$sign.csv"
    done
    claim "$1: derivatives by $2" awk -F, -v value="$3" -v timed="$(grep -c time: "$1.yaml")" '
        FNR == 1 { ++file; delete c; for (i = 1; i <= NF; ++i) c[$i] = i; next }
        file == 4 { D[++n] = $c["d_output"]; next }
        { row = timed ? FNR - 1 : $c["stage"]; y[file, row] = $c["elongation_mm"]
          if (file == 3) { end[row] = FNR - 1; if (row > rows) rows = row } }
        END { for (r = 1; r <= rows; ++r) { exact = (y[2, r] - y[1, r]) / (2e-3 * value); mine = D[end[r]]
                  e = exact - mine; if (e < 0) e = -e; if (e > worst) worst = e
                  if (exact < 0) exact = -exact; if (exact > largest) largest = exact }
              print "worst relative difference " worst / largest; exit !(rows > 1 && worst < 1e-4 * largest) }' moved-.csv moved+.csv rows.csv table.csv
}
by_differences pressure material.mu 100 kPa
by_differences pressure material.viscoelastic.moduli.2 0.2 ''
by_differences pressure material.viscoelastic.times.1 0.5 s
by_differences pressure material.softening.r 3 ''
by_differences pressure geometry.inner_radius 7 mm
by_differences volume geometry.inner_radius 7 mm
by_differences volume material.softening.m 5 kPa
by_differences slow material.softening.m 5 kPa
by_differences slow geometry.inner_radius 7 mm
by_differences cycles material.mu 100 kPa
by_differences cycles geometry.inner_radius 7 mm
by_differences held material.mu 100 kPa
runs "mesh-gen -q slow.yaml --set 'path.stages.wait={}' --sensitivity material.mu,material.mu | solve -q | postprocess -q --sensitivity -o table.csv"
claim "a stage in which nothing changes keeps the derivatives" \
    [ "$(tail -n 1 table.csv | cut -d, -f7-)" = "$(tail -n 2 table.csv | head -n 1 | cut -d, -f7-)" ]
runs 'postprocess -q pressure.h5 --at time=0.55s,1s,3s -o hold.csv'
claim "the pressure is constant while it is held" [ "$(column pressure_kPa hold.csv | xargs)" = '15 15 15' ]

runs 'postprocess -q volume.h5 --tolerances material.softening.m=10% --plot band.svg --x time --y pressure -o band.csv'
claim "the band of the pressure is at equal times" awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i } END { exit !($c["band_rss_pressure_kPa"] > 0) }' band.csv
runs 'postprocess -q pressure.h5 --tolerances geometry.inner_radius=0.3mm --plot loop.svg -o loop.csv'
claim "with a prescribed pressure the plot has the band of the elongation: four stages and the legend" \
    [ "$(grep -c "<polygon fill = 'rgb(230, 159,   0)' fill-opacity" loop.svg)" = 5 ]
cat >rubbers.yaml <<'END'
design: pressure.yaml
vary: {material.viscoelastic.moduli.1: [0.2, 0.4]}
sensitivity: [material.mu]
at: [time=3s, pressure=10kPa]
outputs: [elongation_mm, dissipated_energy_mJ]
END
runs "$here/../../scripts/sweep rubbers.yaml --folder rubbers"
claim "a derivative at a fixed pressure is empty on a path in time" grep -q 'derivatives of a path in time are at fixed times' rubbers/results.csv
claim "sweeps have values and derivatives at a time" \
    like "$(head -n 1 rubbers/results.csv)" '*,elongation_mm_at_time_3s,*elongation_by_material_mu_mm_per_kPa_at_time_3s,*'

# A known rubber from its curve, and from a test after its law.
runs "mesh-gen -q pressure.yaml | solve -q | postprocess -q --at time=0.25s,0.5s,1s,2s,5.5s,5.75s,6s,6.25s,6.5s -o measured.csv"
sed -i 's/mu: 100 kPa/mu: 80 kPa/; s/\[0.3, 0.2\]/[0.1, 0.1]/; s/m: 5 kPa/m: 8 kPa/' pressure.yaml
cat >goal.yaml <<'END'
design: pressure.yaml
vary:
  material.mu: {from: 50 kPa, to: 200 kPa}
  material.viscoelastic.moduli.1: {from: 0.02, to: 1}
  material.viscoelastic.moduli.2: {from: 0.02, to: 1}
targets: [{curve: measured.csv}]
set: {material.softening.m: 5 kPa}
END
runs 'optimize -q goal.yaml --starts 1 -o found.yaml'
claim "the modulus is found" within "$(sed -n 's/^# material.mu: \([0-9.]*\) kPa.*/\1/p' found.yaml)" 99.99 100.01
claim "the first Maxwell element is found" within "$(sed -n 's/^# material.viscoelastic.moduli.1: \([0-9.]*\) .*/\1/p' found.yaml)" 0.29997 0.30003
claim "the second Maxwell element is found" within "$(sed -n 's/^# material.viscoelastic.moduli.2: \([0-9.]*\) .*/\1/p' found.yaml)" 0.19998 0.20002
claim "curves are compared at equal times" grep -q 'elongation at equal time' found.yaml

# A bar of the law mu (l - 1/l^2) (1 + 0.5 exp(-t/2 s)), stretched at once
awk 'BEGIN { print "time (s),engineering strain,engineering stress (kPa)"; print "0,0,0"
    for (t = 1e-4; t < 20; t *= 1.5) printf "%.6g,0.5,%.9g\n", t, 40 * (1.5 - 1 / 2.25) * (1 + 0.5 * exp(-t / 2)) }' >test.csv
runs "fit-material -q test.csv --elastic '{law: neo-hookean, mu: 40 kPa}' --viscoelastic 1 -o rubber.yaml"
claim "the given law keeps its constant" grep -q '^  mu: 40 kPa   # given$' rubber.yaml
modulus() { sed -n 's/^    moduli: \[\([0-9.]*\)\].*/\1/p' "$1"; }
claim "its Maxwell element is found" within "$(modulus rubber.yaml)" 0.4999 0.5001
runs 'fit-material -q test.csv --elastic rubber.yaml --viscoelastic 1 -o again.yaml'
claim "a material file gives the same" within "$(modulus again.yaml)" 0.4999 0.5001
refuses 64 'fit-material: --elastic: has no effect without --viscoelastic or --softening; omit it' 'fit-material test.csv --elastic rubber.yaml'
refuses 65 "fit-material: --elastic:1:11: material.name: no silicone is called 'nope'*" 'fit-material test.csv --elastic nope --viscoelastic 1'

refuses 65 'fit-material: test.csv: the law has no finite stress at the stretches of the test*' \
    "fit-material test.csv --elastic '{law: gent, mu: 40 kPa, jm: 0.2}' --viscoelastic 1"
refuses 64 'postprocess: --tolerances material.softening.m=5%: the tolerance of this number is given twice; omit one of them' \
    'postprocess volume.h5 --tolerances material.softening.m=3%,material.softening.m=5%'
refuses 65 "mesh-gen: --set material.viscoelastic.moduli.3: 'material.viscoelastic.moduli' is a list of 2 values; write *.1 to .2*" \
    'mesh-gen -q slow.yaml --set material.viscoelastic.moduli.3=0.1'
