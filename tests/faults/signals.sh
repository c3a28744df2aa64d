#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# Signals at random times: the exit code is 128 + signal, the converged rows are kept, nothing else is left. What --resume makes of
# a file after kill -9 is in ../pipeline/resume.sh.   [SEED=n] signals.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
RANDOM=${SEED:-$(($(date +%s) % 32768))}
echo "seed $RANDOM"
set +m
runs 'mesh-gen -q designs/tube.yaml --set solver.step_accuracy=1e-4 -o case.h5 && solve -q case.h5 -o whole.h5 && postprocess -q whole.h5 -o whole.csv'
declare -A command=([mesh-gen]='mesh-gen -q ../designs/tube.yaml -o out' [solve]='solve -q ../case.h5 -o out'
                    [postprocess]='postprocess -q ../whole.h5 -o out')
declare -A number=([INT]=2 [TERM]=15 [HUP]=1 [KILL]=9)

now_ms() { echo $(($(date +%s%N) / 1000000)); }
# A shell starts background commands with INT ignored; env restores the default.
start() { (cd place && exec env --default-signal=INT,TERM,HUP bash -c "exec $1" 2>../said) & victim=$!; }

# struck TOOL SIGNAL TIMES LEFT: each run ends by itself or by the signal, and kept_LEFT is true for the folder place
struck() {
    local began took by_signal=0 others='' bad=0 code
    rm -rf place && mkdir place
    began=$(now_ms)
    start "${command[$1]}"
    wait "$victim" || others=failed
    took=$(($(now_ms) - began))
    for ((i = 0; i < $3; ++i)); do
        rm -rf place && mkdir place
        if [ "$4" = old ]; then echo precious >place/out; fi
        start "${command[$1]}"
        sleep "$(awk -v ms=$(((i * took + RANDOM % took) / $3)) 'BEGIN { print ms / 1000 }')"
        kill -s "$2" "$victim" 2>"$seen/kill"
        wait "$victim" 2>"$seen/wait"
        code=$?
        if [ $code -eq $((128 + number[$2])) ]; then by_signal=$((by_signal + 1)); elif [ $code -ne 0 ]; then others+=" $code"; fi
        if [ $code -ne 0 ] && { ! "kept_$4" || [ -s said ]; }; then bad=$((bad + 1)); ls -la place; head -n 3 said; fi
    done
    status=0
    line="$1 under $2, $3 times in $took ms"
    echo "$line: $by_signal interrupted it"
    claim "$line: some interrupted it" within "$by_signal" 1 "$3"
    claim "$line: no other exit code than 0 and $((128 + number[$2])), but:$others" [ -z "$others" ]
    claim "$line: each time the expected file is left and no message is printed" [ $bad -eq 0 ]
}
kept_old() { [ "$(ls -A place)" = out ] && { grep -qx precious place/out || [ "$(stat -c %s place/out)" -gt 1000 ]; }; }
kept_rows() { [ "$(ls -A place)" = '' ] || { [ "$(ls -A place)" = out ] && first_rows place/out; }; }

for signal in INT TERM HUP KILL; do
    code=$((128 + number[$signal]))
    listed "signal $signal" mesh-gen $code - 'the old file'
    struck mesh-gen $signal 12 old
    listed "signal $signal" solve $code - 'the converged rows'
    struck solve $signal 12 rows
    listed "signal $signal" postprocess $code - 'the old file'
    struck postprocess $signal 12 old
done

# One of two ranks is killed: mpirun ends the other; FILE keeps its rows and can be resumed.
rm -rf place && mkdir place && cd place || exit 1
listed 'one of two ranks is killed' solve 137 '- (mpirun reports it)' 'the converged rows'
mpirun -n 2 solve -q ../case.h5 --set solver.step_accuracy=1e-6 -o out 2>../said &
victim=$!
for ((i = 0; i < 400; ++i)); do
    if [ "$(postprocess -q out 2>"$seen/err" | wc -l)" -ge 6 ]; then break; fi
    sleep 0.05
done
kill -9 "$(pgrep -P "$victim" -x solve | tail -n 1)"
wait "$victim"
status=$?
line='kill -9 of one of two ranks'
cd ..
claim "mpirun ends with 137" exits 137
runs 'postprocess -q place/out -o part.csv'
claim "the rows are kept" within "$(column step part.csv | tail -n 1)" 1 1000
claim "no other file is left" [ "$(ls -A place)" = out ]
runs 'mpirun -n 2 solve -q --resume place/out'
runs 'postprocess -q place/out -o resumed.csv'
claim "the resumed path reaches the end" cmp -s part.csv <(head -n "$(wc -l <part.csv)" resumed.csv)
claim "no process is left" [ -z "$(pgrep -P "$victim")" ]
table_is_complete
