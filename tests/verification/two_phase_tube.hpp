#pragma once
/// A long closed tube of rubber that locks has a maximum and a minimum of pressure; between them a bulged part and a part
/// of it that has hardly grown can lie side by side at one pressure, and the bulge spreads at that pressure as volume is
/// added. It is the Maxwell line of the pressure-volume curve of the even tube: E. Chater and J. W. Hutchinson, On the
/// propagation of bulges and buckles, J. Appl. Mech. 51 (1984) 269-277. Here with the wall's thickness, by quadrature.
#include "inflation_formula.hpp"

namespace soft::verification {

struct GentTube {
    double mu_Pa, jm;  ///< W = -mu jm / 2 ln(1 - (I1 - 3)/jm)
    double inner_m, outer_m;
};

/// An even state, with volume and energy per undeformed length.
struct EvenTube {
    double inner_stretch, axial_stretch, pressure_Pa;
    double volume_m2;  ///< enclosed
    double energy_J_m;
};

/// The even state of an inner hoop stretch below that at which the chains lock.
[[nodiscard]] EvenTube even_tube(const GentTube& tube, double inner_stretch);

struct Coexistence {
    double pressure_Pa;
    EvenTube thin, bulge;  ///< the parts before and within the bulge; both have this pressure
};

/// The pressure at which energy - pressure x volume is the same in both parts. `maximum` and `minimum`: the inner stretches
/// of the pressure's extrema. Tested by formula_test: the areas that the line cuts from the curve p(V) are equal.
[[nodiscard]] Coexistence coexistence(const GentTube& tube, double maximum, double minimum);

}  // namespace soft::verification
