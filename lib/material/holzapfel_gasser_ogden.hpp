#pragma once
/// Neo-Hookean rubber with one or two families of fibres: W = mu/2 (I1bar - 3) + the energy of material/fibers.hpp.
/// mu, k1 [Pa], k2 [-] > 0, angle [rad].
/// Source: Holzapfel, Gasser, Ogden, J. Elasticity 61 (2000) 1, eqs. 63-65. Tested by material/law_test.
#include "material/fibers.hpp"
#include "material/invariants.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct HolzapfelGasserOgden {
    double mu_Pa = 0;

    template <class T>
    T isochoric_energy(const Invariants<T>& bar) const {
        return 0.5 * mu_Pa * (bar.I1 - 3.0);
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return mu_Pa; }

    static LawInfo info() {
        return {.name = "holzapfel-gasser-ogden",
                .energy = "mu/2 (I1 - 3) + sum k1/(2 k2) [exp(k2 (I4 - 1)^2) - 1] over fibres with I4 > 1",
                .validity = "rubber with one or two families of fibres that carry tension only",
                .source = "Holzapfel, Gasser, Ogden, J. Elasticity 61 (2000) 1",
                .parameters =
                    {positive("mu", "initial shear modulus of the rubber between the fibres", "0.1644 MPa"),
                     positive("k1", "stiffness of the fibres at small strain", "0.5 MPa"),
                     positive("k2", "exponential stiffening of the fibres", "1", Quantity::ratio),
                     {.name = "angle",
                      .quantity = Quantity::angle,
                      .meaning =
                          "angle of the fibres from the axis x, towards the hoop direction (bodies of revolution) or y",
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
    static HolzapfelGasserOgden from(const Constants& constants) { return {constants.at("mu").front()}; }
    static Fibers fibers_from(const Constants& constants) {
        const auto value = [&](const char* name) { return constants.at(name).front(); };
        return {value("angle"), value("k1"), value("k2"), static_cast<int>(value("families"))};
    }
};

}  // namespace soft::material
