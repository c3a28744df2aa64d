"""A block of rubber of radius and height L = 50 mm on a frictionless floor, axisymmetric, kappa = 1e4 mu, indented without friction.
    getfem_indentation.py sphere N    rigid sphere, R = 10 mm, d = 0.02 mm, against Hertz' F = 16/3 mu sqrt(R) d^1.5
    getfem_indentation.py punch N     rigid flat punch, a = 0.5 mm, d = 0.01 mm, against F = 8 mu a d
N cells along 1.5 contact radii (sphere) or along the punch; the cells grow outward."""
import resource, sys
import getfem as gf
import numpy as np
from getfem_model import add_patch, faces_where

what, n = sys.argv[1], int(sys.argv[2]); mu, kappa, size = 0.1, 1000., 50.
radius, d = (10., 0.02) if what == 'sphere' else (0.5, 0.01)
near = 1.5 * np.sqrt(radius * d) if what == 'sphere' else radius
g = [near * i / n for i in range(n + 1)]; step = near / n
while g[-1] < size: step *= 1 + 1.6 / n; g.append(g[-1] + step)
g = np.array(g); g[n:] = near + (g[n:] - near) * (size - near) / (g[-1] - near)
mesh = gf.Mesh('empty', 2)
for i in range(len(g) - 1):
    for j in range(len(g) - 1):
        add_patch(mesh, 1, 1, lambda s, t: np.array([g[i] + s * (g[i + 1] - g[i]), -g[j + 1] + t * (g[j + 1] - g[j])]))
TOP, FLOOR, AXIS = 1, 2, 3
mesh.set_region(TOP, faces_where(mesh, lambda x, y: abs(y) < 1e-9 and x < near + 1e-9))
mesh.set_region(FLOOR, faces_where(mesh, lambda x, y: abs(y + size) < 1e-6))
mesh.set_region(AXIS, faces_where(mesh, lambda x, y: abs(x) < 1e-9))
mim = gf.MeshIm(mesh, gf.Integ('IM_GAUSS_PARALLELEPIPED(2,8)')); fems = []
for dim, order in ((2, 2), (1, 2), (1, 1)): fems.append(gf.MeshFem(mesh, dim)); fems[-1].set_fem(gf.Fem(f'FEM_QK(2,{order})'))
md = gf.Model('real'); md.add_fem_variable('u', fems[0]); md.add_fem_variable('p', fems[2])
for name, value in (('mu', mu), ('kappa', kappa), ('d', 0.)): md.add_initialized_data(name, value)
for name, value in (('F', '(Id(2)+Grad_u)'), ('L', '(1+u(1)/X(1))'), ('J', '(Det(F)*L)'), ('I1', '(Norm_sqr(F)+sqr(L))'),
                    ('rr', '(X(1)+u(1))'), ('zz', f'(X(2)+u(2)-{radius}+d)'), ('dist', '(sqrt(sqr(rr)+sqr(zz)))')): md.add_macro(name, value)
md.add_nonlinear_term(mim, "X(1)*((mu*pow(J,-2/3)*(F-I1/3*Inv(F)')+p*J*Inv(F)'):Grad_Test_u"
                      "+(mu*pow(J,-2/3)*(L-I1/3/L)+p*Det(F))*Test_u(1)/X(1)+(J-1-p/kappa)*Test_p)")
for region, c in ((FLOOR, 2), (AXIS, 1)):
    md.add_filtered_fem_variable(f'hold{region}', fems[1], region); md.add_linear_term(mim, f'hold{region}*Test_u({c})+u({c})*Test_hold{region}', region)
md.add_filtered_fem_variable('lam', fems[1], TOP)
if what == 'sphere':
    r = 100 * mu / np.sqrt(radius * d)
    md.add_nonlinear_term(mim, f'X(1)*(-lam*(rr*Test_u(1)+zz*Test_u(2))/dist-(lam-pos_part(lam-{r}*(dist-{radius})))*Test_lam)', TOP)
    force, formula = '-X(1)*lam*zz/dist', 16 / 3 * mu * np.sqrt(radius) * d**1.5
else:
    md.add_nonlinear_term(mim, 'X(1)*(lam*Test_u(2)+(u(2)+d)*Test_lam)', TOP); force, formula = 'X(1)*lam', 8 * mu * radius * d
for k in range(1, 11):
    md.set_variable('d', d * k / 10)
    assert md.solve('max_iter', 40, 'max_res', 1e-10, 'lsolver', 'mumps')[1]
F = 2 * np.pi * gf.asm('generic', mim, 0, force, TOP, md); use = resource.getrusage(resource.RUSAGE_SELF)
print(f'{(len(g) - 1)**2} cells: F = {F:.7g} N, {100 * (F / formula - 1):+.3f} % against {formula:.7g} N; {use.ru_utime + use.ru_stime:.3g} CPU s')
