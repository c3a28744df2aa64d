#!/usr/bin/env bash
# Opens the reports of a bellows, a tube and a block under a ball in a headless Chromium.   browser.sh BIN WORK     WORK: folder for the pinned npm packages
# Exits with 77 (skipped) if node, npm, a Chromium, gnuplot or the viewer is missing.
. "$(dirname "${BASH_SOURCE[0]}")/browser_setup.sh" "$1" "$2" gnuplot

"$bin/mesh-gen" -q "$here/../../designs/bellows.yaml" --set mesh.size=3mm | "$bin/solve" -q -o bellows.h5 || exit 1
# a label with HTML must appear as text
"$bin/postprocess" -q bellows.h5 --with "bellows.h5:<script>alert('label')</script>" --report report.html >refused.txt 2>&1 || {
    cat refused.txt
    grep -q 'built without the viewer' refused.txt && skip "built without npm"
    exit 1
}
[ ! -s refused.txt ] || exit 1
"$bin/mesh-gen" -q "$here/../../designs/tube.yaml" --set model=quarter --set mesh.size=4mm --set path.until.elongation=5mm |
    "$bin/solve" -q -o tube.h5 && "$bin/postprocess" -q tube.h5 --report tube.html || exit 1

cat >block.yaml <<'END'
family: rod
name: block
geometry: {length: 20 mm, width: 20 mm, height: 8 mm}
material: {law: neo-hookean, mu: 0.1 MPa, kappa: incompressible}
model: quarter
mesh: {size: 4 mm}
supports: {fixed: fixed}
obstacles:
  ball: {sphere: {center: [20 mm, 0 mm, 9 mm], radius: 4 mm}}
loads:
  ball: {displacement: -3 mm, along: z}
END
"$bin/mesh-gen" -q block.yaml | "$bin/solve" -q -o block.h5 && "$bin/postprocess" -q block.h5 --report block.html || exit 1

# Undeformed lengths: ten convolutions of 9.25 mm between two discs of 6 mm, 100 mm for the tube, 20 mm for the block; elongations at the end of
# the paths.
mkdir -p bellows tube block || exit 1
timeout 600 node report.mjs report.html 104.5 130 bellows && timeout 600 node report.mjs tube.html 100 5 tube &&
    timeout 600 node report.mjs block.html 20 '' block moving
