#pragma once
/// Gent rubber, whose chains lock: W = -mu jm/2 ln(1 - (I1bar - 3)/jm), neo-Hookean as jm grows.
/// mu [Pa] is the initial shear modulus, jm > 0 [-] the value of I1bar - 3 at which the stress becomes infinite. At and
/// beyond it W and all its derivatives are NaN: no state of the rubber, which Newton's line search treats like an
/// inverted cell and steps back from. Stable up to there. Source: Gent, Rubber Chem. Technol. 69 (1996) 59. Held by
/// material/law_test.
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
        // log1p alone would keep finite derivatives beyond the limit.
        if (!(x < jm)) return x * std::numeric_limits<double>::quiet_NaN();
        return -0.5 * mu_Pa * jm * log1p(-x * (1.0 / jm));
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return mu_Pa; }

    static LawInfo info() {
        return {
            .name = "gent",
            .energy = "-mu jm/2 ln(1 - (I1 - 3)/jm)",
            .validity = "rubber that stiffens towards a largest stretch; no state beyond I1 - 3 = jm",
            .source = "Gent, Rubber Chem. Technol. 69 (1996) 59",
            .parameters = {
                {.name = "mu", .meaning = "initial shear modulus", .example = "0.1644 MPa", .min = 0, .min_open = true},
                {.name = "jm",
                 .quantity = Quantity::ratio,
                 .meaning = "value of I1 - 3 at which the chains lock",
                 .example = "80",
                 .min = 0,
                 .min_open = true}}};
    }
    static Gent from(const Constants& constants) { return {constants.at("mu").front(), constants.at("jm").front()}; }
};

}  // namespace soft::material
