#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# `solve --resume` in the stages of a load programme; what else can happen to the file of a running `solve -o FILE`: no
# room, removed; and what --resume refuses.
#   resume_failures.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
runs 'mesh-gen -q designs/tube.yaml --set mesh.size=3mm --set solver.step_accuracy=2e-4 -o case.h5 && solve -q case.h5 -o whole.h5'
runs 'postprocess -q whole.h5 -o whole.csv'
rows() { json "$1" rows; }
holds_the_first_rows() {   # FILE: some, not all
    runs "postprocess -q $1 --json k.json -o k.csv"
    claim "the steps that fitted are readable" within "$(rows k.json)" 2 "$(($(wc -l <whole.csv) - 2))"
    claim "and are those of the whole path" cmp k.csv <(head -n $(($(rows k.json) + 1)) whole.csv)
}
resumes() {   # FILE: to the end of the path
    runs "solve -q --resume $1 && postprocess -q $1 -o k.csv"
    claim "the curve is that of a run without a break" near whole.csv k.csv 1e-10
}

# No room: a limit on the size of files, and a small disk where one may be mounted.
room=$(($(stat -c %s case.h5) / 1024 + 600))
refuses 74 'solve: k.h5: cannot be written: *; make room and go on with solve --resume k.h5' \
    "(ulimit -f $room; exec solve -q case.h5 -o k.h5)"
holds_the_first_rows k.h5
cp k.h5 stopped.h5
resumes k.h5
# Error bars are not resumed. Their rows have no records to go on from, and take less room.
run "(trap '' XFSZ; ulimit -f $((room - 450)); exec solve -q case.h5 --tolerance 1% -o barred.h5)"
claim "a path with --tolerance stops in between" exits 74
holds_the_first_rows barred.h5
refuses 65 'solve: barred.h5: a run with --tolerance cannot be resumed; solve the case again with --tolerance; *' 'solve -q --resume barred.h5'
mkdir disk
if mount -t tmpfs -o "size=${room}k" tmpfs disk 2>"$seen/err"; then
    refuses 74 'solve: disk/k.h5: cannot be written: No space left on device; make room and go on with solve --resume disk/k.h5' \
        'solve -q case.h5 -o disk/k.h5'
    holds_the_first_rows disk/k.h5
    refuses 74 'solve: disk/k.h5: cannot be written: No space left on device; *' 'solve -q --resume disk/k.h5'
    holds_the_first_rows disk/k.h5
    runs 'mount -o remount,size=64m disk'
    resumes disk/k.h5
    claim "no temporary file is left" [ "$(ls disk)" = k.h5 ]
    umount disk
else
    echo "no small disk can be mounted here: left out"
fi

# Removed or replaced while solve runs: it is made anew at the end, and solve says so.
for what in 'rm gone.h5' 'cp case.h5 other.h5; mv other.h5 gone.h5'; do
    run "rm -f gone.h5; (solve case.h5 -o gone.h5 2>&1; echo \$? >code) | while read -r l; do if [ -z \"\$done\" ] && [[ \$l == *\" % \"* ]]; then $what; done=1; fi; echo \"\$l\" >&2; done"
    claim "solve ends well" [ "$(cat code)" = 0 ]
    claim "and says what it did" grep -qx 'solve: warning: gone.h5 was removed or replaced during the run; it is written again' "$seen/err"
    runs 'postprocess -q gone.h5 -o k.csv && cmp k.csv whole.csv'
done
runs 'solve -q case.h5 -o k.h5 >&- && postprocess -q k.h5 -o k.csv && cmp k.csv whole.csv'   # a closed stdout is not needed

# What --resume refuses
refuses 65 'solve: whole.h5: is finished, there is nothing to resume; postprocess reads it' 'solve -q --resume whole.h5'
refuses 65 'solve: case.h5: a case without solution; run solve on it' 'solve -q --resume case.h5'
refuses 66 'solve: absent.h5: cannot be opened: No such file or directory' 'solve -q --resume absent.h5'
refuses 65 'solve: short.h5: truncated: 3000 bytes present, *' 'head -c 3000 stopped.h5 >short.h5; solve -q --resume short.h5'
for option in '-o x.h5' '--set solver.step_limit=3' '--fields none' case.h5; do
    refuses 64 'solve: --resume: the file contains the case, its settings and the last row; omit CASE, --set, --fields and -o' \
        "solve -q --resume stopped.h5 $option"
done
cp stopped.h5 cut.h5
truncate -s -1000 cut.h5   # the last record is cut short: from the one before it on
resumes cut.h5
run 'cp stopped.h5 hurt.h5; printf x | dd of=hurt.h5 bs=1 seek=$(($(stat -c %s stopped.h5) - 90000)) conv=notrunc status=none; solve -q --resume hurt.h5'
claim "a damaged record is refused" exits 65
claim "in one line" says 'solve: hurt.h5: a record after the HDF5 data does not match its checksum; *'

# A load programme with a gas, a closed valve and tip forces, cut off in each of its parts. The link keeps the records of the
# steps, which the finished file no longer has.
runs 'mesh-gen -q designs/cycle.yaml --set mesh.size=3mm -o case.h5'
run 'solve -q case.h5 -o cycle.h5 & while [ ! -e cycle.h5 ] && kill -0 $!; do sleep 0.005; done; ln cycle.h5 records.h5; wait $!'
claim "it runs" exits 0
runs 'postprocess -q cycle.h5 -o whole.csv'
claim "there are several stages" within "$(column stage whole.csv | tail -n 1)" 3 100
first=$(stat -c %s case.h5)
last=$(stat -c %s records.h5)
for ((part = 1; part <= 12; ++part)); do
    head -c $((first + (last - first) * part / 12 - 100)) records.h5 >k.h5
    resumes k.h5
done

# The overrides of the interrupted run hold for the rest of it, and nothing is made of what it was called with.
runs 'mesh-gen -q designs/tube.yaml --set mesh.size=3mm --set solver.step_accuracy=2e-4 -o case.h5'
runs 'solve -q case.h5 --set path.until.volume_ratio=3 -o set.h5 && postprocess -q set.h5 -o set.csv'
run "(ulimit -f $room; exec solve -q case.h5 --set path.until.volume_ratio=3 --fields last -o k.h5)"
claim "it stops in between" exits 74
runs 'solve -q --resume k.h5 && postprocess -q k.h5 -o k.csv'
claim "the goal is that of --set" near set.csv k.csv 1e-10
