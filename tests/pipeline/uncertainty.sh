#!/usr/bin/env bash
# The band that the errors of constants make on a curve: exact where the load is proportional to the one constant, and the same
# by sampling where there are several.
. "$(dirname "$0")/check.sh" "$@"
cp -R "$here/../fit/data" data
coarse='--set loads.end.pressure=-0.6MPa --set mesh.size=20mm --set geometry.width=20mm --set geometry.height=20mm --set path.until.elongation=50mm'
band() { awk -F, -v name="$1" -v file="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i } NR == 2 { print $c }' "$2"; }

runs 'fit-material data/dragon-skin-20.csv --law neo-hookean --json one.json > one.yaml'
LIMIT=250 runs "$here/../../scripts/uncertainty designs/rod.yaml one.json --at elongation=50mm $coarse > one.csv"
mu=$(json one.json fits 0 constants 0 value) error=$(json one.json fits 0 constants 0 standard_error)
claim 'the band of neo-Hookean rubber is the error of mu' within \
    "$(awk -v b="$(band band_linear one.csv)" -v p="$(band pressure_kPa one.csv)" -v m="$mu" -v e="$error" 'BEGIN { print -b / p * m / e }')" 0.9999 1.0001

# 24 samples give a deviation to 15 %: three of these
runs 'fit-material data/dragon-skin-20.csv --law yeoh --json three.json > three.yaml'
LIMIT=250 runs "$here/../../scripts/uncertainty designs/rod.yaml three.json --at elongation=25mm,50mm --samples 24 --plot band.svg $coarse > three.csv"
claim 'linearised and sampled bands agree' within \
    "$(awk -v b="$(band band_linear three.csv)" -v s="$(band band_sampled three.csv)" 'BEGIN { print s / b }')" 0.55 1.45
claim 'the picture shows both bands' grep -q 'one standard deviation, linearised' band.svg
claim 'and the samples' grep -q '24 samples' band.svg
runs "mesh-gen designs/rod.yaml $coarse | solve --quiet -o rod.h5; postprocess --quiet rod.h5 --plot rod.svg --band three.csv -o rod.csv"
claim "postprocess draws it too" grep -q "one standard deviation of the constants" rod.svg
refuses 64 'uncertainty: band.jpg: pictures are written as *' "$here/../../scripts/uncertainty designs/rod.yaml one.json --at elongation=50mm --plot band.jpg"
refuses 64 'uncertainty: say where: *' "$here/../../scripts/uncertainty designs/rod.yaml one.json"
