#!/usr/bin/env bash
# scripts/sweep on this machine: results, no repeated computation, kill -9, designs that fail, invalid files.
#   sweep.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
sweep=$here/../../scripts/sweep
folder=results/sweeps
needs parallel parallel

cell() { awk -F, -v name="$1" -v row="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i; next } NR == row + 1 { print $c }' "$3"; }
ages() { stat -c '%n %Y %i' "$1"/*/status; }
only_whole() {   # only_whole FOLDER: every design folder is complete
    local each
    for each in "$1"/????????????????; do
        [ ! -e "$each" ] || { [ -s "$each/status" ] && [ -s "$each/design.yaml" ] && [ -s "$each/result.h5" ]; } || return 1
    done
}

# Four rods with a known solution: the stress on the deformed end is mu (l^2 - 1/l) for any width.
cat >rods.yaml <<'END'
design: designs/rod.yaml
vary:
  geometry.width: {from: 8 mm, to: 12 mm, steps: 2}
  material.mu: [100 kPa, 164.4 kPa]
set: {mesh.size: 20 mm, material.kappa: incompressible, loads.end.pressure: -100 kPa}
outputs: [pressure_kPa, elongation_mm]
END
refuses 64 "sweep: the sweep is missing; see *" "$sweep"
refuses 64 "sweep: --engine: unknown engine 'paralel' *" "$sweep rods.yaml --engine paralel"
refuses 64 "sweep: unknown option '--job'; *" "$sweep rods.yaml --job 3"
runs "$sweep rods.yaml --dry-run"
claim "a dry run shows the plan" [ "$(grep -c waiting "$seen/out")" -eq 4 ]
claim "a dry run counts the designs" says 'sweep: 4 designs: 4 waiting, 0 done, 0 refused'
claim "a dry run writes nothing" [ ! -e results ]
# OMP_NUM_THREADS=1 must not limit the number of cores.
mkdir stub
printf '#!/bin/sh\necho "$@" >>calls.txt\n' >stub/parallel
chmod +x stub/parallel
run "PATH=$PWD/stub:\$PATH OMP_NUM_THREADS=1 $sweep rods.yaml --folder called"
run "PATH=$PWD/stub:\$PATH $sweep rods.yaml --folder called"
claim "OMP_NUM_THREADS does not limit the cores" [ "$(grep -oE -- '--jobs [1-9][0-9]*' calls.txt | uniq -c | awk '{ print $1 }')" = 2 ]

runs "$sweep rods.yaml"
claim "stdout is empty" [ ! -s "$seen/out" ]
claim "progress is reported" grep -q '^sweep: 2 of 4 designs, [0-9.]* .* left$' "$seen/err"
table=$folder/rods/results.csv
claim "there is one row per design" [ "$(wc -l <"$table")" -eq 5 ]
claim "the columns are correct" [ "$(head -n 1 "$table")" = 'id,geometry_width_mm,material_mu_kPa,pressure_kPa_at_end,elongation_mm_at_end,stop_reason,exit_code,error' ]
for row in 1 2 3 4; do
    stretch=$(cell elongation_mm_at_end $row "$table" | awk '{ printf "%.15g", 1 + $1 / 100 }')
    claim "row $row is done" [ "$(cell stop_reason $row "$table"),$(cell exit_code $row "$table")" = done,0 ]
    pull=$(awk -v l="$stretch" -v mu="$(cell material_mu_kPa $row "$table")" 'BEGIN { print mu * (l * l - 1 / l) }')
    claim "row $row: the stress is mu (l^2 - 1/l)" within "$pull" 99.9999 100.0001
done
id=$(cell id 1 "$table")
claim "there is one folder per design" [ "$(find $folder/rods -mindepth 2 -name status | wc -l)" -eq 4 ]
for file in design.yaml result.h5 curve.csv summary.json log; do claim "the folder contains $file" [ -s "$folder/rods/$id/$file" ]; done
runs "mesh-gen -q $folder/rods/$id/design.yaml | solve -q | postprocess -q | cmp - $folder/rods/$id/curve.csv"
ages $folder/rods >before.txt
cp "$table" first.csv

runs "$sweep rods.yaml"
claim "a second run computes nothing" grep -q ' 4 designs, 0 to compute ' "$seen/err"
claim "no folder is changed" cmp before.txt <(ages $folder/rods)
claim "the table is the same" cmp first.csv "$table"
sed -i 's/\[pressure_kPa, elongation_mm\]/[stretch_p99]/; s/steps: 2/steps: 3/' rods.yaml
runs "$sweep rods.yaml"
claim "only new designs are computed" grep -q ' 6 designs, 2 to compute ' "$seen/err"
claim "other outputs need no new computation" [ -n "$(cell stretch_p99_at_end 1 "$table")" ]
sed -i 's/\[stretch_p99\]/[pressure_kPa, elongation_mm]/; s/steps: 3/steps: 2/' rods.yaml

# kill -9 of all processes during the sweep
setsid "$sweep" rods.yaml --folder killed --jobs 1 >out.txt 2>err.txt </dev/null &
session=$!
for _ in {1..1200}; do
    if [ -n "$(find killed -mindepth 2 -maxdepth 2 -name status -not -path '*/.part/*' 2>/dev/null)" ]; then break; fi
    sleep 0.05
done
while pkill -KILL --session "$session"; do sleep 0.2; done   # also processes started while the others are killed
{ wait "$session"; } 2>/dev/null
computed=$(find killed -mindepth 2 -maxdepth 2 -name status -not -path '*/.part/*' | wc -l)
claim "the kill interrupted the sweep" within "$computed" 1 3
claim "no incomplete design looks complete" only_whole killed
mkdir -p killed/.part/host.1/cases   # of a worker killed before it had its lock, or while it removed its folder
runs "$sweep rods.yaml --folder killed"
claim "the next run computes the rest" grep -q " 4 designs, $((4 - computed)) to compute " "$seen/err"
claim "the final table is the same" cmp first.csv killed/results.csv
claim "no temporary folder is left" [ -z "$(ls -A killed/.part)" ]

# Failures: a wall without thickness, a path that ends at its limit point, a program that is killed
cat >orders.yaml <<'END'
design: designs/rod.yaml
vary: {mesh.order: [1, 2], mesh.formulation: [displacement, mixed]}
set: {mesh.size: 50 mm}
END
runs "$sweep orders.yaml"
claim "three are done" [ "$(grep -c ',done,0,$' $folder/orders/results.csv)" -eq 3 ]
claim "an invalid combination of keys is a row" \
    grep -q ',1,mixed,.*,refused,65,"\?orders.yaml:2:[0-9]*: mesh.order: ' $folder/orders/results.csv
cat >tubes.yaml <<'END'
design: designs/tube.yaml
vary: {geometry.inner_radius: [7 mm, 12 mm]}
set: {mesh.size: 3 mm, path.control: pressure}
at: [limit, volume=15mL, volume=9L]
END
runs "$sweep tubes.yaml"
table=$folder/tubes/results.csv
claim "two designs are two rows" [ "$(wc -l <"$table")" -eq 3 ]
claim "an early end is a row with its stop reason" [ "$(cell stop_reason 1 "$table"),$(cell exit_code 1 "$table")" = limit_point,2 ]
claim "the row contains the outputs" within "$(cell pressure_kPa_at_limit 1 "$table")" 44 45
claim "an invalid geometry is a row" grep -q ',refused,65,.*inner_radius' "$table"
claim "a value that the path does not reach has a reason" grep -q 'limit_point,2,".*at volume=9000mL: the path does not reach it; it goes from' "$table"
runs "$sweep tubes.yaml --dry-run --folder dry"
claim "a dry run counts invalid geometries" says 'sweep: 2 designs: 1 waiting, 0 done, 1 refused'
runs "$sweep tubes.yaml"
claim "failed designs are not computed again" grep -q ' 2 designs, 0 to compute ' "$seen/err"

# In long sweeps a worker gets several designs, which a single mesh-gen meshes. Here mesh-gen rejects one, because its face has no support.
cat designs/rod.yaml - >pulled.yaml <<'END'
  pull: {face: fixed, along: x, measure: force}
END
cat >pulls.yaml <<'END'
design: pulled.yaml
vary: {outputs.pull.face: [fixed, end]}
set: {mesh.size: 50 mm}
END
runs "$sweep pulls.yaml"
table=$folder/pulls/results.csv
claim "a design that mesh-gen rejects is a row" grep -q ',end,.*,refused,65,.*outputs.pull' "$table"
runs 'sweep-plan pulls.yaml --folder several --prepare -o plan.csv'
ids=$(sed '1d; s/,.*//' plan.csv | xargs)
runs "$sweep-design several $ids"
claim "the exit code of each design is printed" [ "$(cut -d ' ' -f 2 "$seen/out" | xargs)" = '0 65' ]
runs 'sweep-plan pulls.yaml --folder several --results -o results.csv'
claim "designs of one worker give the same rows as separate ones" cmp <(cut -d, -f 2- "$table" | sed 's/[0-9a-f]*\.yaml//') <(cut -d, -f 2- results.csv | sed 's/[0-9a-f]*\.yaml//')
claim "no temporary folder is left" [ -z "$(ls -A several/.part)" ]

mkdir fake && cat >fake/solve <<END
#!/bin/sh
if [ "\$1" = --version ]; then exec $bin/solve --version; fi
kill -9 \$\$
END
chmod +x fake/solve
run "PATH=$PWD/fake:\$PATH $sweep rods.yaml --folder crashed"
claim "killed programs give exit code 2" exits 2
claim "the rows contain the signal" [ "$(grep -c ',failed,137,solve: killed by signal 9$' crashed/results.csv)" -eq 4 ]
runs "$sweep rods.yaml --folder crashed"
claim "the next run computes them" cmp first.csv crashed/results.csv
cat >fake/solve <<END
#!/bin/sh
if [ "\$1" = --version ]; then exec $bin/solve --version; fi
head -n 1 | $bin/solve --batch
kill -9 \$\$
END
runs "PATH=$PWD/fake:\$PATH $sweep rods.yaml --folder again --jobs 1"
claim "a design after which the program dies does not cost the next one" [ "$(grep -c ',failed,' again/results.csv)" -eq 0 ]
sed -i -e '/^head/d' -e 's/^kill .*/sleep 30/' fake/solve

printf 'design: designs/rod.yaml\nvary: {geometry.width: [8 mm]}\nset: {mesh.size: 20 mm}\n' >one.yaml
run "PATH=$PWD/fake:\$PATH $sweep one.yaml --limit 1"
claim "a program that takes too long is stopped and its row gives the reason" \
    grep -q ',failed,124,[a-z-]*: stopped after 1 s$' $folder/one/results.csv

# Names with special characters for a shell; and a corrupted result
strange="it's a & b/\$folder"
runs "$sweep rods.yaml --folder \"it's a & b/\\\$folder\" --jobs 1"
claim "a folder name may contain special characters" cmp first.csv "$strange/results.csv"
printf 'corrupted' >"$strange/$id/result.h5"
run "$sweep rods.yaml --folder \"it's a & b/\\\$folder\""
claim "an unreadable result is a row with a message" [ "$(grep -c ",failed,65,.*$id/result.h5: .*compute it again" "$strange/results.csv")" -eq 1 ]
claim "the other rows are unchanged" [ "$(grep -c ',done,0,$' "$strange/results.csv")" -eq 3 ]
claim "the exit code is 2" exits 2
rm -rf "${strange:?}/$id"
runs "$sweep rods.yaml --folder \"it's a & b/\\\$folder\""
claim "removing its folder computes it again" cmp first.csv "$strange/results.csv"

# kill -9 of the script alone: its workers continue and do not block the next run
cat >fake/solve <<END
#!/bin/sh
if [ "\$1" = --version ]; then exec $bin/solve --version; fi
touch $PWD/solving
exec sleep 20
END
setsid env "PATH=$PWD/fake:$PATH" "$sweep" rods.yaml --folder orphans --jobs 1 >out.txt 2>err.txt </dev/null &
session=$!
for _ in {1..1200}; do
    if [ -e solving ]; then break; fi
    sleep 0.02
done
kill -KILL "$session"
{ wait "$session"; } 2>/dev/null
runs "$sweep rods.yaml --folder orphans"
claim "workers of a killed script do not hold its lock" cmp first.csv orphans/results.csv
claim "the workers are still running" pkill -0 --session "$session"
for _ in 1 2 3; do
    pkill -KILL --session "$session"
    sleep 0.2
done

# Ctrl-C on a terminal signals the whole process group (bash starts background commands with INT ignored)
setsid env --default-signal=INT "$sweep" rods.yaml --folder stopped --jobs 1 >out.txt 2>err.txt </dev/null &
session=$!
for _ in {1..1200}; do
    if [ -n "$(find stopped -mindepth 3 -name result.h5 -path '*/.part/*' 2>/dev/null)" ] || [ -e stopped/results.csv ]; then break; fi
    sleep 0.02
done
kill -INT -- "-$session"
{ wait "$session"; } 2>/dev/null
claim "no incomplete design looks complete after Ctrl-C" only_whole stopped
runs "$sweep rods.yaml --folder stopped"
claim "the next run computes the rest" cmp first.csv stopped/results.csv

exec 8>killed/.lock
flock 8
refuses 73 "sweep: *killed: another scripts/sweep uses this folder; wait for its end" "$sweep rods.yaml --folder killed 8>&-"
exec 8>&-

# Invalid files, each reported with its location
faulty() {   # faulty PATTERN TEXT
    printf '%b' "$2" >bad.yaml
    refuses 65 "sweep: bad.yaml:$1" "$sweep bad.yaml"
    claim "nothing is written" [ ! -e $folder/bad ]
}
faulty "2:1: vry: unknown key; did you mean 'vary'[?]" 'design: designs/rod.yaml\nvry: {geometry.width: [8 mm]}\n'
faulty "2:25: geometry.widht: unknown key; did you mean 'width'[?]" 'design: designs/rod.yaml\nvary: {geometry.widht: [8 mm]}\n'
faulty "2:31: geometry.width: '9' has no unit*" 'design: designs/rod.yaml\nvary: {geometry.width: [8 mm, 9]}\n'
faulty "3:18: mesh.size: *" 'design: designs/rod.yaml\nvary: {geometry.width: [8 mm]}\nset: {mesh.size: 3 kPa}\n'
faulty "1:1: vary: missing; *" 'design: designs/rod.yaml\n'
faulty "3:5: at: *the curve has no 'elongatoin'*" 'design: designs/rod.yaml\nvary: {geometry.width: [8 mm]}\nat: elongatoin=5mm\n'
faulty "3:5: at: *'5 kPa' is a pressure*" 'design: designs/rod.yaml\nvary: {geometry.width: [8 mm]}\nat: elongation=5 kPa\n'
faulty "3:11: outputs: no curve has a column 'elongation_m'; did you mean 'elongation_mm'[?]" 'design: designs/rod.yaml\nvary: {geometry.width: [8 mm]}\noutputs: [elongation_m]\n'
printf 'design: absent.yaml\nvary: {geometry.width: [8 mm]}\n' >bad.yaml
refuses 66 "sweep: bad.yaml:1:9: design: absent.yaml does not exist; *" "$sweep bad.yaml"
refuses 66 "sweep: absent.yaml: *" "$sweep absent.yaml"

# Names in a sweep cannot lead out of its folder, and endless files are not read.
mkdir -p victim
printf 'design: designs/rod.yaml\nvary: {name: ["ok", "a\\n../../../victim/evil,waiting,x"]}\n' >bad.yaml
refuses 65 "sweep: bad.yaml:2:21: a control character in 'a[?]../../../victim/evil,waiting,x'; *" "$sweep bad.yaml"
claim "nothing is written elsewhere" [ -z "$(ls -A victim)" ]
refuses 64 "sweep-design: ../victim/evil is not a valid design ID" "$sweep-design killed ../victim/evil"
printf 'design: /dev/zero\nvary: {geometry.width: [8 mm]}\n' >bad.yaml
refuses 66 "sweep: /dev/zero: is a device or a pipe; name a file" "$sweep bad.yaml"
refuses 65 "sweep-plan: /dev/zero: *" 'sweep-plan one.yaml --programs /dev/zero'
id=$(sed -n '2s/,.*//p' $folder/one/results.csv)
ln -sf /dev/zero "$folder/one/$id/status"
runs "$sweep one.yaml"
claim "a design with an invalid status is computed again" [ "$(grep -c ',done,0,$' $folder/one/results.csv)" -eq 1 ]
runs "$sweep one.yaml --folder -x"
claim "a folder may begin with a dash" [ -s ./-x/results.csv ]
