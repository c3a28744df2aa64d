#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# `solve --resume` in the stages of a load programme; full disk or removed file during `solve -o FILE`; files and options that --resume
# rejects.
#   resume_failures.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
runs 'mesh-gen -q designs/tube.yaml --set mesh.size=3mm --set solver.step_accuracy=2e-4 -o case.h5 && solve -q case.h5 -o whole.h5'
runs 'postprocess -q whole.h5 -o whole.csv'
rows() { json "$1" rows; }
holds_the_first_rows() {   # FILE: contains some rows, not all
    runs "postprocess -q $1 --json k.json -o k.csv"
    claim "the written steps are readable" within "$(rows k.json)" 2 "$(($(wc -l <whole.csv) - 2))"
    claim "the steps are those of the whole path" cmp k.csv <(head -n $(($(rows k.json) + 1)) whole.csv)
}
resumes() {   # FILE: can be resumed to the end of the path
    runs "solve -q --resume $1 && postprocess -q $1 -o k.csv"
    claim "the curve equals that of an uninterrupted run" near whole.csv k.csv 1e-10
}

# Full disk: a file size limit, and a small disk if one can be mounted.
max_KiB=$(($(stat -c %s case.h5) / 1024 + 600))
refuses 74 'solve: k.h5: cannot be written: *; free disk space and continue with solve --resume k.h5' \
    "(ulimit -f $max_KiB; exec solve -q case.h5 -o k.h5)"
holds_the_first_rows k.h5
cp k.h5 stopped.h5
resumes k.h5
# Runs with error bars cannot be resumed. Their rows have no restart records and take less space.
run "(trap '' XFSZ; ulimit -f $((max_KiB - 450)); exec solve -q case.h5 --tolerance 1% -o barred.h5)"
claim "a path with --tolerance is interrupted" exits 74
holds_the_first_rows barred.h5
refuses 65 'solve: barred.h5: a run with --tolerance cannot be resumed; solve the case again with --tolerance; *' 'solve -q --resume barred.h5'
mkdir disk
if mount -t tmpfs -o "size=${max_KiB}k" tmpfs disk 2>"$seen/err"; then
    refuses 74 'solve: disk/k.h5: cannot be written: No space left on device; free disk space and continue with solve --resume disk/k.h5' \
        'solve -q case.h5 -o disk/k.h5'
    holds_the_first_rows disk/k.h5
    refuses 74 'solve: disk/k.h5: cannot be written: No space left on device; *' 'solve -q --resume disk/k.h5'
    holds_the_first_rows disk/k.h5
    runs 'mount -o remount,size=64m disk'
    resumes disk/k.h5
    claim "no temporary file is left" [ "$(ls disk)" = k.h5 ]
    umount disk
else
    echo "skipped: a small disk cannot be mounted here"
fi

# If the file is removed or replaced while solve runs, solve writes it again at the end and reports it.
for what in 'rm gone.h5' 'cp case.h5 other.h5; mv other.h5 gone.h5'; do
    run "rm -f gone.h5; (solve case.h5 -o gone.h5 2>&1; echo \$? >code) | while read -r l; do if [ -z \"\$done\" ] && [[ \$l == *\" % \"* ]]; then $what; done=1; fi; echo \"\$l\" >&2; done"
    claim "solve succeeds" [ "$(cat code)" = 0 ]
    claim "a warning is printed" grep -qx 'solve: warning: gone.h5 was removed or replaced during the run; it is written again' "$seen/err"
    runs 'postprocess -q gone.h5 -o k.csv && cmp k.csv whole.csv'
done
runs 'solve -q case.h5 -o k.h5 >&- && postprocess -q k.h5 -o k.csv && cmp k.csv whole.csv'   # a closed stdout is not needed

# Rejected by --resume
refuses 65 'solve: whole.h5: is finished and cannot be resumed; read it with postprocess' 'solve -q --resume whole.h5'
refuses 65 'solve: case.h5: a case without solution; run solve on it' 'solve -q --resume case.h5'
refuses 66 'solve: absent.h5: cannot be opened: No such file or directory' 'solve -q --resume absent.h5'
refuses 65 'solve: short.h5: truncated: 3000 bytes present, *' 'head -c 3000 stopped.h5 >short.h5; solve -q --resume short.h5'
for option in '-o x.h5' '--set solver.step_limit=3' '--fields none' case.h5; do
    refuses 64 'solve: --resume: the file contains the case, its settings and the last row; omit CASE, --set, --fields and -o' \
        "solve -q --resume stopped.h5 $option"
done
cp stopped.h5 cut.h5
truncate -s -1000 cut.h5   # the last record is truncated: resume from the previous one
resumes cut.h5
run 'cp stopped.h5 hurt.h5; printf x | dd of=hurt.h5 bs=1 seek=$(($(stat -c %s stopped.h5) - 90000)) conv=notrunc status=none; solve -q --resume hurt.h5'
claim "a damaged record is rejected" exits 65
claim "the message is one line" says 'solve: hurt.h5: a record after the HDF5 data does not match its checksum; *'

# A load programme with a gas, a closed valve and tip forces, truncated in each of its parts. The hard link keeps the restart records,
# which the finished file no longer contains.
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

# The overrides of the interrupted run also apply to the resumed part.
runs 'mesh-gen -q designs/tube.yaml --set mesh.size=3mm --set solver.step_accuracy=2e-4 -o case.h5'
runs 'solve -q case.h5 --set path.until.volume_ratio=3 -o set.h5 && postprocess -q set.h5 -o set.csv'
run "(ulimit -f $max_KiB; exec solve -q case.h5 --set path.until.volume_ratio=3 --fields last -o k.h5)"
claim "the run is interrupted" exits 74
runs 'solve -q --resume k.h5 && postprocess -q k.h5 -o k.csv'
claim "the resumed run uses --set of the interrupted run" near set.csv k.csv 1e-10
