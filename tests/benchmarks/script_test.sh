#!/usr/bin/env bash
# Tests the command line and the output of scripts/benchmark, not the measured values.   script_test.sh TREE BIN
# shellcheck disable=SC2317  # claim calls the check functions
# The script runs in a copy, so that existing results in the tree are kept.
set -uo pipefail
tree=$(realpath "$1")
bin=$(realpath "$2")
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/tree" "$work/build"
cp -R "$tree/scripts" "$tree/designs" "$work/tree/"
ln -s "$bin" "$work/build/bin"
unset KRAKEN_MESHES PEERS RUNS
export BUILD_DIR=$work/build
failures=0

run() { output=$("$work/tree/scripts/benchmark" "$@" 2>"$work/err" </dev/null); status=$?; }
claim() {   # claim TEXT COMMAND...: the command must succeed
    if ! "${@:2}"; then
        printf 'NOT TRUE: %s\n--- exit %s; stdout:\n%s\n--- stderr:\n%s\n' "$1" "$status" "$output" "$(cat "$work/err")"
        failures=$((failures + 1))
    fi
}
exits() { [[ $status -eq $1 ]]; }
prints() { [[ $output == *"$1"* ]]; }
reports() { grep -qF -- "$1" "$work/err"; }
table() { cat "$work"/tree/results/benchmarks/*.csv; }
figure() { table | awk -F, -v what="$1" '$1 == "start" && $2 == what && $3 > 0 && $4 == "CPU s" && $5 == 2 && $6 <= $3 && $3 <= $7 { found = 1 } END { exit !found }'; }

run --help
claim "--help succeeds" exits 0
for group in start bellows sensitivities cyclic kernels ranks rod solid size finger sweep; do claim "and lists the group $group" prints "$group  "; done
run speed
claim "an unknown group is a usage error" exits 64
claim "that lists the groups" reports 'start bellows sensitivities cyclic kernels ranks rod solid size finger sweep'

RUNS=2 run start
claim "the group start succeeds" exits 0
for tool in mesh-gen solve postprocess; do claim "$tool has a row" figure "$tool starts"; done
claim "the BLAS is printed" prints 'BLAS: '
claim "the file has a header" grep -q '^group,what,value,unit,runs,least,most,peer,peer_value,ratio,command,revision,machine,time$' <(table)
RUNS=2 run rod solid
claim "it succeeds without the paper's meshes" exits 0
claim "and reports skipped groups" reports 'rod: skipped because KRAKEN_MESHES is not set'
BUILD_DIR=$work/absent run start
claim "it reports missing tools" reports 'run make build'
claim "and fails" exits 1
((failures == 0)) && echo "all checks passed"
exit $((failures > 0))
