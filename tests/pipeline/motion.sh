#!/usr/bin/env bash
# shellcheck disable=SC2016  # the commands expand their own variables
# Dynamic cases: set in the design and by solve --set; energy, curve, rejected options, and the result after a kill.
#   motion.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
static='--set material.density=1000kg/m^3 --set path={} --set loads.cavity.pressure=5kPa'
moving='--set dynamics.duration=4ms --set dynamics.step=50us'

runs "mesh-gen -q designs/sphere.yaml $static $moving -o case.h5"
runs 'solve case.h5 --json solve.json -o result.h5'
claim "the summary names the integrator and the duration" grep -q 'generalized-alpha over 4 ms, energy balance within' "$seen/err"
claim "the motion reaches its duration" has "done" solve.json stop_reason
claim "it takes 80 steps" has 80 solve.json steps
claim "the summary contains the duration" within "$(json solve.json dynamics time_s)" 0.00399999 0.00400001
claim "the energies balance" within "$(json solve.json energy_balance_error)" 0 1e-3
runs 'postprocess -q result.h5 -o curve.csv --plot curve.svg'
claim "the curve is a table" table curve.csv
claim "there is one row per step" [ "$(column step curve.csv | tail -n 1)" = 80 ]
claim "the first time is 0" [ "$(column time_s curve.csv | head -n 1)" = 0 ]
claim "the kinetic energy is positive" within "$(column kinetic_energy_mJ curve.csv | sort -g | tail -n 1)" 1e-9 1
claim "the plot shows time" grep -q 'time (s)' curve.svg
runs 'postprocess -q result.h5 --at time=1.025ms -o at.csv'
claim "a ramp is linear in time: 5 kPa x 1.025 / 4" within "$(column pressure_kPa at.csv)" 1.28124999 1.28125001

runs "mesh-gen -q designs/sphere.yaml $static -o still.h5 && solve -q still.h5 $moving | postprocess -q -o same.csv"
claim "solve --set gives the same motion" cmp -s curve.csv same.csv

refuses 64 'solve: --tolerance: error bars are not available for a motion in time; *' 'solve case.h5 --tolerance 1% -o x.h5'
claim "no file is written" [ ! -e x.h5 ]
refuses 65 'mesh-gen: *dynamics.duration: the rubber has no density; add material: {density: *' \
    'mesh-gen -q designs/tube.yaml --set path={} --set dynamics.duration=1s -o x.h5'

# 4000 steps take much longer than the time until the kill.
run 'solve -q case.h5 --set dynamics.duration=20ms --set dynamics.step=5us --set dynamics.rows=5000 -o killed.h5 & victim=$!
     for _ in $(seq 300); do sleep 0.1; rows=$(postprocess -q killed.h5 2>/dev/null | wc -l); [ "$rows" -ge 5 ] && break; done
     kill -9 $victim; wait $victim 2>/dev/null; true'
runs 'postprocess killed.h5 -o killed.csv'
claim "postprocess reports an unfinished path" grep -q 'not finished' "$seen/err"
claim "the rows before the kill are stored" table killed.csv
refuses 64 'solve: --resume: a motion in time cannot be resumed; *' 'solve --resume killed.h5'

# The end of a motion with an explicit integrator.
explicit='--set mesh.formulation=f-bar --set mesh.order=1 --set material.kappa=1.6MPa --set dynamics.integrator=explicit-euler'
run "mesh-gen -q designs/sphere.yaml $static $explicit --set dynamics.duration=100ms -o long.h5; solve long.h5 --json solve.json -o long-result.h5"
claim "it ends early" exits 2
claim "the stop reason is the step limit" has step_limit solve.json stop_reason
claim "the result contains only the state at rest" grep -q 'use an implicit integrator; 0 rows,' "$seen/err"

# A slow motion into contact ends in the static state.
wall='mesh-gen -q designs/membrane-at-wall.yaml --set mesh.size=1mm'
runs "$wall | solve -q | postprocess -q -o static.csv"
runs "$wall --set material.density=1080kg/m^3 --set dynamics.duration=1s --set dynamics.stiffness_damping=1ms | solve -q --json solve.json | postprocess -q -o slow.csv"
claim "it pushes on the wall as the static path does" within "$(awk -v a="$(column push_N slow.csv | tail -n 1)" -v b="$(column push_N static.csv | tail -n 1)" 'BEGIN { print a / b }')" 0.995 1.005
claim "the energies balance in contact" within "$(json solve.json energy_balance_error)" 0 5e-3

# A slow motion of an obstacle; the motion of a face is refused.
rod_and_post
slowly='--set material.density=1080kg/m^3 --set dynamics.duration=1s --set dynamics.stiffness_damping=1ms'
runs 'mesh-gen -q pressed.yaml | solve -q | postprocess -q -o static.csv'
runs "mesh-gen -q pressed.yaml $slowly | solve -q --json solve.json -o post.h5 && postprocess -q post.h5 -o slow.csv"
for what in push_N rise_mm; do
    claim "a post that is lifted slowly bends a rod as the static path does: $what" within "$(awk -v a="$(column $what slow.csv | tail -n 1)" -v b="$(column $what static.csv | tail -n 1)" 'BEGIN { print a / b }')" 0.995 1.005
