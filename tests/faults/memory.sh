#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# Out of memory: for a series of limits of address space each program either succeeds or reports `out of memory`. It never crashes,
# hangs or reports another cause.   memory.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
runs 'mesh-gen -q designs/tube.yaml --set path.until.steps=2 -o section.h5 && solve -q section.h5 -o result.h5'
runs 'mesh-gen -q designs/tube.yaml --set model=quarter --set mesh.size=5mm --set mesh.through_wall=2 --set path.until.steps=1 -o solid.h5'

{ echo 'stretch,nominal stress (MPa)'; awk 'BEGIN { for (i = 1; i <= 100000; ++i) { l = 1 + i / 50000; print l "," 0.4 * (l - 1 / l / l) } }'; } >test.csv

# limits.sh STEP COMMAND: starts at the smallest limit with which the program can print its version (below it the loader or a library
# fails) and increases the limit by STEP KB until three runs succeed. Prints exit code, limit and stderr of each run.
cat >limits.sh <<'L'
ulimit -c 0
step=$1; shift
limited() { (ulimit -v "$kb"; exec timeout 200 "$@") >out 2>err; }
for ((kb = 20000; kb < 4000000; kb += step)); do limited "$1" --version && break; done
for ((kb += 1000, succeeded = 0; kb < 4000000 && succeeded < 3; kb += step)); do
    limited "$1" --version || continue   # the start of a library may also fail above the minimum
    limited "$@"
    code=$?
    echo "$code $kb $(cat err)"
    if [ $code -eq 0 ]; then succeeded=$((succeeded + 1)); fi
done 2>&1
L
try_limits() {   # try_limits TOOL WORK STEP ARGUMENT...: every run ends with 0 or 74, and both occur
    listed "no memory (ulimit -v): $2" "$1" 74 'out of memory; use a coarser mesh, or allow more *' nothing
    rm -rf place && mkdir place
    runs "cd place; bash ../limits.sh $3 $1 ${*:4} >../runs.txt; rm -f out err x"
    claim "$1: no file is left" survives nothing
    claim "$1: some runs have too little memory" grep -q '^74 ' runs.txt
    claim "$1: each of these runs prints one line" [ "$(grep -v '^0 ' runs.txt | grep -cv "^74 [0-9]* $1: out of memory; use a coarser mesh, or allow more (ulimit -v, the limit of the job)\$")" -eq 0 ]
    claim "$1: some runs have enough memory" grep -q '^0 ' runs.txt
    grep -v '^0 ' runs.txt | grep -v "^74 [0-9]* $1: out of memory; "
    echo "$1: $(wc -l <runs.txt) runs, $(grep -c '^74 ' runs.txt) of them out of memory"
}
try_limits mesh-gen "a section" 1500 -q ../designs/tube.yaml -o x
try_limits solve "a section (CHOLMOD)" 8000 -q ../section.h5 -o x
try_limits solve "a solid (MUMPS)" 12000 -q ../solid.h5 -o x
try_limits postprocess "a curve" 800 -q ../result.h5 -o x
try_limits fit-material "a long test" 800 -q ../test.csv --law yeoh -o x
table_is_complete
