#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# A case in motion: by the design and by solve --set, its energy, its curve, what it refuses, what a kill leaves.
#   motion.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
static='--set material.density=1000kg/m^3 --set path={} --set loads.cavity.pressure=5kPa'
moving='--set dynamics.duration=4ms --set dynamics.step=50us'

runs "mesh-gen -q designs/sphere.yaml $static $moving -o case.h5"
runs 'solve case.h5 --json solve.json -o result.h5'
claim "the summary names the integrator and the duration" grep -q 'generalized-alpha over 4 ms, energy balance within' "$seen/err"
claim "it ends at its duration" has "done" solve.json stop_reason
claim "in 80 steps" has 80 solve.json steps
claim "the duration is in the summary" within "$(json solve.json dynamics time_s)" 0.00399999 0.00400001
claim "the energy is kept" within "$(json solve.json energy_balance_error)" 0 1e-3
runs 'postprocess -q result.h5 -o curve.csv --plot curve.svg'
claim "there is a curve" table curve.csv
claim "with a row a step" [ "$(column step curve.csv | tail -n 1)" = 80 ]
claim "from time 0" [ "$(column time_s curve.csv | head -n 1)" = 0 ]
claim "of positive kinetic energy" within "$(column kinetic_energy_mJ curve.csv | sort -g | tail -n 1)" 1e-9 1
claim "the picture shows time" grep -q 'time (s)' curve.svg
runs 'postprocess -q result.h5 --at time=1.025ms -o at.csv'
claim "a ramp is linear in time: 5 kPa x 1.025 / 4" within "$(column pressure_kPa at.csv)" 1.28124999 1.28125001

runs "mesh-gen -q designs/sphere.yaml $static -o still.h5 && solve -q still.h5 $moving | postprocess -q -o same.csv"
claim "solve --set makes the same motion" cmp -s curve.csv same.csv

refuses 64 'solve: --tolerance: error bars are not available for a motion in time; *' 'solve case.h5 --tolerance 1% -o x.h5'
claim "no file is left" [ ! -e x.h5 ]
refuses 65 'mesh-gen: *dynamics.duration: the rubber has no density; add material: {density: *' \
    'mesh-gen -q designs/tube.yaml --set path={} --set dynamics.duration=1s -o x.h5'

# 4000 steps: far more than fit into the time until the kill.
run 'solve -q case.h5 --set dynamics.duration=20ms --set dynamics.step=5us --set dynamics.rows=5000 -o killed.h5 & victim=$!
     for _ in $(seq 300); do sleep 0.1; rows=$(postprocess -q killed.h5 2>/dev/null | wc -l); [ "$rows" -ge 5 ] && break; done
     kill -9 $victim; wait $victim 2>/dev/null; true'
runs 'postprocess killed.h5 -o killed.csv'
claim "postprocess says that it is not finished" grep -q 'not finished' "$seen/err"
claim "the rows before the kill are there" table killed.csv
refuses 64 'solve: --resume: a motion in time cannot be resumed; *' 'solve --resume killed.h5'

# What an explicit motion ends as.
explicit='--set mesh.formulation=f-bar --set mesh.order=1 --set material.kappa=1.6MPa --set dynamics.integrator=explicit-euler'
run "mesh-gen -q designs/sphere.yaml $static $explicit --set dynamics.duration=100ms -o long.h5; solve long.h5 --json solve.json -o long-result.h5"
claim "it ends early" exits 2
claim "too many steps are a reason" has step_limit solve.json stop_reason
claim "rest alone is in the file" grep -q 'use an implicit integrator; 0 steps,' "$seen/err"

# Steps that lose energy: a warning also with --quiet
run 'mesh-gen -q designs/plate.yaml --set mesh.size=20mm --set path={} --set material.density=1000kg/m^3 --set "loads={bottom: {pressure: 0.8 kPa, time_function: {kind: step}}}" --set dynamics.duration=50ms --set dynamics.step=1ms --set dynamics.integrator=implicit-euler | solve -q -o lost.h5'
claim "it runs" exits 0
claim "and warns" says 'solve: warning: the energies do not balance: at row * are kinetic *use a smaller dynamics.accuracy or dynamics.step*'
