#pragma once
/// A long closed tube of incompressible rubber with fibres in a layer of its wall: inflation, extension and torsion by
/// quadrature. With A the inner radius, h = a/A, theta = Theta + tau X, x = lz X and r^2 = a^2 + (R^2 - A^2)/lz,
///   F = diag(R/(r lz), r/R, lz) in (r, theta, x), and F_theta,X = r tau,
///   sigma + q I = 2 w(I1) B + sum over families 2 k1 (I4 - 1) exp(k2 (I4 - 1)^2) f (x) f,  f = F a0,  I4 = f.f > 1,
///   a0 = (0, +- sin(angle), cos(angle)), w = dW/dI1 of the rubber between the fibres;
///   p = int (s_theta - s_r) dr/r,  int (2 s_x - s_theta - s_r) r dr = 0 (closed ends, see closed_tube),
///   int s_theta,x r^2 dr = 0 (no torque on the ends).
/// Sources: universal solution of Ericksen and Rivlin, see Ogden, Non-linear Elastic Deformations (1984), 5.3; the stress of
/// the fibres is that of Holzapfel, Gasser, Ogden, J. Elasticity 61 (2000) 1, derived here from W by hand.
/// Tested by formula_test: without fibres it equals closed_tube; a thin wall with stiff fibres has the magic angle.
#include <functional>

namespace soft::verification {

struct FiberTube {
    double inner_m, outer_m;
    std::function<double(double I1)> slope_Pa;  ///< w
    double angle_rad, k1_Pa, k2;
    int families;                           ///< 2: the twist stays 0
    double layer_begin = 0, layer_end = 1;  ///< fractions of the wall
};

struct FiberTubeState {
    double hoop = 1;       ///< a/A
    double axial = 1;      ///< lz
    double twist_1_m = 0;  ///< tau, per undeformed length
};

/// The state at a pressure on the branch that starts at the undeformed state. Throws std::runtime_error beyond the end of this branch.
[[nodiscard]] FiberTubeState fiber_tube_state(const FiberTube& tube, double pressure_Pa);

/// The pressure in equilibrium with a state, from the first equation only.
[[nodiscard]] double fiber_tube_pressure_Pa(const FiberTube& tube, const FiberTubeState& state);

/// The angle [rad] at which the tube does not elongate at this (small) pressure, by the secant method from 54 and 55.5 degrees.
[[nodiscard]] double neutral_angle_rad(FiberTube tube, double pressure_Pa);

}  // namespace soft::verification
