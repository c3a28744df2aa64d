#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# Hostile and very large input is rejected or accepted within 700 MB of address space.   hostile.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
limits='ulimit -v 700000; ulimit -c 0;'
family=$(sed -n '/^family/p' designs/tube.yaml)
runs 'mesh-gen -q designs/tube.yaml -o case.h5'

head -c 100000000 /dev/zero | tr '\0' '#' >big.yaml   # one comment of 100 MB
row '100 MB of YAML' mesh-gen 65 'big.yaml: longer than *' - "$limits mesh-gen big.yaml -o place/out"
row '/dev/zero as design' mesh-gen 65 '/dev/zero: longer than *' nothing "$limits mesh-gen /dev/zero -o place/out"
row 'an endless stdin' mesh-gen 65 '<stdin>: longer than *' nothing "$limits yes | mesh-gen -o place/out"
row '/dev/zero as test data' fit-material 65 '/dev/zero: longer than *' nothing "$limits fit-material /dev/zero --law yeoh -o place/out"
row '/dev/zero as case' solve 65 '/dev/zero: not an HDF5 file *; expected *' nothing "$limits solve /dev/zero -o place/out"
row 'an endless stdin' solve 65 '<stdin>: not an HDF5 file *; expected *' nothing "$limits yes | solve -o place/out"
row 'an endless stdin' postprocess 65 '<stdin>: not an HDF5 file *; expected *' nothing "$limits yes | postprocess -o place/out"
row '/dev/zero as measured data' postprocess 65 '/dev/zero: longer than *' nothing "$limits solve -q case.h5 --set path.until.steps=1 -o r.h5; postprocess r.h5 --compare /dev/zero -o place/out"
row '/dev/zero as a table of points' hull-volume 65 '/dev/zero: longer than *' nothing "$limits hull-volume /dev/zero -o place/out"

{   # ten levels of nine aliases: 3e9 scalars if expanded
    echo "$family"
    echo 'a0: &a0 [x, x, x, x, x, x, x, x, x]'
    for i in 1 2 3 4 5 6 7 8 9; do
        p=$((i - 1))
        echo "a$i: &a$i [*a$p, *a$p, *a$p, *a$p, *a$p, *a$p, *a$p, *a$p, *a$p]"
    done
} >bomb.yaml
row 'exponential YAML aliases' mesh-gen 65 'bomb.yaml:*' nothing "$limits mesh-gen bomb.yaml -o place/out"
{ echo "$family"; printf 'geometry: '; head -c 100000 /dev/zero | tr '\0' '['; } >deep.yaml
row '100,000 levels of YAML' mesh-gen 65 'deep.yaml*' nothing "$limits mesh-gen deep.yaml -o place/out"
{ echo '&a'; sed 's/^geometry:/geometry: *a/;q' designs/tube.yaml; } >cycle.yaml
row 'a cyclic YAML alias' mesh-gen 65 'cycle.yaml:*' nothing "$limits mesh-gen cycle.yaml -o place/out"

for ((i = 0; i < 10000; ++i)); do echo "--set"; echo "mesh.size=1.$((i % 10))mm"; done >sets
row '10,000 --set' mesh-gen 0 - 'a complete case' 'mapfile -t sets <sets; mesh-gen -q designs/tube.yaml "${sets[@]}" -o place/out'
for ((i = 0; i < 10000; ++i)); do echo "--set"; echo "solver.step_limit=$((2 + i % 9))"; done >sets
row '10,000 --set' solve 2 - - 'mapfile -t sets <sets; solve -q case.h5 "${sets[@]}" -o place/out'
table_is_complete
