#!/usr/bin/env bash
# Parts from surface files: a tube exported as STL and OBJ and imported again gives the same curve; invalid files are rejected.
#   parts.sh BIN CMAKE
. "$(dirname "${BASH_SOURCE[0]}")/check.sh"
tube='designs/tube.yaml --set geometry.length=30mm --set path.until.volume_ratio=1.3'
runs "mesh-gen -q $tube --set model=solid --set mesh.size=3mm --surface tube.stl && mesh-gen -q $tube --set model=solid --surface tube.obj"
cat >part.yaml <<'END'
family: imported
geometry:
  file: tube.stl
  faces: {fixed: {plane: {x: 0 mm}}, tip: {plane: {x: 30 mm}}}
material: {law: neo-hookean, mu: 0.1644 MPa, kappa: incompressible}
mesh: {size: 5 mm, through_wall: 2}
supports: {fixed: fixed}
loads: {cavity: {pressure: 50 kPa}}
path: {control: volume, until: {volume_ratio: 1.3}}
outputs: {elongation: {face: tip, along: x}}
END
runs 'mesh-gen part.yaml --json mesh.json -o part.h5'
claim "the wall thickness is printed" grep -q 'wall thickness at least 2.9.* mm' "$seen/err"
claim "the volumes of mesh and file agree within 0.1 %" within "$(json mesh.json rubber_volume_m3)" "$(awk "BEGIN { print 0.999 * $(json mesh.json part volume_m3) }")" "$(awk "BEGIN { print 1.001 * $(json mesh.json part volume_m3) }")"
claim "the wall thickness is that of the tube" within "$(json mesh.json part walls median_m)" 0.00298 0.00302
runs 'solve -q part.h5 -o part.r.h5 && postprocess -q part.r.h5 -o part.csv'
runs "mesh-gen -q $tube | solve -q | postprocess -q -o tube.csv"
p=$(column pressure_kPa tube.csv | tail -n 1)
claim "the pressure at 1.3 times the volume agrees with the tube within 1 %" within "$(column pressure_kPa part.csv | tail -n 1)" "$(awk "BEGIN { print 0.99 * $p }")" "$(awk "BEGIN { print 1.01 * $p }")"
runs 'mkdir again && sed "s|tube.stl|../tube.stl|" part.yaml > again/part.yaml && cp part.yaml same.yaml && mesh-gen -q part.yaml --set name=x -o a.h5 && cp a.h5 b.h5 && mesh-gen -q part.yaml --set name=x -o a.h5 && cmp a.h5 b.h5'
runs 'mesh-gen part.yaml --set geometry.file=tube.obj --check'
runs 'mesh-gen --explain part.yaml | grep -q "the facets that lie in this plane"'
runs 'mesh-gen --template imported | grep -q "point: .x, y, z., up_to: faces"'

head -c 3000 tube.stl >truncated.stl
: >empty.stl
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n' >sheet.stl
printf 'ISO-10303-21;\nHEADER;\nENDSEC;\n' >cut.step
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >wild.obj
for file in truncated.stl empty.stl sheet.stl cut.step wild.obj; do
    refuses 65 "mesh-gen: *geometry.file: $file: *; *" "mesh-gen part.yaml --set geometry.file=$file"
done
refuses 66 'mesh-gen: *geometry.file: absent.stl: *' 'mesh-gen part.yaml --set geometry.file=absent.stl'
refuses 65 'mesh-gen: *geometry.faces.tip.plane.x: no facet of the surface matches this rule; *' 'mesh-gen part.yaml --set geometry.faces.tip.plane.x=31mm'
refuses 65 'mesh-gen: tube.stl: cells of this size need more than 200000 points on the surface; use a larger mesh.size' 'mesh-gen part.yaml --set mesh.size=0.05mm'
