#!/usr/bin/env bash
# Opens the report of a sweep of tubes in a headless Chromium.   sweep_browser.sh BIN WORK     WORK: folder for the pinned npm packages
# Exits with 77 (skipped) if node, npm, parallel or a Chromium is missing.
. "$(dirname "${BASH_SOURCE[0]}")/browser_setup.sh" "$1" "$2" parallel

# The radius of 12 mm is refused, and prescribed pressures end at the limit point.
cat >tubes.yaml <<'YAML'
design: tube.yaml
vary:
  geometry.inner_radius: [5 mm, 6 mm, 7 mm, 8 mm, 12 mm]
  material.mu: {from: 60 kPa, to: 200 kPa, steps: 3, scale: log}
  path.control: [pressure, volume]
set: {mesh.quality: draft, loads.cavity.pressure: 500 kPa}
at: [limit, volume=20mL]
outputs: [pressure_kPa, elongation_mm]
YAML
cp "$here/../../designs/tube.yaml" .
rm -rf tubes pictures
mkdir pictures || exit 1
"$here/../../scripts/sweep" tubes.yaml --folder tubes --report tubes.html --plot tubes.svg 2>sweep.log || { cat sweep.log; exit 1; }
grep -q '<path' tubes.svg || { echo 'the plot has no curve'; exit 1; }
timeout 600 node sweep.mjs tubes.html tubes/results.csv pictures
