#pragma once
/// Gent rubber with limited chain extensibility: W = -mu jm/2 ln(1 - (I1bar - 3)/jm); neo-Hookean for jm -> infinity.
/// mu [Pa] is the initial shear modulus, jm > 0 [-] the value of I1bar - 3 at which the stress becomes infinite. For I1bar - 3 >= jm,
/// W and all its derivatives are NaN. Newton's line search treats such a state like an inverted element and shortens the step.
/// Stable for I1bar - 3 < jm. Source: Gent, Rubber Chem. Technol. 69 (1996) 59. Tested by material/law_test.
#include <cmath>
#include <limits>

#include "material/invariants.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct Gent {
    double mu_Pa = 0;
    double jm = 1;

    template <class T>
    T isochoric_energy(const Invariants<T>& bar) const {
        using std::log1p;
        const T x = bar.I1 - 3.0;
        // The derivatives of log1p are finite beyond the limit, so NaN must be returned explicitly.
        if (!(x < jm)) return x * std::numeric_limits<double>::quiet_NaN();
        return -0.5 * mu_Pa * jm * log1p(-x * (1.0 / jm));
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return mu_Pa; }

    static LawInfo info() {
        return {.name = "gent",
                .energy = "-mu jm/2 ln(1 - (I1 - 3)/jm)",
                .validity = "rubber with a locking stretch; undefined for I1 - 3 >= jm",
                .source = "Gent, Rubber Chem. Technol. 69 (1996) 59",
                .parameters = {positive("mu", "initial shear modulus", "0.1644 MPa"),
                               positive("jm", "value of I1 - 3 at which the chains lock", "80", Quantity::ratio)}};
    }
    static Gent from(const Constants& constants) { return {constants.at("mu").front(), constants.at("jm").front()}; }
};

}  // namespace soft::material
