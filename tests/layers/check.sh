#!/bin/sh
# check.sh TREE: checks the dependencies in TREE/lib.   check.sh --self-check: plants one violation of each kind in a small clean tree
# and fails unless each is found.
here=$(cd "$(dirname "$0")" && pwd)

check() {   # in TREE
    (cd "$1" && find lib -name '*.hpp' -o -name '*.cpp' -o -name CMakeLists.txt | sort |
        xargs awk -f "$here/check.awk" "$here/dependencies.txt")
}

clean_tree() {
    rm -rf "${work:?}/lib"
    mkdir -p "$work/lib/core" "$work/lib/mesh" "$work/lib/io" "$work/lib/geometry" "$work/lib/post" || exit 1
    echo 'soft_module(core)' >"$work/lib/core/CMakeLists.txt"
    printf 'soft_module(mesh SOURCES mesh.cpp\n          USES core)   # one dependency\n' >"$work/lib/mesh/CMakeLists.txt"
    echo 'soft_module(io SOURCES file.cpp USES mesh LIBRARIES soft_hdf5)' >"$work/lib/io/CMakeLists.txt"
    printf '#include <vector>\n' >"$work/lib/core/error.hpp"
    printf '#include "core/error.hpp"\n' >"$work/lib/mesh/mesh.hpp"
    printf '#include "mesh/mesh.hpp"\n#include "core/error.hpp"\n' >"$work/lib/mesh/mesh.cpp"
    printf '#include <hdf5.h>\n#include "mesh/mesh.hpp"\n' >"$work/lib/io/file.cpp"
}

expect_found() {   # "words of the message" after planting
    if found=$(check "$work"); then
        echo "NOT FOUND: $1"; failed=1
    elif ! printf '%s\n' "$found" | grep -qF -- "$1"; then
        printf 'WRONG MESSAGE for %s:\n%s\n' "$1" "$found"; failed=1
    fi
    clean_tree
}

self_check() {
    work=$(mktemp -d) || exit 1
    trap 'rm -rf "$work"' EXIT
    failed=0
    clean_tree
    check "$work" >/dev/null || { echo "the clean tree is rejected:"; check "$work"; failed=1; }

    echo '#include "mesh/mesh.hpp"' >>"$work/lib/core/error.hpp"
    expect_found 'lib/core/error.hpp:2: module core may not include mesh/mesh.hpp'
    echo '#  include <gmsh.h>' >>"$work/lib/mesh/mesh.cpp"
    expect_found 'module mesh may not include <gmsh.h>'
    echo '#include <H5Cpp.h>' >>"$work/lib/mesh/mesh.hpp"
    expect_found 'module mesh may not include <H5Cpp.h>'
    echo '#include <CLI/CLI.hpp>' >>"$work/lib/io/file.cpp"
    expect_found 'module io may not include <CLI/CLI.hpp>'
    echo '#include <hdf5.h>' >"$work/lib/io/file.hpp"   # allowed in io, but not for modules that include io/file.hpp
    echo '#include "io/file.hpp"' >"$work/lib/post/curve.cpp"
    expect_found 'lib/post/curve.cpp:1: reaches <hdf5...> through lib/io/file.hpp'
    echo '#include "tools/cli.hpp"' >>"$work/lib/io/file.cpp"
    expect_found 'tools/cli.hpp is outside lib/'
    echo '#include "../mesh/mesh.hpp"' >>"$work/lib/io/file.cpp"
    expect_found '../mesh/mesh.hpp is outside lib/'
    echo '#include "file.hpp"' >>"$work/lib/io/file.cpp"
    expect_found 'does not start with a module'
    echo '#include "core/error.hpp"' >>"$work/lib/io/file.cpp"
    expect_found 'lib/io/CMakeLists.txt does not name; add it to USES'
    echo 'soft_module(core USES mesh)' >"$work/lib/core/CMakeLists.txt"
    expect_found 'USES mesh is not an allowed dependency of module core'
    mkdir "$work/lib/attic" && echo 'soft_module(attic)' >"$work/lib/attic/CMakeLists.txt"
    expect_found 'module attic is not in tests/layers/dependencies.txt'
    [ "$failed" -eq 0 ] && echo "every planted violation was found"
    exit "$failed"
}

case $1 in
    --self-check) self_check ;;
    *) check "$1" ;;
esac
