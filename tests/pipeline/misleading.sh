#!/usr/bin/env bash
# Checks the messages in the table of tests/catalogue/README.md, and that valid designs cause no warnings.
#   misleading.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
catalogue=$here/../catalogue
mkdir tests && cp -R "$catalogue" tests/ && cd tests/catalogue || exit 1

said_by() { grep -F -e "$2" "$seen/err" | grep -q "^$1: "; }   # said_by PROGRAM WORDS: the program has printed a line with these words
rows=0
while IFS='|' read -r _ design _ program code words _; do
    design=${design##*(}
    design=${design%%.yaml*}
    read -r program <<<"$program"
    read -r code <<<"$code"
    words=$(sed 's/^ *//; s/ *$//' <<<"$words")
    rows=$((rows + 1))
    if [ "$program" = solve ]; then
        runs "mesh-gen -q $design.yaml -o case.h5"
        run 'solve case.h5 -o result.h5'
    else
        run "mesh-gen $design.yaml -o case.h5"
    fi
    claim "$design: exit code $code" exits "$code"
    claim "$design: $program prints '$words'" said_by "$program" "$words"
done < <(grep '^| \[' README.md)
claim "the table has at least forty rows" [ "$rows" -ge 40 ]
claim "the table has one row per design" [ "$rows" -eq "$(find . -name '*.yaml' | wc -l)" ]

# Valid designs cause no warnings
cd "$work/run" || exit 1
for design in designs/*.yaml; do
    [[ $design == designs/finger-at-plate.yaml ]] && continue   # its mesh is coarse, so that it runs in seconds, and the warning is right
    run "mesh-gen --check $design"
    claim "$design causes no warning" not grep -q warning "$seen/err"
done
for design in rod panel ring sphere dome tube fiber-tube revolved; do
    run "mesh-gen -q designs/$design.yaml | solve -o result.h5"
    claim "the path of $design causes no warning" not grep -q warning "$seen/err"
done
