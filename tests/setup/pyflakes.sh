#!/usr/bin/env bash
# Checks every Python script with pyflakes, and that a planted mistake is detected.   pyflakes.sh SOURCE
set -euo pipefail
cd "$1"
command -v pyflakes3 >/dev/null || { echo "skipped: pyflakes3 is not installed"; exit 0; }
if pyflakes3 <<<'print(absent)' >/dev/null; then echo "a planted mistake is not detected" >&2; exit 1; fi
mapfile -t scripts < <(find scripts tests -name '*.py'; grep -rlIE '^#!.*python3' scripts tests)
((${#scripts[@]} > 10)) || { echo "only ${#scripts[@]} scripts found" >&2; exit 1; }
pyflakes3 "${scripts[@]}"
echo "${#scripts[@]} scripts pass"
