#!/usr/bin/env bash
# scripts/sweep --report and --plot: files, repeatability, refusals.   sweep_plots.sh BIN CMAKE     The page in a browser: tests/view
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
sweep=$here/../../scripts/sweep
needs parallel parallel

cat >rods.yaml <<'YAML'
design: designs/rod.yaml
vary:
  geometry.width: {from: 8 mm, to: 12 mm, steps: 2}
  material.mu: [100 kPa, 164.4 kPa]
set: {mesh.size: 20 mm, loads.end.pressure: -100 kPa}
YAML
refuses 64 "sweep: --report: 'page.pdf' does not end with .html, .htm; *" "$sweep rods.yaml --report page.pdf"
refuses 64 "sweep: --plot: 'page.html' does not end with *" "$sweep rods.yaml --plot page.html"
refuses 64 "sweep: --x, --y and --colour need --plot; *" "$sweep rods.yaml --x elongation"
refuses 64 "sweep: --report has no effect with --submit-only; *" "$sweep rods.yaml --engine slurm --submit-only --report page.html"
claim "nothing is computed" [ ! -e results ]
runs "$sweep rods.yaml"
runs "$sweep rods.yaml --report page.html --plot curves.svg"
claim "nothing is computed again" grep -q ' 4 designs, 0 to compute ' "$seen/err"
claim "the files are named" grep -q 'results.csv, page.html, curves.svg, after' "$seen/err"
claim "the page has each design" [ "$(grep -o '"id":"[0-9a-f]*"' page.html | sort -u | wc -l)" -eq 4 ]
claim "the page loads nothing" not grep -qE '(src|href)=.?(https?:|//)' page.html
claim "the plot has its axes and a legend" [ "$(grep -cE '<text>(elongation \(mm\)|pressure \(kPa\)|geometry.width (8|12) mm)<' curves.svg)" -eq 4 ]
cp page.html first.html
runs "$sweep rods.yaml --report page.html"
claim "the same results give the same page" cmp first.html page.html
runs "$sweep rods.yaml --plot points.svg --x material.mu --y elongation_mm_at_end --colour geometry.width"
claim "a plot of the results has their axes" [ "$(grep -cE '<text>(material.mu \(kPa\)|elongation at end \(mm\))<' points.svg)" -eq 2 ]
run "$sweep rods.yaml --plot plot.svg --y pressur"
claim "the exit code is 64" exits 64
claim "an unknown column has a suggestion" grep -q "^sweep: --y: neither the curves nor the results have a column 'pressur'; did you mean 'pressure'?$" "$seen/err"
claim "no file is left" [ ! -e plot.svg ]
run "$sweep rods.yaml --report absent/page.html"
claim "a folder that does not exist is reported" exits 73
