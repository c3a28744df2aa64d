#!/usr/bin/env bash
# fit-material: test data in, a material out that mesh-gen accepts; options and rejected input.
# shellcheck disable=SC2016
. "$(dirname "$0")/check.sh" "$@"
cp -R "$here/../fit/data" data

runs 'fit-material data/dragon-skin-20.csv --law yeoh --notice "ODbL 1.0" -o yeoh.yaml --json yeoh.json --plot fit.svg'
claim 'the plot is an SVG' grep -q '</svg>' fit.svg
claim 'the plot shows the residuals' grep -q 'residual, law minus test' fit.svg
claim 'the notice is written' grep -q '^# ODbL 1.0$' yeoh.yaml
claim 'the hash is correct' grep -q "$(sha256sum data/dragon-skin-20.csv | cut -d' ' -f1)" yeoh.yaml
claim 'the summary contains the law' has yeoh yeoh.json fits 0 law
runs 'sed "/^material:/,/^model:/{/^model:/!d}" designs/bellows.yaml > rest.yaml; cat rest.yaml yeoh.yaml > own.yaml; mesh-gen --check own.yaml'
runs 'mesh-gen own.yaml --set path.until.elongation=10mm | solve --quiet | postprocess > own.csv'
claim 'the fitted material can be solved' table own.csv
runs 'fit-material < data/dragon-skin-20.csv | diff <(sed /^#/d yeoh.yaml | grep -v "source:") <(fit-material data/dragon-skin-20.csv | sed /^#/d | grep -v "source:")'
claim 'stdin and stdout are equivalent to files' exits 0

runs 'fit-material data/ecoflex-00-30.csv --range 0:1300% --law yeoh-5 --weights relative --weight-floor 1% --stability everywhere'
refuses 64 'fit-material: --weight-floor: requires relative weights; *' 'fit-material data/ecoflex-00-30.csv --weight-floor 1%'
refuses 64 "fit-material: --weight-floor: '2' is not between 0 and 1; *" 'fit-material data/ecoflex-00-30.csv --weights relative --weight-floor 2'
runs 'fit-material --uniaxial data/treloar-uniaxial.csv --equibiaxial data/treloar-equibiaxial.csv --planar data/treloar-planar.csv --rank --plot rank.png > rank.txt'
laws=$(fit-material --help | sed -n 's/.*--law LAW.*: //p' | tr ',' '\n' | wc -l)
claim 'there is one line per law' [ "$(wc -l <rank.txt)" -eq $((laws + 1)) ]
claim 'the table contains predictions' grep -q predicts_equibiaxial rank.txt
claim 'the plot is a PNG' [ "$(head -c 4 rank.png | tail -c 3)" = PNG ]

runs 'mesh-gen designs/bellows.yaml --set material=dragon-skin-20 -o named.h5'
runs 'solve named.h5 --set path.until.elongation=10mm | postprocess > named.csv'
claim 'a silicone selected by name can be solved' table named.csv
claim 'postprocess reports law, range and error' grep -q 'dragon-skin-20, yeoh fitted over 11.362:897.727 % strain, stress within 9.8 %' "$seen/err"
runs 'solve -q named.h5 --set path.until.elongation=40mm --set loads.cavity.pressure=20kPa --json low.json -o low.h5; solve -q named.h5 --set path.until.elongation=40mm --set loads.cavity.pressure=60kPa --json high.json -o high.h5'
claim 'the constants do not depend on the load' [ "$(json low.json materials)" = "$(json high.json materials)" ]
runs 'postprocess -q low.h5 --at elongation=20mm,30mm --json low-post.json > low.csv; postprocess -q high.h5 --at elongation=20mm,30mm --json high-post.json > high.csv; paste -d, low.csv high.csv'
claim 'the curve does not depend on the load' awk -F, 'NR > 1 { half = NF / 2; if (($2 - $(half + 2)) ^ 2 > (1e-4 * $2) ^ 2) exit 1 }' "$seen/out"
claim 'the summaries of solve and postprocess agree' [ "$(json low-post.json materials)" = "$(json low.json materials)" ]
claim 'the constants are in SI units' within "$(json low.json materials 0 constants c1)" 61120.48 61120.49
claim 'the summary contains the range of the data' has '11.362:897.727 %' low.json materials 0 fit range
runs 'solve -q named.h5 --set path.until.elongation=10mm -o whole.h5'
max_KiB=$(($(stat -c %s named.h5) / 1024 + 200))
refuses 74 'solve: part.h5: cannot be written: *' "(ulimit -f $max_KiB; exec solve -q named.h5 --set path.until.elongation=10mm -o part.h5)"
runs 'solve -q --resume part.h5; postprocess -q part.h5 | cmp - named.csv'
claim 'a resumed result has the size of an uninterrupted one' [ "$(stat -c %s part.h5)" -eq "$(stat -c %s whole.h5)" ]
runs 'solve named.h5 --set path.until.elongation=10mm --set "material={name: dragon-skin-20, range: 300 %}" -q -o wide.h5; postprocess wide.h5 --json wide.json > wide.csv'
claim 'a given range is kept, and the message suggests a better one' grep -q 'range: 110 %} was fitted there' "$seen/err"
claim 'the summary contains the range' has '4.46:300 %' wide.json material_fit range
runs 'sed "s/max_I1: .*/max_I1: 3.0001/" own.yaml | mesh-gen - --set path.until.elongation=10mm | solve 2> solve.err | postprocess > beyond.csv'
claim 'solve warns beyond the data' grep -q 'beyond the data its constants were fitted to' solve.err
claim 'postprocess warns as well' grep -q 'beyond the data its constants were fitted to' "$seen/err"

