#!/usr/bin/env bash
# solve --batch: many solves in one process, as scripts/sweep runs them.   batch.sh BIN CMAKE
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
claim "each line is answered with its exit code and times" [ "$(grep -cE '^[0-9]+ [0-9]+\.[0-9]{3} [0-9]+\.[0-9]{3} [0-9]+\.[0-9]{3}$' "$seen/out")" -eq 4 ]
claim "the codes are those of the solves" [ "$(cut -d ' ' -f 1 "$seen/out" | xargs)" = '0 2 0 0' ]
claim "the first that is not 0 is that of the whole" exits 2
claim "a line says what its solve says" grep -q '^solve: limit_point: ' "$seen/err"
claim "a summary is written" has limit_point tube.json stop_reason
claim "its CPU seconds are the line's own" [ "$(awk 'NR == 2 { print $2 + $3 + 0.01 }' "$seen/out" | awk -v own="$(json tube.json cpu_s)" '{ print own <= $1 }')" = 1 ]
same() {   # same CASE RESULT OPTION...: as the curve of a process of its own
    solve -q "${@:3}" "$1" | postprocess -q >alone.csv 2>/dev/null
    postprocess -q "$2" >batch.csv && cmp alone.csv batch.csv
}
claim "the rod's curve is that of a solve of its own" same rod.h5 rod-result.h5
claim "and that of the tube, with its --set" same 'a tube.h5' 'a tube-result.h5' --set path.control=pressure
claim "and that of the sphere" same sphere.h5 sphere-result.h5
claim "and that of the rod after the others" same rod.h5 again.h5

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
claim "what fails is told, the others go on" [ "$(cut -d ' ' -f 1 "$seen/out" | xargs)" = '66 64 64 0 64 64 64 64 64 0' ]
claim "the exit code is that of the first" exits 66
claim "each with its reason" [ "$(grep -c '^solve: ' "$seen/err")" -eq 8 ]
claim "among them the nearest option" grep -q "unknown option '--fild'; did you mean '--fields'" "$seen/err"
claim "the good one is written" [ -s good.h5 ]
claim "and nothing else" [ ! -e nothing.h5 ]

cat >lines <<'END'
rod.h5 -q -o "open.h5
rod.h5 -q -o 'open.h5
rod.h5 -q -o open.h5 \
rod.h5 -q --set="path={control: pressure}" -o 'it'"'"'s'\ one.h5
END
printf 'rod.h5 -q -o es\033[1mcape.h5\nrod.h5 -q -o nul\0.h5\n' >>lines
run "solve --batch <lines"
claim "a quote that is not closed and control characters are refused" [ "$(cut -d ' ' -f 1 "$seen/out" | xargs)" = '64 64 64 0 64 64' ]
claim "with their reason" grep -q "^solve: --batch: a quote in the line is not closed, or the line ends with a backslash; quote as in a shell: " "$seen/err"
claim "quotes are those of a shell" [ -s "it's one.h5" ]
claim "nothing else is written" [ -z "$(find . -maxdepth 1 -name 'open*' -o -maxdepth 1 -name 'es*' -o -maxdepth 1 -name 'nul*')" ]
run "ulimit -v 4000000; { head -c 300000000 /dev/zero | tr '\\0' x; echo; echo 'rod.h5 -q -o long.h5'; } | solve --batch"
claim "a line without an end is refused, the next is solved" [ "$(cut -d ' ' -f 1 "$seen/out" | xargs),$([ -s long.h5 ] && echo whole)" = '64 0,whole' ]
claim "in one line on stderr" says 'solve: --batch: a line is longer than 1 MiB; *'

if [ -w /dev/full ]; then
    printf '%s\n' 'rod.h5 -q -o /dev/full' 'rod.h5 -q -o late.h5' >lines
    run "solve --batch <lines"
    claim "a disk that is full is told" [ "$(cut -d ' ' -f 1 "$seen/out" | xargs)" = 74 ]
    claim "and is the end: who gives the lines starts anew" [ "$status,$([ -e late.h5 ] && echo late)" = 74, ]
fi
run "yes 'rod.h5 -q -o again.h5' | head -n 500 | solve --batch | head -n 1"
claim "it ends when nobody reads" [ "$(wc -l <"$seen/out")" -eq 1 ]
run "solve --batch </dev/null"
claim "no lines are no work" exits 0
refuses 64 'solve: *--json: cannot be combined with --batch; *' 'solve --batch --json a.json </dev/null'
refuses 64 'solve: CASE: cannot be combined with --batch; *' 'solve --batch rod.h5'
run "mpirun -n 2 solve --batch <lines"
claim "it is for one rank" grep -q 'solve: --batch: runs on one rank only; omit mpirun' "$seen/err"
claim "several are refused" exits 64
