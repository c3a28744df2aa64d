#!/usr/bin/env bash
# Checks that docs/developer/modules.svg is what scripts/module-graph draws from the code.   module_graph.sh TREE
set -euo pipefail
drawn=$(mktemp)
trap 'rm -f "$drawn"' EXIT
"$1/scripts/module-graph" "$drawn"
cmp "$1/docs/developer/modules.svg" "$drawn" || { echo "docs/developer/modules.svg is out of date; run scripts/module-graph" >&2; exit 1; }
