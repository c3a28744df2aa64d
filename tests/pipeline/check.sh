# shellcheck shell=bash
# Shared functions of the test scripts. The first argument of a script is the folder of the tools, the second cmake:
#   . check.sh BIN [CMAKE]
# The script continues in a scratch folder with copies of designs/ and meshes/; the tools are first on PATH. It fails if a claim is
# false, if it makes no claim, or if it stops early. Tested by self_check.sh.
set -uo pipefail
bin=$(realpath "$1")
cmake=${2:-cmake}
here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
work=$(mktemp -d) || exit 1
seen=$work/seen
mkdir "$seen" "$work/run" && cp -R "$here/../../designs" "$here/../../meshes" "$work/run/" && cd "$work/run" || exit 1
export PATH="$bin:$PATH"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
unset NO_COLOR
claims=0
failures=0
status=

finish() {
    local code=$?
    rm -rf "$work"
    if ((failures == 0 && code == 0)); then echo "all $claims claims are true"; else echo "$failures of $claims claims are false"; fi
    ((code == 0 && claims > 0 && failures == 0)) || exit 1
}
trap finish EXIT

run() {   # run COMMAND: runs a shell command without input; sets $status, writes its output to $seen/out and $seen/err
    line=$1
    timeout --kill-after=5 "${LIMIT:-600}" bash -o pipefail -c "$1" >"$seen/out" 2>"$seen/err" </dev/null
    status=$?
}

claim() {   # claim TEXT COMMAND...: the command must succeed
    claims=$((claims + 1))
    "${@:2}" && return
    failures=$((failures + 1))
    printf 'NOT TRUE: %s\n  after: %s\n  exit code %s; stderr:\n' "$1" "${line:-}" "$status"
    tail -n 5 "$seen/err" 2>/dev/null | cut -c1-500 | sed 's/^/  | /'
    if [ -n "${FAIL_FAST:-}" ]; then exit 1; fi
}

runs() {   # runs COMMAND: it must exit with 0
    run "$1"
    claim "it runs" exits 0
}

refuses() {   # refuses CODE PATTERN COMMAND: expects this exit code, an empty stdout and one line on stderr that matches PATTERN
    run "$3"
    claim "the exit code is $1" exits "$1"
    claim "stdout is empty" [ ! -s "$seen/out" ]
    claim "the one line on stderr is: $2" says "$2"
}

needs() {   # needs PROGRAM PACKAGE: ends the script where the program is not installed
    [ -n "$(type -P "$1")" ] && return
    echo "skipped: $1 (package $2) is not installed"
    claim "$1 is missing" [ ! -x "$(type -P "$1")" ]
    exit 0
}

exits() { [ "$status" -eq "$1" ]; }
quiet() { [ ! -s "$seen/err" ]; }
says() { [ "$(wc -l <"$seen/err")" -eq 1 ] && like "$(cat "$seen/err")" "$1"; }
# shellcheck disable=SC2053  # the right-hand side is a pattern
like() { [[ $1 == $2 ]]; }
not() { ! "$@"; }
within() { awk -v x="$1" -v low="$2" -v high="$3" 'BEGIN { exit !(x ~ /^[-+.0-9]/ && x >= low && x <= high) }'; }   # X LOW HIGH

json() { "$cmake" -D "FILE=$PWD/$1" -D "KEYS=$(IFS=';'; echo "${*:2}")" -P "$here/json.cmake"; }   # json FILE KEY...: prints the value
has() { local value; value=$(json "${@:2}") && like "$value" "$1"; }   # has PATTERN FILE KEY...

column() {   # column NAME FILE.csv: prints the values of the column
    awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i; if (!c) exit 1; next } { print $c }' "$2"
}
table() {   # table FILE.csv: has a header and at least two rows with the same number of finite numbers
    awk -F, 'NR == 1 { n = NF; if ($0 !~ /^step,(time_s,)?(cycle,)?(stage,)?(pressure_kPa|traction_kPa|load_N|load_factor),.*,stable(,stable_under_control)?$/ && $0 !~ /^step,time_s,.*,kinetic_energy_mJ,.*,min_J$/) bad = 1; next }
             { if (NF != n) bad = 1; for (i = 1; i <= NF; ++i) if ($i !~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) bad = 1 }
             END { exit bad || NR < 3 }' "$1"
}
rod_and_post() {   # writes pressed.yaml: a post moves toward the end of a rod and bends it
    cat >pressed.yaml <<'END'
family: rod
geometry: {length: 50 mm, height: 10 mm, width: 10 mm}
mesh: {size: 10 mm}
model: half
material: {law: neo-hookean, mu: 0.1644 MPa}
supports: {fixed: fixed}
obstacles:
  post: {cylinder: {point: [45 mm, 0 mm, -6 mm], axis: [0, 1, 0], radius: 5 mm}}
loads:
  post: {displacement: 2 mm, along: z}
outputs:
  push: {obstacle: post, measure: force, along: z}
  rise: {face: end, along: z}
END
}
near() {   # near A.csv B.csv TOLERANCE: same header and rows; all columns agree relative to the maximum of the column
    awk -F, -v tolerance="$3" '
        { if (NF != fields && NR > 1) bad = 1; fields = NF }
        NR == FNR { line[FNR] = $0; rows = FNR
                    if (FNR > 1) for (i = 1; i <= NF; ++i) { size = $i < 0 ? -$i : +$i; if (size > largest[i]) largest[i] = size }
                    next }
        FNR == 1 { if ($0 != line[1]) bad = 1 }
        FNR > 1 {
            split(line[FNR], a)
            for (i = 1; i <= NF; ++i) {
                ++compared
                if (a[i] !~ /^[-+.0-9]/ || $i !~ /^[-+.0-9]/) bad = 1   # nan
                off = a[i] < $i ? $i - a[i] : a[i] - $i
                if (!(off <= tolerance * largest[i])) { bad = 1; print "row " FNR - 1 ", column " i ": " a[i] " and " $i }
            }
        }
        END { exit bad || !compared || FNR != rows }' "$1" "$2"
}
agree() {   # agree A.csv B.csv TOLERANCE [COLUMN...]: same header and rows; all or the given columns agree relative to each value
    awk -F, -v tolerance="$3" -v only=" ${*:4} " '
        NR == FNR { line[FNR] = $0; rows = FNR; next }
        FNR == 1 { if ($0 != line[1]) bad = 1; for (i = 1; i <= NF; ++i) name[i] = $i }
        FNR > 1 {
            if (split(line[FNR], a) != NF) bad = 1
            for (i = 1; i <= NF; ++i) {
                if (only !~ /^ +$/ && index(only, " " name[i] " ") == 0) continue
                ++compared
                if (a[i] !~ /^[-+.0-9]/ || $i !~ /^[-+.0-9]/) bad = 1   # nan
                size = a[i] < 0 ? -a[i] : +a[i]
                off = a[i] < $i ? $i - a[i] : a[i] - $i
                if (!(off <= tolerance * size)) { bad = 1; print "row " FNR - 1 ", " name[i] ": " a[i] " and " $i }
            }
        }
        END { exit bad || !compared || FNR != rows }' "$1" "$2"
}
