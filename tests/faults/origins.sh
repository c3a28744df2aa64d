#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# Files of another release or byte order.   origins.sh BIN CMAKE H5_CHANGE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh" "$1" "$2"
change=$3
runs 'mesh-gen -q designs/tube.yaml --set path.until.steps=3 -o case.h5 && solve -q case.h5 -o result.h5 && postprocess -q result.h5 -o whole.csv'
changed() { runs "cp $1 changed.h5 && $change changed.h5 $2"; }
for tool in solve postprocess; do
    file=case.h5
    if [ $tool = postprocess ]; then file=result.h5; fi
    changed $file older
    row 'a file of an older format' $tool 65 'changed.h5: an older release wrote it (format 1, this program reads 2); *' nothing \
        "$tool changed.h5 -o place/out"
    changed $file version
    row 'a file of a newer format' $tool 65 'changed.h5: a newer release wrote it (format 3, this program reads 2); use the same release of *' nothing \
        "$tool changed.h5 -o place/out"
    changed $file unknown
    row 'groups and attributes of a newer release' $tool 0 - - "$tool -q changed.h5 -o place/out"
    changed $file 'big-endian /VTKHDF/Points'
    row 'a big-endian file' $tool 65 'changed.h5:/VTKHDF/Points: does not hold 64-bit little-endian floats; *' nothing \
        "$tool changed.h5 -o place/out"
done
runs "cp result.h5 changed.h5 && $change changed.h5 unknown && postprocess -q changed.h5 -o unknown.csv"
claim "unknown objects are ignored: the curve is the same" cmp unknown.csv whole.csv
changed result.h5 'big-endian /path/pressure'
row 'a big-endian curve' postprocess 65 'changed.h5:/path/pressure: does not hold 64-bit little-endian floats; *' nothing \
    'postprocess changed.h5 -o place/out'
table_is_complete
