// Ogden's law at equal stretches, compared with laws in invariants, which do not use principal stretches.
#include <gtest/gtest.h>

#include <cmath>

#include "samples.hpp"

namespace soft::material {
namespace {

using namespace sample;

/// alpha = 2: mu/2 (I1bar - 3). alpha = (2, -2) with mu = (2 c10, -2 c01): Mooney-Rivlin, as I2bar is the sum of l^-2.
constexpr double c10_Pa = 6.4e4, c01_Pa = 1.8e4;

template <class L>
Rubber<L> made(std::string_view law, const Constants& constants) {
    return std::get<Rubber<L>>(make_rubber({.law = law, .constants = constants, .bulk_modulus_Pa = kappa_Pa}));
}

/// Q1 diag(stretches) Q2.
Tensor with_stretches(const Vector3& l) {
    return multiply(rotation(0.4), multiply(Tensor{l[0], 0, 0, 0, l[1], 0, 0, 0, l[2]}, rotation(-1.1)));
}

void expect_same(const Vector3& stretches) {
    const Tensor at = with_stretches(stretches);
    const auto compare = [&](const PointResponse& ogden, const PointResponse& other) {
        EXPECT_LE(distance(ogden.first_piola, other.first_piola), 1e-12 * size_of(other.tangent)) << stretches[1];
        EXPECT_LE(distance(ogden.tangent, other.tangent), 1e-12 * size_of(other.tangent)) << stretches[1];
    };
    compare(displacement(made<Ogden>("ogden", {{"mu", {mu_Pa}}, {"alpha", {2.0}}}), at),
            displacement(made<NeoHookean>("neo-hookean", {{"mu", {mu_Pa}}}), at));
    compare(displacement(made<Ogden>("ogden", {{"mu", {2 * c10_Pa, -2 * c01_Pa}}, {"alpha", {2.0, -2.0}}}), at),
            displacement(made<MooneyRivlin>("mooney-rivlin", {{"c10", {c10_Pa}}, {"c01", {c01_Pa}}}), at));
}

TEST(Ogden, WithAlphaTwoIsNeoHookeanAndWithTwoTermsMooneyRivlin) {
    expect_same({1.6, 0.9, 0.7});
    expect_same({4.0, 0.5, 0.5});
    expect_same({0.3, 1.83, 1.83});
    expect_same({1.0, 1.0, 1.0});
    expect_same({1.3, 1.3, 1.3});
}

TEST(Ogden, IsExactForNearlyEqualStretches) {
    for (const double apart :
         {0.1, 0.021, 0.02, 0.0199, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 0.0}) {
        expect_same({1.4, 1.4 * (1 + apart), 0.6});
        expect_same({0.6, 1.4, 1.4 * (1 + apart)});
        expect_same({1.2 * (1 + apart), 1.2, 1.2 * (1 - apart)});
    }
}

TEST(Ogden, WithHighExponentsIsContinuousWhereTheQuotientChangesItsForm) {
    // If two stretches differ by more than 0.02 in log stretch, the plain quotient is used instead of the mean of W''. Both must agree,
    // also for the largest exponents in use. A jump would be a deviation from the mean of the neighbouring values.
    const auto r = made<Ogden>("ogden", {{"mu", {1e3, -2e3, 1.2e5}}, {"alpha", {25.0, -12.0, 1.3}}});
    const double edge = std::exp(0.02);
    const auto below = displacement(r, with_stretches({1.1, 1.1 * edge * (1 - 1e-9), 0.8}));
    const auto above = displacement(r, with_stretches({1.1, 1.1 * edge * (1 + 1e-9), 0.8}));
    EXPECT_LE(distance(below.tangent, above.tangent), 1e-7 * size_of(above.tangent));
    EXPECT_LE(distance(below.first_piola, above.first_piola), 1e-8 * size_of(above.tangent));
}

TEST(Ogden, TangentAtEqualStretchesIsTheDerivativeOfTheStress) {
    const auto r = rubber<Ogden>();
    constexpr Tensor H{0.4, -0.7, 0.2, 0.9, 0.3, -0.5, -0.1, 0.6, -0.8};
    for (const Vector3& l : {Vector3{1.5, 1.5, 0.5}, Vector3{1.0, 1.0, 1.0}, Vector3{2.2, 0.7, 0.7}}) {
        const Tensor at = with_stretches(l);
        const Tensor expected = contracted(displacement(r, at).tangent, H);
        const auto central = [&](double h) {
            Tensor up = at, down = at;
            for (int m = 0; m < 9; ++m) {
                up[m] += h * H[m];
                down[m] -= h * H[m];
            }
            Tensor slope = difference(displacement(r, up).first_piola, displacement(r, down).first_piola);
            for (double& s : slope) s /= 2 * h;
            return slope;
        };
        const double coarse = distance(central(2e-3), expected), fine = distance(central(1e-3), expected);
        EXPECT_NEAR(coarse / fine, 4.0, 0.05);  // error of the central difference: h^2
        EXPECT_LE(fine, 1e-5 * size_of(displacement(r, at).tangent));
    }
}

}  // namespace
}  // namespace soft::material
