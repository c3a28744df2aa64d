#!/usr/bin/env bash
# Runs an unchanged design of designs/ through the three tools.   design.sh BIN CMAKE NAME
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
case $3 in pneunet | segment | imported-part) export LIMIT=800 ;; esac   # solids
run "mesh-gen designs/$3.yaml --json mesh.json -o case.h5 && solve case.h5 --json solve.json | postprocess --json curve.json -o curve.csv"
claim "the exit code is 0" exits 0
claim "stdout is empty" [ ! -s "$seen/out" ]
claim "every message starts with the name of its tool" not grep -qvE '^(mesh-gen|solve|postprocess): ' "$seen/err"
claim "the curve is a table" table curve.csv
claim "the stop reason is as expected" has "done" solve.json stop_reason
claim "postprocess reports the same reason" has "done" curve.json stop_reason
claim "the curve contains each step and the undeformed state" [ "$(json solve.json steps)" = "$(column step curve.csv | tail -n 1)" ]
claim "the mesh has cells" within "$(json mesh.json cells)" 1 1e9
claim "no cell is badly shaped" within "$(json mesh.json min_scaled_jacobian)" 0.1 1
claim "no cell is inverted" within "$(column min_J curve.csv | sort -g | head -n 1)" 0.1 1
if [ "$3" = pneunet ]; then   # 12.52 is extrapolated from the mesh study in the design file
    claim "the bend agrees with fine meshes within 1 %" within "$(column bend_deg curve.csv | tail -n 1)" 12.395 12.645
fi
claim "there is no negative zero" not grep -qE '(^|,)-0(,|$)' curve.csv
