#!/usr/bin/env bash
# An obstacle moves toward a body at rest and presses on it.   approach.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
cat >sheet.yaml <<'END'
family: rod
geometry: {length: 200 mm, width: 200 mm, height: 2 mm}
material: {law: neo-hookean, mu: 0.2 MPa, kappa: 2 MPa}
model: quarter
mesh: {size: 20 mm, formulation: displacement}
supports: {fixed: fixed}
obstacles:
  ball: {sphere: {center: [100 mm, 0 mm, 25 mm], radius: 20 mm}}
loads:
  ball: {displacement: -5 mm, along: z}
END
runs 'mesh-gen -q sheet.yaml -o case.h5 && solve -q case.h5 --json solve.json -o result.h5'
claim "nothing happens on the way: contact begins in row 2" [ "$(json solve.json events 0 step)" = 2 ]
# The gap is 4 mm; facets of 20 mm act at 2 % of their size.
claim "contact begins at (4 - 0.4) / 5 of the load" within "$(json solve.json events 0 load_factor)" 0.7200 0.7201
claim "the body at rest needs no steps by powers of ten" awk -v n="$(json solve.json steps)" 'BEGIN { exit !(n <= 75) }'
# Contact gives the matrix another pattern.
solve='solve -q case.h5 --set path.until.steps=16'
runs "$solve | postprocess -q > direct.csv; $solve --set solver.linear=krylov --set solver.preconditioner=multigrid --set solver.linear_tolerance=1e-10 --set solver.linear_limit=300 | postprocess -q > multigrid.csv"
claim "multigrid gives the same rows in contact" near direct.csv multigrid.csv 1e-5
# Nothing slides before the contact.
runs "solve -q case.h5 --set contact.friction=0.5 --set path.until.steps=4 --json friction.json -o friction.h5"
claim "with friction, contact begins there too" within "$(json friction.json events 0 load_factor)" 0.7200 0.7201
echo 'outputs: {way: {obstacle: ball, measure: displacement, along: z}}' >>sheet.yaml
runs 'mesh-gen -q sheet.yaml -o case.h5'
refuses 65 'solve: *displacement control needs an output*' 'solve -q case.h5 --set path.control=displacement -o control.h5'
for goal in 3.59 3.61; do
    runs "solve -q case.h5 --set path.until.way=-${goal}mm --json goal.json -o goal.h5 && postprocess -q goal.h5 -o goal.csv"
    claim "a goal of $goal mm beside the contact at 3.6 mm is reached" within "$(column way_mm goal.csv | tail -n 1)" "-${goal}01" "-${goal}00"
    claim "... before or after the contact" [ "$(json goal.json events | grep -c first_contact)" = "$([ $goal = 3.59 ] && echo 0 || echo 1)" ]
done
# The walls of a bellows under suction touch at -1.35 kPa, the wall that follows it at -1.8 kPa, in the same step.
runs 'mesh-gen -q designs/vacuum.yaml --set mesh.size=3mm --set "obstacles={wall: {plane: {point: [-30 mm, 0 mm, 0 mm], normal: [1, 0, 0]}}}" \
    --set loads.cavity.pressure=-2kPa --set "loads.wall={displacement: 60 mm, along: x}" --set "path={control: pressure, contact: stop}" \
    --set solver.steps=constant --set solver.first_step=0.5 -o suction.h5'
solve -q suction.h5 --json suction.json -o stopped.h5 2>/dev/null
claim "with path.contact: stop, the path ends where the bellows touches itself" [ "$(json suction.json stop_reason)" = self_contact ]
claim "... before it meets the wall" [ "$(json suction.json events)" = '[]' ]
# A wall is withdrawn from a bellows that presses on it, and a post from a rod: both are free again.
bellows='mesh-gen -q designs/bellows-at-wall.yaml --set mesh.quality=draft'
runs "$bellows --set 'loads={cavity: {pressure: 5 kPa}, wall: {displacement: -10 mm, along: x}}' --set 'path.stages={i: {loads: {cavity: {pressure: 5 kPa}}}, r: {loads: {wall: {displacement: -10 mm}}}}' \
    | solve -q | postprocess -q -o withdrawn.csv"
