#!/usr/bin/env bash
# Known designs give their constants and dimensions back from their curves, with and without noise; what the data cannot tell apart is
# named; starts side by side and continued searches give the same result; refusals.
#   calibration.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
export LIMIT=300

# twin DESIGN COLUMN SETTINGS...: its curve, with the load and the first output, in twin.csv; with 1 % noise in the column in noisy.csv
twin() {
    local design=$1 column=$2
    shift 2
    runs "mesh-gen -q designs/$design.yaml $* | solve -q | postprocess -q -o twin.csv"
    cut -d, -f2,3 twin.csv >two && mv two twin.csv
    # noise of zero mean and a standard deviation of 1 % of the largest value
    awk -F, -v OFS=, -v c="$column" 'NR == 1 { print; next } { row[NR] = $0; big = $c^2 > big^2 ? $c : big }
        END { for (i = 2; i <= NR; ++i) { $0 = row[i]; $c += 0.01 * sqrt(2) * big * sin(78.233 * i^2 + 0.3); print } }' twin.csv >noisy.csv
}
# returns KEY VALUE UNIT: found.yaml, from exact data, has the value to 1e-4; noisy.json has it within four standard errors
returns() {
    local found noisy error
    found=$(awk -v key="$1:" '$2 == key { print $3; exit }' found.yaml)
    claim "$1 is $2 again" within "$(awk -v a="$found" -v b="$2" 'BEGIN { print a / b }')" 0.9999 1.0001
    noisy=$(json noisy.json values "$1" | awk '{ print $1 }')
    error=$(json noisy.json standard_errors_SI "$1")
    claim "with noise, $1 is $2 within four standard errors" within "$(awk -v a="$noisy" -v b="$2" -v s="$error" -v u="$3" 'BEGIN { print (a - b) * u / s }')" -4 4
}
fit() {   # GOAL TEXT
    printf '%s\ntargets: [{curve: twin.csv}]\n' "$1" >goal.yaml
    runs 'optimize goal.yaml --starts 1 -q -o found.yaml'
    printf '%s\ntargets: [{curve: noisy.csv, within: 1 %%}]\n' "$1" >noisy.yaml
    runs 'optimize noisy.yaml --starts 1 -q -o noisy-found.yaml --json noisy.json'
    claim "the scatter is what the noise is" within "$(json noisy.json scatter)" 0.5 1.6
}

twin bellows 2 --set mesh.quality=draft --set geometry.wall=2.7mm --set material.mu=0.15MPa --set path.until.pressure=15kPa
fit 'design: designs/bellows.yaml
set: {mesh.quality: draft}
vary: {geometry.wall: {from: 2 mm, to: 4 mm}, material.mu: {from: 0.05 MPa, to: 0.5 MPa}}'
returns geometry.wall 2.7 1e-3
returns material.mu 0.15 1e6
claim "what the data cannot tell apart is named" grep -q '^# the data hardly tell apart: geometry.wall .* with material.mu' noisy-found.yaml
sed -i 's/to: 0.5 MPa/to: 0.5 MPa, prior: 0.15 MPa, sd: 0.5 kPa/' noisy.yaml
runs 'optimize noisy.yaml --starts 1 -q -o noisy-found.yaml --json prior.json'
claim "a prior narrows the wall" within "$(awk -v a="$(json prior.json standard_errors_SI geometry.wall)" -v b="$(json noisy.json standard_errors_SI geometry.wall)" 'BEGIN { print a / b }')" 0 0.3
twin dome 1 --set mesh.quality=draft --set material.mu=60kPa
fit 'design: designs/dome.yaml
set: {mesh.quality: draft, loads.outer.pressure: 50 kPa}
vary: {material.mu: {from: 20 kPa, to: 500 kPa}}'
returns material.mu 60 1e3

# a law with two constants, beyond the limit point of the pressure
twin tube 1 --set "'material={law: gent, mu: 0.2 MPa, jm: 40, kappa: incompressible}'" --set loads.cavity.pressure=200kPa --set path.stretch_limit=3.5
printf 'design: designs/tube.yaml\nset: {"material": "{law: gent, mu: 0.16 MPa, jm: 60, kappa: incompressible}", loads.cavity.pressure: 200 kPa, path.stretch_limit: 4.5, path.until.volume_ratio: 8}\n' >settings
fit "$(cat settings)
vary: {material.mu: {from: 0.05 MPa, to: 0.5 MPa}, material.jm: {from: 20, to: 200}}"
returns material.mu 0.2 1e6
returns material.jm 40 1

