#pragma once
/// Saint Venant-Kirchhoff: linear elasticity in the Green strain E = (C - I)/2,
///   W = mu dev E : dev E + kappa/2 (tr E)^2.
/// mu, kappa [Pa] are the shear and bulk moduli. Valid only for small strains with large rotations: in compression the stress
/// tends to zero as the stretch tends to 0; its uniaxial maximum is at a stretch of 3^-1/2. The constraint tr E = 0 differs from
/// J = 1, so there is no incompressible form. Source: Bonet and Wood, Nonlinear Continuum Mechanics (2008), 6.3.
/// Tested by material/law_test.
#include "material/invariants.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct SaintVenantKirchhoff {
    double mu_Pa = 0;

    /// dev E : dev E = tr E^2 - (tr E)^2/3 with tr E = (I1 - 3)/2 and tr E^2 = (I1^2 - 2 I2 - 2 I1 + 3)/4.
    template <class T>
    T shear_energy(const Invariants<T>& I, const T&) const {
        const T trace_E = 0.5 * (I.I1 - 3.0);
        return mu_Pa * (0.25 * (I.I1 * I.I1 - 2.0 * I.I2 - 2.0 * I.I1 + 3.0) - trace_E * trace_E / 3.0);
    }
    /// Theta = tr E in place of a function of J.
    template <class T>
    static T dilatation(const Invariants<T>& I, const T&) {
        return 0.5 * (I.I1 - 3.0);
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return mu_Pa; }

    static LawInfo info() {
        return {.name = "saint-venant-kirchhoff",
                .energy = "mu dev E : dev E + kappa/2 (tr E)^2, E the Green strain",
                .validity = "small strains with large rotations; fails in compression below a stretch of 0.58",
                .source = "Bonet and Wood, Nonlinear Continuum Mechanics (2008), 6.3",
                .parameters = {positive("mu", "shear modulus", "0.1644 MPa")},
                .bulk = Bulk::finite,
                .takes_volumetric = false,
                .takes_young_poisson = true};
    }
    static SaintVenantKirchhoff from(const Constants& constants) { return {constants.at("mu").front()}; }
};

}  // namespace soft::material
