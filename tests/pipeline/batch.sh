#!/usr/bin/env bash
# solve --batch: many solves in one process, as used by scripts/sweep.   batch.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"

runs 'mesh-gen -q designs/rod.yaml --set mesh.size=50mm -o rod.h5; mesh-gen -q designs/tube.yaml --set mesh.size=3mm -o "a tube.h5"'
runs "mesh-gen -q designs/sphere.yaml --set mesh.size=5mm -o sphere.h5"
cat >lines <<'END'
rod.h5 -q -o rod-result.h5
"a tube.h5" --set path.control=pressure --json tube.json -o 'a tube-result.h5'
sphere.h5 --fields none -q -o sphere-result.h5
rod.h5 -q -o again.h5
END
run "solve --batch <lines"
claim "the answer to each line contains its exit code and times" [ "$(grep -cE '^[0-9]+ [0-9]+\.[0-9]{3} [0-9]+\.[0-9]{3} [0-9]+\.[0-9]{3}$' "$seen/out")" -eq 4 ]
claim "the exit codes are those of the solves" [ "$(cut -d ' ' -f 1 "$seen/out" | xargs)" = '0 2 0 0' ]
claim "the exit code of the batch is the first that is not 0" exits 2
claim "the messages of each solve are printed" grep -q '^solve: limit_point: ' "$seen/err"
claim "the summary is written" has limit_point tube.json stop_reason
claim "the CPU seconds are those of the line alone" [ "$(awk 'NR == 2 { print $2 + $3 + 0.01 }' "$seen/out" | awk -v own="$(json tube.json cpu_s)" '{ print own <= $1 }')" = 1 ]
same() {   # same CASE RESULT OPTION...: equals the curve of a separate process
    solve -q "${@:3}" "$1" | postprocess -q >alone.csv 2>/dev/null
    postprocess -q "$2" >batch.csv && cmp alone.csv batch.csv
}
claim "the curve of the rod equals that of a separate solve" same rod.h5 rod-result.h5
claim "the curve of the tube with its --set equals that of a separate solve" same 'a tube.h5' 'a tube-result.h5' --set path.control=pressure
claim "the curve of the sphere equals that of a separate solve" same sphere.h5 sphere-result.h5
claim "the curve of the rod after other solves equals that of a separate solve" same rod.h5 again.h5

cat >lines <<'END'
absent.h5 -o nothing.h5

rod.h5
rod.h5 --help
rod.h5 --profile -o nothing.h5
rod.h5 -o nothing.h5 -- -log_view
--batch
rod.h5 --fild none -o nothing.h5
- -o nothing.h5
rod.h5 -q -o good.h5
END
run "solve --batch <lines"
claim "failing lines are reported and the others continue" [ "$(cut -d ' ' -f 1 "$seen/out" | xargs)" = '66 64 64 0 64 64 64 64 64 0' ]
claim "the exit code is that of the first failure" exits 66
claim "each failure has a message" [ "$(grep -c '^solve: ' "$seen/err")" -eq 8 ]
claim "an unknown option suggests the most similar one" grep -q "unknown option '--fild'; did you mean '--fields'" "$seen/err"
claim "the valid line is solved" [ -s good.h5 ]
claim "invalid lines write nothing" [ ! -e nothing.h5 ]

cat >lines <<'END'
rod.h5 -q -o "open.h5
rod.h5 -q -o 'open.h5
rod.h5 -q -o open.h5 \
rod.h5 -q --set="path={control: pressure}" -o 'it'"'"'s'\ one.h5
END
printf 'rod.h5 -q -o es\033[1mcape.h5\nrod.h5 -q -o nul\0.h5\n' >>lines
run "solve --batch <lines"
claim "unclosed quotes and control characters are rejected" [ "$(cut -d ' ' -f 1 "$seen/out" | xargs)" = '64 64 64 0 64 64' ]
claim "the message gives the reason" grep -q "^solve: --batch: a quote in the line is not closed, or the line ends with a backslash; quote as in a shell: " "$seen/err"
claim "quotes are those of a shell" [ -s "it's one.h5" ]
claim "rejected lines write nothing" [ -z "$(find . -maxdepth 1 -name 'open*' -o -maxdepth 1 -name 'es*' -o -maxdepth 1 -name 'nul*')" ]
run "ulimit -v 4000000; { head -c 300000000 /dev/zero | tr '\\0' x; echo; echo 'rod.h5 -q -o long.h5'; } | solve --batch"
claim "a line that is too long is rejected, the next one is solved" [ "$(cut -d ' ' -f 1 "$seen/out" | xargs),$([ -s long.h5 ] && echo whole)" = '64 0,whole' ]
claim "there is one line on stderr" says 'solve: --batch: a line is longer than 1 MiB; *'

if [ -w /dev/full ]; then
    printf '%s\n' 'rod.h5 -q -o /dev/full' 'rod.h5 -q -o late.h5' >lines
    run "solve --batch <lines"
    claim "a full disk is reported" [ "$(cut -d ' ' -f 1 "$seen/out" | xargs)" = 74 ]
    claim "and ends the batch" [ "$status,$([ -e late.h5 ] && echo late)" = 74, ]
fi
run "yes 'rod.h5 -q -o again.h5' | head -n 500 | solve --batch | head -n 1"
claim "it ends when the reader closes the pipe" [ "$(wc -l <"$seen/out")" -eq 1 ]
run "solve --batch </dev/null"
claim "an empty input is valid" exits 0
refuses 64 'solve: *--json: cannot be combined with --batch; *' 'solve --batch --json a.json </dev/null'
refuses 64 'solve: CASE: cannot be combined with --batch; *' 'solve --batch rod.h5'
run "mpirun -n 2 solve --batch <lines"
claim "several ranks are reported" grep -q 'solve: --batch: runs on one rank only; omit mpirun' "$seen/err"
claim "several ranks are rejected" exits 64
