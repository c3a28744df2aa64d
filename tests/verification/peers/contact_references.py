"""Reference values of contact without a mesh.   contact_references.py   (Debian: python3-scipy)

Shells in rigid shells. An incompressible shell keeps b^k - a^k = B^k - A^k (k = 2 cylinder, 3 sphere); equilibrium sigma_r' = (sigma_t - sigma_r)
(k - 1)/r gives p(b) = int_a^b (k - 1) (sigma_t - sigma_r) dr/r, for neo-Hookean rubber in closed form. Once b = c nothing can move, and
the contact pressure is p - p(c). The same integral by quadrature checks the closed form.

Elastica ring, R = EI = 1, a quarter from the side (theta = pi/2) to the top (theta = pi): x' = cos theta, y' = sin theta, theta' = k, moment
M = k - 1 with k' = -(t x n), n' = p m (m = (sin theta, -cos theta) the outward normal; n the internal force). Both symmetry planes
transmit no shear until the top touches its mirror image (y = 0), which then adds a point force. Plates: p = 0, n = (0, -P/2).
Line contact begins where the curvature at the top is 0; between plates the flat part then grows."""
import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq, fsolve

def shell(k, A, B, c, mu):
    a = (A**k + c**k - B**k) ** (1 / k); la, lb = a / A, c / B
    closed = (mu * (np.log(la / lb) + (lb**-2 - la**-2) / 2) if k == 2 else mu * (2 / lb + lb**-4 / 2 - 2 / la - la**-4 / 2))
    def integrand(r):
        l = r / (r**k - c**k + B**k) ** (1 / k)               # hoop stretch
        return (k - 1) * mu * (l**2 - l ** (-2 * (k - 1))) / r
    assert abs(quad(integrand, a, c, epsabs=0, epsrel=1e-12)[0] / closed - 1) < 1e-9
    return closed, a

def integrate(p, start, length):
    """start: curvature, n_y, x at the side. Returns theta, k, x, y, n_x, n_y, area of the quarter at the other end."""
    def rhs(s, z):
        t, k, x, y, nx, ny, area = z; c, d = np.cos(t), np.sin(t)
        return [k, d * nx - c * ny, c, d, p * d, -p * c, (x * d - y * c) / 2]
    return solve_ivp(rhs, (0, length), [np.pi / 2, start[0], start[2], 0, 0, start[1], 0], rtol=1e-11, atol=1e-12).y[:, -1]

def solve(residual, guess):
    z, _, ok, text = fsolve(residual, guess, xtol=1e-12, full_output=True)
    assert np.abs(residual(z)).max() < 1e-9, text
    return z

def plates(P, guess):
    """Point contact at the top. Returns half height, half width, curvatures at the side and the top."""
    z = solve(lambda z: (lambda y: [y[0] - np.pi, y[2]])(integrate(0, (z[0], -P / 2, z[1]), np.pi / 2)), guess)
    y = integrate(0, (z[0], -P / 2, z[1]), np.pi / 2)
    return y[3], z[1], z[0], y[1], z

def plates_line(P, guess):
    """Contact along a flat part: its curvature is 0. Returns half height, half width, flat half length."""
    end = lambda z: integrate(0, (z[0], -P / 2, 0), z[1])
    z = solve(lambda z: (lambda y: [y[0] - np.pi, y[1]])(end(z)), guess); y = end(z); flat = np.pi / 2 - z[1]
    return y[3], flat - y[2], flat, z

def pressure_free(height, guess):
    """Returns p, area over pi R^2, half width at a half height."""
    end = lambda w: integrate(w[0], w[1:], np.pi / 2)
    w = solve(lambda w: (lambda y: [y[0] - np.pi, y[2], y[5], y[3] - height])(end(w)), guess)
    return w[0], 4 * end(w)[6] / np.pi, w[3], w

def pressure_touching(p, guess):
    """Returns area over pi R^2, half width, curvature at the top, contact force 2 n_y."""
    end = lambda z: integrate(p, z, np.pi / 2)
    z = solve(lambda z: (lambda y: [y[0] - np.pi, y[2], y[3]])(end(z)), guess); y = end(z)
    return 4 * y[6] / np.pi, z[2], y[1], 2 * y[5], z

def main():
    for name, k, A, B, c in (('tube in sleeve', 2, 10, 12.5, 15), ('sphere in sphere', 3, 10, 12, 15), ('sphere in sphere', 3, 10, 12, 20)):
        p, a = shell(k, A, B, c, 100.); e = 1e-4; slope = (shell(k, A, B, c + e, 100.)[0] - shell(k, A, B, c - e, 100.)[0]) / (2 * e)
        peak = max(shell(k, A, B, x, 100.)[0] for x in np.linspace(B * 1.001, c, 2001))
        print(f'{name}, A = {A}, B = {B}, c = {c} mm, mu = 100 kPa: touch at {p:.6g} kPa (maximum before: {peak:.6g}), a = {a:.6g} mm, '
              f'bore +{a - A:.6g} mm, volume ratio {(a / A) ** k:.6g}, dp/db = {slope:.5g} kPa/mm')
    z = (1.2, 1.07)
    for P in (1, 2, 2.5):
        h, w, side, top, z = plates(P, z); print(f'ring between plates, P R^2/EI = {P}: half height {h:.6f}, half width {w:.6f}')
    P = brentq(lambda P: plates(P, z)[3], 2.5, 3, xtol=1e-11); print(f'  line contact from {P:.6f}, half height {plates(P, z)[0]:.6f}')
    z = (1.67, np.pi / 2)
    for P in (3.5, 5):
        h, w, flat, z = plates_line(P, z); print(f'  P R^2/EI = {P}: half height {h:.6f}, half width {w:.6f}, flat part {2 * flat:.6f}')
    w = (3., 1.3, -3.3, 1.1)
    for h in (0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.):
        p, area, width, w = pressure_free(h, w)
        print(f'ring under pressure, half height {h}: p R^3/EI = {p:.6f}, area {area:.6f}, half width {width:.6f}')
    z = w[1:]
    for p in (6.247, 7.247, 8.247, 9.247):
        area, width, top, force, z = pressure_touching(p, z)
        print(f'  p R^3/EI = {p}: area {area:.6f}, half width {width:.6f}, contact force {force:.5f} EI/R^2')
    p = brentq(lambda p: pressure_touching(p, z)[2], 9.9, 10.6, xtol=1e-9); print(f'  line contact from {p:.6f}, area {pressure_touching(p, z)[0]:.6f}')
    l = 0.9; print(f'two blocks, l = {l}: p = {100 * (l**-2 - l**2):.6g} kPa, force on 10 mm x 1 m {1e3 * (l**-3 - l):.6g} N, spread +{10 / l - 10:.6g} mm')
    for F in (0.0181612, 0.0413111):                          # N/mm, GetFEM
        a = np.sqrt(F * 10 / (np.pi * 0.1)); print(f'cylinder, R = 10 mm, F\' = {F}: half width {a:.5f} mm, '
              f'approach of the plates {2 * F / (np.pi * 0.4) * (2 * np.log(40 / a) - 1):.6f} mm')

main()
