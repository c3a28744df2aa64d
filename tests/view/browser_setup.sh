# shellcheck shell=bash
# Set-up of the browser tests: . browser_setup.sh BIN WORK PROGRAM...      WORK: folder for the pinned npm packages, the working directory
# Exits with 77 (skipped) if a program, node, npm or a Chromium is missing.
set -u -o pipefail
bin=$1 work=$2 here=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
skip() { echo "skipped: $1"; exit 77; }
for program in node npm "${@:3}"; do [ -n "$(type -P "$program")" ] || skip "$program is not installed"; done
CHROMIUM=${CHROMIUM:-$(type -P chromium || type -P chromium-browser || type -P google-chrome)} || skip "no Chromium is installed"
export CHROMIUM PATH="$bin:$PATH"
mkdir -p "$work" && cp "$here"/browser/* "$work" && cd "$work" || exit 1
npm ci --ignore-scripts --no-audit --no-fund --prefer-offline --fetch-retries=1 >npm.log 2>&1 || skip "npm could not fetch puppeteer-core"
