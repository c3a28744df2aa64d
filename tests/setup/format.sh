#!/usr/bin/env bash
# Every C++ file has the form that `make format` gives, and a file that has it not is found.   format.sh SOURCE
set -euo pipefail
cd "$1"
# Releases of clang-format differ in what they give; this is Debian 12's.
format=$(command -v clang-format-14) || { echo "skipped: clang-format-14 is not installed"; exit 0; }
if "$format" --dry-run --Werror --assume-filename=lib/a.cpp <<<'int  a ;' 2>/dev/null; then echo "a planted fault is not found" >&2; exit 1; fi
mapfile -t files < <(find lib tools tests -name '*.cpp' -o -name '*.hpp' | sort)
((${#files[@]} > 500)) || { echo "only ${#files[@]} files found" >&2; exit 1; }
"$format" --dry-run --Werror "${files[@]}"
echo "${#files[@]} files have it"
