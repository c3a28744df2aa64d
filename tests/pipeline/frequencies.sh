#!/usr/bin/env bash
# Natural frequencies pass through the pipeline: the curve, a resumed run, two ranks, --set and --tolerance; where they are refused.
# shellcheck disable=SC2016  # awk expands its own variables
#   frequencies.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
design='mesh-gen -q designs/bellows.yaml --set mesh.size=3mm --set material.density=1080kg/m^3'
runs "$design -o plain.h5 && solve -q plain.h5 | postprocess -q -o plain.csv"
runs "$design --set path.frequencies=3 -o case.h5 && solve -q case.h5 -o k.h5 && postprocess -q k.h5 -o whole.csv"
cp k.h5 whole.h5
claim "the curve is a table" table whole.csv
claim "the other columns are unchanged" cmp plain.csv <(cut -d, -f5-7 --complement whole.csv)
claim "the frequencies come after the measured quantities" like "$(head -n 1 whole.csv)" '*,volume_mL,frequency_1_Hz,frequency_2_Hz,frequency_3_Hz,stretch_p99,*'
claim "a bellows stiffens" within "$(column frequency_1_Hz whole.csv | tail -n 1)" "$(column frequency_1_Hz whole.csv | head -n 1)" 100
runs 'postprocess -q k.h5 --at elongation=20mm -o at.csv'
claim "they are interpolated" within "$(column frequency_1_Hz at.csv)" "$(column frequency_1_Hz whole.csv | sed -n 2p)" "$(column frequency_1_Hz whole.csv | sed -n 4p)"
runs 'solve -q plain.h5 --set path.frequencies=3 | postprocess -q | cmp - whole.csv'

# Walls that touch under suction couple further unknowns; contact stiffens the bellows.
runs 'mesh-gen -q designs/vacuum.yaml --set mesh.quality=draft --set material.density=1080kg/m^3 --set path.frequencies=2 --set loads.cavity.pressure=-2kPa -o touch.h5 && solve -q touch.h5 --json touch.json -o touched.h5 && postprocess -q touched.h5 -o touched.csv'
claim "contact raises the frequency" awk -F, -v first="$(json touch.json events 0 step)" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "frequency_1_Hz") k = i; next }
    $1 == first { before = $k } { last = $k } END { exit !(last > 1.5 * before) }' touched.csv
runs 'mpirun -n 2 solve -q touch.h5 -o touched2.h5 && postprocess -q touched2.h5 -o touched2.csv'
claim "... on two ranks too" agree <(sed -n '1p;$p' touched.csv | cut -d, -f2-) <(sed -n '1p;$p' touched2.csv | cut -d, -f2-) 1e-8

# Beck's column: a rod of 200 x 10 x 6 mm pushed by a pressure that follows its end. The roots of 2 W^2 + k^2 + 2 W^2 cosh b cos a + k W sinh b sin a = 0,
# with k = P L^2/EI and a, b = sqrt(sqrt(k^2/4 + W^2) +- k/2), meet at k = 20.05, here 0.451 kPa (M. Beck, Z. angew. Math. Phys. 3 (1952) 225).
cat >beck.yaml <<'END'
family: rod
geometry: {length: 200 mm, width: 10 mm, height: 6 mm}
material: {law: neo-hookean, mu: 100 kPa, kappa: incompressible, density: 1000 kg/m^3}
model: solid
mesh: {size: 10 mm}
supports: {fixed: fixed}
loads: {end: {pressure: 0.3 kPa}}
path: {frequencies: 3}
END
runs 'mesh-gen -q beck.yaml | solve -q | postprocess -q -o beck.csv'
claim "a follower pressure raises the first frequency" within "$(column frequency_1_Hz beck.csv | tail -n 1)" 0.7156 0.7300
claim "... and lowers the second one in its plane" within "$(column frequency_3_Hz beck.csv | tail -n 1)" 2.023 2.063
runs 'mesh-gen -q beck.yaml --set loads.end.pressure=0.5kPa | solve -q | postprocess -q -o flutter.csv'
claim "beyond the pressure at which they meet, both grow" within "$(column frequency_2_Hz flutter.csv | tail -n 1)" -1 -0.01

# A run that the limit of the file size stops after some rows.
run "(ulimit -f $(($(stat -c %s case.h5) / 1024 + 500)); exec solve -q case.h5 -o k.h5)"
claim "the run is stopped" exits 74
runs 'solve -q --resume k.h5 && cmp k.h5 whole.h5'

runs 'mpirun -n 2 solve -q case.h5 -o two.h5 && postprocess -q two.h5 -o two.csv'
claim "two ranks give the same frequencies" agree whole.csv two.csv 1e-8

runs 'solve -q case.h5 --tolerance 5% -o barred.h5 --set path.until.elongation=20mm; postprocess -q barred.h5 -o barred.csv'
claim "each row of a run with error bars has its frequencies" table barred.csv
claim "they are those of its mesh" like "$(head -n 1 barred.csv)" '*,elongation_error_mm,frequency_1_Hz,*'

refuses 65 'mesh-gen: *path.frequencies: the rubber has no density; add material: {density: 1080 kg/m^3}*' \
    'mesh-gen -q designs/bellows.yaml --set path.frequencies=3 -o x.h5'
refuses 65 'solve: *path.frequencies: natural frequencies need a factorisation of the tangent, which solver.linear: krylov avoids; *' \
    'solve -q case.h5 --set solver.linear=krylov -o x.h5'
refuses 65 'mesh-gen: *path.frequencies: a dynamic path has no natural frequencies, only a static path has; *' \
    "$design --set 'path={frequencies: 3}' --set dynamics.duration=1s -o x.h5"
