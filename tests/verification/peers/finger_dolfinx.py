"""The four-chamber finger (designs/pneunet.yaml) with dolfinx 0.5: Taylor-Hood tetrahedra, incompressible, follower pressure, MUMPS.

    mesh-gen designs/pneunet.yaml --set mesh.cells=simplices -o case.h5
    /usr/bin/python3 finger_dolfinx.py case.h5 [steps]

Reads mesh and faces of a case (docs/reference/file-format.md) and prints: unknowns, mean displacement of the tip along x and z [mm],
Newton iterations, CPU seconds without and with the imports.
"""
import resource
import sys

import h5py
import numpy as np
import ufl
from dolfinx import cpp, fem, mesh
from dolfinx.fem.petsc import assemble_matrix, assemble_vector, create_matrix, create_vector, set_bc
from mpi4py import MPI
from petsc4py import PETSc

MU, PRESSURE = 0.1644, 3.5e-3  # MPa; lengths in mm
CORNERS_OF_FACETS = ((0, 1, 3), (1, 2, 3), (0, 2, 3), (0, 1, 2))  # of VTK's tetrahedron


def cpu():
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


imported = cpu()
steps = int(sys.argv[2]) if len(sys.argv) > 2 else 2
with h5py.File(sys.argv[1]) as case:
    points = 1e3 * case["VTKHDF/Points"][:]
    cells = case["VTKHDF/Connectivity"][:].reshape(-1, 10)[:, :4]
    faces = {name: facets[:] for name, facets in case["mesh/facets"].items()}
vertices, cells = np.unique(cells, return_inverse=True)
cells = cells.reshape(-1, 4)
domain = mesh.create_mesh(MPI.COMM_WORLD, cells, points[vertices], ufl.Mesh(ufl.VectorElement("Lagrange", ufl.tetrahedron, 1)))
domain.topology.create_connectivity(2, 3)
boundary = mesh.exterior_facet_indices(domain.topology)
original = np.array(domain.geometry.input_global_indices)[cpp.mesh.entities_to_geometry(domain._mesh, 2, boundary, False)]
number_of = {tuple(sorted(corners)): facet for corners, facet in zip(original.tolist(), boundary)}


def facets_of(name):
    return np.sort([number_of[tuple(sorted(cells[cell, list(CORNERS_OF_FACETS[local])]))] for cell, local in faces[name]]).astype(np.int32)


def measure(name):
    facets = facets_of(name)
    tags = mesh.meshtags(domain, 2, facets, np.full(len(facets), 1, dtype=np.int32))
    return ufl.Measure("ds", domain=domain, subdomain_data=tags, metadata={"quadrature_degree": 4})(1)


V = fem.FunctionSpace(domain, ufl.MixedElement([ufl.VectorElement("Lagrange", ufl.tetrahedron, 2), ufl.FiniteElement("Lagrange", ufl.tetrahedron, 1)]))
w = fem.Function(V)
u, p = ufl.split(w)
F = ufl.Identity(3) + ufl.grad(u)
J = ufl.det(F)
energy = MU / 2 * (J ** (-2 / 3) * ufl.inner(F, F) - 3) + p * (J - 1)
load = fem.Constant(domain, PETSc.ScalarType(0))
follower = load * ufl.inner(J * ufl.dot(ufl.inv(F).T, ufl.FacetNormal(domain)), ufl.split(ufl.TestFunction(V))[0])
residual = ufl.derivative(energy * ufl.Measure("dx", domain=domain, metadata={"quadrature_degree": 4}), w, ufl.TestFunction(V)) + follower * measure("cavity")
R, K = fem.form(residual), fem.form(ufl.derivative(residual, w, ufl.TrialFunction(V)))
zero = PETSc.ScalarType(0)
held = [(V.sub(0).sub(i), "fixed") for i in range(3)] + [(V.sub(0).sub(1), "symmetry_y")]
conditions = [fem.dirichletbc(zero, fem.locate_dofs_topological(space, 2, facets_of(name)), space) for space, name in held]
tip = measure("tip")
area = fem.assemble_scalar(fem.form(fem.Constant(domain, PETSc.ScalarType(1)) * tip))
means = [fem.form(u[i] * tip) for i in (0, 2)]

A, b, step = create_matrix(K), create_vector(R), fem.Function(V)
solver = PETSc.KSP().create(MPI.COMM_WORLD)
solver.setType("preonly")
solver.getPC().setType("lu")
solver.getPC().setFactorSolverType("mumps")
solver.setOperators(A)


def residual_norm():
    b.set(0)
    assemble_vector(b, R)
    set_bc(b, conditions, w.vector, 0.0)
    return b.norm()


iterations, before = 0, None
for i in range(1, steps + 1):
    load.value = PRESSURE * i / steps
    start = w.x.array.copy()
    if before is not None:  # secant
        w.x.array[:] += start - before
    before = start
    first = norm = residual_norm()
    while norm > 1e-8 * first and norm > 1e-11:
        A.zeroEntries()
        assemble_matrix(A, K, bcs=conditions)
        A.assemble()
        solver.solve(b, step.vector)
        w.x.array[:] -= step.x.array
        norm = residual_norm()
        iterations += 1
        if not np.isfinite(norm) or iterations > 50:
            sys.exit("no convergence")
unknowns = V.dofmap.index_map.size_global * V.dofmap.index_map_bs
forward, up = (fem.assemble_scalar(mean) / area for mean in means)
print(f"{unknowns} unknowns, forward {forward:.6f} mm, up {up:.6f} mm, {iterations} iterations, {cpu() - imported:.2f} s, {cpu():.2f} s")
