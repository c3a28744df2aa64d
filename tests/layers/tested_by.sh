#!/bin/sh
# Checks that every test named in a header of lib/ ("Tested by module/name_test") exists.
#   tested_by.sh SOURCE_DIR
cd "$1" || exit 1
named=$(grep -rhoE '[a-z_]+/[a-z_]+_test\b' lib --include='*.hpp' | sort -u)
[ -n "$named" ] || { echo "no header names a test"; exit 1; }
status=0
for test in $named; do
    [ -f "tests/$test.cpp" ] && continue
    echo "tests/$test.cpp does not exist; named in $(grep -rlF "$test" lib --include='*.hpp' | tr '\n' ' ')"
    status=1
done
exit $status
