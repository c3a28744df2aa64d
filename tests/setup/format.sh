#!/usr/bin/env bash
# Checks that every C++ file is formatted as by `make format`, and that an unformatted file is detected.   format.sh SOURCE
set -euo pipefail
cd "$1"
# Releases of clang-format give different results; Debian 12 has 14.
format=$(command -v clang-format-14) || { echo "skipped: clang-format-14 is not installed"; exit 0; }
if "$format" --dry-run --Werror --assume-filename=lib/a.cpp <<<'int  a ;' 2>/dev/null; then echo "a planted error is not detected" >&2; exit 1; fi
mapfile -t files < <(find lib tools tests -name '*.cpp' -o -name '*.hpp' | sort)
((${#files[@]} > 500)) || { echo "only ${#files[@]} files found" >&2; exit 1; }
"$format" --dry-run --Werror "${files[@]}"
echo "${#files[@]} files are formatted"
