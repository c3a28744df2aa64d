#!/usr/bin/env bash
# shellcheck disable=SC2016  # awk expands its own variables
# Contact snaps: walls of first-order bellows press on each other under vacuum, and edges slip.   snaps.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
cat >bellows.yaml <<'E'
family: bellows
geometry:
  convolutions: 4
  pitch: 11.8 mm
  crest_radius: 17.26 mm
  bore_radius: 4.44 mm
  wall: 2.99 mm
  fillet: 1.26 mm
  end_disc: {length: 5.9 mm, radius: 12.3 mm}
  neck: {length: 0.51 mm, radius: 9.8 mm}
material: {law: mooney-rivlin, c10: 5.95 kPa, c01: 3.95 kPa, kappa: 81.3 MPa}
model: axisymmetric
mesh: {size: 2.84 mm, formulation: f-bar, order: 1}
supports: {fixed: end_disc}
loads: {cavity: {pressure: -3 kPa, sealed: true}}
path: {contact: solve}
outputs: {elongation: {face: inlet, along: axis}}
E
last() { column "$1" "$2" | tail -n 1; }
for control in auto arc-length pressure; do
    runs "mesh-gen -q bellows.yaml --set path.control=$control -o $control.h5 && solve -v $control.h5 -o $control-result.h5"
    claim "contact snaps under $control control" grep -q 'contact snaps to' "$seen/err"
    claim "the full load is reached" grep -q 'solve: done: full load reached' "$seen/err"
    runs "postprocess -q $control-result.h5 --also all -o $control.csv"
    claim "the full load is not passed" within "$(last pressure_kPa $control.csv)" -3.000001 -2.999999
    claim "all rows are stable" [ "$(column stable $control.csv | sort -u)" = 1 ]
    paste <(column load_work_mJ $control.csv) <(column stored_energy_mJ $control.csv) <(column dissipated_energy_mJ $control.csv) >energies
    claim "snaps only set energy free, less than 0.2 % of the work" \
        awk '$3 < free { bad = 1 } { work = $1; free = $3 } END { exit bad || !(free > 0 && free < 0.002 * work) }' energies
    claim "the energies balance to 0.1 %" \
        awk '{ gap = $1 - $2 - $3; if (gap < 0) gap = -gap; if (gap > worst) worst = gap; work = $1 } END { exit !(worst < 1e-3 * work) }' energies
    reached=$(last elongation_mm auto.csv)
    claim "the elongation at full load does not depend on the control" within "$(awk -v a="$reached" -v b="$(last elongation_mm $control.csv)" 'BEGIN { print a - b }')" -0.001 0.001
done
run 'timeout -s KILL 1.5 solve -q auto.h5 -o part.h5; if [ -s part.h5 ]; then solve -q --resume part.h5; else solve -q auto.h5 -o part.h5; fi; postprocess -q part.h5 --also all | cmp - auto.csv'
claim "a solve that is killed and resumed gives the same curve to the byte" exits 0

# A tube that plates press flat and release: its inner side creases at the symmetry plane, where the crease closes.
cat >valve.yaml <<'END'
family: ring
geometry: {inner_radius: 4 mm, outer_radius: 6 mm}
material: {law: neo-hookean, mu: 0.25 MPa}
model: plane-strain
obstacles: {top: {plane: {point: [0 mm, 6.05 mm, 0 mm], normal: [0, -1, 0]}}}
loads: {top: {displacement: -4.3 mm, along: y}}
path:
  stages:
    close: {loads: {top: {displacement: -4.3 mm}}}
    open: {loads: {top: {displacement: 0 mm}}}
outputs:
  gap: {obstacle: top, measure: displacement, along: y}
  press: {obstacle: top, measure: force, along: y}
  seal: {obstacle: self, measure: area}
