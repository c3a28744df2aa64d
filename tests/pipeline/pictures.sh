#!/usr/bin/env bash
# Pictures and films of the body.   pictures.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
unset DISPLAY   # headless

is_png() { [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] && [ "$(stat -c %s "$1")" -gt 5000 ]; }

runs 'mesh-gen designs/dome.yaml | solve > dome.h5'
for field in stretch von-mises pressure displacement energy J; do
    runs "postprocess dome.h5 --picture $field.png --field $field --quiet"
    claim "a picture of $field" is_png "$field.png"
done
claim "fields differ" not cmp -s stretch.png pressure.png
claim "no table on stdout" [ ! -s "$seen/out" ]
claim "nothing on stderr" quiet
for view in front side top iso 30,60; do
    runs "postprocess dome.h5 --picture view.png --view $view"
    claim "seen from $view" is_png view.png
    claim "which step is told" like "$(head -n 1 "$seen/err")" 'postprocess: view.png: step [0-9]*'
done
runs 'postprocess dome.h5 --picture whole.png --whole && postprocess dome.h5 --picture flat.png --section'
claim "the whole is not the section" not cmp -s whole.png flat.png

# --at: the stored step nearest to it; several give several pictures
runs 'postprocess dome.h5 --picture at.png --at apex=-5mm,-10mm'
claim "two pictures" is_png at-1.png && is_png at-2.png
claim "of two steps" [ "$(grep -c 'at-[12].png: step [0-9]' "$seen/err")" -eq 2 ]
runs 'postprocess dome.h5 --picture same.png --range 1,1.2'
claim "the range changes the colours" not cmp -s same.png view.png
runs 'postprocess dome.h5 --picture again.png --range 1,1.2'
claim "the same request gives the same bytes" cmp same.png again.png

# films
runs 'mesh-gen designs/ring.yaml | solve --fields every=4 > ring.h5 && postprocess ring.h5 --animate frames/ --quiet'
frames=$(find frames -name 'frame-*.png' | wc -l)
claim "a frame for each stored step" [ "$frames" -ge 2 ]
if [ -n "$(type -P ffmpeg)" ]; then
    runs 'postprocess ring.h5 --animate film.gif --quiet && postprocess ring.h5 --animate film.mp4 --quiet'
    claim "a GIF" [ "$(head -c 6 film.gif)" = GIF89a ]
    claim "an MP4" [ "$(head -c 8 film.mp4 | tail -c 4)" = ftyp ]
fi
mkdir gnuplot-alone && ln -s "$(type -P gnuplot)" "$bin/postprocess" gnuplot-alone/
refuses 73 'postprocess: film2.mp4: the program ffmpeg, which makes films, is not installed; install the package ffmpeg*' \
    'PATH=$PWD/gnuplot-alone postprocess ring.h5 --animate film2.mp4 --quiet'
mkdir alone && ln -s "$bin/postprocess" alone/
refuses 73 'postprocess: a.png: the program gnuplot, which draws the picture, is not installed; install the package gnuplot-nox*' \
    'PATH=$PWD/alone postprocess ring.h5 --picture a.png --quiet'
claim "no file is left behind" [ ! -e a.png ] && [ ! -e film2.mp4 ]

refuses 64 "postprocess: --field: 'stretches' is no field; did you mean 'stretch'?" 'postprocess ring.h5 --picture a.png --field stretches'
refuses 64 "postprocess: --view: 'behind' is no view; *" 'postprocess ring.h5 --picture a.png --view behind'
refuses 64 'postprocess: --picture a.svg: pictures of the body are written as .png' 'postprocess ring.h5 --picture a.svg'
refuses 64 'postprocess: --animate a.avi: *' 'postprocess ring.h5 --animate a.avi'
refuses 64 'postprocess: --field: says nothing without --picture or --animate' 'postprocess ring.h5 --field J'
refuses 64 'postprocess: --range: LOW is not below HIGH' 'postprocess ring.h5 --picture a.png --range 2,1'
refuses 64 'postprocess: --range: *' 'postprocess ring.h5 --picture a.png --field von-mises --range 1,2'
refuses 64 'postprocess: --section: and --whole exclude each other; *' 'postprocess ring.h5 --picture a.png --section --whole'
refuses 65 'postprocess: --at pressure=900000kPa: the path does not reach it; *' 'postprocess dome.h5 --picture a.png --at pressure=900MPa'
