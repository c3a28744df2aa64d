#include "fit/nominal.hpp"

#include <gtest/gtest.h>

#include <array>

#include "samples.hpp"

namespace soft::fit {
namespace {

const std::array modes{Mode::uniaxial, Mode::equibiaxial, Mode::planar};

/// Plausible constants for each candidate.
material::Constants constants(const Candidate& candidate) {
    const std::array<double, 5> linear{120e3, 20e3, 1e3, 300.0, 50.0};
    const std::array<double, 4> shapes{3.0, -2.0, 1.5, 5.0};
    if (candidate.law == "gent") return constants_of(candidate, std::span{linear}.first(1), std::array{80.0});
    return constants_of(candidate, std::span{linear}.first(static_cast<std::size_t>(candidate.linear)),
                        std::span{shapes}.first(static_cast<std::size_t>(candidate.shapes)));
}

TEST(NominalStress, EqualsThatOfTheHomogeneousStateForEveryLaw) {
    for (const Candidate& candidate : candidates()) {
        const auto rubber = rubber_of(candidate, constants(candidate));
        ASSERT_TRUE(rubber) << candidate.name;
        for (const Mode mode : modes)
            for (const double stretch : {0.6, 1.0, 1.2, 2.5}) {
                std::array<double, 1> stress{};
                add_stresses(candidate, constants(candidate), {std::array{mode}, std::array{stretch}}, stress);
                const double wanted =
                    material::nominal_stress_Pa(*material::homogeneous_state(*rubber, mode, stretch), mode);
                EXPECT_NEAR(stress[0], wanted, 1e-10 * std::abs(wanted) + 1e-6) << candidate.name << " " << stretch;
            }
    }
}

TEST(NominalStress, NeoHookeanMatchesItsClosedForms) {
    const material::NeoHookean law{2.0};  // 2 C1 = 2
    EXPECT_NEAR(nominal_stress_Pa(law, Mode::uniaxial, 3.0), 2.0 * (3.0 - 1.0 / 9.0), 1e-14);
    EXPECT_NEAR(nominal_stress_Pa(law, Mode::equibiaxial, 2.0), 2.0 * (2.0 - 1.0 / 32.0), 1e-14);
    EXPECT_NEAR(nominal_stress_Pa(law, Mode::planar, 2.0), 2.0 * (2.0 - 1.0 / 8.0), 1e-14);
}

}  // namespace
}  // namespace soft::fit
