#!/usr/bin/env bash
# Drawings of the geometry keys: every length and angle of every family is drawn, and the stored drawings match the table.
#   parameter_pictures.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
scripts=$here/../../scripts
# names PICTURE-FIELD VALUE: names in the rows of these pictures
names() { awk -v field="$1" -v value="$2" '$1 == "picture" {on = $field == value} on && /^(dim|radius|angle|note) / {print $2}' "$scripts/parameter-pictures.txt" | sort -u; }
for family in $(mesh-gen --list | awk '{print $1}'); do
    case $family in
        two-spheres) continue ;;   # has no solid model
        revolved | extruded | imported) continue ;;   # shapes are defined by files
    esac
    # Keys whose default has a unit; `same` and `auto` are lengths derived from others.
    keys=$(mesh-gen --template "$family" | mesh-gen --explain - | awk '
        /^[a-z]/ {inside = /^geometry:/; next} !inside {next}
        {depth = int(match($0, /[^ ]/) / 2); path[depth] = $1; sub(/:$/, "", path[depth]); name = path[1]; for (i = 2; i <= depth; ++i) name = name "." path[i]}
        $3 ~ /^(mm|deg)$/ || $2 == "same" || $2 == "auto" {print name}' | sort)
    claim "$family: every length and angle is drawn" [ -z "$(comm -23 <(echo "$keys") <(names 3 "$family"))" ]
    comm -23 <(echo "$keys") <(names 3 "$family") | sed "s/^/not drawn: $family /"
done
runs "BUILD_DIR='$(dirname "$bin")' OUT='$PWD/pictures' '$scripts/parameter-pictures'"
while read -r picture; do
    for file in "pictures/$picture.svg" "$here/../../designs/pictures/$picture.svg"; do
        claim "$file contains the names of the table" [ "$(sed -n 's/.*<text>\([^<]*\)<.*/\1/p' "$file" | tr -d ' ' | grep . | sort -u)" = "$(names 2 "$picture")" ]
    done
    # Rubber is filled with grey.
    claim "$picture has a section" grep -qi 'rgb(217, 217, 217)\|#d9d9d9' "pictures/$picture.svg"
done < <(awk '$1 == "picture" {print $2}' "$scripts/parameter-pictures.txt")
refuses 64 'parameter-pictures: cube: no such picture in scripts/parameter-pictures.txt' "BUILD_DIR='$(dirname "$bin")' OUT='$PWD/pictures' '$scripts/parameter-pictures' cube"
