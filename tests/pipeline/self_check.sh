#!/usr/bin/env bash
# shellcheck disable=SC2016  # the scripts expand their own variables
# Checks that the claims of check.sh can fail, with small scripts of known outcome and stand-ins for the tools.
#   self_check.sh CMAKE
set -uo pipefail
here=$(dirname "$(realpath "$0")")
cmake=$1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin" "$work/idle" "$work/broken"
failures=0

printf '#!/bin/sh\necho "tool: a: wrong; right" >&2; exit 65\n' >"$work/bin/refusing"
printf '#!/bin/sh\necho data; echo "tool: a: wrong; right" >&2; exit 65\n' >"$work/bin/talking"
printf '#!/bin/sh\necho "tool: a: wrong; right" >&2; echo trace >&2; exit 65\n' >"$work/bin/tracing"
printf '#!/bin/sh\necho "step,pressure_kPa,x_mm,stable"; echo "0,0,0,1"; echo "1,10,${1:-2},1"\n' >"$work/bin/curve"
for tool in mesh-gen solve postprocess; do   # idle does nothing, broken always fails
    printf '#!/bin/sh\nexit 0\n' >"$work/idle/$tool"
    printf '#!/bin/sh\necho "x: y; z" >&2; exit 65\n' >"$work/broken/$tool"
done
chmod +x "$work"/bin/* "$work"/idle/* "$work"/broken/*

expect() {   # expect passes|fails SCRIPT
    printf '. %s/check.sh "$1" "$2"\n%s\n' "$here" "$2" >"$work/script.sh"
    local output outcome=passes
    output=$(FAIL_FAST='' bash "$work/script.sh" "$work/bin" "$cmake" 2>&1) || outcome=fails
    if [[ $outcome != "$1" ]]; then
        printf '%s instead of %s:\n%s\n--- output:\n%s\n' "$outcome" "$1" "$2" "$output"
        failures=$((failures + 1))
    fi
}

expect passes 'claim "true" true'
expect fails 'claim "false" false'
expect fails 'claim "false" false; claim "true" true'
expect fails 'echo "no claim"'
expect fails 'claim "true" true; exit 3'
expect fails 'claim "true" true; echo "$no_such_variable"'
expect fails 'claim "true" true; if'

expect passes 'runs true'
expect fails 'runs false'
expect fails 'runs "false | true"'
expect fails 'LIMIT=1; runs "sleep 20"'
expect fails 'runs no-such-tool'

expect passes 'refuses 65 "tool: a: wrong; *" refusing'
expect fails 'refuses 64 "tool: a: wrong; *" refusing'
expect fails 'refuses 65 "tool: b: wrong; *" refusing'
expect fails 'refuses 65 "wrong" refusing'
expect fails 'refuses 65 "tool: a: wrong; *" talking'
expect fails 'refuses 65 "tool: a: wrong; *" tracing'
expect fails 'refuses 0 "*" true'

expect passes 'runs "curve > a"; claim "table" table a'
expect fails 'runs "curve nan > a"; claim "table" table a'
expect fails 'runs "curve 1,2 > a"; claim "table" table a'
expect fails 'runs "curve | head -n 2 > a"; claim "table" table a'
expect passes 'runs "curve > a"; claim "column" [ "$(column x_mm a | xargs)" = "0 2" ]'
expect passes 'runs "curve > a; curve 2.0000000001 > b"; claim "agree" agree a b 1e-8'
expect fails 'runs "curve > a; curve 2.0000001 > b"; claim "agree" agree a b 1e-8'
expect passes 'runs "curve > a; curve 3 > b"; claim "agree" agree a b 1e-8 step pressure_kPa'
expect fails 'runs "curve > a; curve 3 > b"; claim "agree" agree a b 1e-8 x_mm'
expect fails 'runs "curve > a; curve > b"; claim "agree" agree a b 1e-8 no_such_column'
expect fails 'runs "curve > a; curve nan > b"; claim "agree" agree a b 1e-8'
expect fails 'runs "curve > a; curve | head -n 2 > b"; claim "agree" agree a b 1e-8'
expect fails 'runs "curve | head -n 2 > a; curve > b"; claim "agree" agree a b 1e-8'
expect fails 'runs "curve > a; curve | sed s/x_mm/y_mm/ > b"; claim "agree" agree a b 1e-8'
expect fails 'runs "curve > a; : > b"; claim "agree" agree a b 1e-8'

expect passes 'runs "curve > a; curve 2.0000000001 > b"; claim "near" near a b 1e-8'
expect fails 'runs "curve > a; curve 2.0000001 > b"; claim "near" near a b 1e-8'
expect passes 'printf "x\\n1\\n1e-12\\n" >a; printf "x\\n1\\n-1e-12\\n" >b; claim "near" near a b 1e-10'
expect fails 'printf "x\\n1e-12\\n" >a; printf "x\\n-1e-12\\n" >b; claim "near" near a b 1e-10'
expect fails 'runs "curve > a; curve nan > b"; claim "near" near a b 1e-8'
expect fails 'runs "curve > a; curve 2,2 > b"; claim "near" near a b 1e-8'
expect fails 'runs "curve > a; curve | head -n 2 > b"; claim "near" near a b 1e-8'
expect fails 'runs "curve | head -n 2 > a; curve > b"; claim "near" near a b 1e-8'
expect fails 'runs "curve > a; curve | sed s/x_mm/y_mm/ > b"; claim "near" near a b 1e-8'
expect fails 'runs "curve > a; : > b"; claim "near" near a b 1e-8'

expect passes 'claim "in" within 5 4 6'
expect fails 'claim "out" within 7 4 6'
expect fails 'claim "nothing" within "" -1 1'
expect fails 'claim "no number" within nan -1 1'
expect passes 'echo "{\"a\": {\"b\": [1, 2]}}" > j; claim "json" has 2 j a b 1'
expect fails 'echo "{\"a\": {\"b\": [1, 2]}}" > j; claim "json" has 3 j a b 1'
expect fails 'echo "{\"a\": 2" > j; claim "json" has 2 j a'
expect fails 'echo "{\"a\": 2}" > j; claim "json" has "*" j b'
expect fails 'claim "json" has "*" absent a'

# Every script must fail with tools that do nothing or always fail, except if it is skipped because a program is missing.
for script in "$here"/*.sh "$here"/../faults/*.sh; do
    name=$(basename "$script")
    case $name in check.sh | self_check.sh) continue ;; esac
    for kind in idle broken; do
        if FAIL_FAST=1 bash "$script" "$work/$kind" "$cmake" tube >"$work/output" 2>&1 &&
            ! grep -q '^skipped: ' "$work/output"; then
            echo "$name passes with tools that are $kind"
            failures=$((failures + 1))
        fi
    done
done
((failures == 0)) && echo "every script had the expected outcome"
exit $((failures > 0))
