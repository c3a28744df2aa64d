#!/usr/bin/env bash
# Uses an installation that was moved after `cmake --install`.   install.sh BIN CMAKE BUILD
. "$(dirname "${BASH_SOURCE[0]}")/../pipeline/check.sh"
build=$3   # an absolute path
source=$(realpath "$here/../..")
moved=$work/moved
mkdir "$work/empty" && cd "$work/empty" || exit 1
runs "'$cmake' --install '$build' --prefix '$work/staged'"
mv "$work/staged" "$moved"
claim "no installed file names the source or build folder" not grep -rqF -e "$source" -e "$(realpath "$build")" "$moved"

# The tour, in an empty folder with only the installed programs on the PATH
tour() { runs "PATH='$moved/bin'; $1"; }
tour 'mesh-gen --template bellows >my.yaml; mesh-gen --check my.yaml'
tour 'mesh-gen my.yaml --set material=ecoflex-00-30 --set mesh.quality=draft --set path.until.elongation=20mm | solve | postprocess >curve.csv'
claim "the curve is a table" table curve.csv
tour 'mesh-gen designs/tube.yaml -o tube.h5'
claim "mesh-gen reports which example it reads" grep -qx "mesh-gen: reads the example $moved/share/soft-actuator/designs/tube.yaml" "$seen/err"
tour 'mesh-gen designs/revolved.yaml --check'   # its profile lies beside it
tour 'sweep-plan designs/sweeps/rod.yaml -o plan.csv'
refuses 66 '*designs/none.yaml*' "PATH='$moved/bin'; mesh-gen designs/none.yaml"

# The scripts
for script in sweep workspace; do
    runs "'$moved/bin/soft-$script' --help"
    claim "the help names the installed command" grep -q "soft-$script " "$seen/out"
    claim "and not the script of the source tree" not grep -q "scripts/$script " "$seen/out"
    claim "its man page has the help" grep -q "^soft.-$script .- [A-Z]" "$moved/share/man/man1/soft-$script.1"
done
ln -s "$moved/bin/soft-workspace" linked
runs 'PATH=/usr/bin:/bin; ./linked --help'
if [ -n "$(type -P parallel)" ]; then
    runs "PATH=/usr/bin:/bin; '$moved/bin/soft-sweep' designs/sweeps/rod.yaml --folder rods"
    claim "the sweep has its results" [ "$(wc -l <rods/results.csv)" -eq 5 ]
fi

# Man pages and completions
for tool in "$moved"/bin/*; do
    tool=${tool##*/}
    case $tool in soft-*) continue ;; esac
    for file in man/man1/$tool.1 bash-completion/completions/$tool zsh/site-functions/_$tool fish/vendor_completions.d/$tool.fish; do
        claim "$file mentions --output" grep -qE '(-|\\-|-l )output' "$moved/share/$file"
    done
done

# The C++ program of the tutorial, built by CMake and with pkg-config, gives the curve of the programs
page=$source/docs/tutorials/cpp.md
fenced() { awk -v fence="\`\`\`$1" '$0 == "```" { inside = 0 } inside; $0 == fence { inside = 1 }' "$page"; }
fenced cpp >curve.cpp
fenced cmake >CMakeLists.txt
export LIMIT=600
runs "'$cmake' -S . -B built -DCMAKE_PREFIX_PATH='$moved' -DCMAKE_BUILD_TYPE=Release && '$cmake' --build built"
cp "$moved/share/soft-actuator/designs/tube.yaml" .
runs "mesh-gen tube.yaml | solve -q | postprocess | cut -d, -f2,3 | tail -n +2 >expected.csv"
runs 'built/curve tube.yaml >printed.csv'
claim "it prints the header" [ "$(head -n 1 printed.csv)" = pressure_kPa,elongation_mm ]
claim "it prints the curve of solve" cmp <(awk -F, '{ printf "%.4f,%.3f\n", $1, $2 }' expected.csv) <(tail -n +2 printed.csv)
refuses 1 'curve: *' 'built/curve missing.yaml'
if [ -n "$(type -P pkg-config)" ]; then
    runs "PKG_CONFIG_PATH='$moved/lib/pkgconfig'; export PKG_CONFIG_PATH; c++ curve.cpp -o curve \$(pkg-config --cflags --libs soft-actuator) && ./curve tube.yaml"
    claim "it prints the same curve" cmp "$seen/out" printed.csv
fi