END
rests_again() {   # rests_again FILE.csv
    claim "... and at rest again" awk -v e="$(last stored_energy_mJ "$1")" -v most="$(column stored_energy_mJ "$1" | sort -g | tail -n 1)" 'BEGIN { exit !(e < 1e-6 * most) }'
}
forces_agree() {   # forces_agree A.csv B.csv FACTOR CLAIM: on the way in and out, A's times FACTOR and B's, within 3 % of B's on the way in
    claim "$4" awk -v a="$(column press_N "$1" | tr '\n' ' ')" -v b="$(column press_N "$2" | tr '\n' ' ')" -v factor="$3" \
        'BEGIN { split(a, x, " "); split(b, y, " "); for (i = 1; i <= 2; ++i) if (!((factor * x[i] / y[1] - 1) ^ 2 < 0.03 ^ 2 && (y[i] / y[1] - 1) ^ 2 < 0.03 ^ 2)) exit 1 }'
}
for quality in normal fine; do
    runs "mesh-gen -q valve.yaml --set mesh.quality=$quality | solve -q -o $quality.h5 && postprocess -q $quality.h5 --also stored_energy -o $quality.csv && postprocess -q $quality.h5 --at gap=-3.5mm -o $quality-at.csv"
    claim "it is closed on the way" awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "seal_mm2") k = i } $k > most { most = $k } END { exit !(most > 1e4) }' $quality.csv
    rests_again $quality.csv
done
forces_agree normal-at.csv fine-at.csv 1 "both meshes need the same force, on the way in and out"

# The same tube meshed whole in height: its creases close away from a symmetry plane. It lies on one node, and only half of its width is meshed.
awk -v n=40 -v m=6 -v inner=4 -v wall=2 'BEGIN {
    print "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n2 1 \"ring\"\n1 2 \"plane\"\n1 3 \"bore\"\n1 4 \"outer\"\n1 5 \"seat\"\n$EndPhysicalNames\n$Nodes"
    print (n + 1) * (m + 1)
    for (i = 0; i <= n; ++i)
        for (j = 0; j <= m; ++j) {
            angle = atan2(0, -1) * i / n; r = inner + wall * j / m
            printf "%d %.12g %.12g 0\n", i * (m + 1) + j + 1, i % n ? r * sin(angle) : 0, -r * cos(angle)
        }
    print "$EndNodes\n$Elements"
    print n * m + 2 * n + 2 * m
    for (i = 0; i < n; ++i)
        for (j = 1; j <= m; ++j) { k = i * (m + 1) + j; print ++e, 3, 2, 1, 1, k, k + m + 1, k + m + 2, k + 1 }
    for (i = 0; i < n; ++i) {
        k = i * (m + 1) + 1; print ++e, 1, 2, 3, 3, k, k + m + 1
        k += m; print ++e, 1, 2, i ? 4 : 5, i ? 4 : 5, k, k + m + 1
    }
    for (j = 1; j <= m; ++j) { print ++e, 1, 2, 2, 2, j, j + 1; k = n * (m + 1) + j; print ++e, 1, 2, 2, 2, k, k + 1 }
    print "$EndElements"
}' >whole.msh
cat >whole.yaml <<'END'
family: imported
geometry: {file: whole.msh}
material: {law: neo-hookean, mu: 0.25 MPa}
model: plane-strain
mesh: {order: 2}
supports: {x: plane, y: seat}
obstacles:
  low: {plane: {point: [0 mm, -6 mm, 0 mm], normal: [0, 1, 0]}}
  top: {plane: {point: [0 mm, 6.1 mm, 0 mm], normal: [0, -1, 0]}}
loads: {top: {displacement: -7.8 mm, along: y}}
path:
  stages:
    close: {loads: {top: {displacement: -7.8 mm}}}
    open: {loads: {top: {displacement: 0 mm}}}
outputs:
  gap: {obstacle: top, measure: displacement, along: y}
  press: {obstacle: top, measure: force, along: y}
END
runs "mesh-gen -q whole.yaml | solve -q -o whole.h5 && postprocess -q whole.h5 --also all -o whole.csv && postprocess -q whole.h5 --at gap=-7mm -o whole-at.csv"
claim "all of its states are stable" [ "$(column stable whole.csv | sort -u)" = 1 ]
rests_again whole.csv
forces_agree whole-at.csv normal-at.csv 2 "its half needs half of the force"
