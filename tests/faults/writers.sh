#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# Two writers on one file.   writers.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
runs 'mesh-gen -q designs/tube.yaml --set solver.step_accuracy=1e-5 -o case.h5 && solve -q case.h5 -o whole && postprocess -q whole -o whole.csv'
# A solve writes place/out while COMMAND runs; the final file is that of this solve.
concurrent='solve -q case.h5 -o place/out & while [ ! -e place/out ] && kill -0 $! 2>/dev/null; do sleep 0.01; done;'
row 'a second solve -o' solve 73 'place/out: another solve is writing to it; wait until it ends or choose another file' 'the whole curve' \
    "$concurrent solve -q case.h5 -o place/out; code=\$?; wait; exit \$code"
row 'solve --resume of a file being written' solve 73 'place/out: another solve is writing to it; wait until it ends or choose another file' 'the whole curve' \
    "$concurrent solve -q --resume place/out; code=\$?; wait; exit \$code"
row 'a concurrent reader' solve 0 - 'the whole curve' "$concurrent postprocess -q place/out >part.csv; cmp part.csv <(head -n \$(wc -l <part.csv) whole.csv); wait"
row 'two mesh-gen -o' mesh-gen 0 - 'a complete case' \
    'for i in 1 2; do mesh-gen -q designs/tube.yaml -o place/out & pids+=" $!"; done; for p in $pids; do wait $p || exit; done'
row 'two postprocess -o' postprocess 0 - 'the curve' 'for i in 1 2; do postprocess -q whole -o place/out & pids+=" $!"; done; for p in $pids; do wait $p || exit; done'
# Started at the same time: one may be rejected, the file is complete.
for i in 1 2 3 4 5; do
    run 'for i in 1 2; do solve -q case.h5 -o both.h5 --set path.until.steps=4 2>>said & pids+=" $!"; done; set -- $pids; wait $1; a=$?; wait $2; echo "$a $?"'
    claim "$i: two at once: both succeed, or one is rejected" like "$(cat "$seen/out")" '@(0 0|73 0|0 73)'
    runs 'postprocess -q both.h5 -o both.csv && [ "$(wc -l <both.csv)" -eq 6 ]'
done
table_is_complete
