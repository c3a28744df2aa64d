# shellcheck shell=bash
# What the scripts of this folder share besides pipeline/check.sh:   . check.sh BIN CMAKE
# A script is a section of README.md, a row of the table there is a call of `row` here: neither can be without the other.
faults=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
# shellcheck source=../pipeline/check.sh
. "$faults/../pipeline/check.sh"
script=$(basename "$0")
rows=$work/rows
: >"$rows"

in_table() { grep -qxF -- "$1" <(section); }
section() { awk -v title="## $script" '/^## / { inside = $0 == title } inside && /^[|] / { print }' "$faults/README.md" | tail -n +2; }

# row FAULT TOOL CODE MESSAGE SURVIVES COMMAND: a line of the table. In a new folder `place` the COMMAND ends with CODE, and its one
# line on stderr is `TOOL: MESSAGE`, a pattern (- : none). SURVIVES is one of those of `survives`; what it is about is place/out.
row() {
    listed "$1" "$2" "$3" "$4" "$5"
    rm -rf place
    mkdir place
    if [ "$5" = 'the old file' ]; then echo precious >place/out; fi
    run "$6"
    claim "$1, $2: the exit code is one of: $3" any_code "$3"
    if [ "$4" = - ]; then claim "$1, $2: nothing is said" quiet; else claim "$1, $2: it says: $4" says "$2: $4"; fi
    claim "$1, $2: what survives: $5" survives "$5"
}
listed() {   # listed FAULT TOOL CODE MESSAGE SURVIVES: the line of the table alone, for claims of another kind
    local text="| $1 | $2 | $3 | ${4//|/\\|} | $5 |"
    echo "$text" >>"$rows"
    if [ -z "${FAULTS_TABLE:-}" ]; then claim "the table of README.md has: $text" in_table "$text"; fi
}
any_code() { local code; for code in ${1//,/ }; do if exits "$code"; then return 0; fi; done; return 1; }
survives() {
    case $1 in
        nothing) [ "$(ls -A place)" = '' ] ;;
        'the old file') [ "$(ls -A place)" = out ] && [ "$(cat place/out)" = precious ] ;;
        'the whole curve') [ "$(ls -A place)" = out ] && postprocess -q place/out -o part.csv && cmp -s part.csv whole.csv ;;
        'a whole case') [ "$(ls -A place)" = out ] && solve -q place/out --set path.until.steps=1 -o solved 2>"$seen/post" ;;
        'the curve') [ "$(ls -A place)" = out ] && cmp -s place/out whole.csv ;;
        -) ;;
        'the rows reached') [ "$(ls -A place)" = out ] && first_rows place/out ;;
        *) return 1 ;;
    esac
}
first_rows() {   # FILE can be read and holds the first rows of whole.csv, be it none
    postprocess -q "$1" -o part.csv 2>"$seen/post" || return
    [ "$(wc -l <part.csv)" -eq 1 ] || cmp -s part.csv <(head -n "$(wc -l <part.csv)" whole.csv)
}
# At the end of a script: the table has no other rows. FAULTS_TABLE=FILE: writes the rows there instead.
table_is_whole() {
    if [ -n "${FAULTS_TABLE:-}" ]; then { echo "## $script"; cat "$rows"; } >>"$FAULTS_TABLE"; return; fi
    claim "the table of README.md has these rows and no other" cmp -s "$rows" <(section)
}
