#!/usr/bin/env bash
# Forces on faces and reactions of fixed faces, from the design to table, plot and check; additional columns.
#   reactions.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
finger() { printf 'mesh-gen -q designs/pneunet.yaml --set geometry.chambers=2 --set "mesh={size: 4 mm, through_wall: 1, grading: 1}" --set loads.cavity.pressure=2kPa %s' "$*"; }
column() { awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) k = i; next } { last = $k } END { print last }' "$1"; }

# A finger with a blocked tip: force and moment as additional columns.
runs "$(finger "--set 'supports={fixed: [fixed, tip]}' --set 'outputs={block: {face: tip, measure: force, along: z}, hold: {face: fixed, measure: force, along: z}, turn: {face: tip, measure: moment, along: y}, arch: {face: bottom, measure: curvature, along: y}}'") -o case.h5 && solve -q case.h5 -o result.h5 && postprocess -q result.h5 -o curve.csv"
claim "the column names contain the units" [ "$(head -n 1 curve.csv)" = "step,pressure_kPa,block_N,hold_N,turn_Nmm,arch_per_m,volume_mL,stretch_p99,max_stretch,min_J,stable,stable_under_control" ]
claim "both reactions are equal and opposite" within "$(awk "BEGIN { print ($(column curve.csv block_N) + $(column curve.csv hold_N)) / $(column curve.csv block_N) }")" -1e-8 1e-8
runs 'postprocess -q result.h5 --check curve.csv --rtol 1e-12'
runs 'postprocess -q result.h5 --at pressure=1kPa -o at.csv'
half=$(column at.csv block_N)
runs "postprocess -q result.h5 --at block=${half}N -o back.csv"
claim "--at accepts a force" within "$(column back.csv pressure_kPa)" 0.999999 1.000001
runs "awk -F, 'NR == 1 { print \"Pressure (kPa),block (mN)\"; next } { print \$2 \",\" 1000 * \$3 }' curve.csv > measured.csv && postprocess -q result.h5 --compare measured.csv --max-error 1Pa -o errors.csv"
runs 'postprocess -q result.h5 --plot block.svg --y block -o /dev/null && postprocess -q result.h5 --paraview finger.hdf && postprocess -q finger.hdf | cmp - curve.csv'
claim "the plot shows the force" grep -q 'block (N)' block.svg
run 'timeout -s KILL 0.4 solve -q case.h5 -o part.h5; if [ -s part.h5 ]; then solve -q --resume part.h5; else solve -q case.h5 -o part.h5; fi; postprocess -q part.h5 --also all > part.csv; postprocess -q result.h5 --also all | cmp - part.csv'
claim "an interrupted run gives the same result" exits 0
run "solve -q case.h5 --set path.until.block=${half}N -o until.h5"
runs 'postprocess -q until.h5 -o until.csv'
claim "a path can end at a force" within "$(awk "BEGIN { print $(column until.csv block_N) / $half }")" 0.999999 1.000001

# A force on the tip acts on the whole finger, although a half is meshed.
pushed="--set 'loads={tip: {force: 20 mN, along: z}}' --set 'outputs={lift: {face: tip, along: z}, hold: {face: fixed, measure: force, along: z}}'"
runs "$(finger "$pushed") | solve -q | postprocess -q > half.csv"
runs "$(finger "$pushed" --set model=solid) | solve -q | postprocess -q > whole.csv"
claim "the load is the first column" [ "$(cut -d, -f2 half.csv | head -n 1)" = load_N ]
claim "the reaction equals the whole force" within "$(column half.csv hold_N)" 0.0199999999 0.0200000001
claim "whole and half models bend equally" within "$(awk "BEGIN { print $(column whole.csv lift_mm) / $(column half.csv lift_mm) }")" 0.99999 1.00001
run "$(finger "$pushed") -o pushed.h5 && solve -q pushed.h5 --set loads.tip.force=10mN | postprocess -q > less.csv"
claim "solve --set changes the force" within "$(column less.csv hold_N)" 0.00999999999 0.01000000001
refuses 65 'mesh-gen: --set loads: loads.tip.along: a symmetry plane of the model would mirror the force; *' "$(finger "--set 'loads={tip: {force: 20 mN, along: y}}'") -o x.h5"
refuses 65 'mesh-gen: --set outputs: outputs.f.face: *tip* is not constrained in this direction, *' "$(finger "--set 'outputs={f: {face: tip, measure: force, along: z}}'") -o x.h5"

