#!/usr/bin/env bash
# The half of a segment against the whole: the same curve, and when mesh-gen uses which.   halves.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
segment() { printf 'mesh-gen -q designs/segment.yaml --set mesh.quality=draft --set geometry.length=40mm --set path.until.pressure=4kPa %s' "$*"; }

for chambers in 2 3; do
    runs "$(segment "--set geometry.chambers=$chambers") | solve -q -o half.h5 && postprocess -q half.h5 -o half.csv"
    runs "$(segment "--set geometry.chambers=$chambers --set model=solid") | solve -q -o whole.h5 && postprocess -q whole.h5 -o whole.csv"
    runs "postprocess -q half.h5 --check whole.csv --rtol 1e-6 --atol sideways=1e-6deg --atol stretch_p99=1e-4"   # a quantile of points
done
cells() { mesh-gen "$@" --json - -o x.h5 2>/dev/null | grep -o '"cells": *[0-9]*'; }
claim "the half has half of the cells" [ "$(cells designs/segment.yaml | tr -dc 0-9)" -eq "$(($(cells designs/segment.yaml --set model=solid | tr -dc 0-9) / 2))" ]