free="$bellows --set 'obstacles={}' --set 'outputs={elongation: {face: inlet, along: axis}}' --set loads.cavity.pressure=5kPa"
runs "$free | solve -q | postprocess -q -o free.csv"
claim "a bellows that a wall has left is a free one" within "$(awk -v a="$(column elongation_mm withdrawn.csv | tail -n 1)" -v b="$(column elongation_mm free.csv | tail -n 1)" 'BEGIN { print a / b }')" 0.9999999 1.0000001
claim "... and nothing pushes it" [ "$(column push_N withdrawn.csv | tail -n 1)" = 0 ]
rod_and_post
runs 'mesh-gen -q pressed.yaml --set contact.friction=0.4 --set "path.stages={up: {loads: {post: {displacement: 2 mm}}}, down: {loads: {post: {displacement: 0 mm}}}}" | solve -q | postprocess -q -o rod.csv'
claim "a rod that a post has left is straight" within "$(column rise_mm rod.csv | tail -n 1)" -1e-6 1e-6
# A tube of fixed volume in a sleeve cannot be pressed so far: its path turns back until the plate has left it, and ends there.
cat >held.yaml <<'END'
family: tube
geometry: {length: 30 mm, outer_radius: 10 mm, inner_radius: 8 mm, cap: 3 mm}
material: {law: neo-hookean, mu: 0.1 MPa, kappa: incompressible}
model: axisymmetric
mesh: {quality: fine}
supports: {fixed: fixed}
obstacles:
  sleeve: {cylinder: {point: [0 mm, 0 mm, 0 mm], axis: [1, 0, 0], radius: 10.5 mm, inside: true}}
  plate: {plane: {point: [31 mm, 0 mm, 0 mm], normal: [-1, 0, 0]}}
loads:
  cavity: {volume: 6.05 mL}
  plate: {displacement: -3 mm, along: x}
path: {stages: {fill: {loads: {cavity: {volume: 6.05 mL}}}, press: {loads: {plate: {displacement: -3 mm}}}}}
outputs: {way: {obstacle: plate, measure: displacement, along: x}, end: {face: inlet, along: x}}
END
run 'mesh-gen -q held.yaml | solve -q --json held.json -o held.h5'
claim "a load that is not reached ends the path early" exits 2
runs 'postprocess -q held.h5 -o held.csv'
claim "the reason is the plate that has left the tube" grep -q 'beyond which the load changes and the state does not' held.json
claim "the plate stays within its way" within "$(column way_mm held.csv | sort -g | tail -n 1)" 0 10
claim "the volume stays as prescribed" within "$(column volume_mL held.csv | tail -n 1)" 6.0499999 6.0500001
# A plate that touches a rod from the start presses it as one that first moves by a tenth of a millimetre.
cat >plate.yaml <<'END'
family: rod
geometry: {length: 50 mm, width: 10 mm, height: 10 mm}
model: quarter
mesh: {size: 5 mm}
material: {law: neo-hookean, mu: 0.1644 MPa, kappa: incompressible}
supports: {x: fixed}
obstacles: {plate: {plane: {point: [50 mm, 0 mm, 0 mm], normal: [-1, 0, 0]}}}
loads: {plate: {displacement: -5 mm, along: x}}
outputs:
  push: {obstacle: plate, measure: force, along: x}
  way: {obstacle: plate, measure: displacement, along: x}
  area: {obstacle: plate, measure: area}
  peak: {obstacle: plate, measure: pressure}
END
for x in 50 50.1; do
    runs "mesh-gen -q plate.yaml --set 'obstacles.plate.plane.point=[$x mm, 0 mm, 0 mm]' --set loads.plate.displacement=-$(awk -v x=$x 'BEGIN { print x - 45 }')mm \
        | solve -q -o plate-$x.h5 && postprocess -q plate-$x.h5 --also load_work,stored_energy,dissipated_energy -o plate-$x.csv"
    claim "no energy is lost" within "$(column dissipated_energy_mJ plate-$x.csv | tail -n 1)" -1e-9 1e-9
    claim "the work is stored" within "$(paste <(column load_work_mJ plate-$x.csv) <(column stored_energy_mJ plate-$x.csv) | awk 'END { print $1 / $2 }')" 0.999 1.001
done
# The gap that remains is below the contact distance, 0.1 mm.
claim "both end alike" within "$(awk -v a="$(column push_N plate-50.csv | tail -n 1)" -v b="$(column push_N plate-50.1.csv | tail -n 1)" 'BEGIN { print a / b }')" 0.97 1.03
runs 'postprocess -q plate-50.h5 --at way=-1mm -o at.csv'
runs 'mesh-gen -q plate.yaml --set loads.plate.displacement=-1mm | solve -q | postprocess -q -o one.csv'
for what in area_mm2 peak_kPa; do
    claim "... also $what" within "$(awk -v a="$(column $what at.csv)" -v b="$(column $what one.csv | tail -n 1)" 'BEGIN { print a / b }')" 0.995 1.005