printf 'Engineering Strain;Engineering Stress (MPa)\n0.1;1\n0.2;2x\n0.3;3\n' >text.csv
printf 'Engineering Strain;Force (N)\n0.1;1\n0.2;2\n' >column.csv
printf 'Engineering Strain;Engineering Stress (MPa)\n0.1;1\n' >one.csv
printf 'Engineering Strain;Engineering Stress (MPa)\n0.1;1\n-1.2;2\n' >negative.csv
printf 'Engineering Strain;Engineering Stress (MPa)\n0.1;1\n0.2;2\n0.15;3\n' >back.csv
printf 'Engineering Strain;Engineering Stress\n0.1;1\n0.2;2\n' >unit.csv
refuses 65 "fit-material: text.csv:3: column 2 'Engineering Stress (MPa)': '2x' is not a number; *" 'fit-material text.csv'
refuses 65 'fit-material: column.csv:1: no title identifies the stress column; name one with --stress-column*' 'fit-material column.csv'
refuses 65 'fit-material: one.csv:2: only 1 of the rows*' 'fit-material one.csv'
refuses 65 'fit-material: negative.csv:3: a stretch of -0.2 is not positive; *' 'fit-material negative.csv'
refuses 65 'fit-material: back.csv:4: the strain reverses direction; *' 'fit-material back.csv'
refuses 65 'fit-material: unit.csv:1: the unit of the stress is not stated; give --stress-unit*' 'fit-material unit.csv'
refuses 65 'fit-material: back.csv: 3 rows are too few for the 3 constants of yeoh; *' 'fit-material back.csv --any-order'
refuses 66 'fit-material: none.csv: *' 'fit-material none.csv'
refuses 64 'fit-material: --output text.csv: would overwrite the input; *' 'fit-material text.csv -o text.csv'
refuses 64 "fit-material: --law: no law is called 'yeho'; did you mean 'yeoh'*" 'fit-material text.csv --law yeho'
refuses 64 "fit-material: --range: '110%' has no colon; *" 'fit-material text.csv --range 110%'
refuses 64 "fit-material: --range: '0:110' looks like percentages*" 'fit-material text.csv --range 0:110'
refuses 64 "fit-material: --skip-rows: '-1' is not a number of rows; give 0 or more; *" 'fit-material text.csv --skip-rows -1'
refuses 64 "fit-material: --skip-rows: '1.5' is not a number of rows; *" 'fit-material text.csv --skip-rows 1.5'
refuses 64 'fit-material: -: stdin can be read only once; *' 'fit-material --uniaxial - --planar -'
refuses 64 "fit-material: --weight: 'planar=2' is not a positive weight of a given mode; *" 'fit-material text.csv --weight planar=2'
refuses 64 'fit-material: fit.jpg: unknown picture format; use .svg, .png or .pdf' 'fit-material text.csv --plot fit.jpg'

