#!/usr/bin/env bash
# Natural frequencies pass through the pipeline: the curve, a resumed run, two ranks, --set and --tolerance; where they are refused.
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
