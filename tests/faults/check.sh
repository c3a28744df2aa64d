# shellcheck shell=bash
# Shared functions of the scripts of this folder, in addition to pipeline/check.sh:   . check.sh BIN CMAKE
# Each script corresponds to a section of README.md, and each call of `row` to a row of its table; both are checked.
faults=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
# shellcheck source=../pipeline/check.sh
. "$faults/../pipeline/check.sh"
script=$(basename "$0")
rows=$work/rows
: >"$rows"

in_table() { grep -qxF -- "$1" <(section); }
section() { awk -v title="## $script" '/^## / { inside = $0 == title } inside && /^[|] / { print }' "$faults/README.md" | tail -n +2; }

# row FAULT TOOL CODE MESSAGE SURVIVES COMMAND: a row of the table. COMMAND, with a new folder `place`, must end with CODE and print one
# line on stderr that matches `TOOL: MESSAGE` (-: no line). SURVIVES is a case of `survives` and describes place/out.
row() {
    listed "$1" "$2" "$3" "$4" "$5"
    rm -rf place
    mkdir place
    if [ "$5" = 'the old file' ]; then echo precious >place/out; fi
    run "$6"
    claim "$1, $2: the exit code is one of: $3" any_code "$3"
    if [ "$4" = - ]; then claim "$1, $2: no message is printed" quiet; else claim "$1, $2: the message is: $4" says "$2: $4"; fi
    claim "$1, $2: remaining file: $5" survives "$5"
}
listed() {   # listed FAULT TOOL CODE MESSAGE SURVIVES: only the row of the table; the caller makes its own claims
    local text="| $1 | $2 | $3 | ${4//|/\\|} | $5 |"
    echo "$text" >>"$rows"
    if [ -z "${FAULTS_TABLE:-}" ]; then claim "the table of README.md contains: $text" in_table "$text"; fi
}
any_code() { local code; for code in ${1//,/ }; do if exits "$code"; then return 0; fi; done; return 1; }
survives() {
    case $1 in
        nothing) [ "$(ls -A place)" = '' ] ;;
        'the old file') [ "$(ls -A place)" = out ] && [ "$(cat place/out)" = precious ] ;;
        'the whole curve') [ "$(ls -A place)" = out ] && postprocess -q place/out -o part.csv && cmp -s part.csv whole.csv ;;
        'a complete case') [ "$(ls -A place)" = out ] && solve -q place/out --set path.until.steps=1 -o solved 2>"$seen/post" ;;
        'the curve') [ "$(ls -A place)" = out ] && cmp -s place/out whole.csv ;;
        -) ;;
        'the converged rows') [ "$(ls -A place)" = out ] && first_rows place/out ;;
        *) return 1 ;;
    esac
}
first_rows() {   # first_rows FILE: FILE is readable and contains the first rows of whole.csv, or none
    postprocess -q "$1" -o part.csv 2>"$seen/post" || return
    [ "$(wc -l <part.csv)" -eq 1 ] || cmp -s part.csv <(head -n "$(wc -l <part.csv)" whole.csv)
}
# Call at the end of a script: the table has no other rows. With FAULTS_TABLE=FILE writes the rows to FILE instead.
table_is_complete() {
    if [ -n "${FAULTS_TABLE:-}" ]; then { echo "## $script"; cat "$rows"; } >>"$FAULTS_TABLE"; return; fi
    claim "the table of README.md has exactly these rows" cmp -s "$rows" <(section)
}
