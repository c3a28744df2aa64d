#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# A locale with a decimal comma, and folders with spaces and non-ASCII letters, do not change the output of programs and scripts.
#   locales.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
scripts=$(realpath "$here/../../scripts")
printf '%s\n' 'Elongation (mm);Pressure (kPa)' '0,1;1,5' '0,3;3,5' >measured.csv
cp "$here/../fit/data/treloar-uniaxial.csv" test.csv
cat >all.sh <<'A'   # writes all outputs of the programs to the current folder
mesh-gen -q designs/tube.yaml --set path.until.steps=4 -o 'c 1.h5' && solve -q 'c 1.h5' -o 'r 1.h5' &&
postprocess -q 'r 1.h5' -o curve.csv --compare measured.csv --json compare.json --plot plot.svg >x.csv &&
postprocess -q 'r 1.h5' --at elongation=0.05mm -o at.csv --picture body.png &&
fit-material -q test.csv --law yeoh -o fit.yaml --plot fit.svg && fit-material -q test.csv --rank -o rank.csv && mesh-gen --explain designs/tube.yaml -o explain.yaml
A
written='body.png curve.csv compare.json plot.svg at.csv fit.yaml rank.csv explain.yaml'
mkdir plain && cp -R designs meshes measured.csv test.csv plain
runs 'cd plain && bash ../all.sh'
same() { local name; for name in $written; do claim "$1: $name is the same" cmp "plain/$name" "$2/$name"; done; }

if localedef -i de_DE -f UTF-8 "$PWD/locales/de_DE.UTF-8" 2>"$seen/err" || { mkdir -p locales && localedef -i de_DE -f UTF-8 "$PWD/locales/de_DE.UTF-8" >"$seen/out" 2>"$seen/err"; }; then
    export LOCPATH=$PWD/locales
    claim "the locale has a decimal comma" [ "$(LC_ALL=de_DE.UTF-8 bash -c 'printf %.1f 0,5')" = 0,5 ]
    mkdir comma && cp -R designs meshes measured.csv test.csv comma
    runs 'export LC_ALL=de_DE.UTF-8; cd comma && bash ../all.sh'
    same 'a decimal comma' comma
    comma=LC_ALL=de_DE.UTF-8
else
    echo "skipped: localedef cannot create a locale with a decimal comma"
    comma=LC_ALL=C
fi
far='Ordner für Höhlen/目 录'
mkdir -p "$far" && cp -R designs meshes measured.csv test.csv "$far"
runs "cd '$far' && bash \"\$OLDPWD/all.sh\""
same 'a path with spaces and UTF-8' "$far"

# Compares the output of the scripts in that folder and locale with the output in a plain folder and the C locale.
study() {   # study FOLDER ENVIRONMENT COMMAND: collects its stdout and out.csv
    runs "cd '$1' && rm -f out.csv && env $2 $3"
    cat "$seen/out" "$1/out.csv" >"$1/said" 2>"$seen/cat"
}
both() {   # both NAME COMMAND
    study plain LC_ALL=C "$2"
    study "$far" "$comma" "$2"
    claim "$1 gives the same output in both folders" cmp plain/said "$far/said"
    claim "$1 prints something" [ "$(wc -c <plain/said)" -gt 20 ]
}
both workspace "'$scripts/workspace' designs/segment.yaml --pressures chamber_1=4kPa,chamber_2=6kPa --steps 1 --set geometry.chambers=2 --set 'mesh={size: 12 mm, through_wall: 1}' --set geometry.length=24mm"
both mesh-study "'$scripts/mesh-study' \"\$PWD/designs/tube.yaml\" --along elongation --set path.until.elongation=2mm mesh.size=8mm mesh.size=6mm"
if [ -n "$(type -P parallel)" ]; then
    for folder in plain "$far"; do
        printf '%s\n' 'design: designs/rod.yaml' 'vary:' '  geometry.width: [8.5 mm, 12 mm]' \
            'set: {mesh.size: 20 mm, material.kappa: incompressible, loads.end.pressure: -100 kPa}' 'outputs: [pressure_kPa, elongation_mm]' >"$folder/rods 1.yaml"
    done
    both sweep "bash -c \"'$scripts/sweep' 'rods 1.yaml' --folder here >out.txt && cut -d, -f2- here/results.csv >out.csv\""
fi
