#!/usr/bin/env bash
# Viscoelastic and softening rubber through the tools: cycles, resumption, ranks, threads, error bars, pictures and refusals.   inelastic.sh BIN CMAKE
# shellcheck disable=SC2016  # awk expands its own variables
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"

cycles='--set mesh.quality=draft --set path.repeat=2'
runs "mesh-gen -q designs/cyclic.yaml $cycles -o case.h5 && solve -q --cores 1 case.h5 -o whole.h5"
runs 'postprocess -q whole.h5 --also all --json whole.json -o whole.csv'
claim "rows have time, cycle and stage" like "$(head -n 1 whole.csv)" 'step,time_s,cycle,stage,pressure_kPa,*'
claim "the last row ends the second cycle" like "$(tail -n 1 whole.csv)" '*,32,2,4,0,*'
runs 'postprocess -q whole.h5 --at time=0.3s,16.3s -o half.csv'
claim "the first inflation is the stiffest" awk -F, 'NR == 2 { first = $6 } END { exit !($6 > 1.05 * first) }' half.csv
claim "it creeps while it is held" \
    awk -F, '$3 == 1 && $4 == 1 { from = $6 } $3 == 1 && $4 == 2 { to = $6 } END { exit !(to > 1.01 * from) }' whole.csv
claim "the energies of both cycles are stated" has 2 whole.json cycles 1 cycle
first=$(json whole.json cycles 0 dissipated_energy_mJ) second=$(json whole.json cycles 1 dissipated_energy_mJ)
claim "the first cycle loses the most" within "$first" "$(awk -v x="$second" 'BEGIN { print 1.2 * x }')" 1e6

runs 'postprocess -q whole.h5 --cycle 2 --also all --plot loop.svg --x elongation -o second.csv'
claim "a cycle begins where the one before ends" like "$(sed -n 2p second.csv)" '0,16,1,4,0,*'
claim "the plot shows the direction" grep -q 'vectors\|polygon' loop.svg
refuses 64 "postprocess: --cycle: the path has no cycle 3; it has 2 cycles" 'postprocess -q whole.h5 --cycle 3'
refuses 64 "postprocess: --cycle: a part of the path has no pictures and no report; omit one of them" \
    'postprocess -q whole.h5 --cycle 2 --picture a.png'

# The same bytes from threads, the same curve from ranks and after an interruption.
runs 'solve -q --cores 2 case.h5 | postprocess -q --also all -o threads.csv'
claim "threads do not change a digit" cmp whole.csv threads.csv
times=0.3s,3s,5.8s,10s,16.4s,24s,30s
runs "mpirun -n 2 solve -q case.h5 -o ranks.h5 && postprocess -q ranks.h5 --at time=$times -o ranks.csv"
runs "postprocess -q whole.h5 --at time=$times -o serial.csv"
cut -d, -f2- ranks.csv >a.csv && cut -d, -f2- serial.csv >b.csv   # the steps may differ by rounding
claim "two ranks give the same curve" near a.csv b.csv 1e-4
for ((try = 0; try < 20; ++try)); do
    rm -f k.h5
    solve -q --cores 1 case.h5 -o k.h5 2>"$seen/err" &
    victim=$!
    for ((i = 0; i < 400; ++i)); do
        sleep 0.02
        if [ -e k.h5 ] && [ "$(stat -c %s k.h5)" -gt $((60000 + 100000 * try)) ]; then break; fi
    done
    kill -9 $victim 2>"$seen/kill"
    wait $victim 2>"$seen/wait"
    run 'solve -q --cores 1 --resume k.h5'
    if ((status == 0)); then break; fi
done
claim "a killed run continues" exits 0
runs 'postprocess -q k.h5 --also all -o resumed.csv'
claim "a resumed run gives the same digits" cmp whole.csv resumed.csv

