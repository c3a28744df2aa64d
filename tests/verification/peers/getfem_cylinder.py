"""A long rubber cylinder between two rigid frictionless plates.   getfem_cylinder.py N TOP [KAPPA_OVER_MU]
Prints force per depth [N/mm], half width of the contact [mm] and the half width of the section at approaches of 5, 10, 15, 20 % of the diameter."""
import resource, sys
import numpy as np
from getfem_model import ON_X, ON_Y, OUTER, Rubber, advance, quarter_disc

def main(n, top, ratio=1000., radius=10., mu=0.1):
    rubber = Rubber(quarter_disc(radius, n, top), (None, radius), mu, ratio * mu); md = rubber.md
    rubber.slide(ON_X); rubber.slide(ON_Y)
    md.add_initialized_data('h', radius)                      # height of the plate above the middle plane
    rubber.contact('lam', OUTER, 'h-X(2)-u(2)', ('', 2), 100 * mu / radius)
    print(f'# {n * n + 2 * n * top} cells, {md.nbdof()} unknowns, kappa/mu = {ratio:g}')
    print('approach_percent,force_N_per_mm,contact_half_width_mm,half_width_mm,cpu_s')
    done, steps = radius, 0
    for percent in (1, 2, 5, 10, 15, 20):
        target = radius * (1 - percent / 100)
        steps += advance(rubber, lambda v: md.set_variable('h', v), done, target, 0.01 * radius); done = target
        force = 2 * rubber.integral('lam', OUTER)
        u = md.variable('u').reshape(-1, 2); points = rubber.mfu.basic_dof_nodes()[:, ::2].T
        side = np.argmin(np.hypot(points[:, 0] - radius, points[:, 1]))
        outer = np.abs(np.hypot(*points.T) - radius) < 1e-6
        x = points + u; touching = outer & (x[:, 1] > target - 1e-6 * radius)
        use = resource.getrusage(resource.RUSAGE_SELF)
        print(f'{percent},{force:.8g},{x[touching, 0].max():.4g},{x[side, 0]:.8g},{use.ru_utime + use.ru_stime:.3g}', flush=True)
    print(f'# {steps} steps')

main(int(sys.argv[1]), int(sys.argv[2]), *map(float, sys.argv[3:]))
