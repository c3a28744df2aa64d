#!/usr/bin/env bash
# shellcheck disable=SC2016  # the backticks are fences
# Checks the links of all Markdown pages, and that the checker detects planted faults.   links.sh TREE
set -euo pipefail
tree=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/scripts" "$work/docs/guides"
cp "$tree/scripts/docs-site" "$work/scripts/"
failures=0

expect() {   # expect passes|fails WORDS-OF-THE-OUTPUT PAGE-TEXT
    printf '%b' "$3" >"$work/docs/page.md"
    local output outcome=passes
    output=$("$work/scripts/docs-site" --check 2>&1) || outcome=fails
    if [[ $outcome != "$1" || $output != *"$2"* ]]; then
        printf '%s instead of %s, wanted "%s" in: %s\n--- of the page:\n%b\n' "$outcome" "$1" "$2" "$output" "$3"
        failures=$((failures + 1))
    fi
}

printf '# The `x` guide (1)\n\n## Two words\n' >"$work/docs/guides/x.md"
expect passes '3 links, 0 broken' '[a](guides/x.md) [b\nc](guides/x.md#the-x-guide-1) ![d](../docs/guides/x.md#two-words)\n'
expect passes '1 links, 0 broken' '# Own\n[a](#own) [outside](https://example.org/x#y)\n'
expect fails 'docs/page.md:3: guides/y.md: no such file' 'a\n\n[a](guides/y.md)\n'
expect fails 'docs/page.md:2: pictures/p.svg: no such file' '\n![a](pictures/p.svg)\n'
expect fails 'guides/x.md#three: no such heading' '[a\nb](guides/x.md#three)\n'
expect fails '#own: no such heading' '```text\n# own\n```\n[a](#own)\n'
expect fails 'names this heading differently' '## A - b\n[a](#a---b)\n'
expect fails '1 links, 1 broken' '[a]: nowhere.md\n'
expect passes '0 links' '`[a](nowhere.md)` and\n\n```sh\n[a](nowhere.md)\n```\n'
((failures == 0)) || exit 1
exec "$tree/scripts/docs-site" --check
