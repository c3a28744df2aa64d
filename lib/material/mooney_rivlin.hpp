#pragma once
/// Mooney-Rivlin rubber of two to five terms, with x = I1bar - 3 and y = I2bar - 3:
///   W = c10 x + c01 y + c20 x^2 + c11 x y + c02 y^2.
/// Constants in Pa; the initial shear modulus is 2 (c10 + c01) > 0. With c20 = c11 = c02 = 0 it is stable everywhere if c10
/// and c01 are not negative; if c01 < 0, only up to a uniaxial stretch of sqrt(-c10/c01). Sources: Mooney, J. Appl. Phys.
/// 11 (1940) 582; Rivlin, Phil. Trans. R. Soc. A 241 (1948) 379; the limit is derived in material/stability_test.
/// Tested by material/law_test.
#include "material/invariants.hpp"
#include "material/parameter.hpp"

namespace soft::material {

struct MooneyRivlin {
    double c10_Pa = 0, c01_Pa = 0, c20_Pa = 0, c11_Pa = 0, c02_Pa = 0;

    template <class T>
    T isochoric_energy(const Invariants<T>& bar) const {
        const T x = bar.I1 - 3.0, y = bar.I2 - 3.0;
        return x * (c10_Pa + c20_Pa * x + c11_Pa * y) + y * (c01_Pa + c02_Pa * y);
    }
    [[nodiscard]] double initial_shear_modulus_Pa() const { return 2.0 * (c10_Pa + c01_Pa); }

    static LawInfo info() {
        return {.name = "mooney-rivlin",
                .energy = "c10 (I1 - 3) + c01 (I2 - 3) + c20 (I1 - 3)^2 + c11 (I1 - 3)(I2 - 3) + c02 (I2 - 3)^2",
                .validity = "two terms up to stretches of about 2; five terms need tests in more than one mode",
                .source = "Rivlin, Phil. Trans. R. Soc. A 241 (1948) 379",
                .parameters = {{.name = "c10",
                                .meaning = "factor of I1 - 3; 2 (c10 + c01) is the initial shear modulus",
                                .example = "64 kPa"},
                               {.name = "c01", .meaning = "factor of I2 - 3", .example = "18 kPa"},
                               optional_modulus("c20", "factor of (I1 - 3)^2", "1 kPa"),
                               optional_modulus("c11", "factor of (I1 - 3)(I2 - 3)", "1 kPa"),
                               optional_modulus("c02", "factor of (I2 - 3)^2", "1 kPa")}};
    }
    static MooneyRivlin from(const Constants& constants) {
        const auto value = [&](const char* name) { return constants.at(name).front(); };
        return {value("c10"), value("c01"), value("c20"), value("c11"), value("c02")};
    }
};

}  // namespace soft::material