done
claim "the energies balance where an obstacle moves" within "$(json solve.json energy_balance_error)" 0 1e-3
# A belt drags a block that slides: between the rows too, the drag is that of the friction, and the belt follows its table.
runs 'mesh-gen -q - -o belt.h5 <<END
family: rod
geometry: {length: 20 mm, width: 20 mm, height: 10 mm}
model: half
mesh: {size: 10 mm}
material: {law: neo-hookean, mu: 1 MPa, kappa: incompressible, density: 1000 kg/m^3}
supports: {}
obstacles: {belt: {plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}, friction: 0.3}}
loads:
  gravity: {acceleration: 10 m/s^2, along: -z, time_function: {kind: ramp, rise: 0.02 s}}
  belt: {displacement: 100 mm, along: x, time_function: {kind: table, times: [0.05 s, 0.15 s], shares: [0, 1]}}
dynamics: {duration: 0.2 s, stiffness_damping: 1 ms}
outputs:
  drag: {obstacle: belt, measure: force, along: x}
  way: {obstacle: belt, measure: displacement, along: x}
END'
runs 'solve -q belt.h5 -o belt-result.h5 && postprocess -q belt-result.h5 --at time=0.1s,0.12s,0.14s -o belt.csv'
claim "a block of 40 g slides with a drag of 0.3 of its weight" within "$(column drag_N belt.csv | sed -n 2p)" -0.0125 -0.0115
claim "the belt follows its table" within "$(column way_mm belt.csv | sed -n 2p)" 69.9999 70.0001
claim "the load factor is that of gravity" within "$(column load_factor belt.csv | sed -n 2p)" 1 1
claim "a motion has no verdict on stability" [ -z "$(head -n 1 belt.csv | tr , '\n' | grep stable)" ]
# The force of a stage has the sign that it states.
runs 'mesh-gen -q designs/rod.yaml --set mesh.quality=draft --set "loads={end: {force: -0.1 N, along: x}}" --set "path={stages: {a: {loads: {end: {force: -0.1 N}}}, b: {loads: {end: {force: 0.2 N}}}}}" | solve -q | postprocess -q -o signs.csv'
claim "a stage of 0.2 N ends at 0.2 N, after one of -0.1 N" within "$(column load_N signs.csv | tail -n 1)" 0.2 0.2
claim "... which ends at -0.1 N" grep -q ',1,-0.1,' signs.csv
# In a step of 2 ms the post would move by 12 mm, through a rod of 3 mm.
sed 's/height: 10 mm/height: 3 mm/; s/-6 mm\]/-3 mm]/; s/radius: 5 mm/radius: 1 mm/' pressed.yaml >thin.yaml
runs 'mesh-gen -q thin.yaml --set material.density=1080kg/m^3 --set mesh.size=5mm --set loads.post.displacement=60mm --set dynamics.duration=10ms --set dynamics.step=2ms --set dynamics.stiffness_damping=0.5ms | solve | postprocess -q -o fast.csv'
claim "a fast post carries the rod along, and does not pass through it" within "$(column rise_mm fast.csv | tail -n 1)" 20 60
refuses 65 'mesh-gen: --set dynamics.integrator: rosenbrock * does not follow an obstacle that moves; *' \
    "mesh-gen -q pressed.yaml $slowly --set dynamics.integrator=rosenbrock -o x.h5"
refuses 65 'mesh-gen: *loads.end.displacement: the displacement of a face is not supported *' \
    "mesh-gen -q pressed.yaml $slowly --set 'loads={end: {displacement: 1 mm, along: z}}' -o x.h5"

# Steps that lose energy cause a warning, also with --quiet
run 'mesh-gen -q designs/plate.yaml --set mesh.size=20mm --set path={} --set material.density=1000kg/m^3 --set "loads={bottom: {pressure: 0.8 kPa, time_function: {kind: step}}}" --set dynamics.duration=50ms --set dynamics.step=1ms --set dynamics.integrator=implicit-euler | solve -q -o lost.h5'
claim "it runs" exits 0
claim "it prints a warning" says 'solve: warning: the energies do not balance: at row * are kinetic *use a smaller dynamics.accuracy or dynamics.step*'

# A block falls on the floor from a height of 1 mm, far less than it would fall freely: steps resolve the impact, and it does not bounce higher.
cat >drop.yaml <<'DESIGN'
family: extruded
geometry:
  thickness: 20 mm
  profile: |
    x_mm,y_mm,tag,curve,via_x_mm,via_y_mm
    3,1,bottom,,,
    17,1,low,arc,19.12132034,1.87867966
    20,4,right,,,
    20,11,top,,,
    0,11,left,,,
    0,4,low,arc,0.87867966,1.87867966
material: {law: neo-hookean, mu: 0.1 MPa, kappa: 5 MPa, density: 1070 kg/m^3}
model: plane-strain
mesh: {size: 2 mm}
supports: {x: left}
obstacles: {floor: {plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 1, 0]}}}
loads: {gravity: {acceleration: 9.81 m/s^2, along: -y, time_function: {kind: step}}}
dynamics: {duration: 0.2 s, stiffness_damping: 3 ms}
outputs: {h: {face: top, along: y}}
DESIGN
runs 'mesh-gen -q drop.yaml | solve -q -o drop.h5 && postprocess -q drop.h5 -o drop.csv'
claim "a block that falls on the floor stays below its start" within "$(column h_mm drop.csv | sort -g | tail -n 1)" -1e-9 1e-9
claim "... its energies balance within the damping of the impact" within "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next } { off = $at["kinetic_energy_mJ"] + $at["stored_energy_mJ"] + $at["damping_work_mJ"] - $at["load_work_mJ"]; if (off > most) most = off } END { print most + 0 }' drop.csv)" -1e-9 0.1
claim "... and has at most the energy of its fall" within "$(column kinetic_energy_mJ drop.csv | sort -g | tail -n 1)" 1.5 2.1