done
# The plate presses and is withdrawn.
runs 'mesh-gen -q plate.yaml --set "path={stages: {press: {loads: {plate: {displacement: -2 mm}}}, back: {loads: {plate: {displacement: 1 mm}}}}}" | solve -q | postprocess -q --also load_work,stored_energy,dissipated_energy -o back.csv'
claim "it takes its work back" within "$(column load_work_mJ back.csv | tail -n 1)" -2e-3 2e-3
claim "... and nothing is lost" within "$(column dissipated_energy_mJ back.csv | tail -n 1)" 0 2e-3
claim "values between the rows are those of a path that ends there" within "$(awk -v a="$(column push_N at.csv)" -v b="$(column push_N one.csv | tail -n 1)" 'BEGIN { print a / b }')" 0.999 1.001
# Uniaxial compression to 0.9: area 100 / 0.9 mm^2, Cauchy pressure mu (1 / 0.9 - 0.81). The sides do not face the plate.
claim "the area is that of the end" within "$(column area_mm2 plate-50.csv | tail -n 1)" 110.5 112
claim "the largest pressure is that of the end" within "$(column peak_kPa plate-50.csv | tail -n 1)" 48.5 51
# Rows after a contact that stops the bellows are short: the path is not closed.
runs "$bellows --set 'loads={cavity: {volume: 11 mL}}' | solve -q | postprocess -q -o volume.csv"
claim "a prescribed volume is reached in contact" within "$(column volume_mL volume.csv | tail -n 1)" 10.9999999 11.0000001
# Between the rows before the first contact, at 2.36 kPa, the path does not bend.
runs "$bellows --set loads.cavity.pressure=5kPa -o case.h5 && solve -q case.h5 | postprocess -q --at pressure=1.5kPa,2kPa -o at.csv"
runs "$free --set solver.step_accuracy=1e-6 | solve -q | postprocess -q --at pressure=1.5kPa,2kPa -o smooth.csv"
claim "values before a first contact are those of the free bellows" near <(cut -d, -f2,3 at.csv) <(cut -d, -f2,3 smooth.csv) 1e-3
# A stage ends at an area of contact, and the next one follows.
runs "mesh-gen -q designs/membrane-at-wall.yaml --set 'path.stages={press: {loads: {bottom: {pressure: 10 kPa}}, until: {touching: 200 mm^2}}, vent: {loads: {bottom: {pressure: 0 kPa}}}}' | solve -q | postprocess -q -o area.csv"
claim "the area at which a stage ends is reached" within "$(awk -v s="$(column stage area.csv | tr '\n' ' ')" -v a="$(column touching_mm2 area.csv | tr '\n' ' ')" 'BEGIN {
    rows = split(a, area, " "); split(s, stage, " "); for (i = 1; i <= rows; ++i) if (stage[i] == 1) last = area[i]; print last }')" 199.9999 200.0001
runs "mesh-gen designs/membrane-at-wall.yaml --set path.until.touching=460mm^2 | solve -q | postprocess -q -o area-late.csv"
claim "... also in the last step to the full load" within "$(column touching_mm2 area-late.csv | tail -n 1)" 459.9999 460.0001
claim "a stage follows it" within "$(column pressure_kPa area.csv | tail -n 1)" -1e-9 1e-9
# A post of 2 mm on its way past the tip of a rod, which it overlaps by 0.3 mm: facets of 5 mm act at 0.1 mm.
cat >pin.yaml <<'END'
family: rod
geometry: {length: 50 mm, height: 10 mm, width: 10 mm}
mesh: {size: 5 mm}
model: half
material: {law: neo-hookean, mu: 0.1644 MPa, kappa: incompressible}
supports: {fixed: fixed}
obstacles: {post: {cylinder: {point: [51.7 mm, 0 mm, -22 mm], axis: [0, 1, 0], radius: 2 mm}}}
loads: {post: {displacement: 50 mm, along: z}}
outputs:
  way: {obstacle: post, measure: displacement, along: z}
  rise: {face: end, along: z}
