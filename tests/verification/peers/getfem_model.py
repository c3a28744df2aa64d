"""Plane-strain rubber in GetFEM: meshes of 9-node quadrilaterals, the mixed form of the neo-Hookean law, contact with a rigid plane.
W = mu/2 (I1bar - 3) + kappa/2 (J - 1)^2, p = kappa (J - 1), Q2/Q1. The contact pressure lam >= 0 per undeformed area is a Lagrange multiplier
(augmented Lagrangian), Q2 on the boundary: with Q1 the touching face wrinkles between the nodes, and forces are wrong by 1 %.
Units: mm, N, MPa. Debian: python3-getfem, python3-numpy."""
import getfem as gf, numpy as np
gf.util('trace level', 0); gf.util('warning level', 0)

def add_patch(mesh, n, m, place):
    """n x m cells of the map place: [0,1]^2 -> plane."""
    for i in range(n):
        for j in range(m):
            s = [place((2 * i + a) / (2 * n), (2 * j + b) / (2 * m)) for b in range(3) for a in range(3)]
            mesh.add_convex(gf.GeoTrans('GT_QK(2,2)'), np.array(s).T)

def quarter_disc(radius, n, top):
    """The quarter x, y >= 0 in three patches around a core: `top` cells along the arc from 45 to 90 degrees, n along the other edges;
    shorter cells toward the arc."""
    mesh = gf.Mesh('empty', 2); c = 0.5 * radius; k = 0.42 * radius
    arc = lambda t: np.array([radius * np.cos(t), radius * np.sin(t)])
    line = lambda p, q, s: (1 - s) * np.array(p) + s * np.array(q)
    grade = lambda s: 1 - (1 - s)**2.5
    add_patch(mesh, top, n, lambda s, t: line(line((0, 0), (c, 0), s), line((0, c), (k, k), s), t))
    add_patch(mesh, n, n, lambda s, t: line(line((c, 0), (k, k), t), arc(t * np.pi / 4), grade(s)))
    add_patch(mesh, top, n, lambda s, t: line(line((k, k), (0, c), 1 - s), arc((2 - s) * np.pi / 4), grade(t)))
    return mesh

def ring_sector(inner, outer, through, around, first=0., last=np.pi / 2):
    mesh = gf.Mesh('empty', 2)
    def place(s, t):
        r, a = inner + s * (outer - inner), first + t * (last - first)
        return r * np.array([np.cos(a), np.sin(a)])
    add_patch(mesh, through, around, place)
    return mesh

def faces_where(mesh, test):
    """Boundary faces whose nodes all satisfy test(x, y)."""
    faces = mesh.outer_faces(); keep = []
    for k in range(faces.shape[1]):
        pts = mesh.pts(mesh.pid_in_faces(faces[:, k:k + 1]))
        if all(test(*p) for p in pts.T): keep.append(k)
    return faces[:, keep]

INNER, OUTER, ON_X, ON_Y = 1, 2, 3, 4   # regions: faces at the inner and outer radius, faces on y = 0, faces on x = 0

class Rubber:
    def __init__(self, mesh, radii, mu, kappa, residual=1e-9):
        """`residual`: sum of the absolute nodal forces [N/mm] at which Newton's method ends."""
        self.mesh, self.residual, eps = mesh, residual, 1e-6
        for region, r in zip((INNER, OUTER), radii):
            if r: mesh.set_region(region, faces_where(mesh, lambda x, y: abs(np.hypot(x, y) - r) < eps))
        mesh.set_region(ON_X, faces_where(mesh, lambda x, y: abs(y) < eps))
        mesh.set_region(ON_Y, faces_where(mesh, lambda x, y: abs(x) < eps))
        self.mim = gf.MeshIm(mesh, gf.Integ('IM_GAUSS_PARALLELEPIPED(2,8)'))
        self.mfu = gf.MeshFem(mesh, 2); self.mfu.set_fem(gf.Fem('FEM_QK(2,2)'))
        self.mfs = gf.MeshFem(mesh, 1); self.mfs.set_fem(gf.Fem('FEM_QK(2,2)'))
        self.mfp = gf.MeshFem(mesh, 1); self.mfp.set_fem(gf.Fem('FEM_QK(2,1)'))
        md = self.md = gf.Model('real')
        md.add_fem_variable('u', self.mfu); md.add_fem_variable('p', self.mfp)
        md.add_initialized_data('mu', mu); md.add_initialized_data('kappa', kappa)
        md.add_macro('F', '(Id(2)+Grad_u)')
        md.add_nonlinear_term(self.mim, '(mu*pow(Det(F),-2/3)*(F-(Norm_sqr(F)+1)/3*Inv(F)\')+p*Det(F)*Inv(F)\'):Grad_Test_u'
                              '+(Det(F)-1-p/kappa)*Test_p')
    def slide(self, region):
        """No displacement normal to a symmetry plane."""
        c = 2 if region == ON_X else 1; name = f'hold{region}'
        self.md.add_filtered_fem_variable(name, self.mfs, region)
        self.md.add_linear_term(self.mim, f'{name}*Test_u({c})+u({c})*Test_{name}', region)
    def contact(self, name, region, gap, direction, r):
        """`gap` >= 0: distance to a rigid plane, in GWFL; `direction`: the component of u along which the gap closes, with its sign."""
        self.md.add_filtered_fem_variable(name, self.mfs, region)
        self.md.add_nonlinear_term(self.mim, f'{name}*{direction[0]}Test_u({direction[1]})'
                                   f'-({name}-pos_part({name}-({r})*({gap})))*Test_{name}', region)
    def integral(self, expression, region=-1):
        return gf.asm('generic', self.mim, 0, expression, region, self.md)
    def solve(self, max_iter=40):
        """Newton's method; a failed solve restores the state. Returns whether it converged."""
        before = self.md.from_variables()
        try:
            n, ok = self.md.solve('max_iter', max_iter, 'max_res', self.residual, 'lsolver', 'mumps', 'lsearch', 'simplest', 'alpha min', 0.3)
        except RuntimeError:                                  # a singular tangent
            n, ok = 0, False
        if ok and n < max_iter and np.all(np.isfinite(self.md.from_variables())): return True
        self.md.to_variables(before); return False

def advance(rubber, set_value, start, end, step):
    """Moves a parameter from start to end with steps that halve on failure. Returns the number of solved steps."""
    done, h, count = start, step, 0
    while abs(end - done) > 1e-12 * max(1, abs(end)):
        h = min(h, abs(end - done)); value = done + np.copysign(h, end - done)
        set_value(value)
        if not rubber.solve():
            h /= 2
            if h < 1e-5 * step: raise SystemExit(f'no convergence at {value:g}')
            continue
        done, count, h = value, count + 1, min(step, 1.5 * h)
    return count
