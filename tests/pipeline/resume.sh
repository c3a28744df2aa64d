#!/usr/bin/env bash
# kill -9 of `solve -o FILE` at 50 random times: FILE is readable, and `solve --resume FILE` gives the curve of an uninterrupted run.   [SEED=n] resume.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
rounds=50
seed=${SEED:-$(($(date +%s) % 32768))}
RANDOM=$seed
echo "seed $seed"
runs 'mesh-gen -q designs/tube.yaml --set solver.step_accuracy=1e-4 -o case.h5'   # much longer than the start-up time

now_ms() { echo $(($(date +%s%N) / 1000000)); }
random_below() { echo $((RANDOM * 32768 + RANDOM)) | awk -v below="$1" '{ printf "%d", $1 % below }'; }   # BELOW > 0
kill_after() {   # kill_after MILLISECONDS COMMAND...
    "${@:2}" 2>"$seen/err" &
    local victim=$!
    sleep "$(awk -v ms="$1" 'BEGIN { print ms / 1000 }')"
    kill -9 "$victim" 2>"$seen/kill"
    wait "$victim" 2>"$seen/wait"
    line="kill -9 of ${*:2} after $1 ms"
}
reads_first_rows() {   # k.h5 is readable and contains the first rows of the whole curve
    if [ -n "$(type -P h5ls)" ]; then runs 'h5ls k.h5'; fi
    runs 'postprocess k.h5 --json k.json -o k.csv'
    rows=$(json k.json rows)
    head -n $((rows + 1)) whole.csv >part.csv
    if ((rows > 0)); then claim "the rows are those of the whole path" near part.csv k.csv 1e-10; fi
}
is_finished() { [ -n "$(json k.json stop_reason)" ]; }

runs 'solve -q case.h5 -o k.h5 && postprocess -q k.h5 -o whole.csv'
claim "there is a path to interrupt" within "$(column step whole.csv | tail -n 1)" 30 1000
began=$(now_ms)
runs 'solve -q case.h5 -o k.h5'
duration=$(($(now_ms) - began))
echo "a run takes $duration ms"

at_work=0
for ((i = 0; i < rounds; ++i)); do
    for ((try = 0; try < 4; ++try)); do
        rm -rf ./*k.h5*
        kill_after $(((i * duration + $(random_below "$duration")) / rounds)) solve -q case.h5 -o k.h5
        if [ ! -s "$seen/kill" ]; then break; fi
        duration=$((duration * 9 / 10))   # the run had already ended: assume a shorter duration
    done
    if [ ! -e k.h5 ]; then continue; fi   # killed before the first write
    reads_first_rows
    if ((i % 5 == 0)) && ! is_finished; then   # kill several times
        for ((again = 0; again <= i % 3; ++again)); do
            kill_after "$(random_below $((duration / 2)))" solve -q --resume k.h5
            before=$rows
            reads_first_rows
            # The last row before the first kill may lack its state.
            claim "earlier rows are kept" within "$rows" $((before - 1)) 1000
            if is_finished; then break; fi
        done
    fi
    if is_finished; then
        refuses 65 'solve: k.h5: is finished and cannot be resumed; read it with postprocess' 'solve -q --resume k.h5'
    else
        at_work=$((at_work + 1))
        runs 'solve -q --resume k.h5'
    fi
    runs 'postprocess -q k.h5 -o k.csv'
    claim "the curve equals that of an uninterrupted run" near whole.csv k.csv 1e-10
done
echo "$at_work of $rounds kills interrupted the path"
claim "most kills interrupted the path" within "$at_work" 20 "$rounds"
