#!/usr/bin/env bash
# Summaries, versions and help of the tools, as text and JSON.   reports.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# --json: the summaries
runs 'mesh-gen designs/tube.yaml --json mesh.json | solve --json solve.json | postprocess --json curve.json -o curve.csv'
for pair in mesh-gen:mesh.json solve:solve.json postprocess:curve.json; do
    claim "the summary of ${pair%:*} contains the tool" has "${pair%:*}" "${pair#*:}" tool
    claim "the summary contains the version" has '[0-9]*.[0-9]*.[0-9]*' "${pair#*:}" version
    if [ -n "$(type -P python3)" ]; then claim "Python reads the JSON" python3 -c 'import json, sys; json.load(open(sys.argv[1]))' "${pair#*:}"; fi
done
claim "the number of cells is plausible" within "$(json mesh.json cells)" 10 1e6
for key in steps newton_iterations factorizations unknowns wall_s cpu_s peak_memory_MB; do
    claim "the summary of solve contains $key" within "$(json solve.json "$key")" 1e-3 1e9
done
claim "the limit point is 44.34 kPa" within "$(json solve.json limit_points 0 pressure_Pa)" 44317 44361
claim "postprocess reports it in the units of the table" within "$(json curve.json limit_points 0 pressure_kPa)" 44.317 44.361

# A tube touches its sleeve at 13.023 kPa, less the thickness of the contact layer.
runs 'mesh-gen designs/verification/contact-sleeve.yaml --set loads.cavity.pressure=20kPa | solve --json touch.json | postprocess --json touches.json -o touch.csv'
claim "solve reports the first contact" grep -q '^solve: first contact at 1[23]\.[0-9]* kPa, bore .*: the actuator touches the obstacle .sleeve. at x = ' "$seen/err"
claim "postprocess reports it" grep -q '^postprocess: first contact: pressure_kPa 1[23].*: the actuator touches the obstacle .sleeve. at x = ' "$seen/err"
for summary in touch.json touches.json; do
    claim "the event is a first contact" has first_contact "$summary" events 0 kind
    claim "the event names the obstacle" has sleeve "$summary" events 0 obstacle
    claim "the event contains its text" has 'the actuator touches *' "$summary" events 0 text
    claim "the contact is at the outer radius" within "$(awk -v x="$(json "$summary" events 0 location_mm 0)" -v y="$(json "$summary" events 0 location_mm 1)" 'BEGIN { print sqrt(x * x + y * y) }')" 12.49 12.51
done
claim "the first contact is at 13.02 kPa" within "$(json touch.json events 0 pressure_Pa)" 12900 13024
claim "postprocess reports it in the units of the table" within "$(json touches.json events 0 pressure_kPa)" 12.9 13.024

claim "the number of rows is correct" [ "$(json curve.json rows)" = "$(column step curve.csv | wc -l)" ]

runs 'sweep-plan designs/sweeps/rod.yaml --json sweep.json > plan.csv'
claim "the number of designs is correct" [ "$(json sweep.json designs)" -eq 4 ]

declare -A own_codes=([mesh-gen]='' [solve]='1 2 ' [postprocess]='1 ' [sweep-plan]='2 ')   # besides 0 and those of errors
for tool in mesh-gen solve postprocess sweep-plan; do
    runs "$tool --version"
    claim "the first line contains name, version and revision" like "$(head -n 1 "$seen/out")" "$tool [0-9]*.[0-9]*.[0-9]* (*)"
    runs "$tool --version --json > version.json"
    claim "the JSON contains the tool" has "$tool" version.json tool
    claim "the JSON contains the version of HDF5" has '1.*' version.json libraries HDF5
    claim "stderr is empty" quiet

    runs "$tool --help > help.txt"
    sed -n '/^Examples:/,/^Exit codes:/s/^  \([a-z].*\)/\1/p' help.txt >examples.txt
    claim "--help has two examples" [ "$(wc -l <examples.txt)" -eq 2 ]
    claim "--help lists the exit codes" [ "$(sed -n '/^Exit codes:/,$s/^  \([0-9]*\) .*/\1/p' help.txt | xargs)" = "0 ${own_codes[$tool]}64 65 66 70 73 74" ]
    cp examples.txt "examples-$tool.txt"

    runs "$tool --completion bash > completion.sh && bash -n completion.sh"
    runs "source ./completion.sh && complete -p $tool"
    runs "$tool --man > $tool.1"
    if [ -n "$(type -P groff)" ]; then
        runs "groff -man -Tascii -P-cbou -ww $tool.1 > man.txt"
        claim "groff prints no warning" quiet
        claim "the man page contains every option" [ "$(grep -cE -- '--(help|version|output|json|quiet)' man.txt)" -ge 5 ]
    fi
done

# Runs the examples of --help on a coarse bellows and the first millimetre of the tube.
sed -i 's/{size: 1.5 mm/{size: 3 mm/' designs/bellows.yaml
runs 'mesh-gen -q designs/bellows.yaml -o bellows-case.h5; solve -q bellows-case.h5 -o bellows.h5; mesh-gen -q designs/tube.yaml --set path.until.elongation=1mm -o case.h5'
while read -r example; do
    case $example in
        *--plot*) [ -n "$(type -P gnuplot)" ] || continue ;;
    esac
    runs "$example"
done < <(sort -u examples-*.txt)
if [ -n "$(type -P gnuplot)" ]; then claim "the plot is an SVG" grep -q '<svg' curve.svg; fi

# Help with designs
runs 'mesh-gen --list'
families=$(cut -d ' ' -f 1 "$seen/out" | xargs)
claim "the families of designs/ are listed" [ "$(tr ' ' '\n' <<<"$families" | sort | xargs)" = "$(sed -n 's/^family: *\([a-z-]*\).*/\1/p' designs/*.yaml | sort -u | xargs)" ]
for family in $families; do
    runs "mesh-gen --template $family | mesh-gen --check"
    claim "stdout is empty" [ ! -s "$seen/out" ]
    claim "a template is valid without warnings" grep -qx 'mesh-gen: <stdin>: valid' "$seen/err"
    runs "cd designs && mesh-gen --explain $family.yaml | mesh-gen --check -q"   # mesh files are relative to the design
done
runs 'mesh-gen --explain designs/tube.yaml --set geometry.cap=4mm'
claim "--explain marks overrides" grep -q '4 mm.*given at --set geometry.cap' "$seen/out"
claim "--explain marks defaults" grep -q 'default' "$seen/out"
