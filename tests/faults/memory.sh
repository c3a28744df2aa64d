#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# No memory: down a ladder of limits of address space each program does its work or says so; never a crash, a hang, or
# another cause.   memory.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
LIMIT=600
runs 'mesh-gen -q designs/tube.yaml --set path.until.steps=2 -o section.h5 && solve -q section.h5 -o result.h5'
runs 'mesh-gen -q designs/tube.yaml --set model=quarter --set mesh.size=5mm --set mesh.through_wall=2 --set path.until.steps=1 -o solid.h5'

{ echo 'stretch,nominal stress (MPa)'; awk 'BEGIN { for (i = 1; i <= 100000; ++i) { l = 1 + i / 50000; print l "," 0.4 * (l - 1 / l / l) } }'; } >test.csv

# ladder STEP COMMAND: from the least at which the program can show its version (below, the loader or a library's own start ends
# it) upward by STEP KB until three runs are done. Codes, and lines that are none of ours, are on stdout.
cat >ladder.sh <<'L'
ulimit -c 0
step=$1; shift
limited() { (ulimit -v "$kb"; exec timeout 30 "$@") >out 2>err; }
for ((kb = 20000; kb < 4000000; kb += step)); do limited "$1" --version && break; done
for ((kb += 1000, well = 0; kb < 4000000 && well < 3; kb += step)); do
    limited "$1" --version || continue   # a library's start may fail beyond the least too
    limited "$@"
    code=$?
    echo "$code $kb $(cat err)"
    if [ $code -eq 0 ]; then well=$((well + 1)); fi
done 2>&1
L
ladder() {   # ladder TOOL WORK STEP ARGUMENT...: every rung ends with 0 or 74, some with each
    listed "no memory (ulimit -v): $2" "$1" 74 'out of memory; use a coarser mesh, or allow more *' nothing
    rm -rf place && mkdir place
    runs "cd place; bash ../ladder.sh $3 $1 ${*:4} >../rungs; rm -f out err x"
    claim "$1: nothing is left" survives nothing
    claim "$1: some runs have too little" grep -q '^74 ' rungs
    claim "$1: each of those says so in one line" [ "$(grep -v '^0 ' rungs | grep -cv "^74 [0-9]* $1: out of memory; use a coarser mesh, or allow more (ulimit -v, the limit of the job)\$")" -eq 0 ]
    claim "$1: more is enough" grep -q '^0 ' rungs
    grep -v '^0 ' rungs | grep -v "^74 [0-9]* $1: out of memory; "
    echo "$1: $(wc -l <rungs) rungs, $(grep -c '^74 ' rungs) of them too low"
}
ladder mesh-gen "a section" 1500 -q ../designs/tube.yaml -o x
ladder solve "a section (CHOLMOD)" 8000 -q ../section.h5 -o x
ladder solve "a solid (MUMPS)" 12000 -q ../solid.h5 -o x
ladder postprocess "a curve" 800 -q ../result.h5 -o x
ladder fit-material "a long test" 800 -q ../test.csv --law yeoh -o x
table_is_whole
