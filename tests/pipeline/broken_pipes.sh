#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# Readers that close the pipe, and stages that fail or are killed.   broken_pipes.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
codes() { [ "$(tail -n 1 "$seen/out")" = "$1" ]; }   # the last line of stdout
runs 'mesh-gen -q designs/bellows.yaml -o bellows.h5; mesh-gen -q designs/tube.yaml -o tube.h5'
runs 'solve -q tube.h5 -o result.h5 && postprocess -q result.h5 > whole.csv'

# A reader that closes the pipe ends the writer without an error.
run 'mesh-gen designs/tube.yaml -q --set path.until.steps=3 | solve -q | postprocess -q | head -n 1; echo "${PIPESTATUS[*]}"'
claim "the header arrives" [ "$(head -n 1 "$seen/out")" = "$(head -n 1 whole.csv)" ]
claim "all stages succeed" codes '0 0 0 0'
claim "no message is printed" quiet
for command in 'mesh-gen -q designs/bellows.yaml' 'solve -q tube.h5 --set path.until.steps=9' 'postprocess -q result.h5' \
    'mesh-gen --help' 'mesh-gen --template tube'; do
    run "(sleep 0.3; exec $command) | true; echo \"\${PIPESTATUS[*]}\""   # the reader has ended before the first byte is written
    claim "both stages succeed" codes '0 0'
    claim "no message is printed" quiet
done
run '(solve -v tube.h5 --set path.until.steps=9 -o x.h5; echo $? > code) 2>&1 | head -n 1; cat code'
claim "a closed stderr pipe does no harm" codes 0
claim "the file is complete" postprocess -q x.h5 -o /dev/null

# A stage that fails causes exit code 65 in the next one.
run 'mesh-gen absent.yaml | solve -q | postprocess -q; echo "${PIPESTATUS[*]}"'
claim "the codes are 66 65 65" codes '66 65 65'
claim "each stage prints one line" [ "$(wc -l <"$seen/err")" -eq 3 ]
claim "the first stage reports the cause" grep -q '^mesh-gen: absent.yaml: cannot be opened' "$seen/err"
claim "the second stage reports the empty input" grep -q '^solve: <stdin>: empty input; check whether the previous program failed$' "$seen/err"
refuses 65 'postprocess: <stdin>: truncated: *' '(head -c 30000 result.h5; kill -9 $BASHPID) 2>&- | postprocess -q'

# Parallel runs, as in a sweep, do not share a folder that one could remove (Open MPI's session folder in TMPDIR).
mkdir scratch && touch -d 2020-01-01 scratch
runs 'TMPDIR=$PWD/scratch solve -q tube.h5 --set path.until.steps=1 -o x.h5'
claim "the temporary folder is not used" [ -z "$(find scratch -newermt 2020-01-02)" ]

# kill -9 of a running `solve -o FILE`: the file contains the complete steps so far.
solve -q tube.h5 --set solver.step_accuracy=1e-6 -o killed.h5 &
solver=$!
line='kill -9 of a running solve -o'
rows() { postprocess -q killed.h5 2>"$seen/err" | tail -n +2 | wc -l; }
for ((i = 0; i < 200; ++i)); do
    if [ "$(rows)" -ge 4 ] || ! kill -0 "$solver"; then break; fi
    sleep 0.05
done
kill -9 "$solver"
wait "$solver" 2>"$seen/wait"
claim "it was still running" [ $? -eq 137 ]
runs 'postprocess -q killed.h5 --json killed.json -o killed.csv'
claim "the file is readable and contains steps" within "$(column step killed.csv | tail -n 1)" 3 1000
claim "the rows are complete" table killed.csv
claim "no stop reason is set" has '' killed.json stop_reason
steps=$(column step killed.csv | tail -n 1)
runs "solve -q tube.h5 --set solver.step_accuracy=1e-6 --set path.until.steps=${steps:-1} | postprocess -q > again.csv"
claim "the steps equal those of an uninterrupted run" cmp killed.csv again.csv
claim "no other file is left" [ "$(echo killed*)" = 'killed.csv killed.h5 killed.json' ]
