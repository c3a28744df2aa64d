#pragma once
/// Ogden rubber of 1 to 4 terms in the isochoric principal stretches: W = sum_i mu_i/alpha_i (l1^a_i + l2^a_i + l3^a_i - 3).
/// mu_i [Pa], alpha_i not 0; initial shear modulus sum mu_i alpha_i / 2 > 0. alpha = 2 alone is neo-Hookean, (2, -2)
/// Mooney-Rivlin. Stable for every stretch where mu_i alpha_i > 0 for all i. Source: Ogden, Proc. R. Soc. A 326 (1972)
/// 565. Tested by material/law_test; equal stretches by material/ogden_test.
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct Ogden {
    static constexpr int max_terms = 4;
    struct Term {
        double mu_Pa = 0, alpha = 1;
    };
    std::array<Term, max_terms> terms{};
    int count = 0;

    template <class T>
    T energy_of_log_stretch(const T& x) const {
        using std::exp;
        T sum = 0.0;
        for (int i = 0; i < count; ++i) {
            const auto& [mu_Pa, alpha] = terms[static_cast<std::size_t>(i)];
            sum += mu_Pa / alpha * (exp(alpha * x) - 1.0);
        }
        return sum;
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const {
        double sum = 0;
        for (int i = 0; i < count; ++i)
            sum += 0.5 * terms[static_cast<std::size_t>(i)].mu_Pa * terms[static_cast<std::size_t>(i)].alpha;
        return sum;
    }

    static LawInfo info() {
        return {
            .name = "ogden",
            .energy = "sum mu_i/alpha_i (l1^alpha_i + l2^alpha_i + l3^alpha_i - 3), l the isochoric stretches",
            .validity = "fits most rubbers over their whole range; stable where every mu_i alpha_i is positive",
            .source = "Ogden, Proc. R. Soc. A 326 (1972) 565",
            .parameters = {{.name = "mu",
                            .meaning = "one value per term; the initial shear modulus is half the sum of mu_i alpha_i",
                            .example = "[0.63 MPa, 0.0012 MPa, -0.01 MPa]",
                            .max_count = max_terms},
                           {.name = "alpha",
                            .quantity = Quantity::ratio,
                            .meaning = "exponent of each term, not 0",
                            .example = "[1.3, 5, -2]",
                            .max_count = max_terms}}};
    }
    /// Throws Error (bad_input) for lists of different lengths or an exponent of 0.
    static Ogden from(const Constants& constants) {
        const auto& mu = constants.at("mu");
        const auto& alpha = constants.at("alpha");
        if (mu.size() != alpha.size())
            throw Error(ExitCode::bad_input, "alpha",
                        "mu has " + std::to_string(mu.size()) + " values and alpha " + std::to_string(alpha.size()),
                        "write one exponent for each modulus");
        Ogden law;
        for (std::size_t i = 0; i < mu.size() && i < max_terms; ++i) {
            if (alpha[i] == 0.0)
                throw Error(ExitCode::bad_input, "alpha", "an exponent of 0 gives no energy", "leave the term out");
            law.terms[i] = {mu[i], alpha[i]};
            ++law.count;
        }
        return law;
    }
};

}  // namespace soft::material
