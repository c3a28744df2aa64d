#!/usr/bin/env bash
# Pictures and films of the body.   pictures.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
unset DISPLAY   # headless

is_png() { [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] && [ "$(stat -c %s "$1")" -gt 5000 ]; }

runs 'mesh-gen designs/dome.yaml | solve > dome.h5'
for field in stretch von-mises pressure displacement energy J contact-pressure; do
    runs "postprocess dome.h5 --picture $field.png --field $field --quiet"
    claim "a picture of $field" is_png "$field.png"
done
claim "fields differ" not cmp -s stretch.png pressure.png
claim "stdout is empty" [ ! -s "$seen/out" ]
claim "stderr is empty" quiet
for view in front side top iso 30,60; do
    runs "postprocess dome.h5 --picture view.png --view $view"
    claim "view $view gives a picture" is_png view.png
    claim "the state is printed" like "$(head -n 1 "$seen/err")" 'postprocess: view.png: step [0-9]*, pressure 5 kPa, apex -* mm'
done
runs 'postprocess dome.h5 --picture whole.png --whole && postprocess dome.h5 --picture flat.png --section'
claim "the whole body and the section differ" not cmp -s whole.png flat.png

# --at: the nearest stored step; several values give several pictures
runs 'postprocess dome.h5 --picture each.png --at apex=-10mm,-10.0001mm,-5mm'
for k in 1 2 3; do claim "a file for request $k" is_png "each-$k.png"; done
claim "two values with the same nearest step give the same picture" cmp each-1.png each-2.png
claim "the same state is printed for both" [ "$(grep -o '^postprocess: each-[12].png: step [0-9]*, pressure .* kPa, apex .* mm$' "$seen/err" | cut -d: -f3 | uniq -c | awk '{ print $1 }')" = 2 ]
claim "the step is the nearest one" within "$(grep -o 'each-1.png: .* apex .* mm' "$seen/err" | awk '{ print $(NF - 1) }')" -11.5 -8.5
runs 'postprocess dome.h5 --picture same.png --range 1,1.2'
claim "--range changes the colours" not cmp -s same.png view.png
runs 'postprocess dome.h5 --picture again.png --range 1,1.2'
claim "the same command gives the same bytes" cmp same.png again.png

# films
mkdir frames && touch frames/frame-9999.png frames/frame-99.png frames/notes.txt   # stale frames of a longer film, and other files
runs 'mesh-gen designs/ring.yaml | tee ring-case.h5 | solve --fields every=4 > ring.h5 && postprocess ring.h5 --animate frames/'
frames=$(find frames -name 'frame-????.png' | wc -l)
claim "there is a frame for each stored step" [ "$frames" -ge 2 ]
claim "a stale frame is removed" [ ! -e frames/frame-9999.png ]
claim "the removal is reported" grep -qx "postprocess: frames/: $frames steps; 1 frame of an earlier result removed" "$seen/err"
claim "other files are kept" rm frames/frame-99.png frames/notes.txt
claim "no other file is written" [ "$(find frames -type f | wc -l)" -eq "$frames" ]
if [ -n "$(type -P ffmpeg)" ]; then
    runs 'postprocess ring.h5 --animate film.gif 2>said'
    runs 'postprocess ring.h5 --animate film.mp4 --quiet'
    claim "the film has interpolated frames" grep -qx 'postprocess: film.gif: 36 frames' said
    rm said
    claim "the file is a GIF" [ "$(head -c 6 film.gif)" = GIF89a ]
    claim "the file is an MP4" [ "$(head -c 8 film.mp4 | tail -c 4)" = ftyp ]
fi
# Errors are reported before the first frame, in one line, and leave no file.
mkdir gnuplot-alone && ln -s "$(type -P gnuplot)" "$bin/postprocess" gnuplot-alone/
# shellcheck disable=SC2016  # for the inner shell
refuses 73 'postprocess: film2.mp4: the program ffmpeg, which makes films, is not installed; install the package ffmpeg*' \
    'PATH=$PWD/gnuplot-alone postprocess ring.h5 --animate film2.mp4'