# Two tests of one design: loads differ, constants are common.
for force in 1 2; do
    runs "mesh-gen -q designs/rod.yaml --set material.mu=0.2MPa --set loads.end.pressure=-${force}00kPa | solve -q | postprocess -q -o $force.csv"
done
printf 'design: designs/rod.yaml\nvary: {material.mu: {from: 0.1 MPa, to: 1 MPa, prior: 0.2 MPa, sd: 10 kPa}}\ntargets:\n' >goal.yaml
for force in 1 2; do printf '  - {curve: %s.csv, at: elongation, to: 20 mm, set: {loads.end.pressure: -%s00 kPa}}\n' $force $force >>goal.yaml; done
runs 'optimize goal.yaml --starts 1 -q -o found.yaml --json two.json'
claim "two tests give the constant" within "$(awk '$2 == "material.mu:" { print $3 }' found.yaml)" 0.19998 0.20002
claim "rows beyond the range are left out" [ "$(json two.json curves 1 rows_left_out)" -gt 0 ]

# At a bifurcation (39.64 mm) and beside it the load is proportional to mu.
printf 'design: designs/rod.yaml\nset: {mesh.size: 10 mm, material.kappa: incompressible}\nvary: {material.mu: {from: 100 kPa, to: 400 kPa}}\n' >goal.yaml
printf 'targets: [{pressure: -202 kPa, at: {elongation: 39.6 mm}}]\n' >>goal.yaml
runs 'optimize goal.yaml --starts 1 -q -o found.yaml --json report.json'
claim "its derivative is the load over mu" within "$(awk -v d="$(json report.json conditions 0 derivatives_SI material.mu)" -v p="$(json report.json conditions 0 value_SI)" \
    -v m="$(json report.json values material.mu | awk '{ print $1 * 1e3 }')" 'BEGIN { print d * m / p }')" 0.99 1.01

# Starts side by side, and a search that was killed, give the same bytes.
twin bellows 2 --set mesh.quality=draft --set geometry.wall=2.7mm --set path.until.pressure=15kPa
printf 'design: designs/bellows.yaml\nset: {mesh.quality: draft}\nvary: {geometry.wall: {from: 2 mm, to: 4 mm}}\ntargets: [{curve: twin.csv}]\n' >goal.yaml
runs 'optimize goal.yaml -q -o one.yaml'
runs 'optimize goal.yaml -q --jobs 2 --folder trials -o two.yaml'
claim "two jobs find the same" cmp one.yaml two.yaml
refuses 64 'optimize: trials/trials.jsonl: contains the trials of an earlier search; continue it with --resume*' 'optimize goal.yaml -q --folder trials'
head -c -20 trials/trials.jsonl >shorter && mv shorter trials/trials.jsonl
runs 'optimize goal.yaml -q --folder trials --resume -o three.yaml'
claim "a continued search finds the same" cmp one.yaml three.yaml
lines=$(wc -l <trials/trials.jsonl)
runs 'optimize goal.yaml -q --folder trials --resume -o four.yaml'
claim "the line that was cut off is computed once" [ "$(wc -l <trials/trials.jsonl)" -eq "$lines" ]
sed -i 's/4 mm/5 mm/' goal.yaml
refuses 65 'optimize: trials/trials.jsonl: contains the trials of another goal or version; *' 'optimize goal.yaml -q --folder trials --resume'

printf 'pressure_kPa,width_mm\n1,2\n' >other.csv
printf 'design: designs/bellows.yaml\nvary: {geometry.wall: {from: 2 mm, to: 4 mm}}\ntargets: [{curve: other.csv, at: width}]\n' >goal.yaml
refuses 65 "optimize: *goal.yaml:3:*" 'optimize goal.yaml -q'
sed -i 's/other.csv/nowhere.csv/' goal.yaml
refuses 66 'optimize: *nowhere.csv*' 'optimize goal.yaml -q'
