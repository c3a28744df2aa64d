#!/usr/bin/env bash
# Outputs that cannot be created (73) or completed (74), and the state of existing files.
#   outputs.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
runs 'mesh-gen -q designs/tube.yaml --set path.until.steps=3 -o case.h5 && solve -q case.h5 -o result.h5'
runs 'postprocess -q result.h5 > curve.csv'
declare -A command=([mesh-gen]='mesh-gen -q designs/tube.yaml' [solve]='solve -q case.h5' [postprocess]='postprocess -q result.h5'
                   [sweep-plan]='sweep-plan -q designs/sweeps/rod.yaml')

for tool in mesh-gen solve postprocess sweep-plan; do
    refuses 73 "$tool: no/such/file: cannot be created: No such file or directory" "${command[$tool]} -o no/such/file"
    refuses 73 "$tool: designs: is a folder; name a file" "${command[$tool]} -o designs"
    refuses 74 "$tool: <stdout>: cannot be written: No space left on device" "${command[$tool]} > /dev/full"
    refuses 74 "$tool: /dev/full: cannot be written: No space left on device" "${command[$tool]} -o /dev/full"
    refuses 74 "$tool: /dev/full: cannot be written: No space left on device" "${command[$tool]} --json /dev/full -o x"
    rm -f x
    refuses 74 "$tool: <stdout>: cannot be written: *" "${command[$tool]} >&-"
    if [ "$(id -u)" -ne 0 ]; then   # root may write anywhere
        mkdir -p locked && chmod a-w locked
        refuses 73 "$tool: locked/x: cannot be created: Permission denied" "${command[$tool]} -o locked/x"
    fi
    # A file size limit simulates a full disk.
    echo precious >kept
    refuses 74 "$tool: kept: cannot be written: *" "(ulimit -f 0; ${command[$tool]} -o kept) 2>&1 | cat >&2"
    claim "the existing file is unchanged" [ "$(cat kept)" = precious ]
    rm -f kept
done
# A solve that fails after reading its case keeps an existing result.
cp result.h5 kept.h5
refuses 65 'solve: solver.linear: cholmod needs *' 'solve -q case.h5 --set solver.linear=cholmod -o kept.h5'
refuses 64 'solve: PETSc: does not provide the solver *' 'solve -q case.h5 --set solver.linear=krylov -o kept.h5 -- -ksp_type no-such-type'
claim "the existing result is unchanged" cmp result.h5 kept.h5
runs 'postprocess -q kept.h5 | cmp - curve.csv && rm kept.h5'
# An output through a symbolic link is written to the target of the link.
mkdir links && ln -s ../links/absent links/dangling && ln -s dangling links/chain && ln -s loop links/loop && ln -s no/such links/nowhere
for tool in mesh-gen solve postprocess sweep-plan; do
    runs "${command[$tool]} -o links/chain && [ -L links/chain ] && [ -L links/dangling ] && [ -s links/absent ] && rm links/absent"
    refuses 73 "$tool: links/loop: cannot be created: Too many levels of symbolic links" "${command[$tool]} -o links/loop"
    refuses 73 "$tool: links/nowhere: cannot be created: No such file or directory" "${command[$tool]} -o links/nowhere"
done
rm -r links
# The longest file name that the file system accepts.
name=$(printf 'a%.0s' {1..255})
for tool in mesh-gen solve postprocess sweep-plan; do
    runs "${command[$tool]} -o $name && [ -s $name ] && rm $name"
    refuses 73 "$tool: ${name}a: cannot be created: File name too long" "${command[$tool]} -o ${name}a"
done
refuses 74 'postprocess: <stdin>: cannot be read: *' 'postprocess <&-'
if [ -n "$(type -P gnuplot)" ]; then
    refuses 73 'postprocess: no/picture.svg: cannot be created: *' 'postprocess -q result.h5 --plot no/picture.svg -o x'
    rm -f x
fi
rm -rf locked
claim "no temporary file is left" [ "$(echo *)" = 'case.h5 curve.csv designs meshes result.h5' ]
runs "${command[postprocess]} -o curve2.csv && cmp curve.csv curve2.csv && ${command[solve]} -o /dev/null"
