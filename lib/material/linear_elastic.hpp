#pragma once
/// Linear elasticity at small strain, the comparison model of the paper: with e = sym(F - I),
///   W = mu dev e : dev e + kappa/2 (tr e)^2,   P = 2 mu dev e + kappa tr e I.
/// mu, kappa [Pa] are the shear and bulk moduli. Not frame indifferent: a rigid rotation by an angle a causes strains of
/// order a^2/2, so the law is valid for small displacements only. Tested by material/law_test.
#include "material/parameter.hpp"

namespace soft::material {

struct LinearElastic {
    double mu_Pa = 0;

    [[nodiscard]] double initial_shear_modulus_Pa() const { return mu_Pa; }

    static LawInfo info() {
        return {.name = "linear-elastic",
                .energy = "mu dev e : dev e + kappa/2 (tr e)^2, e the small strain",
                .validity = "small strains and rotations; for comparison with finite strain",
                .source = "the paper's linear model; Hooke's law",
                .parameters = {positive("mu", "shear modulus", "0.1644 MPa")},
                .takes_volumetric = false,
                .takes_young_poisson = true,
                .f_bar = false};
    }
    static LinearElastic from(const Constants& constants) { return {constants.at("mu").front()}; }
};

}  // namespace soft::material