# Displacement and force of a testing machine: the specimen of these data is 33 mm long, with a section of 6 x 3 mm.
awk -F';' '/^[0-9.]+;[0-9]/ { if (!n++) print "Specimen,1\n\n\"Extension\",\"Load\"\n\"(mm)\",\"(N)\""; printf "\"%.9f\",\"%.9f\"\n", 33 * $4, 18 * $5 }' data/dragon-skin-20.csv >machine.csv
runs 'fit-material machine.csv --gauge-length 33mm --width 6mm --thickness 3mm > machine.yaml'
constants() { awk '/^  c[123]:/ { print $1, $2 }' "$1"; }
claim 'force and displacement give the same constants' awk \
    'NR == FNR { c[$1] = $2; next } { if (($2 - c[$1]) ^ 2 > (1e-6 * $2) ^ 2) exit 1; ++n } END { exit n != 3 }' <(constants yeoh.yaml) <(constants machine.yaml)
refuses 65 'fit-material: machine.csv:3: no title identifies the strain column; *; for a displacement give --gauge-length' 'fit-material machine.csv'
refuses 64 'fit-material: --width: defines only one side of the cross-section; *' 'fit-material machine.csv --gauge-length 33mm --width 6mm'
refuses 64 'fit-material: --area: the cross-section is given twice; *' 'fit-material machine.csv --gauge-length 33mm --width 6mm --thickness 3mm --area 18mm^2'
refuses 64 "fit-material: --gauge-length: '0 mm' is not positive; *" 'fit-material machine.csv --gauge-length "0 mm" --area 18mm^2'

# Other formats: decimal commas, no header, true stress, files that are not tables.
sed 's/\./,/g' data/dragon-skin-20.csv >comma.csv
sed 's/;/\t/g' data/dragon-skin-20.csv >tabs.tsv
awk -F';' '/^[0-9.]+;[0-9]/ { print $4, $5 }' data/dragon-skin-20.csv >bare.txt
same() { cmp <(sed '/^#/d; /source:/d; /sha256:/d' "$1") <(sed '/^#/d; /source:/d; /sha256:/d' yeoh.yaml); }
runs 'fit-material comma.csv > comma.yaml'
claim 'decimal commas give the same result' same comma.yaml
runs 'fit-material tabs.tsv > tabs.yaml'
claim 'tabs give the same result' same tabs.yaml
runs 'fit-material bare.txt --strain-column 1 --stress-column 2 --strain engineering --stress engineering --stress-unit MPa > bare.yaml'
claim 'data without header give the same result' same bare.yaml
refuses 65 'fit-material: bare.txt:1: the table has no header to identify the strain column; name one with --strain-column*' 'fit-material bare.txt'
runs 'fit-material data/dragon-skin-20.csv --strain-column "true strain" --stress-column "true stress" > true.yaml'
claim 'true stress is recorded' grep -q "stress: 'engineering, from true'" true.yaml
: >empty.csv
head -c 900 data/dragon-skin-20.csv | sed '$ s/;[^;]*$//' >cut.csv
printf 'strain,stress\n0.1,1\000\n' >zero.csv
refuses 65 'fit-material: empty.csv: contains no row of numbers' 'fit-material empty.csv'
runs 'head -c 1500 data/dragon-skin-20.csv > short.csv; fit-material short.csv > short.yaml'
claim 'a missing line ending is reported' grep -q 'short.csv: the last line has no line ending; check that the file is complete' "$seen/err"
claim 'a poor fit is reported' grep -q 'the best fit is poor' "$seen/err"
refuses 65 "fit-material: cut.csv:*: column * 'Engineering Stress (MPa)': the cell is empty; *" 'fit-material cut.csv'
refuses 65 'fit-material: zero.csv:2: contains a zero byte: the file is not text; *' 'fit-material zero.csv'
refuses 65 'fit-material: wide.h5:*: contains a zero byte: the file is not text; *' 'fit-material wide.h5'
refuses 66 'fit-material: data: *' 'fit-material data'

runs 'fit-material --help; fit-material --version; fit-material --man; fit-material --completion bash'
claim 'the help contains examples' grep -q 'fit-material --uniaxial ut.csv' "$seen/out"
