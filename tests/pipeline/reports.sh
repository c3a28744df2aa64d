#!/usr/bin/env bash
# What the tools tell about themselves and their work, for people and for programs.   reports.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# --json: the summaries
runs 'mesh-gen designs/tube.yaml --json mesh.json | solve --json solve.json | postprocess --json curve.json -o curve.csv'
for pair in mesh-gen:mesh.json solve:solve.json postprocess:curve.json; do
    claim "the summary of ${pair%:*} names the tool" has "${pair%:*}" "${pair#*:}" tool
    claim "and its version" has '[0-9]*.[0-9]*.[0-9]*' "${pair#*:}" version
    if [ -n "$(type -P python3)" ]; then claim "a second reader takes it" python3 -c 'import json, sys; json.load(open(sys.argv[1]))' "${pair#*:}"; fi
done
claim "cells are counted" within "$(json mesh.json cells)" 10 1e6
for key in steps newton_iterations factorizations unknowns wall_s cpu_s peak_memory_MB; do
    claim "solve tells $key" within "$(json solve.json "$key")" 1e-3 1e9
done
claim "the limit point is told, 44.34 kPa" within "$(json solve.json limit_points 0 pressure_Pa)" 44317 44361
claim "by postprocess in the units of the table" within "$(json curve.json limit_points 0 pressure_kPa)" 44.317 44.361
claim "rows are counted" [ "$(json curve.json rows)" = "$(column step curve.csv | wc -l)" ]

runs 'sweep-plan designs/sweeps/rod.yaml --json sweep.json > plan.csv'
claim "designs are counted" [ "$(json sweep.json designs)" -eq 4 ]

for tool in mesh-gen solve postprocess sweep-plan; do
    runs "$tool --version"
    claim "the first line is name, version, revision" like "$(head -n 1 "$seen/out")" "$tool [0-9]*.[0-9]*.[0-9]* (*)"
    runs "$tool --version --json > version.json"
    claim "the same as JSON" has "$tool" version.json tool
    claim "with the version of HDF5" has '1.*' version.json libraries HDF5
    claim "nothing on stderr" quiet

    runs "$tool --help > help.txt"
    sed -n '/^Examples:/,/^Exit codes:/s/^  \([a-z].*\)/\1/p' help.txt >examples.txt
    claim "--help has two examples" [ "$(wc -l <examples.txt)" -eq 2 ]
    claim "and the exit codes" [ "$(sed -n '/^Exit codes:/,$s/^  \([0-9]*\) .*/\1/p' help.txt | xargs)" = '0 1 2 64 65 66 70 73 74' ]
    cp examples.txt "examples-$tool.txt"

    runs "$tool --completion bash > completion.sh && bash -n completion.sh"
    runs "source ./completion.sh && complete -p $tool"
    runs "$tool --man > $tool.1"
    if [ -n "$(type -P groff)" ]; then
        runs "groff -man -Tascii -P-cbou -ww $tool.1 > man.txt"
        claim "without a warning" quiet
        claim "every option is in it" [ "$(grep -cE -- '--(help|version|output|json|quiet)' man.txt)" -ge 5 ]
    fi
done

# The examples of --help run: on a coarse bellows and the first millimetre of the tube, with the files they name.
sed -i 's/{size: 1.5 mm/{size: 3 mm/' designs/bellows.yaml
runs 'mesh-gen -q designs/bellows.yaml -o bellows-case.h5; solve -q bellows-case.h5 -o bellows.h5; mesh-gen -q designs/tube.yaml --set path.until.elongation=1mm -o case.h5'
while read -r example; do
    case $example in
        *--plot*) [ -n "$(type -P gnuplot)" ] || continue ;;
    esac
    runs "$example"
done < <(sort -u examples-*.txt)
if [ -n "$(type -P gnuplot)" ]; then claim "the picture is one" grep -q '<svg' curve.svg; fi

# Help with designs
runs 'mesh-gen --list'
families=$(cut -d ' ' -f 1 "$seen/out" | xargs)
claim "the families of designs/ are listed" [ "$(tr ' ' '\n' <<<"$families" | sort | xargs)" = "$(sed -n 's/^family: *\([a-z-]*\).*/\1/p' designs/*.yaml | sort -u | xargs)" ]
for family in $families; do
    runs "mesh-gen --template $family | mesh-gen --check"
    claim "stdout stays empty" [ ! -s "$seen/out" ]
    claim "a template needs no comment" grep -qx 'mesh-gen: <stdin>: valid' "$seen/err"
    runs "cd designs && mesh-gen --explain $family.yaml | mesh-gen --check -q"   # a mesh file is looked for from the design
done
runs 'mesh-gen --explain designs/tube.yaml --set geometry.cap=4mm'
claim "an override is explained" grep -q '4 mm.*given at --set geometry.cap' "$seen/out"
claim "and so are defaults" grep -q 'default' "$seen/out"
