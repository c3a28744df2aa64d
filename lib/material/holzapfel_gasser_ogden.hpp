#pragma once
/// Neo-Hookean rubber with two families of fibres that only pull, Holzapfel-Gasser-Ogden form without dispersion:
///   W = mu/2 (I1bar - 3) + sum over families k1/(2 k2) [exp(k2 (I4 - 1)^2) - 1] where I4 = a0 . C a0 > 1,
///   a0 = cos(angle) e1 +- sin(angle) e2 in the fibre frame (e1 the axis x; e2 the hoop direction, or y).
/// mu, k1 [Pa], k2 [-] > 0, angle [rad] from e1; I4 is the full, not the isochoric, invariant. With one family (+ only) a
/// tube twists. Source: Holzapfel, Gasser, Ogden, J. Elasticity 61 (2000) 1, eqs. 63-65. Held by material/law_test.
#include <cmath>

#include "material/invariants.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct HolzapfelGasserOgden {
    double mu_Pa = 0, k1_Pa = 0, k2 = 1, angle_rad = 0;
    int families = 2;

    template <class T>
    T isochoric_energy(const Invariants<T>& bar) const {
        return 0.5 * mu_Pa * (bar.I1 - 3.0);
    }
    /// Energy of one family by its squared stretch I4.
    template <class T>
    T fiber_energy(const T& I4) const {
        using std::exp;
        const T x = I4 - 1.0;
        if (!(x > 0.0)) return T(0.0);
        return 0.5 * k1_Pa / k2 * (exp(k2 * x * x) - 1.0);
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return mu_Pa; }

    static LawInfo info() {
        return {.name = "holzapfel-gasser-ogden",
                .energy = "mu/2 (I1 - 3) + sum k1/(2 k2) [exp(k2 (I4 - 1)^2) - 1] over fibres with I4 > 1",
                .validity = "rubber with one or two families of fibres that carry tension only",
                .source = "Holzapfel, Gasser, Ogden, J. Elasticity 61 (2000) 1",
                .parameters = {{.name = "mu",
                                .meaning = "initial shear modulus of the rubber between the fibres",
                                .example = "0.1644 MPa",
                                .min = 0,
                                .min_open = true},
                               {.name = "k1",
                                .meaning = "stiffness of the fibres at small stretch",
                                .example = "0.5 MPa",
                                .min = 0,
                                .min_open = true},
                               {.name = "k2",
                                .quantity = Quantity::ratio,
                                .meaning = "how fast the fibres stiffen",
                                .example = "1",
                                .min = 0,
                                .min_open = true},
                               {.name = "angle",
                                .quantity = Quantity::angle,
                                .meaning = "of the fibres from the axis x, towards the hoop direction (bodies of revolution) or y",
                                .example = "30 deg",
                                .min = 0,
                                .max = 1.5707963267948966},
                               {.name = "families",
                                .quantity = Quantity::count,
                                .meaning = "2: fibres at plus and minus the angle; 1: at plus the angle",
                                .example = "2",
                                .min = 1,
                                .max = 2,
                                .fallback = "2"}},
                .fibers = true};
    }
    static HolzapfelGasserOgden from(const Constants& constants) {
        const auto value = [&](const char* name) { return constants.at(name).front(); };
        return {value("mu"), value("k1"), value("k2"), value("angle"), static_cast<int>(value("families"))};
    }
};

}  // namespace soft::material
