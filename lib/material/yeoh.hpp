#pragma once
/// Yeoh rubber: W = c1 x + c2 x^2 + c3 x^3 with x = I1bar - 3. All in Pa; the initial shear modulus is 2 c1 > 0. Stable
/// everywhere where W' = c1 + 2 c2 x + 3 c3 x^2 is positive and grows; c2 is negative and c3 positive for most rubbers.
/// Source: Yeoh, Rubber Chem. Technol. 66 (1993) 754. Held by material/law_test.
#include "material/invariants.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct Yeoh {
    double c1_Pa = 0, c2_Pa = 0, c3_Pa = 0;

    template <class T>
    T isochoric_energy(const Invariants<T>& bar) const {
        const T x = bar.I1 - 3.0;
        return x * (c1_Pa + x * (c2_Pa + c3_Pa * x));
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return 2.0 * c1_Pa; }

    static LawInfo info() {
        return {.name = "yeoh",
                .energy = "c1 (I1 - 3) + c2 (I1 - 3)^2 + c3 (I1 - 3)^3",
                .validity = "follows the upturn of filled rubbers from uniaxial tests alone",
                .source = "Yeoh, Rubber Chem. Technol. 66 (1993) 754",
                .parameters = {
                    {.name = "c1",
                     .meaning = "half the initial shear modulus",
                     .example = "82.2 kPa",
                     .min = 0,
                     .min_open = true},
                    {.name = "c2", .meaning = "factor of (I1 - 3)^2", .example = "1 kPa", .fallback = "0 Pa"},
                    {.name = "c3", .meaning = "factor of (I1 - 3)^3", .example = "0.05 kPa", .fallback = "0 Pa"}}};
    }
    static Yeoh from(const Constants& constants) {
        return {constants.at("c1").front(), constants.at("c2").front(), constants.at("c3").front()};
    }
};

}  // namespace soft::material