refuses 73 'postprocess: none/film2.mp4: cannot be created: No such file or directory' 'postprocess ring.h5 --animate none/film2.mp4'
refuses 73 "postprocess: --animate a/b/: the folder 'a' for 'b' does not exist; create it first*" 'postprocess ring.h5 --animate a/b/'
refuses 73 "postprocess: --animate film2/: 'film2' exists and is not a folder; choose another name*" \
    'touch film2; postprocess ring.h5 --animate film2/'
mkdir alone && ln -s "$bin/postprocess" alone/
# shellcheck disable=SC2016  # for the inner shell
refuses 73 'postprocess: a.png: the program gnuplot, which draws the picture, is not installed; install the package gnuplot-nox*' \
    'PATH=$PWD/alone postprocess ring.h5 --picture a.png --quiet'
claim "no picture is left" [ ! -e a.png ]
claim "no film is left" [ ! -e film2.mp4 ]

# Full disk: write errors are reported although gnuplot and ffmpeg succeed.
ln -s /dev/full full.png
refuses 74 'postprocess: full.png: cannot be written: No space left on device' 'postprocess -q ring.h5 --picture full.png'
films='gif mp4'
if [ -z "$(type -P ffmpeg)" ]; then films=; fi
runs 'solve -q ring-case.h5 --fields last -o short.h5'
mkdir disk
if mount -t tmpfs -o size=16k tmpfs disk 2>"$seen/err"; then
    for file in disk/a.png ${films:+disk/a.gif disk/a.mp4}; do
        option=--animate
        if [ "$file" = disk/a.png ]; then option=--picture; fi
        echo old >"$file"
        refuses 74 "postprocess: $file: cannot be written: No space left on device" "postprocess -q short.h5 $option $file"
        claim "the existing file is kept" [ "$(cat "$file")" = old ]
        claim "no other file is left" [ "$(ls disk)" = "${file#disk/}" ]
        rm -f "$file"
    done
    umount disk
else
    echo "skipped: a small disk cannot be mounted here"
fi

# A signal at any time leaves no partial or temporary files.
mkdir stopped temporary
for how in INT:0.2 TERM:0.5 INT:0.8 TERM:1.1; do
    for file in a.png ${films:+a.gif a.mp4}; do
        option=--animate
        if [ "$file" = a.png ]; then option=--picture; fi
        run "TMPDIR=\$PWD/temporary timeout -s ${how%:*} ${how#*:} postprocess -q dome.h5 $option stopped/$file"
        claim "only the complete file may be left" [ "$(find stopped temporary -mindepth 1 ! -name "$file" | wc -l)" -eq 0 ]
        rm -f "stopped/$file"
    done
done

refuses 64 "postprocess: --field: 'stretches' is not a field; did you mean 'stretch'?" 'postprocess ring.h5 --picture a.png --field stretches'
refuses 64 "postprocess: --view: 'behind' is not a view; *" 'postprocess ring.h5 --picture a.png --view behind'
refuses 64 'postprocess: --picture a.svg: unknown extension; use .png' 'postprocess ring.h5 --picture a.svg'
refuses 64 'postprocess: --animate a.avi: *' 'postprocess ring.h5 --animate a.avi'
refuses 64 'postprocess: --field: has no effect without --picture or --animate' 'postprocess ring.h5 --field J'
refuses 64 'postprocess: --range: LOW is not below HIGH' 'postprocess ring.h5 --picture a.png --range 2,1'
refuses 64 'postprocess: --range: *' 'postprocess ring.h5 --picture a.png --field von-mises --range 1,2'
refuses 64 'postprocess: --section: and --whole exclude each other; *' 'postprocess ring.h5 --picture a.png --section --whole'
refuses 65 'postprocess: --at pressure=900000kPa: the path does not reach it; *' 'postprocess dome.h5 --picture a.png --at pressure=900MPa'
refuses 64 'postprocess: --view: a plane-strain model is drawn only from the front; omit --view' \
    'postprocess ring.h5 --picture a.png --view side'
runs 'postprocess -q ring.h5 --picture a.png --view front && mesh-gen designs/plate.yaml | solve --fields last > plate.h5'
refuses 64 'postprocess: --section: the model is not axisymmetric and has no such section; *' \
    'postprocess plate.h5 --picture a.png --section'
refuses 64 'postprocess: --section: the model is not axisymmetric and has no such section; *' \
    'postprocess plate.h5 --animate film3.gif --section'
