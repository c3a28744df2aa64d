#!/usr/bin/env bash
# Measured membranes without rings: the pressures agree with the medians of the measurements.   membranes.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
mkdir scripts && cp "$here"/../../scripts/{measured-membranes,shared.py} scripts/
export LIMIT=300
runs 'scripts/measured-membranes plain'
grep '^| plain' "$seen/out" >rows
claim "every weight has a row" [ "$(wc -l <rows)" -eq 3 ]
while IFS='|' read -r _ name weight heights _ maximum _; do
    claim "$name $weight N: every pressure from 10 mm on is within 6 % of the median ($heights mm)" within "${maximum// /}" 0 6
done <rows
runs 'cp -R meshes before && scripts/measured-membranes --write-meshes && diff -r before meshes'
refuses 64 "measured-membranes: unknown membrane 'thick'; *" 'scripts/measured-membranes thick'
