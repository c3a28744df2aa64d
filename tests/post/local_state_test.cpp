#include "post/local_state.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace soft::post {
namespace {

TEST(PrincipalStretches, OfSimpleShearMatchTheClosedForm) {
    // Ogden, Non-Linear Elastic Deformations (1984), 2.2: l - 1/l = g, the largest along tan 2t = 2/g in the deformed
    // configuration
    const double g = 0.7, l = 0.5 * (g + std::sqrt(g * g + 4)), t = 0.5 * std::atan2(2.0, g);
    const auto principal = principal_stretches({1, g, 0, 0, 1, 0, 0, 0, 1});
    EXPECT_NEAR(principal.stretch[0], l, 1e-14);
    EXPECT_NEAR(principal.stretch[1], 1.0, 1e-14);
    EXPECT_NEAR(principal.stretch[2], 1.0 / l, 1e-14);
    EXPECT_NEAR(principal.direction[0][0], std::cos(t), 1e-14);
    EXPECT_NEAR(principal.direction[0][1], std::sin(t), 1e-14);
    EXPECT_NEAR(principal.direction[1][2], 1.0, 1e-14);
}

TEST(PrincipalStretches, DirectionsRotateWithTheBody) {
    const double c = std::cos(0.4), s = std::sin(0.4);
    const Tensor turned{1.5 * c, -1.2 * s, 0, 1.5 * s, 1.2 * c,
                        0,       0,        0, 0.8};  // rotation about z by 0.4 after diag(1.5, 1.2, 0.8)
    const auto principal = principal_stretches(turned);
    EXPECT_NEAR(principal.stretch[0], 1.5, 1e-14);
    EXPECT_NEAR(principal.stretch[2], 0.8, 1e-14);
    EXPECT_NEAR(principal.direction[0][0], c, 1e-14);
    EXPECT_NEAR(principal.direction[0][1], s, 1e-14);
    EXPECT_NEAR(principal.direction[1][0], -s, 1e-14);
    EXPECT_NEAR(principal.direction[1][1], c, 1e-14);
}

TEST(VonMises, IsTheUniaxialStressAndRootThreeTimesAShearStress) {
    EXPECT_NEAR(von_mises_Pa({5, 0, 0, 0, 0, 0, 0, 0, 0}), 5.0, 1e-14);
    EXPECT_NEAR(von_mises_Pa({0, 2, 0, 2, 0, 0, 0, 0, 0}), 2.0 * std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(von_mises_Pa({7, 0, 0, 0, 7, 0, 0, 0, 7}), 0.0, 1e-14);
}

TEST(Pressure, IsPositiveInCompression) {
    EXPECT_DOUBLE_EQ(pressure_Pa({-3, 0, 0, 0, -3, 0, 0, 0, -3}), 3.0);
    EXPECT_DOUBLE_EQ(pressure_Pa({6, 0, 0, 0, 0, 0, 0, 0, 0}), -2.0);
}

}  // namespace
}  // namespace soft::post
