#!/usr/bin/env bash
# Every number of a design by which solve differentiates, against central differences of the whole pipeline.
#   every_sensitivity.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# every DESIGN [OPTION...]: at the last row. The derivative of the load at a fixed output; the runs may end at a load, at an output or at an
# amount of gas, so the differences move along the slope of the curve, -d_load / d_output of the number that matters most.
every() {
    local design="mesh-gen -q designs/$1.yaml --set solver.residual_tolerance=1e-11 ${*:2}" step load output key value unit d_load d_output slope sides side n=0
    runs "$design --sensitivity all | solve -q | postprocess -q --sensitivity -o table.csv"
    step=$(tail -n 1 table.csv | cut -d, -f1) load=$(head -n 1 table.csv | cut -d, -f2) output=$(head -n 1 table.csv | cut -d, -f3)
    slope=$(grep "^$step," table.csv | awk -F, '$10 * $10 > most { most = $10 * $10; slope = -$7 / $8 } END { printf "%.17g", slope }')
    grep "^$step," table.csv | cut -d, -f4-8 | grep "^${only:-}.*,.*,.*,.*,." >numbers.csv
    claim "$1 has derivatives" [ -s numbers.csv ]
    : >lines
    while IFS=, read -r key value unit d_load d_output; do
        n=$((n + 1))
        for side in 1.0002 0.9998; do
            runs "$design --set '$key=$(awk -v v="$value" -v s="$side" 'BEGIN { printf "%.15g", v * s }') $unit' -o $n-$side.h5"
            echo "$n-$side.h5 -q -o $n-$side-result.h5" >>lines
        done
    done <numbers.csv
    runs 'solve --batch <lines'
    n=0
    while IFS=, read -r key value unit d_load d_output; do
        sides='' n=$((n + 1))
        for side in 1.0002 0.9998; do
            runs "postprocess -q $n-$side-result.h5 -o side.csv"
            sides+=" $(column "$load" side.csv | tail -n 1),$(column "$output" side.csv | tail -n 1)"
        done
        claim "$1: $key: $sides $d_load $d_output" awk -v sides="$sides" -v v="$value" -v dl="$d_load" -v slope="$slope" 'BEGIN {
            split(sides, s, /[ ,]+/); first = s[1] == "" ? 2 : 1
            found = (s[first] - s[first + 2] - slope * (s[first + 1] - s[first + 3])) / 0.0004
            off = found - dl * v; wanted = 1e-4 * ((dl * v < 0 ? -dl * v : dl * v) + 1e-3 * (s[first] < 0 ? -s[first] : s[first]))
            exit !(off * off <= wanted * wanted) }'
    done <numbers.csv
}
every tube
every fiber-tube --set mesh.quality=draft
every bellows
every dome
every sphere --set "'outputs={growth: {face: outer, along: r}}'"
every plate
every panel
every extruded
# An amount of gas, beyond the limit point
every tube --set "'loads.cavity={mass: 20 mg}'" --set path.until={}

# All constants of all laws, those of fibres included; the stress of kraken has no energy, and linear-elastic no finite strain.
only=material
law() { every rod --set mesh.size=10mm --set loads.end.pressure=-100kPa --set "'material={law: $1}'" "${@:2}"; }
law 'saint-venant-kirchhoff, mu: 0.2 MPa, kappa: 2 MPa'
law 'neo-hookean, mu: 0.2 MPa, kappa: 4 MPa'
law 'neo-hookean-compressible, mu: 0.2 MPa, kappa: 4 MPa'
law 'mooney-rivlin, c10: 0.08 MPa, c01: 0.02 MPa, c20: 2 kPa, c11: 1 kPa, c02: 1 kPa, kappa: incompressible'
law 'yeoh, c1: 0.1 MPa, c2: 5 kPa, c3: 1 kPa, a: 0.01 MPa, b: 2, kappa: incompressible'
law 'ogden, mu: [0.1 MPa, 0.05 MPa], alpha: [1.5, 4], kappa: incompressible'
law 'gent, mu: 0.2 MPa, jm: 20, kappa: incompressible'
law 'arruda-boyce, mu: 0.2 MPa, locking_stretch: 3, kappa: incompressible'
law 'holzapfel-gasser-ogden, mu: 0.2 MPa, k1: 0.1 MPa, k2: 0.5, angle: 30 deg, kappa: incompressible'
law 'kraken, mu: 0.2 MPa, kappa: 2 MPa' --set mesh.formulation=displacement
law 'linear-elastic, mu: 0.2 MPa, kappa: 2 MPa'

# A face that is moved, alone and in a stage before another one, which starts where an output has a value.
only=
cat >designs/moved.yaml <<'END'
family: tube
geometry: {length: 100 mm, inner_radius: 7 mm, outer_radius: 10 mm, cap: 5 mm}
material: {law: neo-hookean, mu: 0.1644 MPa, kappa: incompressible}
mesh: {quality: draft}
supports: {fixed: fixed}
loads: {inlet: {displacement: 20 mm, along: axis}, cavity: {pressure: 10 kPa}}
outputs: {growth: {face: outer, along: r}}
END
cp designs/moved.yaml designs/moved-then-inflated.yaml
echo 'path: {stages: {pull: {loads: {inlet: {displacement: 20 mm}}, until: {growth: -0.5 mm}},
                inflate: {loads: {cavity: {pressure: 10 kPa}}, until: {growth: -0.4 mm}}}}' >>designs/moved-then-inflated.yaml
every moved --set "'loads={inlet: {displacement: 20 mm, along: axis}}'"
every moved-then-inflated
