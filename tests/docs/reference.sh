#!/usr/bin/env bash
# Checks that docs/reference is what scripts/reference-pages generates from the programs.   reference.sh TREE BUILD
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
BUILD_DIR=$(realpath "$2") "$1/scripts/reference-pages" "$work"
diff -ru "$1/docs/reference" "$work" || { echo "docs/reference differs from the programs; run scripts/reference-pages" >&2; exit 1; }
