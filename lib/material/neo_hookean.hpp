#pragma once
/// Neo-Hookean rubber: W = mu/2 (I1bar - 3). mu [Pa] is the initial shear modulus, any mu > 0; stable everywhere.
/// The paper's C1 is mu/2. Source: Treloar, Trans. Faraday Soc. 39 (1943) 241. Tested by material/law_test.
#include "material/invariants.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct NeoHookean {
    double mu_Pa = 0;

    template <class T>
    T isochoric_energy(const Invariants<T>& bar) const {
        return 0.5 * mu_Pa * (bar.I1 - 3.0);
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return mu_Pa; }

    static LawInfo info() {
        return {
            .name = "neo-hookean",
            .energy = "mu/2 (I1 - 3)",
            .validity = "one constant; good to stretches of about 1.5, stable everywhere",
            .source = "Treloar, Trans. Faraday Soc. 39 (1943) 241",
            .parameters = {positive(
                "mu", "initial shear modulus, a third of Young's modulus of an incompressible rubber", "0.1644 MPa")}};
    }
    static NeoHookean from(const Constants& constants) { return {constants.at("mu").front()}; }
};

}  // namespace soft::material
