#!/usr/bin/env bash
# --check, --compare and --plot of several results: outcome, exit codes, JUnit, plots, and rejected input.
#   checks.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
sed -i 's/{size: 1.5 mm/{size: 3 mm/' designs/bellows.yaml
runs 'mesh-gen -q designs/bellows.yaml --set path.until.elongation=60mm -o case.h5 && solve -q case.h5 -o result.h5'
runs 'mesh-gen -q designs/bellows.yaml --set path.until.elongation=60mm --set solver.step_accuracy=1e-4 | solve -q -o finer.h5'
runs 'mesh-gen -q designs/bellows.yaml --set path.until.elongation=60mm --set material.mu=0.17MPa | solve -q -o stiffer.h5'
runs 'postprocess -q result.h5 -o golden.csv'

# --check
runs 'postprocess -q result.h5 --check golden.csv --rtol 1e-12 --junit verdict.xml'
claim "the table is not written" [ ! -s "$seen/out" ]
claim "every column except step is a passed test" [ "$(grep -c '<testcase' verdict.xml) $(grep -c '<failure' verdict.xml)" = "$(head -n 1 golden.csv | tr ',' '\n' | tail -n +2 | wc -l) 0" ]
runs 'postprocess -q finer.h5 --check golden.csv'
claim "the result has other steps" [ "$(postprocess -q finer.h5 | wc -l)" -gt "$(wc -l <golden.csv)" ]
refuses 1 'postprocess: golden.csv:3: pressure_kPa is * where elongation_mm is *, golden *: * apart, allowed *; * rows differ' \
    'postprocess -q stiffer.h5 --check golden.csv --junit verdict.xml'
claim "the pressure is reported as failed" grep -qA1 'name="pressure_kPa agrees"' verdict.xml
claim "the reason is reported" grep -q '<failure message="golden.csv:3: pressure_kPa' verdict.xml
runs 'postprocess -q stiffer.h5 --check golden.csv --rtol 4%'   # mu is 3.4 % larger
runs 'postprocess -q stiffer.h5 --check golden.csv --atol pressure=1kPa --atol volume=1mL'
runs 'postprocess -q result.h5 --at elongation=20mm,40mm -o two.csv && postprocess -q finer.h5 --check two.csv'
runs 'head -n 3 golden.csv >short.csv && postprocess result.h5 --check short.csv'
claim "an incomplete coverage is reported" grep -q 'short.csv: 2 rows of .* agree.*; it covers [0-9.]* % of the path$' "$seen/err"
runs 'postprocess result.h5 --check golden.csv'
claim "a complete coverage is not reported" not grep -q covers "$seen/err"
refuses 1 "postprocess: other.csv: the result has no column 'bend_deg'" "sed '1s/volume_mL/bend_deg/' golden.csv > other.csv; postprocess -q result.h5 --check other.csv"
refuses 66 'postprocess: absent.csv: *' 'postprocess -q result.h5 --check absent.csv'
refuses 65 "postprocess: broken.csv:4: column 2 'pressure_kPa': 'x' is not a number; *" "sed '4s/,[^,]*/,x/' golden.csv > broken.csv; postprocess -q result.h5 --check broken.csv"
refuses 64 'postprocess: --rtol: *' 'postprocess -q result.h5 --check golden.csv --rtol -1'
refuses 64 'postprocess: --junit: has no effect without --check or --max-error' 'postprocess -q result.h5 --junit x.xml'

# --compare: the path itself in other units has no error
runs "awk -F, 'NR == 1 { print \"Druck (psi);Weg (in)\"; next } { printf \"%.9f;%.9f\n\", \$2 / 6.894757293168361, \$3 / 25.4 }' golden.csv | tr . , > same.csv"
runs 'postprocess -q finer.h5 --compare same.csv --max-error 10Pa --json summary.json -o errors.csv'
claim "two quantities are compared" [ "$(wc -l <errors.csv)" -eq 3 ]
claim "the error is negligible" within "$(json summary.json comparison 0 rms)" 0 0.005
claim "R2 is 1" within "$(json summary.json comparison 0 r2)" 0.99999 1
# 1 kPa less than the path at two points, 2 kPa more at a third
runs "awk -F, 'BEGIN { print \"pressure_kPa,elongation_mm\" } NR > 2 && NR < 6 { print \$2 + (NR == 5 ? 2 : -1) \",\" \$3 }' golden.csv > off.csv"
run 'postprocess -q result.h5 --compare off.csv --max-error 1.5kPa --junit verdict.xml -o errors.csv'
claim "the largest error exceeds the limit" exits 1
claim "the message is one line" says 'postprocess: the largest error of pressure at equal elongation is -2 kPa at elongation * mm (off.csv:4), allowed is 1.5 kPa'
claim "the mean is 0" within "$(column mean errors.csv | head -n 1)" -1e-4 1e-4
claim "the mean absolute error is 4/3" within "$(column mean_absolute errors.csv | head -n 1)" 1.3332 1.3334
claim "the RMS error is the square root of 2" within "$(column rms errors.csv | head -n 1)" 1.4141 1.4143
claim "JUnit contains a failure" grep -q 'failures="1"' verdict.xml
runs 'tail -n +2 off.csv | tr "," "\t" > bare.tsv && postprocess -q result.h5 --compare bare.tsv --columns pressure=1:kPa,elongation=2:mm --max-error 2.01kPa'
refuses 65 'postprocess: bare.tsv: no pressure was found among column 1, column 2; name its column, e.g. --columns pressure=1:kPa; *' 'postprocess -q result.h5 --compare bare.tsv'
refuses 65 'postprocess: bare.tsv: column 1: the unit is missing; give it, e.g. --columns pressure=1:kPa' 'postprocess -q result.h5 --compare bare.tsv --columns pressure=1,elongation=2:mm'
refuses 65 'postprocess: ragged.csv:3: has 1 cells, the first line has 2; *' "sed '3s/,.*//' off.csv > ragged.csv; postprocess -q result.h5 --compare ragged.csv"
refuses 64 "postprocess: --max-error: '5 deg' does not have the unit of a compared quantity; *" 'postprocess -q result.h5 --compare off.csv --max-error "5 deg"'
refuses 64 'postprocess: --at: has no effect with --compare, *' 'postprocess -q result.h5 --compare off.csv --at pressure=1kPa'
refuses 64 'postprocess: --max-error: has no effect without --compare' 'postprocess -q result.h5 --max-error 5kPa'

