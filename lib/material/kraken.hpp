#pragma once
/// The stress of the reference work, for reproducing its results only: Cauchy sigma = kappa (J - 1) I + mu B (its Eq. 2 with
/// mu = 2 C1 and kappa = 2 D1). There is no energy for it (the B term lacks the factor 1/J), so its tangent is not symmetric. The
/// undeformed state has the initial stress mu I; without load the body shrinks by about mu/(3 kappa) in each direction.
/// In F: P = kappa (J - 1) cof F + mu J F. Source: MOOSE-Based Finite Element Hyperelastic Modeling for Soft Robot
/// Simulations (2022), Eq. 2. Tested by material/law_test.
#include <array>

#include "material/invariants.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct Kraken {
    double mu_Pa = 0;
    double kappa_Pa = 0;

    /// P = c1 dI1/dF + c2 dI2/dF + cJ cof F.
    template <class T>
    std::array<T, 3> stress_coefficients(const Invariants<T>&, const T& J) const {
        return {0.5 * mu_Pa * J, T(0.0), kappa_Pa * (J - 1.0)};
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return mu_Pa; }

    static LawInfo info() {
        return {
            .name = "kraken",
            .energy = "no energy; Cauchy stress kappa (J - 1) I + mu B",
            .validity =
                "stress of the reference work, to reproduce its results; the undeformed state has the initial stress mu",
            .source = "MOOSE-Based Finite Element Hyperelastic Modeling for Soft Robot Simulations (2022), Eq. 2",
            .parameters = {positive("mu", "twice the paper's C1", "0.1644 MPa")},
            .bulk = Bulk::finite,
            .takes_volumetric = false,
            .mixed = false,
            .f_bar = false};
    }
    /// make_rubber sets kappa from the bulk modulus of the rubber.
    static Kraken from(const Constants& constants) { return {constants.at("mu").front(), 0.0}; }
};

}  // namespace soft::material
