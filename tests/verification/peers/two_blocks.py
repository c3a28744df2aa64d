"""Writes the mesh of designs/verification/contact-patch.yaml: two separate blocks, 10 x 5 mm, 0.01 mm apart.   two_blocks.py > meshes/two-blocks.msh"""
import sys
nodes, lines, cells = [], [], []
def block(region, y0, n, m, sides):
    first = len(nodes) + 1; at = lambda i, j: first + j * (n + 1) + i
    nodes.extend((10 * i / n, y0 + 5 * j / m) for j in range(m + 1) for i in range(n + 1))
    cells.extend((region, (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))) for j in range(m) for i in range(n))
    bottom, right, top, left = sides
    lines.extend((bottom, (at(i, 0), at(i + 1, 0))) for i in range(n)); lines.extend((right, (at(n, j), at(n, j + 1))) for j in range(m))
    lines.extend((top, (at(i + 1, m), at(i, m))) for i in range(n)); lines.extend((left, (at(0, j + 1), at(0, j))) for j in range(m))
names = ['bottom', 'right', 'lower_contact', 'left', 'upper_contact', 'top']; tag = {name: k + 1 for k, name in enumerate(names)}
block(7, 0, 4, 2, [tag[k] for k in ('bottom', 'right', 'lower_contact', 'left')])
block(7, 5.01, 7, 3, [tag[k] for k in ('upper_contact', 'right', 'top', 'left')])
out = ['$MeshFormat', '2.2 0 8', '$EndMeshFormat', '$PhysicalNames', str(len(names) + 1)]
out += [f'1 {tag[k]} "{k}"' for k in names] + ['2 7 "rubber"', '$EndPhysicalNames', '$Nodes', str(len(nodes))]
out += [f'{k + 1} {x:.10g} {y:.10g} 0' for k, (x, y) in enumerate(nodes)] + ['$EndNodes', '$Elements', str(len(lines) + len(cells))]
out += [f'{k + 1} {kind} 2 {t} {t} ' + ' '.join(map(str, ids)) for k, (kind, t, ids) in
        enumerate([(1, *line) for line in lines] + [(3, *cell) for cell in cells])] + ['$EndElements']
sys.stdout.write('\n'.join(out) + '\n')