# The loads do what is stored and dissipated; a rest of ten minutes takes few steps; a stage ends at its load, also beyond a kink.
balance() { awk -F, -v limit="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) c[$i] = i; next }
    { e = $c["load_work_mJ"] - $c["stored_energy_mJ"] - $c["dissipated_energy_mJ"]; if (e < 0) e = -e; if (e > worst) worst = e
      if ($c["load_work_mJ"] > most) most = $c["load_work_mJ"] } END { exit !(worst < limit * most) }' "$2"; }
claim "the energies balance within 0.1 %" balance 1e-3 whole.csv
runs "mesh-gen -q designs/cyclic.yaml --set mesh.quality=draft --set path.repeat=1 --set 'path.stages.rest.time=600 s' | solve -q | postprocess -q -o rest.csv"
claim "a long rest takes few steps" within "$(tail -n 1 rest.csv | cut -d, -f1)" 40 250
softened="mesh-gen -q designs/verification/inelastic.yaml --set 'material={law: yeoh, c1: 20 kPa, c2: 1 kPa, kappa: incompressible, softening: {r: 2, m: 5 kPa, beta: 0.1}}' --set 'outputs={elongation: {face: end, along: axis}}'"
for middle in 30 10; do
    runs "$softened --set 'loads={end: {traction: 70 kPa, along: x}}' --set 'path.stages={a: {loads: {end: {traction: 70 kPa}}}, b: {loads: {end: {traction: $middle kPa}}}, c: {loads: {end: {traction: -20 kPa}}}}' | solve -q | postprocess -q -o kink.csv"
    claim "the path ends at its last load" within "$(column traction_kPa kink.csv | tail -n 1)" -20.0001 -19.9999
done
softened_in_time='--set path.stages.stretch.time=none --set path.stages.hold.time=none --set path.modulus=instantaneous'
runs "mesh-gen -q designs/verification/inelastic.yaml $softened_in_time | solve -q | postprocess -q --also all -o fast.csv"
claim "infinitely fast rubber dissipates nothing" within "$(column dissipated_energy_mJ fast.csv | tail -n 1)" -1e-9 1e-9

# The fields of a row depend on the rows before.
runs 'postprocess -q whole.h5 --picture stress.png --field von-mises'
claim "the stress can be drawn" [ -s stress.png ]
runs 'solve -q case.h5 --fields last -o last.h5'
refuses 65 "postprocess: --field: the stress of inelastic rubber depends on all rows before*" \
    'postprocess -q last.h5 --picture stress.png --field von-mises'
runs 'mesh-gen -q designs/verification/inelastic.yaml | solve -q --tolerance 1% | postprocess -q -o bars.csv'
claim "bars are computed" grep -q tension_error bars.csv

# Without times the rubber is elastic, slow or fast.
elastic() { echo "mesh-gen -q designs/verification/inelastic.yaml --set path.stages.stretch.time=none --set path.stages.hold.time=none --set path.modulus=$1 | solve -q | postprocess -q -o $1.csv"; }
runs "$(elastic long-term) && $(elastic instantaneous)"
slow=$(column tension_N long-term.csv | tail -n 1) fast=$(column tension_N instantaneous.csv | tail -n 1)
claim "the instantaneous modulus is 1.6 times the long-term one" within "$(awk -v a="$fast" -v b="$slow" 'BEGIN { print a / b }')" 1.5999 1.6001

bar='mesh-gen -q designs/verification/inelastic.yaml'
refuses 65 "*path.stages.hold.time: other stages have a time, this one has none; give every stage a time, or none" "$bar --set path.stages.hold.time=none"
refuses 65 "*material.viscoelastic.times: 1 times for 2 moduli; write one time for each modulus" "$bar --set 'material.viscoelastic.times=[1 s]'"
refuses 65 "*path.stages.stretch.time: a stage with a time ends with it, not where elongation is reached; omit until, or the time" \
    "$bar --set path.until.elongation=3mm"
refuses 65 "*material.law: the law linear-elastic has no isochoric energy*" "$bar --set material.law=linear-elastic --set material.kappa=1MPa"
refuses 65 "*path.repeat: the path has no stages that could be repeated*" 'mesh-gen -q designs/tube.yaml --set path.repeat=2'
