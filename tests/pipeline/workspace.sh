#!/usr/bin/env bash
# scripts/workspace: the grid of pressures, the points, their hull, and what is refused.
#   workspace.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
workspace=$here/../../scripts/workspace
coarse="--set 'mesh={size: 12 mm, through_wall: 1}' --set geometry.length=24mm"
runs "'$workspace' designs/segment.yaml --pressures chamber_1=4kPa,chamber_2=6kPa --steps 1 --set geometry.chambers=2 $coarse --plot points.svg > points.csv"
claim "a row a point of the grid" [ "$(cut -d, -f1,2 points.csv | tr '\n' ' ')" = 'pressure_chamber_1_kPa,pressure_chamber_2_kPa 0,0 4,0 4,6 0,6 ' ]
claim "the end is where it was at rest" [ "$(sed -n 2p points.csv)" = 0,0,0,0,0 ]
claim "opposite chambers move it to opposite sides" within "$(awk -F, 'NR == 3 { a = $5 } NR == 5 { print a * $5 < 0 }' points.csv)" 1 1
claim "the hull is told" grep -q '^workspace: 4 points, their convex hull has [0-9.e+-]* mm^3$' "$seen/err"
claim "and drawn" grep -q 'z (mm)' points.svg
runs 'printf "x_mm,y_mm,z_cm\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n" | hull-volume --json hull.json'
claim "a tetrahedron is a sixth of its box" [ "$(tail -n 1 "$seen/out")" = 4,1.6666666666666667 ]
refuses 65 'hull-volume: <stdin>: there is no column of the length z; *' 'printf "x_mm,y_mm\n0,0\n" | hull-volume'
refuses 64 "workspace: --pressures: 'chamber_1' is no chamber with its pressure; *" "'$workspace' designs/segment.yaml --pressures chamber_1"
refuses 64 "workspace: --steps '0' is no number from 1 to 99" "'$workspace' designs/segment.yaml --pressures chamber_1=4kPa --steps 0"
refuses 64 'workspace: no design is named; *' "'$workspace'"
refuses 65 "mesh-gen: --set outputs: outputs.x.face: *" "'$workspace' designs/segment.yaml --pressures chamber_1=4kPa --face nose"
