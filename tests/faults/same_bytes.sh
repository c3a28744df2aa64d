#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# The same case gives the same bytes: the whole file, /path with it.   same_bytes.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
LIMIT=300
unset OMP_NUM_THREADS OPENBLAS_NUM_THREADS
# A section, which CHOLMOD factorises, past its limit point; a solid, which MUMPS does; a motion in time.
runs 'mesh-gen -q designs/tube.yaml --set path.until.steps=16 -o section.h5'
runs 'mesh-gen -q designs/tube.yaml --set model=quarter --set mesh.size=5mm --set mesh.through_wall=2 --set path.until.steps=3 -o solid.h5'
runs 'mesh-gen -q designs/bellows-inflation.yaml --set mesh.size=4mm --set dynamics.duration=0.01s -o motion.h5'
same() {   # same TEXT CASE COMMAND: writes out.h5 as `solve -q CASE.h5 -o out.h5` does
    rm -f out.h5
    run "$3"
    claim "$2, $1: it runs" exits 0
    claim "$2, $1: the bytes are the same" cmp out.h5 "$2.first"
}
for case in section solid motion; do
    solve="solve -q $case.h5 -o out.h5"
    runs "$solve && mv out.h5 $case.first"
    same 'again' $case "$solve"
    same 'at fixed addresses (no ASLR)' $case "setarch -R $solve"
    same 'beside two that keep the processors busy' $case "for i in 1 2; do (while :; do :; done) & done; $solve; code=\$?; kill %1 %2; exit \$code"
    same 'with the environment asking for three threads' $case "OMP_NUM_THREADS=3 OPENBLAS_NUM_THREADS=3 $solve"
    same 'with another locale, time zone, and an empty environment beside' $case "env -i PATH=\"\$PATH\" TZ=Pacific/Chatham LC_ALL=de_DE.UTF-8 $solve"
done
echo '-ksp_rtol 1e-1' >.petscrc
same 'beside options of PETSc in a file' solid 'solve -q solid.h5 -o out.h5'
rm .petscrc
for case in section solid; do
    same 'interrupted and resumed' $case "(trap '' XFSZ; ulimit -f $(($(stat -c %s $case.h5) / 1024 + 300)); exec solve -q $case.h5 -o out.h5) 2>stopped; grep -q 'make room' stopped && solve -q --resume out.h5"
done

# Two ranks: each time the same bytes, as those of each other. MUMPS alone adds in the order in which messages come.
two() { for i in 1 2 3; do rm -f out.h5; runs "mpirun -n 2 solve -q $1.h5 -o out.h5 && mv out.h5 $1.two$i"; done; }
two section
claim "section, on two ranks: the second time the same" cmp section.two1 section.two2
claim "section, on two ranks: the third time the same" cmp section.two1 section.two3
rm -f out.h5
runs "for i in 1 2; do (while :; do :; done) & done; mpirun -n 2 solve -q section.h5 -o out.h5; kill %1 %2"
claim "section, on two ranks beside two busy processes: the same" cmp section.two1 out.h5
runs 'mpirun -n 2 setarch -R solve -q section.h5 -o out.h5'
claim "section, on two ranks at fixed addresses: the same" cmp section.two1 out.h5
runs 'postprocess -q section.two1 -o two.csv; postprocess -q section.first -o one.csv'
claim "section: two ranks agree with one to 1e-8" agree one.csv two.csv 1e-8
two solid
runs 'for i in 1 2 3; do postprocess -q solid.two$i -o $i.csv; done; postprocess -q solid.first -o one.csv'
for i in 1 2 3; do claim "solid: two ranks agree with one to 1e-8" agree one.csv $i.csv 1e-8; done
if cmp -s solid.two1 solid.two2 && cmp -s solid.two1 solid.two3; then echo "the solid's three runs on two ranks gave the same bytes"; else echo "the solid's three runs on two ranks differ in last digits"; fi
