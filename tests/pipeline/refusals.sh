#!/usr/bin/env bash
# Rejected input: exit codes 64, 65 and 66, each with one line that contains location, problem and remedy.
#   refusals.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
runs 'mesh-gen -q designs/tube.yaml -o case.h5 && solve -q case.h5 --set path.until.steps=3 -o result.h5'

# 64: usage
refuses 64 "mesh-gen: unknown option '--lst'; did you mean '--list'[?]" 'mesh-gen --lst'
refuses 64 "solve: unknown option '--feilds'; did you mean '--fields'[?]" 'solve --feilds all case.h5'
refuses 64 "postprocess: unknown option '--plto'; did you mean '--plot'[?]" 'postprocess --plto x.svg result.h5'
for tool in mesh-gen solve postprocess sweep-plan; do
    refuses 64 "$tool: one argument too many: 'two'; see *--help*" "$tool one two"
    refuses 64 "$tool: *exclude each other; *" "$tool --quiet --verbose x"
    refuses 64 "$tool: data and --json cannot both go to stdout; use *" "$tool --json - x"
done
# an empty value from an unset shell variable is rejected, and no output overwrites an input or another output
refuses 64 'postprocess: --check: the value is empty; give a value or omit the option' 'postprocess --check "" --junit v.xml result.h5'
refuses 64 'solve: --output: the value is empty; *' 'solve -o "" case.h5'
refuses 64 'mesh-gen: --output tube.yaml: would overwrite the input; write to another file' 'cp designs/tube.yaml tube.yaml; mesh-gen tube.yaml -o tube.yaml'
refuses 64 'sweep-plan: --output designs/sweeps/../sweeps/rod.yaml: would overwrite the input; *' 'sweep-plan designs/sweeps/rod.yaml -o designs/sweeps/../sweeps/rod.yaml'
refuses 64 'mesh-gen: --output designs/tube.h5: would overwrite the input; *' 'cp designs/tube.yaml designs/tube.h5; mesh-gen designs/tube.h5 --output-folder designs'
refuses 64 'solve: --json ./case.h5: would overwrite the input; *' 'solve case.h5 --json ./case.h5 -o x.h5'
refuses 64 'postprocess: --report ./x.html: is also the file of --json; *' 'postprocess result.h5 --json x.html --report ./x.html'
refuses 64 'postprocess: --output result.h5: would overwrite the input; *' 'postprocess result.h5 -o result.h5'
refuses 64 'postprocess: --output and --junit cannot both go to stdout; *' 'postprocess result.h5 -o - --check golden.csv --junit -'
refuses 64 'postprocess: --report x.pdf: a report is an HTML file; use the extension .html' 'postprocess result.h5 --report x.pdf'
claim "the inputs are unchanged" cmp tube.yaml designs/tube.yaml
rm tube.yaml
refuses 64 "solve: --fields: 'some' is not a valid choice; use all, last, none or every=N" 'solve --fields some case.h5'
refuses 64 "postprocess: picture.jpg: unknown picture format; use .svg, .png or .pdf" 'postprocess --plot picture.jpg result.h5'
refuses 64 "postprocess: --at: the curve has no 'pressur'; it has pressure, elongation, volume" 'postprocess --at pressur=1kPa result.h5'
refuses 64 "postprocess: --at elongation: '5' has no unit, *; write for example 5 mm" 'postprocess --at elongation=5 result.h5'
refuses 64 "solve: 'x' after -- is not a PETSc option; *" 'solve case.h5 -- x'
refuses 66 "solve: -options_file none.txt: cannot be opened" 'solve case.h5 -- -options_file none.txt'
refuses 64 "solve: PETSc: does not provide the solver *; see *" 'solve -q case.h5 -- -pc_type magic'
# invalid --set: a wrong form is a usage error (64), a wrong value is invalid input (65)
refuses 64 "mesh-gen: --set wall: no '=' in it; write --set key.path=value, *" 'mesh-gen --set wall designs/tube.yaml'
refuses 64 "solve: --set wall: no '=' in it; write --set key.path=value, *" 'solve --set wall case.h5'
refuses 64 "solve: --set geometry.wall: *built into the case *; give the same --set to mesh-gen; *" 'solve --set geometry.wall=2mm case.h5'
refuses 65 "mesh-gen: --set geometry.cpa: unknown key; did you mean 'cap'[?]" 'mesh-gen --set geometry.cpa=5mm designs/tube.yaml'
refuses 65 "solve: --set path.control: 'presure' is not a valid value; did you mean 'pressure'[?]" 'solve --set path.control=presure case.h5'
if [ -n "$(type -P script)" ]; then   # a terminal as stdout or stdin
    terminal() { line="on a terminal: $1"; timeout 200 script -qec "$1" /dev/null </dev/null 2>&1 | tr -d '\r' >"$seen/err"; status=${PIPESTATUS[0]}; }
    for command in 'mesh-gen designs/tube.yaml' 'solve case.h5'; do
        terminal "$command"
        claim "binary data are rejected" exits 64
        claim "the message contains a remedy" says "${command%% *}: <stdout>: binary data is not written to a terminal; use -o FILE or a pipe"
    done
    for command in 'mesh-gen -o x' 'solve -o x' 'postprocess -o x'; do
        terminal "$command"
        claim "a terminal is rejected as input" exits 64
        claim "the message contains a remedy" says "${command%% *}: no input is given and stdin is a terminal; give a file, *"
    done
    terminal 'postprocess -q result.h5'
    claim "text may go to a terminal" exits 0
