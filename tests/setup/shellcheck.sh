#!/usr/bin/env bash
# Checks every shell script with ShellCheck, and that a planted mistake is detected.   shellcheck.sh SOURCE
set -euo pipefail
cd "$1"
command -v shellcheck >/dev/null || { echo "skipped: shellcheck is not installed"; exit 0; }
# shellcheck disable=SC2016  # planted
if printf '#!/usr/bin/env bash\ncd $1\n' | shellcheck - >/dev/null; then echo "a planted mistake is not detected" >&2; exit 1; fi
mapfile -t scripts < <(grep -rlIE --exclude-dir=.git --exclude-dir='build*' --exclude-dir=results --exclude-dir=node_modules '^#!.*[/ ](bash|sh)$' . |
    xargs awk 'FNR == 1 && /^#!/ { print FILENAME } { nextfile }')
((${#scripts[@]} > 20)) || { echo "only ${#scripts[@]} scripts found" >&2; exit 1; }
shellcheck "${scripts[@]}"
echo "${#scripts[@]} scripts pass"