# --plot
if [ -n "$(type -P gnuplot)" ]; then
    runs 'postprocess -q result.h5 --with "stiffer.h5:mu = 0.17 MPa" --with finer.h5 --compare off.csv --plot all.svg -o errors.csv'
    for label in kraken-bellows 'mu = 0.17 MPa' 'kraken-bellows (finer)' measured 'cavity pressure (kPa)'; do
        claim "the plot contains '$label'" grep -qF "$label" all.svg
    done
    runs 'postprocess -q result.h5 --plot curve.pdf --x volume --y max_stretch -o curve.csv && head -c 5 curve.pdf | grep -q %PDF-'
    runs 'postprocess -q result.h5 --plot curve.png -o curve.csv && head -c 8 curve.png | grep -q PNG'
    refuses 64 "postprocess: --x: the curve has no 'elongatoin'; did you mean 'elongation'[?]" 'postprocess -q result.h5 --plot x.svg --x elongatoin -o x.csv'
    refuses 65 'postprocess: --with *: the curve has no *' 'mesh-gen -q designs/sphere.yaml | solve -q -o sphere.h5; postprocess -q result.h5 --with sphere.h5 --plot x.svg -o x.csv'
fi
refuses 64 'postprocess: --with: has no effect without --plot or --report' 'postprocess -q result.h5 --with finer.h5'

# Stages that hold the first pressure while another moves: rows of other steps are found by the pressure that moves
cat >holds.yaml <<'DESIGN'
family: two-spheres
geometry: {inner_radius: 10 mm, outer_radius: 14 mm, gap: 10 mm}
material: {law: neo-hookean, mu: 0.1644 MPa, kappa: incompressible}
model: axisymmetric
mesh: {quality: draft}
supports: {}
loads: {cavities: {left: {pressure: 20 kPa}, right: {pressure: 20 kPa}}}
path:
  stages:
    left_up:    {loads: {cavities: {left: {pressure: 20 kPa}}}}
    right_up:   {loads: {cavities: {right: {pressure: 20 kPa}}}}
    left_down:  {loads: {cavities: {left: {pressure: 5 kPa}}}}
    right_down: {loads: {cavities: {right: {pressure: 5 kPa}}}}
outputs: {}
DESIGN
runs 'mesh-gen -q holds.yaml -o holds.h5 && solve -q holds.h5 | postprocess -q -o holds.csv'
runs 'solve -q holds.h5 --set solver.first_step=0.005 | postprocess --check holds.csv -o other-steps.csv'
runs 'solve -q holds.h5 --set solver.max_step=0.2 | postprocess --check holds.csv -o other-steps.csv'
refuses 1 'postprocess: holds.csv:*' 'solve -q holds.h5 --set material.mu=0.165MPa | postprocess -q --check holds.csv -o other-mu.csv'

# A contact area, which has no derivative along the path: other steps agree, a wider plate does not
membrane='mesh-gen -q designs/membrane-at-wall.yaml --set mesh.size=1mm'
runs "$membrane -o membrane.h5 && solve -q membrane.h5 | postprocess -q -o membrane.csv"
for accuracy in 2e-4 1e-3; do
    runs "solve -q membrane.h5 --set solver.step_accuracy=$accuracy | postprocess -q --check membrane.csv -o other-steps.csv"
done
cut -d, -f2,4 membrane.csv >areas.csv
refuses 1 'postprocess: areas.csv:*touching_mm2*' "$membrane --set geometry.radius=20.1mm | solve -q | postprocess -q --check areas.csv -o wider.csv"
