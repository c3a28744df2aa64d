#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# Messages of solve at its start and when it is interrupted.   interrupted.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
runs 'mesh-gen -q designs/tube.yaml --set solver.step_accuracy=1e-9 -o case.h5'
runs 'mesh-gen -q designs/bellows-inflation.yaml -o motion.h5'
prints() { grep -q -- "$1" "$seen/err"; }

runs 'solve case.h5 --set path.until.steps=3 -o r.h5 --json r.json'
claim "the first line contains unknowns and memory" grep -qx "solve: $(json r.json unknowns) unknowns, about [0-9]* MB of memory" <(head -n 1 "$seen/err")
claim "the last line does not contain the unknowns" not grep -q unknown <(tail -n 1 "$seen/err")
used=$(json r.json peak_memory_MB)
expected=$(head -n 1 "$seen/err" | sed 's/.*about \([0-9]*\) MB.*/\1/')
claim "the estimate is within a factor of two" within "$expected" "$(awk -v used="$used" 'BEGIN { print used / 2 }')" "$(awk -v used="$used" 'BEGIN { print used * 2 }')"

# Without -o an interrupted run is lost: there is a warning if stdout is a file, but not for a pipe.
lost='warning: stdout is a file, which is written only at the end: an interrupted run is lost; use -o FILE to save each row'
runs 'solve case.h5 --set path.until.steps=3 >out.h5'
claim "a file causes a warning" prints "^solve: $lost\$"
runs 'solve case.h5 --set path.until.steps=3 | cat >out.h5'
claim "a pipe causes no warning" not prints "$lost"
runs 'solve case.h5 --set path.until.steps=3 >/dev/null'
claim "a device causes no warning" not prints "$lost"

# interrupted SIGNAL ARGUMENT...: runs solve and sends the signal when it has rows; messages are in $seen/err, the exit code in $status
interrupted() {
    # A shell starts background commands with INT ignored; env restores the default.
    line="solve ${*:2} under $1"
    : >"$seen/err"   # the background shell truncates it later
    env --default-signal=INT,TERM solve "${@:2}" 2>"$seen/err" >out.h5 &
    local victim=$!
    until grep -qE ' % |continues from' "$seen/err" || { [ "$2" = -q ] && [ -s k.h5 ]; } || ! kill -0 $victim; do sleep 0.02; done
    sleep 0.2
    kill -s "$1" $victim
    wait $victim
    status=$?
}
for signal in INT TERM; do
    code=$((128 + $(kill -l $signal)))
    rm -f k.h5
    interrupted $signal case.h5 -o k.h5
    claim "the signal ends the process" exits $code
    claim "the message says what is saved and how to continue" like "$(tail -n 1 "$seen/err")" 'solve: interrupted; k.h5 contains +([0-9]) row?(s): `solve --resume k.h5` continues, `postprocess k.h5` reads them'
    said=$(tail -n 1 "$seen/err" | sed 's/.*contains \([0-9]*\) row.*/\1/')
    runs 'postprocess -q k.h5 --json k.json -o /dev/null'
    claim "the rows are in the file" within "$(json k.json rows)" "$said" $((said + 1))
    interrupted $signal --resume k.h5
    claim "the message is the same for a resumed run" like "$(tail -n 1 "$seen/err")" 'solve: interrupted; k.h5 contains +([0-9]) row?(s): *'
    interrupted $signal case.h5
    claim "the signal ends the process" exits $code
    claim "the message says that nothing is saved" grep -qx 'solve: interrupted; no row is saved; with -o FILE each row is saved as soon as it is computed' <(tail -n 1 "$seen/err")
    rm k.h5
    interrupted $signal motion.h5 -o k.h5
    claim "a motion can be read but not resumed" like "$(tail -n 1 "$seen/err")" 'solve: interrupted; k.h5 contains +([0-9]) row?(s): `postprocess k.h5` reads them; a motion in time cannot be resumed'
    rm k.h5
    interrupted $signal -q case.h5 -o k.h5
    claim "the signal ends the process" exits $code
    claim "--quiet prints nothing" quiet
done
