#!/usr/bin/env bash
# scripts/workspace: grid of pressures, points, convex hull, interruption, and rejected input.
#   workspace.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
workspace=$here/../../scripts/workspace
coarse="--set 'mesh={size: 12 mm, through_wall: 1}' --set geometry.length=24mm --set geometry.jacket.fibers.k1=0.01MPa"
mkdir "it's here"
export TMPDIR="$PWD/it's here"
runs "'$workspace' designs/segment.yaml --pressures chamber_1=4kPa,chamber_2=6kPa --steps 1 --set geometry.chambers=2 $coarse --plot points.svg > points.csv"
claim "there is one row per grid point" [ "$(cut -d, -f1,2 points.csv | tr '\n' ' ')" = 'pressure_chamber_1_kPa,pressure_chamber_2_kPa 0,0 4,0 4,6 0,6 ' ]
claim "the first point is the undeformed state" [ "$(sed -n 2p points.csv)" = 0,0,0,0,0 ]
claim "opposite chambers move the end to opposite sides" within "$(awk -F, 'NR == 3 { a = $5 } NR == 5 { print a * $5 < 0 }' points.csv)" 1 1
claim "the volume of the hull is printed" grep -q '^workspace: 4 points; volume of their convex hull [0-9.e+-]* mm^3$' "$seen/err"
claim "the points are plotted" grep -q 'z (mm)' points.svg
claim "progress is reported" grep -q '^solve: 50 % p2: ' "$seen/err"
claim "the path is stored" [ -s results/workspaces/segment.h5 ]
runs "'$workspace' designs/segment.yaml --pressures chamber_1=4kPa --steps 1 --set geometry.chambers=2 $coarse --result one.h5 > one.csv"
claim "one chamber with one step gives two points" [ "$(cut -d, -f1 one.csv | xargs)" = 'pressure_chamber_1_kPa 0 4' ]
claim "the second point equals that of the grid" [ "$(sed -n 3p one.csv | cut -d, -f 2-)" = "$(sed -n 3p points.csv | cut -d, -f 3-)" ]

# Ctrl-C in the second stage: the points so far are printed, --resume continues
setsid env --default-signal=INT bash -c "exec '$workspace' designs/segment.yaml --pressures chamber_1=4kPa,chamber_2=6kPa --steps 1 --set geometry.chambers=2 $coarse --result cut.h5" >cut.csv 2>cut.txt </dev/null &
session=$!
for _ in {1..2400}; do
    if grep -q ' p2: ' cut.txt; then break; fi
    sleep 0.02
done
kill -INT -- "-$session"
{ wait "$session"; status=$?; } 2>/dev/null
claim "an interruption returns 130" exits 130
claim "the message says how to continue" grep -q 'scripts/workspace --resume cut.h5` continues$' cut.txt
claim "the points so far are printed" [ "$(cut -d, -f1,2 cut.csv | tail -n 1)" = 4,0 ]
runs "'$workspace' --resume cut.h5 > resumed.csv"
claim "the resumed points equal those of an uninterrupted run" cmp points.csv resumed.csv

# Thousands of points exceed the maximum length of a program argument.
runs "workspace-grid designs/segment.yaml --pressures chamber_1=12kPa,chamber_2=12kPa,chamber_3=12kPa --steps 12 -o grid.yaml"
claim "each point is a stage" [ "$(grep -cE '^ *p[0-9]+:' grid.yaml)" -eq 2196 ]
refuses 64 "workspace: --steps 99: 3 chambers make 1000000 points, more than 5000; use fewer steps" "'$workspace' designs/segment.yaml --pressures chamber_1=12kPa,chamber_2=12kPa,chamber_3=12kPa --steps 99"

runs 'printf "x_mm,y_mm,z_cm\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n" | hull-volume --json hull.json'
claim "a tetrahedron is a sixth of its box" [ "$(tail -n 1 "$seen/out")" = 4,1.6666666666666667 ]
refuses 65 'hull-volume: <stdin>: there is no column z with a length unit; *' 'printf "x_mm,y_mm\n0,0\n" | hull-volume'
refuses 64 "workspace: --pressures: 'chamber_1' is not of the form chamber=pressure; *" "'$workspace' designs/segment.yaml --pressures chamber_1"
refuses 64 "workspace: --pressures: 'chamber_1=4mm': '4mm' is a length*" "'$workspace' designs/segment.yaml --pressures chamber_1=4mm"
refuses 64 "workspace: --steps: '0' is not a number from 1 to 99" "'$workspace' designs/segment.yaml --pressures chamber_1=4kPa --steps 0"
refuses 64 'workspace: the design is missing; *' "'$workspace'"
refuses 65 "workspace: --face: outputs.x.face: *" "'$workspace' designs/segment.yaml --pressures chamber_1=4kPa --face nose"
