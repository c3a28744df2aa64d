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

# The force on a jaw of a pair, across the symmetry plane, is that on one of two jaws; along the plane it is that on both.
jaw() { printf '{box: {from: [30 mm, -20 mm, %s mm], to: [60 mm, 20 mm, %s mm], radius: 3 mm}}' "$1" "$2"; }
rod='family: rod
geometry: {length: 40 mm, width: 10 mm, height: 10 mm}
material: {law: neo-hookean, mu: 0.1 MPa, kappa: incompressible}
mesh: {size: 2.5 mm}
outputs: {grip: {obstacle: jaw, measure: force, along: z}, pull: {obstacle: jaw, measure: force, along: x}}'
printf '%s\nmodel: quarter\nobstacles: {jaw: %s}\nloads: {jaw: {displacement: -0.5 mm, along: z}}\n' "$rod" "$(jaw 5.1 15)" >one.yaml
printf '%s\nmodel: half\nobstacles: {jaw: %s, low: %s}\nloads: {jaw: {displacement: -0.5 mm, along: z}, low: {displacement: 0.5 mm, along: z}}\n' \
    "$rod" "$(jaw 10.1 20)" "$(jaw -10 -0.1)" >two.yaml
for jaws in one two; do runs "mesh-gen -q $jaws.yaml | solve -q | postprocess -q -o $jaws.csv"; done
share() { awk -v a="$(column "$1" one.csv | tail -n 1)" -v b="$(column "$1" two.csv | tail -n 1)" 'BEGIN { print a / b }'; }
claim "the grip of a jaw is that of the model with both" within "$(share grip_N)" 0.999999 1.000001
claim "the pull is that of both jaws" within "$(share pull_N)" 1.99999 2.00001
