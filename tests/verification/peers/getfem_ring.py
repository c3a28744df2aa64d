"""A solid rubber ring in plane strain, quarter x, y >= 0, mean radius 20 mm, mu = 0.1 MPa.
    getfem_ring.py pressure THROUGH AROUND [THICKNESS] [KAPPA_OVER_MU]   buckles under outer pressure until its inner faces touch (the mirror
                                                                         image in y = 0), and beyond; load: p R^3/EI
    getfem_ring.py plates   THROUGH AROUND [THICKNESS] [KAPPA_OVER_MU]   between two rigid frictionless plates; load: P R^2/EI
EI = E' t^3/12 with E' = 4 mu. Prints load, enclosed area over its undeformed value, positions of the inner, middle and outer point on x = 0
and on y = 0 over R, contact force [N/mm] and CPU seconds."""
import resource, sys
import numpy as np
from getfem_model import INNER, ON_X, ON_Y, OUTER, Rubber, advance, ring_sector

HEADER = 'load,area,inner_height,middle_height,outer_height,inner_width,middle_width,outer_width,force_N_per_mm,cpu_s'

class Ring:
    def __init__(self, contact_face, through, around, thickness=2., ratio=1000., mean=20., mu=0.1):
        self.inner, self.outer, self.mean, self.around = mean - thickness / 2, mean + thickness / 2, mean, around
        self.EI = 4 * mu * thickness**3 / 12; self.pressure = self.EI / mean**3; self.face = contact_face
        self.rubber = Rubber(ring_sector(self.inner, self.outer, through, around), (self.inner, self.outer), mu, ratio * mu,
                             1e-6 * self.EI / mean**2)
        self.md = self.rubber.md; self.rubber.slide(ON_X); self.rubber.slide(ON_Y)
        self.points = self.rubber.mfu.basic_dof_nodes()[:, ::2].T
        near = lambda x, y: int(np.argmin(np.hypot(self.points[:, 0] - x, self.points[:, 1] - y)))
        radii = (self.inner, mean, self.outer)
        self.on_y, self.on_x = [near(0, r) for r in radii], [near(r, 0) for r in radii]
        print(f'# {through * around} cells, t/R = {thickness / mean:g}, kappa/mu = {ratio:g}, EI = {self.EI:.8g} N mm\n{HEADER}')
    def area(self):
        return self.rubber.integral("-0.5*(X+u).(Det(F)*(Inv(F)'*Normal))", INNER) / (np.pi * self.inner**2 / 4)
    def force(self):
        return 2 * self.rubber.integral('lam', self.face)
    def place(self):
        return self.points + self.md.variable('u').reshape(-1, 2)
    def report(self, load):
        x = self.place() / self.mean; use = resource.getrusage(resource.RUSAGE_SELF)
        row = (load, self.area(), *x[self.on_y, 1], *x[self.on_x, 0], self.force(), use.ru_utime + use.ru_stime)
        print(','.join(f'{v:.8g}' for v in row), flush=True)

def under_pressure(ring):
    md, mean = ring.md, ring.mean
    md.add_variable('load', 1)
    md.add_nonlinear_term(ring.rubber.mim, f"load*{ring.pressure:.17g}*Det(F)*((Inv(F)'*Normal).Test_u)", OUTER)
    ring.rubber.contact('lam', INNER, 'X(2)+u(2)', ('-', 2), 1000 * ring.pressure)
    # the equation of `load`: the area (by_area = 1), or the load itself is prescribed
    for name in ('by_area', 'target'): md.add_initialized_data(name, 1.)
    quarter, length = np.pi * ring.inner**2 / 4, np.pi * ring.inner / 2
    md.add_nonlinear_term(ring.rubber.mim, f"(by_area*(-0.5/{quarter:.17g}*(X+u).(Det(F)*(Inv(F)'*Normal))-target/{length:.17g})"
                          f"+(1-by_area)*(load-target)/{length:.17g})*Test_load", INNER)
    a = np.arctan2(ring.points[:, 1], ring.points[:, 0]); d = 0.1 * mean   # the mode of two waves: u_r = d cos 2a, u_a = -d/2 sin 2a
    md.set_variable('u', d * np.array([np.cos(2 * a) * np.cos(a) + np.sin(2 * a) * np.sin(a) / 2,
                                       np.cos(2 * a) * np.sin(a) - np.sin(2 * a) * np.cos(a) / 2]).T.ravel())
    md.set_variable('load', [3.05])
    loads, area, free = [3.5, 4., 4.5, 5., 5.246887, 6.247, 7.247, 8.247, 9.247], 0.98, []
    md.set_variable('target', area)
    if not ring.rubber.solve(): raise SystemExit('the buckled branch is not found')
    step = 0.02
    while loads:
        before = (md.from_variables(), area, float(md.variable('load')[0]))
        area = before[1] - step; md.set_variable('target', area)
        if not ring.rubber.solve():
            area = before[1]; step /= 2
            if step < 1e-6: raise SystemExit('no convergence')
            continue
        load, gap = float(md.variable('load')[0]), ring.place()[ring.on_y[0], 1]
        if abs(ring.force()) < 1e-12: free.append((gap, load, area))
        elif free:                                            # first touch: extrapolation of the free states to a gap of 0
            g, l, s = np.array(free[-3:]).T
            print(f'# touch: load {np.polyval(np.polyfit(g, l, 2), 0):.6f}, area {np.polyval(np.polyfit(g, s, 2), 0):.6f}', flush=True); free = []
        while loads and load >= loads[0]:
            here = md.from_variables()
            md.set_variable('by_area', 0.); md.set_variable('target', loads[0])
            if not ring.rubber.solve(): print(f'# not solved at {loads[0]}')
            else: ring.report(float(md.variable('load')[0]))
            md.to_variables(here); md.set_variable('by_area', 1.); loads.pop(0)
        step = min(1.3 * step, 0.004 if gap < 0.15 * mean else 0.02)

def between_plates(ring):
    """The plate moves down; at each load of the list its height is corrected by the secant method."""
    md = ring.md; h = ring.outer; md.add_initialized_data('h', h)
    ring.rubber.contact('lam', OUTER, 'h-X(2)-u(2)', ('', 2), 1000 * ring.pressure)
    load = lambda: ring.force() * ring.mean**2 / ring.EI
    def move(to):
        nonlocal h
        advance(ring.rubber, lambda v: md.set_variable('h', v), h, to, 0.02 * ring.mean); h = to
    loads, last = [1., 2., 2.5, 2.786408, 3.5, 5.], (h, 0.)
    while loads:
        move(h - 0.02 * ring.mean); now = (h, load())
        while loads and now[1] >= loads[0]:
            a, b = last, now
            while abs(b[1] - loads[0]) > 1e-6:
                move(b[0] + (loads[0] - b[1]) * (a[0] - b[0]) / (a[1] - b[1])); a, b = b, (h, load())
            ring.report(b[1]); loads.pop(0); move(now[0])
        last = now

case, through, around = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
ring = Ring(INNER if case == 'pressure' else OUTER, through, around, *map(float, sys.argv[4:]))
(under_pressure if case == 'pressure' else between_plates)(ring)
