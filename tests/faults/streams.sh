#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# Invalid streams, files and folders, in addition to ../pipeline/{refusals,outputs,broken_pipes}.sh.
#   streams.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
runs 'mesh-gen -q designs/tube.yaml --set path.until.steps=3 -o case.h5 && solve -q case.h5 -o result.h5 && postprocess -q result.h5 -o whole.csv'
cp "$here/../fit/data/treloar-uniaxial.csv" test.csv
runs 'fit-material -q test.csv --law yeoh -o whole.yaml'
declare -A command=([mesh-gen]='mesh-gen -q designs/tube.yaml' [solve]='solve -q case.h5' [postprocess]='postprocess -q result.h5'
                    [fit-material]='fit-material -q test.csv --law yeoh')
declare -A input=([mesh-gen]=designs/tube.yaml [solve]=case.h5 [postprocess]=result.h5 [fit-material]=test.csv)
declare -A options=([fit-material]='--law yeoh')

for tool in mesh-gen solve postprocess fit-material; do
    do_it=${command[$tool]} from="$tool -q ${options[$tool]:-}"
    row 'empty stdin' $tool 65 '<stdin>: *' nothing "$from -o place/out"
    if [ $tool = fit-material ]; then   # a truncated table is still valid
        row 'truncated stdin' $tool 0 'warning: <stdin>: the last line has no line ending; check that the file is complete' - \
            "head -c -3 test.csv | fit-material --law yeoh -o place/out 2>&1 | grep warning >&2"
    else
        row 'truncated stdin' $tool 65 '<stdin>*' nothing "head -c 700 ${input[$tool]} | $from -o place/out"
    fi
    row 'closed stdin' $tool 74 '<stdin>: cannot be read: *' nothing "$from - -o place/out <&-"
    row 'closed stdout' $tool 74 '<stdout>: cannot be written: *' nothing "$do_it >&-"
    row 'closed stderr' $tool 0 - - "$do_it -o place/out 2>&-"
    row 'closed stderr and an error' $tool 66 - nothing "$tool absent ${options[$tool]:-} -o place/out 2>&-"
    row 'a folder as input' $tool 66 'designs: is a folder; name a file' nothing "$tool designs ${options[$tool]:-} -o place/out"
    row 'a folder as output' $tool 73 'place: is a folder; name a file' nothing "$do_it -o place"
    row 'output onto the input' $tool 64 '--output *: would overwrite the input; *' nothing "cp ${input[$tool]} own; $tool own ${options[$tool]:-} -o ./own"
    claim "$tool: the input is unchanged" cmp -s own "${input[$tool]}"
    row 'a named pipe as output' $tool 0 - - "mkfifo place/out; cat place/out >copy & $do_it -o place/out; code=\$?; wait; exit \$code"
    claim "$tool: the reader received all data" [ "$(stat -c %s copy)" -gt 300 ]
    row 'a named pipe as input' $tool 0 - - "mkfifo place/in; cat ${input[$tool]} >place/in & $from place/in -o copy"
    row 'full output' $tool 74 '/dev/full: cannot be written: No space left on device' nothing "$do_it -o /dev/full"
    row 'full output' $tool 74 '<stdout>: cannot be written: No space left on device' nothing "$do_it >/dev/full"
    row 'no HOME and no writable TMPDIR' $tool 0 - - "env -u HOME TMPDIR=/proc/absent $do_it -o place/out"
    row 'a deleted working folder' $tool 73 'out: cannot be created: No such file or directory' nothing \
        "cp ${input[$tool]} own; mkdir gone; cd gone; rmdir ../gone; $tool -q \$OLDPWD/own ${options[$tool]:-} -o out 2>&1 | grep -v 'Unable to get the current working directory' >&2"   # a message of Open MPI
done

# A full disk and a read-only disk, if a disk can be mounted.
mkdir disk
if mount -t tmpfs -o size=40k tmpfs disk 2>"$seen/err"; then
    for tool in mesh-gen postprocess fit-material; do
        head -c 34000 /dev/zero >disk/kept
        listed 'a disk that becomes full' $tool 74 'disk/out: cannot be written: No space left on device' 'the old file'
        head -c 100 whole.csv >disk/out
        cp disk/out old
        run "yes | head -c 4000 >disk/more 2>more; ${command[$tool]} -o disk/out"
        claim "$tool: exit code 74" exits 74
        claim "$tool: the error is reported" says "$tool: disk/out: cannot be written: No space left on device"
        claim "$tool: the existing file is unchanged" cmp -s disk/out old
        claim "$tool: no other file is left" [ "$(echo disk/* disk/.[!.]*)" = 'disk/kept disk/more disk/out disk/.[!.]*' ]
        rm disk/*
    done
    for option in '--plot disk/a.svg' '--plot disk/a.png' '--report disk/a.html' '--json disk/a.json'; do
        file=${option#* }
        listed "a disk that becomes full: ${option%/*}/${file#*/}" postprocess 74 "$file: cannot be written: No space left on device" 'the old file'
        echo old >"$file"
        run "yes | head -c 40000 >disk/more 2>more; postprocess -q result.h5 -o copy.csv $option"
        if [[ $option == --report* ]] && grep -q 'built without the viewer' "$seen/err"; then   # npm was not available: reports are refused before anything is written
            claim "postprocess $option: exit code 73" exits 73
        else
            claim "postprocess $option: exit code 74" exits 74
            claim "postprocess $option: the error is reported" says "postprocess: $file: cannot be written: No space left on device"
        fi
        claim "postprocess $option: the existing file is unchanged and no other is left" [ "$(cat "$file") $(echo disk/*)" = "old $file disk/more" ]
        rm disk/*
    done
    mount -o remount,ro disk
    for tool in mesh-gen solve postprocess fit-material; do
        row 'a read-only folder' $tool 73 'disk/out: cannot be created: Read-only file system' nothing "${command[$tool]} -o disk/out"
    done
    umount disk
else
    echo "skipped: a full and a read-only disk cannot be mounted here"
    grep -E '^\| (a disk that becomes full|a read-only folder) ' <(section) >>"$rows"
fi
table_is_complete
