#!/usr/bin/env bash
# shellcheck disable=SC2016,SC2317  # the stand-ins expand $state; claim calls the little checks
# Tests scripts/setup in simulated systems: a copy of the scripts, and a PATH with a few real tools and stand-ins for apt-get, dpkg-query,
# update-alternatives, sudo, id and cmake that store their state in files.
#   setup_test.sh TREE
set -uo pipefail
tree=$(realpath "$1")
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
bin=$work/bin
state=$work/state
export state
unset BUILD_DIR JOBS   # the suite may use another build folder, which must not be changed here
failures=0

stand_in() {   # stand_in NAME, body from stdin; records every call in $state/calls
    { echo '#!/bin/sh'; echo "echo \"$1 \$*\" >>\"\$state/calls\""; cat; } >"$bin/$1"
    chmod +x "$bin/$1"
}

fresh_system() {   # all packages, an optimised BLAS, root, apt, and a CMake that finds everything
    rm -rf "$work/tree" "$bin" "$state"
    mkdir -p "$work/tree" "$bin" "$state"
    cp -R "$tree/scripts" "$work/tree/"
    for tool in bash sh awk sed paste head tail mkdir rm uname env cat dirname mktemp grep; do
        ln -s "$(type -P "$tool")" "$bin/$tool"
    done
    for tool in c++ ninja pkg-config mpirun gnuplot npm ffmpeg python3 chromium pvpython Xvfb; do ln -s "$(type -P true)" "$bin/$tool"; done
    (cd "$work/tree" && scripts/setup --list debian) | tr ' ' '\n' >"$state/installed"
    echo 0 >"$state/uid"
    echo 'libblas.so.3-x auto /usr/lib/x/openblas-serial/libblas.so.3' >"$state/alternatives"
    stand_in id <<<'cat "$state/uid"'
    stand_in dpkg-query <<'E2'
shift 3   # --show --showformat FORMAT
status=0
for name; do
    if grep -qx "$name" "$state/installed"; then echo "$name installed"; else status=1; fi
done
exit $status
E2
    stand_in apt-get <<'E2'
[ -e "$state/apt-fails" ] && { echo "E: Unable to locate package"; exit 100; }
found=
for word; do
    case $word in install) found=1 ;; -*) ;; *) [ -n "$found" ] && echo "$word" >>"$state/installed" ;; esac
done
true
E2
    stand_in update-alternatives <<'E2'
case $1 in
    --get-selections) cat "$state/alternatives" ;;
    --auto) echo "$2 auto /usr/lib/x/openblas-serial/libblas.so.3" >"$state/alternatives" ;;
esac
E2
    stand_in cmake <<'E2'
[ -e "$state/cmake-fails" ] && { echo "CMake Error at x: gmsh.h not found"; exit 1; }
mkdir -p build
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/CMakeCache.txt
echo >build/build.ninja
E2
}

setup() { : >"$state/calls"; output=$(cd "$work/tree" && PATH=$bin bash scripts/setup "$@" 2>&1 </dev/null); status=$?; }
remove() { grep -vx "$1" "$state/installed" >"$state/left"; mv "$state/left" "$state/installed"; }
called() { grep -qE -- "$1" "$state/calls"; }
claim() {   # claim TEXT COMMAND...: the command must succeed
    local text=$1
    shift
    if ! "$@"; then
        printf 'NOT TRUE: %s\n--- exit %s, calls:\n%s\n--- output:\n%s\n' "$text" "$status" "$(cat "$state/calls")" "$output"
        failures=$((failures + 1))
    fi
}
not() { ! "$@"; }
says() { [[ $output == *"$1"* ]]; }
exits() { [[ $status -eq $1 ]]; }

fresh_system; setup
claim "a complete system installs nothing" not called '^apt-get'
claim "the first call configures" called '^cmake -S'
claim "the tests are enabled, although CGAL's files would disable them" called '^cmake .*-DBUILD_TESTING=ON'
setup
claim "the second call runs no command" not called '^(cmake|apt-get)'
claim "the second call prints nothing" test -z "$output"
remove libgmsh-dev; setup
claim "a removed package is installed again" called '^apt-get .*install .*--no-install-recommends libgmsh-dev$'
claim "CMake runs again after an installation" called '^cmake'

