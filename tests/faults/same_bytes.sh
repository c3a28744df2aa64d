#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# The same case gives a byte-identical result file.   same_bytes.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
unset OMP_NUM_THREADS OPENBLAS_NUM_THREADS
# An axisymmetric section past its limit point, a solid large enough for several threads, and a motion in time.
runs 'mesh-gen -q designs/tube.yaml --set path.until.steps=16 -o section.h5'
runs 'mesh-gen -q designs/tube.yaml --set model=quarter --set mesh.size=5mm --set mesh.through_wall=2 --set path.until.steps=3 -o solid.h5'
runs 'mesh-gen -q designs/bellows-inflation.yaml --set mesh.size=4mm --set dynamics.duration=0.01s -o motion.h5'
same() {   # same TEXT CASE COMMAND: writes out.h5 as `solve -q CASE.h5 -o out.h5` does
    rm -f out.h5
    run "$3"
    claim "$2, $1: it runs" exits 0
    claim "$2, $1: the bytes are the same" cmp out.h5 "$2.first"
}
kernel=${OPENBLAS_CORETYPE:+OPENBLAS_CORETYPE=$OPENBLAS_CORETYPE}   # another kernel of BLAS gives other digits
for case in section solid motion; do
    solve="solve -q $case.h5 -o out.h5"
    runs "$solve && mv out.h5 $case.first"
    same 'repeated' $case "$solve"
    same 'at fixed addresses (no ASLR)' $case "setarch -R $solve"
    same 'with two other busy processes' $case "for i in 1 2; do (while :; do :; done) & done; $solve; code=\$?; kill %1 %2; exit \$code"
    same 'with three threads set in the environment' $case "OMP_NUM_THREADS=3 OPENBLAS_NUM_THREADS=3 $solve"
    same 'with one thread' $case "OMP_NUM_THREADS=1 $solve"
    same 'with another locale and time zone in an otherwise empty environment' $case "env -i PATH=\"\$PATH\" $kernel TZ=Pacific/Chatham LC_ALL=de_DE.UTF-8 $solve"
done
echo '-ksp_rtol 1e-1' >.petscrc
same 'with PETSc options in a petscrc file' solid 'solve -q solid.h5 -o out.h5'
rm .petscrc
for case in section solid; do
    same 'interrupted and resumed' $case "(ulimit -f $(($(stat -c %s $case.h5) / 1024 + 300)); exec solve -q $case.h5 -o out.h5) 2>stopped; grep -q 'free disk space' stopped && solve -q --resume out.h5"
done

# Two ranks: repeated runs give identical files. The section is factorised on each rank, the solid by substructures.
for case in section solid; do
    two="mpirun -n 2 solve -q $case.h5 -o out.h5"
    rm -f out.h5
    runs "$two && mv out.h5 $case.two"
    again() {   # again TEXT COMMAND
        rm -f out.h5
        runs "$2"
        claim "$case, on two ranks, $1: the bytes are the same" cmp out.h5 "$case.two"
    }
    again 'the second time' "$two"
    again 'the third time' "$two"
    again 'with two other busy processes' "for i in 1 2; do (while :; do :; done) & done; $two; code=\$?; kill %1 %2; exit \$code"
    again 'at fixed addresses' "mpirun -n 2 setarch -R solve -q $case.h5 -o out.h5"
    runs "postprocess -q $case.two -o two.csv; postprocess -q $case.first -o one.csv"
    claim "$case: two ranks agree with one to 1e-8" agree one.csv two.csv 1e-8
done
