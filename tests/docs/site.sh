#!/usr/bin/env bash
# Builds the site of docs/ in a scratch folder and checks some of its pages.   site.sh TREE
set -euo pipefail
command -v mkdocs >/dev/null || { echo "skipped: mkdocs is not installed"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
BUILD_DIR=$work "$1/scripts/docs-site"
cd "$work/site"
pages=$(find . -name '*.html' | wc -l)
((pages > 30)) || { echo "only $pages pages" >&2; exit 1; }
# Markdown that the generator did not understand is left in the text of a page.
if find . -name '*.html' -exec awk '
        /<pre/ { code = 1 }
        !code && /^ *<p>(```|[|] ?-|[-*] )|^[-*] .|^[|].*[|]$/ { print FILENAME ": " $0 }
        /<[/]pre>/ { code = 0 }' {} + | grep .; then
    echo "a table, list or block above is not rendered; separate it from the text by an empty line, and place blocks outside lists" >&2
    exit 1
fi
