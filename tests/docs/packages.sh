#!/bin/sh
# Checks that docs/guides/install.md names every package of scripts/setup for each system.   packages.sh TREE
cd "$1" || exit 1
page=docs/guides/install.md
missing=0
for system in debian fedora homebrew; do
    names=$(scripts/setup --list "$system") || exit 1
    [ -n "$names" ] || { echo "scripts/setup --list $system names nothing"; missing=1; }
    for name in $names; do
        grep -qwF -- "$name" "$page" || { echo "$page does not name $name ($system)"; missing=1; }
    done
done
exit "$missing"
