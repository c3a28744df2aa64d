#!/usr/bin/env bash
# Uncertainty band of a curve due to the errors of the constants: exact if the load is proportional to a single constant, for each type
# of load, and confirmed by sampling for several constants.
. "$(dirname "$0")/check.sh" "$@"
cp -R "$here/../fit/data" data
uncertainty=$here/../../scripts/uncertainty
coarse='--set mesh.size=20mm --set geometry.width=20mm --set geometry.height=20mm'
pulled="$coarse --set loads.end.pressure=-0.6MPa --set path.until.elongation=50mm"
band() { column "$1" "$2" | head -n 1; }
part() { awk -v b="$(band "$1" "$3")" -v q="$(band "$2" "$3")" 'BEGIN { print b / (q < 0 ? -q : q) }'; }   # part BAND QUANTITY FILE

runs 'fit-material data/dragon-skin-20.csv --law neo-hookean --json one.json > one.yaml'
mu=$(json one.json fits 0 constants 0 value) error=$(json one.json fits 0 constants 0 standard_error)
share=$(awk -v m="$mu" -v e="$error" 'BEGIN { print e / m }')
is_share() { within "$(awk -v a="$1" -v b="$share" 'BEGIN { print a / b }')" 0.999 1.001; }
runs "'$uncertainty' designs/rod.yaml one.json --at elongation=50mm $pulled > one.csv"
claim 'the band of the pressure is the error of mu' is_share "$(part pressure_band_kPa pressure_kPa one.csv)"
claim 'the quantity of --at has no band' [ -z "$(band elongation_band_mm one.csv)" ]
runs "'$uncertainty' designs/rod.yaml one.json --at elongation=10mm $coarse --set 'loads={end: {force: 30 N, along: x}}' > force.csv"
claim 'the band of a force is the error of mu' is_share "$(part load_band_N load_N force.csv)"
runs "'$uncertainty' designs/rod.yaml one.json --at elongation=10mm $coarse --set 'loads={end: {displacement: 20 mm, along: x}}' --set 'outputs={elongation: {face: end, along: x}, pull: {face: end, along: x, measure: force}}' > motion.csv"
claim 'the band of the reaction of a prescribed motion is the error of mu' is_share "$(part pull_band_N pull_N motion.csv)"
runs "'$uncertainty' designs/rod.yaml one.json --at elongation=10mm $coarse --set 'loads={end: {displacement: 20 mm, along: x}}'"
claim 'a warning is printed if no quantity varies' grep -q '^uncertainty: warning: elongation=10mm: no quantity of the curve depends on the constants there; ' "$seen/err"
# p = mu (l^2 - 1/l): at a pressure, dl = -(l^2 - 1/l) / (2 l + 1/l^2) dmu/mu
runs "'$uncertainty' designs/rod.yaml one.json --at pressure=-100kPa $coarse --set loads.end.pressure=-0.2MPa > pressure.csv"
claim 'at a pressure the elongation has a band' within \
    "$(awk -v b="$(band elongation_band_mm pressure.csv)" -v x="$(band elongation_mm pressure.csv)" -v s="$share" \
        'BEGIN { l = 1 + x / 100; print b / (100 * s * (l * l - 1 / l) / (2 * l + 1 / (l * l))) }')" 0.998 1.002

# the standard deviation of 24 samples has an error of 15 %; the limits are three times this
runs 'fit-material data/dragon-skin-20.csv --law yeoh --json three.json > three.yaml'
runs "'$uncertainty' designs/rod.yaml three.json --at elongation=25mm,50mm --samples 24 --plot band.svg $pulled > three.csv"
claim 'linearised and sampled bands agree' within \
    "$(awk -v b="$(band pressure_band_kPa three.csv)" -v s="$(band pressure_sampled_band_kPa three.csv)" 'BEGIN { print s / b }')" 0.55 1.45
claim 'all samples are counted' [ "$(band samples three.csv)" = 24 ]
claim 'progress is reported' grep -q '^uncertainty: 31 of 31 runs$' "$seen/err"
claim 'the plot shows the band' grep -q '1 standard deviation' band.svg
# Full force exactly at the requested value: the stiffer half of the samples does not reach it.
runs "'$uncertainty' designs/rod.yaml one.json --at elongation=17.6mm --samples 8 $coarse --set 'loads={end: {force: 30 N, along: x}}' > short.csv"
claim 'samples that fall short are reported with a count' grep -Eq '^uncertainty: warning: elongation=17.6mm: [1-7] of 8 samples do(es)? not reach it and (is|are) left out$' "$seen/err"
claim 'the table contains the number of the other samples' within "$(band samples short.csv)" 1 7
claim 'a stiffer run that does not reach the value leaves the linear band empty' [ -z "$(band load_band_N short.csv)" ]

constant() { json three.json fits 0 constants "$1" value; }
fitted="material={law: yeoh, c1: $(constant 0) Pa, c2: $(constant 1) Pa, c3: $(constant 2) Pa}"
runs "mesh-gen designs/rod.yaml $pulled --set '$fitted' | solve --quiet -o rod.h5; postprocess --quiet rod.h5 --plot rod.svg --band three.csv -o rod.csv"
claim "postprocess draws the band as well" grep -q "1 standard deviation" rod.svg
refuses 64 'uncertainty: band.jpg: unknown picture format; *' "'$uncertainty' designs/rod.yaml one.json --at elongation=50mm --plot band.jpg"
refuses 64 'uncertainty: --at is missing: *' "'$uncertainty' designs/rod.yaml one.json"
refuses 64 "uncertainty: --samples: '1' is not a number of samples; *" "'$uncertainty' designs/rod.yaml one.json --at elongation=50mm --samples 1"
refuses 65 'uncertainty: --at elongation=500mm: the path does not reach it; *' "'$uncertainty' designs/rod.yaml one.json --at elongation=500mm $coarse"
refuses 66 'uncertainty: absent.json: *' "'$uncertainty' designs/rod.yaml absent.json --at elongation=50mm"
refuses 65 'uncertainty: one.yaml: is not a fit: *' "'$uncertainty' designs/rod.yaml one.yaml --at elongation=50mm"
