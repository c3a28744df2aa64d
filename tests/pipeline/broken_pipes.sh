#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# Readers that leave, stages that die.   broken_pipes.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
LIMIT=60   # none may hang
codes() { [ "$(tail -n 1 "$seen/out")" = "$1" ]; }   # the last line of stdout
runs 'mesh-gen -q designs/bellows.yaml -o bellows.h5; mesh-gen -q designs/tube.yaml -o tube.h5'
runs 'solve -q tube.h5 -o result.h5 && postprocess -q result.h5 > whole.csv'

# A reader that leaves ends the writer quietly.
run 'mesh-gen designs/tube.yaml -q --set path.until.steps=3 | solve -q | postprocess -q | head -n 1; echo "${PIPESTATUS[*]}"'
claim "the header arrives" [ "$(head -n 1 "$seen/out")" = "$(head -n 1 whole.csv)" ]
claim "all end well" codes '0 0 0 0'
claim "and quietly" quiet
for command in 'mesh-gen -q designs/bellows.yaml' 'solve -q tube.h5 --set path.until.steps=9' 'postprocess -q result.h5' \
    'mesh-gen --help' 'mesh-gen --template tube'; do
    run "(sleep 0.3; exec $command) | true; echo \"\${PIPESTATUS[*]}\""   # nobody reads when the first byte is written
    claim "it ends well" codes '0 0'
    claim "and quietly" quiet
done
run '(solve -v tube.h5 --set path.until.steps=9 -o x.h5; echo $? > code) 2>&1 | head -n 1; cat code'
claim "messages that nobody reads do no harm" codes 0
claim "the file is whole" postprocess -q x.h5 -o /dev/null

# A stage that dies leaves a clear 65 in the next.
run 'mesh-gen absent.yaml | solve -q | postprocess -q; echo "${PIPESTATUS[*]}"'
claim "the codes are 66 65 65" codes '66 65 65'
claim "each stage says one line" [ "$(wc -l <"$seen/err")" -eq 3 ]
claim "the first names the cause" grep -q '^mesh-gen: absent.yaml: cannot be opened' "$seen/err"
claim "the second what it saw" grep -q '^solve: <stdin>: empty input; did the stage before fail?$' "$seen/err"
refuses 65 'postprocess: <stdin>: truncated: *' '(head -c 30000 result.h5; kill -9 $BASHPID) 2>&- | postprocess -q'

# Runs side by side, as in a sweep, share no folder that one could take from another (Open MPI's own in TMPDIR).
mkdir scratch && touch -d 2020-01-01 scratch
runs 'TMPDIR=$PWD/scratch solve -q tube.h5 --set path.until.steps=1 -o x.h5'
claim "the folder for temporary files is never written" [ -z "$(find scratch -newermt 2020-01-02)" ]

# kill -9 of `solve -o FILE` at work: the file holds the whole steps so far.
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
claim "it was at work until then" [ $? -eq 137 ]
runs 'postprocess -q killed.h5 --json killed.json -o killed.csv'
claim "the file is readable and has steps" within "$(column step killed.csv | tail -n 1)" 3 1000
claim "with whole rows" table killed.csv
claim "no cause of an end is made up" has '' killed.json stop_reason
steps=$(column step killed.csv | tail -n 1)
runs "solve -q tube.h5 --set solver.step_accuracy=1e-6 --set path.until.steps=${steps:-1} | postprocess -q > again.csv"
claim "they are the steps of an unbroken run" cmp killed.csv again.csv
claim "nothing else is left behind" [ "$(echo killed*)" = 'killed.csv killed.h5 killed.json' ]
