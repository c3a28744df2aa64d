#pragma once
/// Yeoh rubber: W = c1 x + c2 x^2 + c3 x^3 + a (x - (1 - exp(-b x))/b) with x = I1bar - 3; c1, c2, c3, a in Pa, b > 0 a plain
/// number. The initial shear modulus is 2 c1 > 0. The last term is the exponential term of Yeoh's paper, combined with a part of the
/// linear term so that dW/dI1 increases by a from c1 as 1 - exp(-b x): the modulus first increases and then levels off. The term
/// is omitted if a = 0. Stable at every stretch if c2, c3 and a are not negative: dW/dI1 is positive and does not decrease.
/// Source: Yeoh, Rubber Chem. Technol. 66 (1993) 754. Tested by material/law_test and material/homogeneous_test.
#include <cmath>

#include "material/invariants.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct Yeoh {
    double c1_Pa = 0, c2_Pa = 0, c3_Pa = 0, a_Pa = 0, b = 1;

    template <class T>
    T isochoric_energy(const Invariants<T>& bar) const {
        using std::expm1;
        const T x = bar.I1 - 3.0;
        const T polynomial = x * (c1_Pa + x * (c2_Pa + c3_Pa * x));
        if (a_Pa == 0.0) return polynomial;
        return polynomial + a_Pa * (x + expm1(-b * x) * (1.0 / b));
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return 2.0 * c1_Pa; }

    static LawInfo info() {
        return {.name = "yeoh",
                .energy = "c1 x + c2 x^2 + c3 x^3 + a (x - (1 - exp(-b x))/b), x = I1 - 3",
                .validity = "stiffening of filled rubbers at large stretch; needs only uniaxial tests",
                .source = "Yeoh, Rubber Chem. Technol. 66 (1993) 754",
                .parameters = {positive("c1", "half the initial shear modulus", "82.2 kPa"),
                               optional_modulus("c2", "factor of (I1 - 3)^2", "1 kPa"),
                               optional_modulus("c3", "factor of (I1 - 3)^3", "0.05 kPa"),
                               optional_modulus("a", "increase of dW/dI1 from c1, as 1 - exp(-b (I1 - 3))", "50 kPa"),
                               {.name = "b",
                                .quantity = Quantity::ratio,
                                .meaning = "rate of this increase; unused if a is 0",
                                .example = "0.1",
                                .min = 0,
                                .min_open = true,
                                .fallback = "1"}}};
    }
    static Yeoh from(const Constants& constants) {
        const auto value = [&](const char* name) { return constants.at(name).front(); };
        return {value("c1"), value("c2"), value("c3"), value("a"), value("b")};
    }
};

}  // namespace soft::material
