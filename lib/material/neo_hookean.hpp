#pragma once
/// Neo-Hookean rubber: W = mu/2 (I1bar - 3). mu [Pa] is the initial shear modulus, any mu > 0; stable everywhere.
/// The paper's C1 is mu/2. Source: Treloar, Trans. Faraday Soc. 39 (1943) 241. Held by material/law_test.
#include <string_view>

#include "material/invariants.hpp"

namespace soft::material {

struct NeoHookean {
    static constexpr std::string_view name = "neo-hookean";
    double mu_Pa = 0;

    template <class T>
    T isochoric_energy(const Invariants<T>& bar) const {
        return 0.5 * mu_Pa * (bar.I1 - 3.0);
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return mu_Pa; }
};

}  // namespace soft::material
