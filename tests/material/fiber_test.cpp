#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "material/stability.hpp"
#include "samples.hpp"

namespace soft::material {
namespace {

using namespace sample;

constexpr double k1_Pa = 2e5, k2 = 0.8;

Rubber<HolzapfelGasserOgden> fibres(double angle_rad, double families = 2) {
    const Constants constants{
        {"mu", {mu_Pa}}, {"k1", {k1_Pa}}, {"k2", {k2}}, {"angle", {angle_rad}}, {"families", {families}}};
    return std::get<Rubber<HolzapfelGasserOgden>>(
        make_rubber({.law = "holzapfel-gasser-ogden", .constants = constants, .bulk_modulus_Pa = kappa_Pa}));
}

/// P of the fibres without that of the matrix.
Tensor pull(const Rubber<HolzapfelGasserOgden>& rubber, const Tensor& at, const FiberAxes& axes = {}) {
    const Rubber<NeoHookean> matrix{{mu_Pa}, VolumetricLaw::quadratic, rubber.inverse_bulk_modulus};
    return difference(displacement(rubber, at, axes).first_piola, displacement(matrix, at).first_piola);
}

TEST(Fibres, StressAlongTheStretchMatchesTheClosedForm) {
    // One family along x, F = diag(l, 1, 1): I4 = l^2, dW/dl = 2 k1 l (l^2 - 1) exp(k2 (l^2 - 1)^2).
    for (const double l : {1.05, 1.4, 1.9}) {
        const double x = l * l - 1, expected = 2 * k1_Pa * l * x * std::exp(k2 * x * x);
        const Tensor P = pull(fibres(0.0, 1), {l, 0, 0, 0, 1, 0, 0, 0, 1});
        EXPECT_NEAR(P[0], expected, 1e-12 * kappa_Pa + 1e-12 * expected);
        for (int m = 1; m < 9; ++m) EXPECT_NEAR(P[m], 0.0, 1e-12 * kappa_Pa);
    }
}

TEST(Fibres, CarryNoCompression) {
    EXPECT_LE(size_of(pull(fibres(0.0), {0.8, 0, 0, 0, 1.2, 0, 0, 0, 1.1})), 0.0);
    EXPECT_LE(size_of(pull(fibres(1.2), {1.3, 0, 0, 0, 0.7, 0, 0, 0, 1})), 0.0);  // I4 = 1.69 c^2 + 0.49 s^2 = 0.65
}

TEST(Fibres, StressIsContinuousAtZeroFibreStrain) {
    // I4 - 1 = 2 h: the stress 2 k1 (2 h) is of first order; the tangent jumps by the modulus 4 k1.
    for (const double h : {1e-3, 1e-6, 1e-9}) {
        const Tensor P = pull(fibres(0.0, 1), {1 + h, 0, 0, 0, 1, 0, 0, 0, 1});
        EXPECT_NEAR(P[0] / (4 * k1_Pa * h), 1.0, 3 * h + 1e-16 * kappa_Pa / (k1_Pa * h));
    }
    EXPECT_EQ(size_of(pull(fibres(0.0, 1), identity_tensor)), 0.0);
}

TEST(Fibres, TwoFamiliesAreAtPlusAndMinusTheAngle) {
    // F = I + g e1 e2 stretches +angle and shortens -angle for small g: I4 - 1 = 2 g c s + g^2 s^2.
    const double angle = 0.6, c = std::cos(angle), s = std::sin(angle), g = 0.3;
    const Tensor at{1, g, 0, 0, 1, 0, 0, 0, 1};
    const double x = 2 * g * c * s + g * g * s * s, slope = 2 * k1_Pa * x * std::exp(k2 * x * x);
    const Vector3 a{c + g * s, s, 0};
    for (const double families : {1.0, 2.0}) {
        const Tensor P = pull(fibres(angle, families), at);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(P[3 * i], slope * a[i] * c, 1e-12 * kappa_Pa);
            EXPECT_NEAR(P[3 * i + 1], slope * a[i] * s, 1e-12 * kappa_Pa);
            EXPECT_NEAR(P[3 * i + 2], 0.0, 1e-12 * kappa_Pa);
        }
    }
    // With the opposite shear only the second family is in tension.
    EXPECT_EQ(size_of(pull(fibres(angle, 1), {1, -g, 0, 0, 1, 0, 0, 0, 1})), 0.0);
    EXPECT_GT(size_of(pull(fibres(angle, 2), {1, -g, 0, 0, 1, 0, 0, 0, 1})), 1e3);
}

TEST(Fibres, FollowTheirFrame) {  // P(F Q^T) of the frame Q e is P(F) Q^T of the frame e
    const Tensor Q = rotation(0.9);
    const FiberAxes turned{{Q[0], Q[3], Q[6]}, {Q[1], Q[4], Q[7]}};
    const auto r = fibres(0.5);
    const Tensor expected = multiply(displacement(r, F).first_piola, transposed(Q));
    EXPECT_LE(distance(displacement(r, multiply(F, transposed(Q)), turned).first_piola, expected), 1e-12 * kappa_Pa);
    EXPECT_GT(distance(displacement(r, multiply(F, transposed(Q))).first_piola, expected), 1e-2 * kappa_Pa * 0.01);
}

/// The message "location: problem; remedy" for fibres in a rubber; empty if they are accepted.
std::string refusal(const Fibers& in, std::string_view law = "neo-hookean") {
    auto description = description_of(law);
    description.fibers = in;
    try {
        static_cast<void>(make_rubber(description));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(Fibres, AddedToNeoHookeanGiveTheHolzapfelGasserOgdenLaw) {
    const Rubber<NeoHookean> beside = fibered<NeoHookean>();
    const Rubber<HolzapfelGasserOgden> own = rubber<HolzapfelGasserOgden>();
    ASSERT_EQ(beside.fibers, own.fibers);
    EXPECT_EQ(displacement(beside, F).first_piola, displacement(own, F).first_piola);
    EXPECT_EQ(displacement(beside, F).tangent, displacement(own, F).tangent);
}

TEST(Fibres, RejectsInvalidParametersAndUnsupportedLaws) {
    EXPECT_EQ(refusal(two_families), "");
    EXPECT_EQ(refusal({0.5, 2e5, 0.8, 1}, "ogden"), "");
    EXPECT_EQ(refusal({0.5, 0, 0.8, 2}), "fibers.k1: 0 Pa is not positive");
    EXPECT_EQ(refusal({0.5, 2e5, -1, 2}), "fibers.k2: -1 is not positive");
    EXPECT_EQ(refusal({0.5, 2e5, 0.8, 3}), "fibers.families: 3 is not supported; use 1 or 2");
    EXPECT_EQ(refusal({1.6, 2e5, 0.8, 2}),
              "fibers.angle: 1.6 rad is outside its range; use 0 to 90 degrees from the axis");
    for (const char* law : {"kraken", "linear-elastic"})
        EXPECT_EQ(refusal(two_families, law),
                  std::string{"fibers: the law "} + law +
                      " has no finite-strain energy to which fibres can be added; use neo-hookean, for example");
    EXPECT_EQ(refusal(two_families, "holzapfel-gasser-ogden"),
              "fibers: the law holzapfel-gasser-ogden already has fibres; use a law without fibres");
}

TEST(Fibres, DoNotChangeTheStabilityLimitsOfTheMatrix) {
    auto description = description_of("mooney-rivlin");
    const auto plain = stability_limits(make_rubber(description));
    description.fibers = two_families;
    const auto limits = stability_limits(make_rubber(description));
    ASSERT_EQ(limits.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(limits[i].stretch, plain[i].stretch);
}

}  // namespace
}  // namespace soft::material
