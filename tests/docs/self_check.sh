#!/usr/bin/env bash
# shellcheck disable=SC2016  # the backticks are fences
# Checks that run_blocks.sh detects failures, with small documents of known outcome.
set -uo pipefail
runner=$(dirname "$(realpath "$0")")/run_blocks.sh
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
mkdir bin data
printf '#!/bin/sh\necho "x y"\n' >bin/say-xy && chmod +x bin/say-xy
echo content >data/file
document=README.md
failures=0

expect() {   # expect passes|fails WORDS-OF-THE-OUTPUT DOCUMENT-TEXT
    printf '%b' "$3" >"$document"
    local output outcome=passes
    output=$(bash "$runner" "$document" bin data 2>&1) || outcome=fails
    if [[ $outcome != "$1" || $output != *"$2"* ]]; then
        printf '%s instead of %s, wanted "%s" in:\n%s\n--- of the document:\n%b\n' "$outcome" "$1" "$2" "$output" "$3"
        failures=$((failures + 1))
    fi
}

expect passes '2 blocks run' 'Text\n```sh\nsay-xy | grep x >out\ncat data/file\n```\nmore\n```sh\ntest -s out\n```\n'
expect fails 'FAILED with exit code 3' '```sh\n(exit 3)\necho later\n```\n'
expect fails 'FAILED with exit code 1' '```sh\nfalse | cat\n```\n'
expect fails 'FAILED with exit code 127' '```sh\nno-such-tool\n```\n'
expect fails '2 blocks run, 1 failed' '```sh\nfalse\n```\n```sh\ntrue\n```\n'
expect passes '1 blocks run' '<!-- not run: needs a cluster -->\n```sh\nfalse\n```\n```sh\ntrue\n```\n'
expect passes 'not run: needs a cluster' '<!-- not run: needs a cluster -->\n\n```sh\nfalse\n```\n```sh\ntrue\n```\n'
expect fails '1 failed' '<!-- not run: far away -->\ntext between\n```sh\nfalse\n```\n'
expect fails 'without a reason' '<!-- not run: -->\n```sh\nfalse\n```\n```sh\ntrue\n```\n'
expect fails 'never closed' '```sh\ntrue\n'
expect fails '0 blocks run' 'no block\n```yaml\nfamily: rod\n```\n'
expect passes '1 blocks run' '```yaml\na: 1\n```\n```sh\ntrue\n```\n```text\nfalse\n```\n'
document=page.md
expect passes '0 blocks run' 'no block\n'
expect fails '1 failed' '```sh\nfalse\n```\n'
((failures == 0)) && echo "every document came out as expected"
exit $((failures > 0))