fresh_system; remove libcgal-dev; remove nettle-dev; setup
claim "only the missing packages are installed" called ' --no-install-recommends libcgal-dev nettle-dev$'
claim "the installation succeeds" exits 0

fresh_system; rm "$bin/ninja"; remove ninja-build; setup
claim "a missing command installs its package" called ' ninja-build$'
fresh_system; remove ninja-build; setup
claim "a command from another source satisfies the row" not called '^apt-get'

fresh_system; remove libcgal-dev; echo 1000 >"$state/uid"; touch "$state/cmake-fails"; setup
claim "setup fails without root and sudo" exits 1
claim "the message contains the exact command" says 'apt-get install --no-install-recommends libcgal-dev'
claim "the message contains the error of CMake" says 'gmsh.h not found'
claim "nothing is installed without root" not called '^apt-get'
rm "$state/cmake-fails"; setup
claim "a library that CMake finds elsewhere is accepted" exits 0

fresh_system; remove libcgal-dev; echo 1000 >"$state/uid"
stand_in sudo <<'E2'
[ "$1" = -n ] && shift
"$@"
E2
setup
claim "sudo is used by other users than root" called '^sudo env .*apt-get .* libcgal-dev$'

fresh_system; remove libcgal-dev; touch "$state/apt-fails" "$state/cmake-fails"; setup
claim "a failed installation is an error" exits 1
claim "the error contains the message of apt" says 'E: Unable to locate package'

fresh_system; rm "$bin/chromium"; remove chromium; setup
claim "a build does not install packages of the tests" not called '^apt-get'
setup --tests
claim "--tests installs packages of the tests" called '^apt-get .* chromium$'
fresh_system; rm "$bin/chromium"; remove chromium; touch "$state/apt-fails"; setup --tests
claim "a package of the tests that cannot be installed is a warning" says 'warning: chromium could not be installed'
fresh_system; remove dpkg-dev; rm -f "$bin/dpkg-shlibdeps"; setup --package
claim "--package installs dpkg-dev" called '^apt-get .* dpkg-dev$'
fresh_system; remove mkdocs; setup --docs
claim "--docs installs mkdocs" called '^apt-get .* mkdocs$'
claim "--docs does not configure" not called '^cmake'
fresh_system; remove mkdocs; setup --tests
claim "--tests installs the packages of the documentation" called '^apt-get .* mkdocs$'
fresh_system; remove clang-16; rm -f "$bin/clang++-16"; setup --tests
claim "--tests does not install packages of .ci/run" not called '^apt-get'
setup --checks
claim "--checks installs packages of .ci/run" called '^apt-get .*install.* clang-16'
claim "a missing package of the tests does not fail --checks" exits 0

fresh_system; rm "$bin/apt-get"; setup
claim "a complete system without apt succeeds" exits 0
fresh_system; rm "$bin/apt-get"; touch "$state/cmake-fails"; setup
claim "an incomplete system without apt fails" exits 1
for words in libgmsh-dev gmsh-devel 'Homebrew:' 'PETSc 3.18' 'gmsh 4.8'; do claim "the message contains $words" says "$words"; done

fresh_system; echo 'libblas.so.3-x manual /usr/lib/x/blas/libblas.so.3' >"$state/alternatives"; setup
claim "the reference BLAS is replaced" called '^update-alternatives --auto libblas.so.3-x'
fresh_system; remove libopenblas0-serial; setup
claim "any optimised BLAS is accepted" not called '^apt-get'
echo 'libblas.so.3-x auto /usr/lib/x/blas/libblas.so.3' >"$state/alternatives"; setup
claim "OpenBLAS is installed if only the reference BLAS exists" called '^apt-get .* libopenblas0-serial$'

fresh_system; setup; mv "$work/tree/build/CMakeCache.txt" "$state/"
echo 'CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere' >"$work/tree/build/CMakeCache.txt"; setup
claim "a copied build folder is configured again" called '^cmake .*--fresh'

((failures == 0)) && echo "every claim holds"
exit $((failures > 0))