END
runs 'mesh-gen -q pin.yaml | solve -q --set path.until.steps=20 --json pin.json -o pin.h5'
claim "a post does not pass a rod between two rows: it meets it where its circle does" within "$(json pin.json events 0 way_m)" 0.020766 0.020768
# A bar that rests on a soft pad is pressed in and lifted: it ends up as one that starts 0.1 mm above it, without a dent where it touches first.
cat >pad.yaml <<'END'
family: extruded
geometry:
  thickness: 20 mm
  profile: |
    x_mm,y_mm,tag
    0,0,base
    60,0,right
    60,10,top
    0,10,left
material: {law: neo-hookean, mu: 0.0333 MPa, kappa: incompressible}
model: plane-strain
mesh: {size: 2 mm}
supports: {fixed: base}
obstacles: {bar: {cylinder: {point: [20 mm, 18 mm, 0 mm], axis: [0, 0, 1], radius: 8 mm}}}
loads: {bar: {displacement: -2 mm, along: y}}
outputs: {push: {obstacle: bar, measure: force, along: y}, peak: {obstacle: bar, measure: pressure}}
END
runs "mesh-gen -q pad.yaml --set 'path={stages: {press: {loads: {bar: {displacement: -2 mm}}}, lift: {loads: {bar: {displacement: 1 mm}}}}}' | solve -q | postprocess -q -o rests.csv"
runs "mesh-gen -q pad.yaml --set 'obstacles.bar.cylinder.point=[20 mm, 18.1 mm, 0 mm]' --set loads.bar.displacement=-2.1mm | solve -q | postprocess -q -o apart.csv"
awk -F, 'NR == 1 || $2 == 1' rests.csv >pressed.csv
for column in push_N peak_kPa; do
    claim "a bar that rests at the start presses like one that does not: $column" within "$(awk -v a="$(column $column pressed.csv | tail -n 1)" -v b="$(column $column apart.csv | tail -n 1)" 'BEGIN { print a / b }')" 0.965 1.005
done
claim "lifted, it touches nothing" within "$(column push_N rests.csv | tail -n 1)" -1e-9 1e-9
# The sleeve of a ring, drawn as thin as a sheet: sqrt(15^2 - 12.5^2 + 10^2) - 10 mm less the gap.
cat >shell.csv <<'END'
x_mm,y_mm,tag,curve,via_x_mm,via_y_mm,loop
15.05,0,a,arc,0,15.05,1
-15.05,0,a,arc,0,-15.05,1
15,0,h,arc,0,-15,2
-15,0,h,arc,0,15,2
END
runs "mesh-gen -q designs/verification/contact-sleeve.yaml --set 'obstacles={sleeve: {profile: shell.csv}}' | solve -q | postprocess -q -o held.csv"
claim "a shell of 0.05 mm holds a ring" within "$(column bore_mm held.csv | tail -n 1)" 2.975 2.991
claim "... which presses on all of it, 2 pi 15 mm per 1 m" within "$(column touching_mm2 held.csv | tail -n 1)" 94000 94500

# A ring that is pressed and released: where the contact opens the ring is at rest, and the rest of the way moves the plane alone.
cat >released.yaml <<'END'
family: ring
geometry: {inner_radius: 5 mm, outer_radius: 6 mm}
material: {law: neo-hookean, mu: 0.25 MPa}
obstacles: {jaw: {plane: {point: [0 mm, 6.05 mm, 0 mm], normal: [0, -1, 0]}}}
loads: {jaw: {displacement: -3.3 mm, along: y}}
path: {stages: {close: {loads: {jaw: {displacement: -3.3 mm}}}, open: {loads: {jaw: {displacement: 0 mm}}}}}
outputs: {way: {obstacle: jaw, measure: displacement, along: y}, grip: {obstacle: jaw, measure: force, along: y}}
END
for case in '0.29 mm, 3.3 mm' '0.29 mm, 4.1 mm' '0.4 mm, 3.8 mm'; do
    size=${case%,*} depth=${case#*, }
    runs "mesh-gen -q released.yaml --set 'mesh.size=$size' --set 'loads.jaw.displacement=-$depth' --set 'path.stages.close.loads.jaw.displacement=-$depth' | solve -q | postprocess -q -o released.csv"
    claim "a ring pressed by $depth is released (cells of $size)" [ "$(column way_mm released.csv | tail -n 1)" = 0 ]
    claim "... without a force" [ "$(column grip_N released.csv | tail -n 1)" = 0 ]
done
