#pragma once
/// The pressure of a long closed tube with a locking stretch has a maximum and a minimum. Between them a bulged part and a hardly inflated
/// part of the tube can coexist at one pressure, and the bulge propagates at this pressure as volume is added. It is the Maxwell line of
/// the pressure-volume curve of the uniform tube: E. Chater and J. W. Hutchinson, On the propagation of bulges and buckles, J. Appl.
/// Mech. 51 (1984) 269-277. Here for finite wall thickness, by quadrature.
#include "inflation_formula.hpp"

namespace soft::verification {

struct GentTube {
    double mu_Pa, jm;  ///< W = -mu jm / 2 ln(1 - (I1 - 3)/jm)
    double inner_m, outer_m;
};

/// A uniform state, with volume and energy per undeformed length.
struct EvenTube {
    double inner_stretch, axial_stretch, pressure_Pa;
    double volume_m2;  ///< enclosed
    double energy_J_m;
};

/// The uniform state at an inner hoop stretch below the locking stretch.
[[nodiscard]] EvenTube even_tube(const GentTube& tube, double inner_stretch);

struct Coexistence {
    double pressure_Pa;
    EvenTube thin, bulge;  ///< the parts outside and inside the bulge, both at this pressure
};

/// The pressure at which energy - pressure x volume is equal in both parts. `maximum` and `minimum` are the inner stretches at the extrema
/// of the pressure. Tested by formula_test: the line cuts equal areas from the curve p(V).
[[nodiscard]] Coexistence coexistence(const GentTube& tube, double maximum, double minimum);

}  // namespace soft::verification
