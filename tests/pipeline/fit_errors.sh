#!/usr/bin/env bash
# The band that the errors of fitted constants cause: exact where the load is proportional to a single constant, and as wide as
# the scatter of whole runs with constants drawn from the covariance; refusals.
. "$(dirname "$0")/check.sh" "$@"
cp -R "$here/../fit/data" data
rod='--set mesh.size=20mm --set geometry.width=20mm --set geometry.height=20mm'
part() { awk -v b="$(column "$1" "$3" | tail -n 1)" -v q="$(column "$2" "$3" | tail -n 1)" 'BEGIN { print b / (q < 0 ? -q : q) }'; }
sed '/^material:/,/^model:/{/^model:/!d}' designs/rod.yaml >rest.yaml

runs 'fit-material data/dragon-skin-20.csv --law neo-hookean --json one.json > one.yaml'
cat rest.yaml one.yaml >one-rod.yaml
share=$(awk -v m="$(json one.json fits 0 constants 0 value)" -v e="$(json one.json fits 0 constants 0 standard_error)" 'BEGIN { print e / m }')
is_share() { within "$(awk -v a="$1" -v b="$share" 'BEGIN { print a / b }')" 0.9999 1.0001; }
runs "mesh-gen -q one-rod.yaml $rod --set loads.end.pressure=-0.6MPa --set path.until.elongation=50mm --sensitivity material.mu | solve -q -o one.h5 && postprocess -q one.h5 --errors one.json -o one.csv --plot one.svg"
claim 'the band of the pressure is the error of mu' is_share "$(part band_rss_pressure_kPa pressure_kPa one.csv)"
claim 'the plot shows the band' grep -q tolerances one.svg
# p = mu (l^2 - 1/l): at a pressure, dl = -(l^2 - 1/l) / (2 l + 1/l^2) dmu/mu
claim 'at a pressure the elongation has a band' within \
    "$(awk -v b="$(column band_rss_elongation_mm one.csv | tail -n 1)" -v x="$(column elongation_mm one.csv | tail -n 1)" -v s="$share" \
        'BEGIN { l = 1 + x / 100; print b / (100 * s * (l * l - 1 / l) / (2 * l + 1 / (l * l))) }')" 0.998 1.002
runs "mesh-gen -q one-rod.yaml $rod --set 'loads={end: {force: 30 N, along: x}}' --sensitivity material.mu | solve -q | postprocess -q --errors one.json -o force.csv"
claim 'the band of a force is the error of mu' is_share "$(part band_rss_load_N load_N force.csv)"

# Three correlated constants against 24 whole runs: the standard deviation of 24 samples has an error of 15 %, the limits are three times this.
runs 'fit-material data/dragon-skin-20.csv --law yeoh --json three.json > three.yaml'
cat rest.yaml three.yaml >three-rod.yaml
pulled="$rod --set loads.end.pressure=-0.6MPa --set path.until.elongation=50mm"
runs "mesh-gen -q three-rod.yaml $pulled --sensitivity material.c1,material.c2,material.c3 | solve -q -o three.h5 && postprocess -q three.h5 --errors three.json --at elongation=50mm -o three.csv"
runs "python3 - three.json >samples <<'END'
import json, random, sys
fit = json.load(open(sys.argv[1]))['fits'][0]
c, n = [k['value'] for k in fit['constants']], len(fit['constants'])
L = [[0.0] * n for _ in range(n)]                                    # Cholesky
for i in range(n):
    for j in range(i + 1):
        rest = fit['covariance'][i * n + j] - sum(L[i][k] * L[j][k] for k in range(j))
        L[i][j] = rest**0.5 if i == j else rest / L[j][j]
random.seed(1)
for number in range(24):
    z = [random.gauss(0, 1) for _ in c]
    values = [c[i] + sum(L[i][k] * z[k] for k in range(n)) for i in range(n)]
    text = ', '.join(f'c{i + 1}: {v} Pa' for i, v in enumerate(values))
    print(f'case.h5 --set \"material={{law: yeoh, {text}, kappa: incompressible}}\" --quiet -o run-{number}.h5')
END"
runs "mesh-gen -q three-rod.yaml $pulled -o case.h5 && solve --batch <samples"
for run in run-*.h5; do postprocess -q "$run" --at elongation=50mm | column pressure_kPa /dev/stdin; done >pressures
claim 'the band is as wide as the scatter of the samples' within \
    "$(awk -v b="$(column band_rss_pressure_kPa three.csv)" '{ n++; s += $1; q += $1^2 } END { print sqrt((q - s^2 / n) / (n - 1)) / b }' pressures)" 0.55 1.45
claim 'there are 24 of them' [ "$(wc -l <pressures)" -eq 24 ]

# The report of a calibration: its own errors.
runs "mesh-gen -q one-rod.yaml $rod --set path.until.elongation=50mm --set loads.end.pressure=-0.6MPa | solve -q | postprocess -q -o twin.csv"
printf 'design: one-rod.yaml\nset: {mesh.size: 20 mm, loads.end.pressure: -1 MPa}\nvary: {material.mu: {from: 50 kPa, to: 500 kPa}}\ntargets: [{curve: noisy.csv, at: elongation}]\n' >goal.yaml
awk -F, 'NR == 1 { print $2 "," $3; next } NR > 2 { print $2 * (1 + 0.01 * sin(NR * NR)) "," $3 }' twin.csv >noisy.csv
runs 'optimize goal.yaml -q --json report.json -o found.yaml && mesh-gen -q found.yaml --sensitivity material.mu | solve -q | postprocess -q --errors report.json -o found.csv'
claim 'the errors of a calibration give a band' within "$(part band_rss_pressure_kPa pressure_kPa found.csv)" 1e-4 0.01

sed 's/"material.mu": "[0-9.]* /"material.mu": "10 /' report.json >other.json
runs 'mesh-gen -q found.yaml --sensitivity material.mu | solve -q -o found.h5'
refuses 65 'postprocess: --errors other.json: the fit has another material.mu than the result *' 'postprocess -q found.h5 --errors other.json'
echo '{"standard_errors_SI": {}, "correlations": {}}' >empty.json
refuses 65 'postprocess: empty.json: has no errors: *' 'postprocess -q found.h5 --errors empty.json'
refuses 65 'postprocess: one.yaml: is not a fit: *' 'postprocess -q one.h5 --errors one.yaml'
refuses 66 'postprocess: absent.json: *' 'postprocess -q one.h5 --errors absent.json'
refuses 64 'postprocess: --errors three.json: the result has no sensitivity to material.c1; *' 'postprocess -q one.h5 --errors three.json'
sed 's/"value": [0-9.]*/"value": 1e5/' one.json >other.json
refuses 65 'postprocess: --errors other.json: the fit has another material.mu than the result *' 'postprocess -q one.h5 --errors other.json'
