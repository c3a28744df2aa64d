#pragma once
/// Compressible neo-Hookean rubber, not split into isochoric and volumetric parts:
///   W = mu/2 (I1 - 3 - 2 ln J) + lambda/2 Theta(J)^2,   lambda = kappa - 2 mu/3.
/// mu, kappa [Pa] are the initial shear and bulk moduli, kappa > 2 mu/3; with Theta = ln J (volumetric: log) this is the
/// textbook form. Source: Bonet and Wood, Nonlinear Continuum Mechanics (2008), eq. 6.27. Tested by material/law_test.
#include <cmath>

#include "material/invariants.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct NeoHookeanCompressible {
    double mu_Pa = 0;

    template <class T>
    T shear_energy(const Invariants<T>& I, const T& J) const {
        using std::log;
        return 0.5 * mu_Pa * (I.I1 - 3.0 - 2.0 * log(J));
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return mu_Pa; }
    /// Factor of Theta^2/2 for the initial bulk modulus kappa; 0 where it is lost in rounding: the mixed form divides by it.
    [[nodiscard]] double dilatation_modulus_Pa(double kappa_Pa) const {
        const double lambda_Pa = kappa_Pa - 2.0 * mu_Pa / 3.0;
        return lambda_Pa > 1e-8 * mu_Pa ? lambda_Pa : 0.0;
    }

    static LawInfo info() {
        return {.name = "neo-hookean-compressible",
                .energy = "mu/2 (I1 - 3 - 2 ln J) + (kappa - 2 mu/3)/2 Theta(J)^2, I1 not isochoric",
                .validity = "the form with ln J for foams and textbook comparisons; kappa above 2 mu/3",
                .source = "Bonet and Wood, Nonlinear Continuum Mechanics (2008), eq. 6.27",
                .parameters = {positive("mu", "initial shear modulus", "0.1644 MPa")}};
    }
    static NeoHookeanCompressible from(const Constants& constants) { return {constants.at("mu").front()}; }
};

}  // namespace soft::material