# Error bars of a force.
runs 'mesh-gen -q designs/tube.yaml --set mesh.size=3mm --set "supports={fixed: fixed, x: inlet}" --set path={} --set loads.cavity.pressure=20kPa --set "outputs={thrust: {face: inlet, measure: force, along: x}}" | solve -q --tolerance 1% | postprocess -q > bars.csv'
claim "the table contains error bars of the force" grep -q 'thrust_error_N' bars.csv

# Energy, work and the list of columns.
runs 'postprocess -q result.h5 --also stored_energy,load_work -o energy.csv'
claim "the work of the loads equals the stored energy" within "$(awk "BEGIN { print $(column energy.csv load_work_mJ) / $(column energy.csv stored_energy_mJ) }")" 0.9999 1.0001
runs 'postprocess --outputs'
claim "--outputs lists all columns" grep -q '^<force>_N *N *force of the actuator' "$seen/out"
runs 'postprocess --outputs result.h5'
claim "--outputs RESULT lists the columns of the table" [ "$(grep -vc -- --also "$seen/out")" -eq "$(head -n 1 curve.csv | tr ',' '\n' | wc -l)" ]
refuses 64 "postprocess: --also: the result has no column 'energy'; *" 'postprocess -q result.h5 --also energy'

# A rod pulled and released: between rows, also near the reversal, the stretch follows the elongation.
cat >there-and-back.yaml <<'EOF'
family: rod
geometry: {length: 100 mm, width: 10 mm, height: 10 mm}
material: {law: neo-hookean, mu: 0.1644 MPa, kappa: incompressible}
model: solid
mesh: {size: 10 mm}
supports: {x: fixed, y: left, z: bottom}
loads: {end: {displacement: 50 mm, along: x}}
path: {stages: {pull: {loads: {end: {displacement: 50 mm}}}, back: {loads: {end: {displacement: 0 mm}}}}}
outputs: {elongation: {face: end, along: x}}
EOF
runs 'mesh-gen -q there-and-back.yaml | solve -q -o there-and-back.h5 && postprocess -q there-and-back.h5 --at elongation=40mm --also stored_energy -o turn.csv'
claim "there is one crossing in each stage" [ "$(cut -d, -f2 turn.csv | tr '\n' ' ')" = "stage 1 2 " ]
head -n 2 turn.csv >pull.csv
energy=$(awk 'BEGIN { print 164.4 / 2 * (1.4 ^ 2 + 2 / 1.4 - 3) * 10 }')   # mu/2 (l^2 + 2/l - 3) V, in mJ
claim "the stretch is 1.4 in the first stage" within "$(column pull.csv stretch_p99)" 1.399999 1.400001
claim "the stretch is 1.4 in the second stage" within "$(column turn.csv stretch_p99)" 1.399999 1.400001
for way in pull turn; do
    claim "the energy is that of this stretch" within "$(awk "BEGIN { print $(column $way.csv stored_energy_mJ) / $energy }")" 0.998 1.002
done

# A plane-strain strip bent by its weight: its end rotates by rho g L^3 / (2 mu h^2), a beam with the plane-strain modulus 4 mu.
cat >strip.yaml <<'EOF'
family: panel
geometry: {length: 80 mm, height: 2 mm, end_height: 2 mm}
material: {law: neo-hookean, mu: 0.2 MPa, kappa: incompressible, density: 1000 kg/m^3}
model: plane-strain
mesh: {size: 2 mm, through_wall: 1}
supports: {fixed: fixed}
loads: {gravity: {acceleration: 10 mm/s^2, along: y}}
outputs: {turn: {face: end, measure: bend, along: z, reference: fixed}}
EOF
runs 'mesh-gen -q strip.yaml | solve -q | postprocess -q -o strip.csv'
beam=$(awk 'BEGIN { print 180 / atan2(0, -1) * 1000 * 0.01 * 0.08 ^ 3 / (2 * 0.2e6 * 0.002 ^ 2) }')
claim "a plane-strain strip bends like a beam" within "$(awk "BEGIN { print $(column strip.csv turn_deg) / $beam }")" 0.99 1.001