fi
# names with control characters or line breaks
wild=$'x\e[31m\ny\377'
refuses 66 'solve: x?[[]31m?y?: cannot be opened: *' "solve '$wild'"
refuses 73 'solve: x?[[]31m?y?/a: cannot be created: *' "solve case.h5 -o '$wild/a'"
refuses 64 'postprocess: x?[[]31m?y?: unknown picture format; *' "postprocess result.h5 --plot '$wild'"
refuses 65 'postprocess: x?[[]31m?y?: not an HDF5 file *' "echo text >'$wild'; postprocess '$wild'"
claim "stderr contains no raw control characters" not grep -q "$(printf '[\033\377]')" "$seen/err"
rm "$wild"

# 65: a design. edit changes one value, location prints line:column of the change.
edit() { sed "$1" designs/tube.yaml >edited.yaml; claim "the edit $1 changes the design" not cmp -s designs/tube.yaml edited.yaml; }
location() { awk -v text="$1" '{ at = index($0, text) } at { print NR ":" at; exit }' edited.yaml; }
edit 's/inner_radius: 7 mm/inner_radius: 12 mm/'
refuses 65 "mesh-gen: edited.yaml:$(location '12 mm'): geometry.inner_radius: 12 mm is not smaller than outer_radius (10 mm); *" 'mesh-gen edited.yaml'
edit 's/cap: 5 mm/cpa: 5 mm/'
refuses 65 "mesh-gen: edited.yaml:$(location cpa): geometry.cpa: unknown key; did you mean 'cap'[?]" 'mesh-gen edited.yaml'
edit 's/cap: 5 mm/cap: 5/'
refuses 65 "mesh-gen: edited.yaml:$(location '5   '): geometry.cap: '5' has no unit, a length is needed; write for example 5 mm" 'mesh-gen edited.yaml'
edit 's/cap: 5 mm/cap: 5 kPa/'
refuses 65 "mesh-gen: edited.yaml:$(location '5 kPa'): geometry.cap: '5 kPa' is a pressure where a length is needed; *" 'mesh-gen edited.yaml'
edit 's/cap: 5 mm/cap: 5 ells/'
refuses 65 "mesh-gen: edited.yaml:$(location '5 ells'): geometry.cap: unknown unit 'ells' in a length; *" 'mesh-gen edited.yaml'
edit 's/^  cap: 5 mm/&\n&/'
refuses 65 "mesh-gen: edited.yaml:*: key 'cap' is written twice; the first is at edited.yaml:$(location 'cap: 5')" 'mesh-gen edited.yaml'
edit 's/{quality: normal}/{quality: normal/'
refuses 65 "mesh-gen: edited.yaml:*:*: not YAML: *; see *--template*" 'mesh-gen edited.yaml'
refuses 65 "mesh-gen: <stdin>:*:*: not YAML: *" 'mesh-gen - < edited.yaml'
edit 's/family: tube/family: tub/'
refuses 65 "mesh-gen: edited.yaml:*:9: family: no family is called 'tub'; did you mean 'tube'[?]" 'mesh-gen edited.yaml'
edit 's/fixed: fixed}/}/'
refuses 65 'solve: supports: no support prevents a rigid *; fix a face *' 'mesh-gen -q edited.yaml | solve -q'
refuses 65 'mesh-gen: <stdin>: *empty; *' 'mesh-gen'
refuses 65 'mesh-gen: case.h5:1:1: not UTF-8 text; *' 'mesh-gen case.h5'

# 65: a case or a result
for tool in solve postprocess; do
    file=case.h5
    [ "$tool" = postprocess ] && file=result.h5
    bytes=$(wc -c <"$file")
    refuses 65 "$tool: <stdin>: empty input; check whether the previous program failed" "$tool"
    refuses 65 "$tool: <stdin>: not an HDF5 file *; expected *" "yes | head -c 5000 | $tool"
    refuses 65 "$tool: designs/tube.yaml: not an HDF5 file *; expected *" "$tool designs/tube.yaml"
    refuses 65 "$tool: <stdin>: *; *" "head -c 1 $file | $tool"
    for length in 40 1000 $((bytes / 2)) $((bytes - 1)); do
        refuses 65 "$tool: <stdin>: truncated: *; check whether the program that wrote it was killed or the disk was full" "head -c $length $file | $tool"
    done
    cp "$file" damaged.h5
    printf 'XXXX' | dd of=damaged.h5 bs=1 seek=$((bytes / 3)) conv=notrunc 2>"$seen/dd"
    refuses 65 "$tool: damaged.h5: *; *" "$tool damaged.h5"
done
refuses 65 'postprocess: case.h5: a case without solution; run solve on it' 'postprocess case.h5'
refuses 65 'solve: result.h5:/path: already contains a solution; give solve the case from mesh-gen' 'solve -q result.h5'
refuses 65 'postprocess: --at pressure=99kPa: the path does not reach it; it goes from 0 to * kPa' 'postprocess --at pressure=99kPa result.h5'

# 66: an input that cannot be opened
for tool in mesh-gen solve postprocess sweep-plan; do
    refuses 66 "$tool: absent: cannot be opened: No such file or directory" "$tool absent"
    refuses 66 "$tool: designs: is a folder; name a file" "$tool designs"
done
claim "no file is left" [ "$(echo *)" = 'case.h5 damaged.h5 designs edited.yaml meshes result.h5' ]
