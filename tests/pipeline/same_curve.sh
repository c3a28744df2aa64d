#!/usr/bin/env bash
# The curve is identical to the byte for every way to connect the stages.   same_curve.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
few='--set path.until.steps=3'
coarse='--set mesh.size=3mm'
path_of() { if [ -n "$(type -P h5dump)" ]; then h5dump -g /path "$1" | tail -n +2; else postprocess -q "$1"; fi; }
same_path() { path_of "$1" >"$seen/a" && path_of "$2" >"$seen/b" && [ -s "$seen/a" ] && cmp "$seen/a" "$seen/b"; }
gives() {   # gives COMMAND: writes the curve of pipe.csv to stdout
    runs "$1"
    claim "the curve equals that of the pipe" cmp "$seen/out" pipe.csv
}

for name in tube bellows; do
    design=designs/$name.yaml
    runs "mesh-gen -q $design $few $coarse | solve -q | tee pipe.h5 | postprocess -q > pipe.csv"
    claim "no message is printed" quiet
    claim "the curve is a table" table pipe.csv
    claim "there are three steps after the undeformed state" [ "$(column step pipe.csv | tail -n 1)" = 3 ]

    gives "mesh-gen -q $design $few $coarse -o case.h5 && solve -q case.h5 -o result.h5 && postprocess -q result.h5 -o a.csv && cat a.csv"
    claim "/path is identical" same_path pipe.h5 result.h5
    gives "mesh-gen -q - $few $coarse < $design > case2.h5; solve -q - -o result2.h5 < case2.h5; postprocess -q - < result2.h5"
    gives "cat case.h5 | solve -q -o - | postprocess -o - -q"
    cp result.h5 first.h5
    gives "solve -q case.h5 -o result.h5 && postprocess -q result.h5"
    claim "a second run writes an identical file" cmp first.h5 result.h5
done
# Only the tube from here on.
runs "mesh-gen -q designs/tube.yaml $few -o case.h5 && solve -q case.h5 | tee pipe.h5 | postprocess -q > pipe.csv"
gives "mesh-gen -q designs/tube.yaml | solve -q $few | postprocess -q"
gives "mesh-gen --explain designs/tube.yaml | mesh-gen -q - $few | solve -q | postprocess -q"
for fields in none last every=2; do gives "solve -q --fields $fields case.h5 | postprocess -q"; done
gives "solve --verbose case.h5 | postprocess --verbose"
gives "postprocess --comments -q pipe.h5 | grep -v '^#'"
gives "solve -q case.h5 -- -ksp_monitor -log_view | postprocess -q"
