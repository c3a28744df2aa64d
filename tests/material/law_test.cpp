// Properties that every law must have.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "law_types.hpp"
#include "material/response.hpp"
#include "samples.hpp"

namespace soft::material {
namespace {

using namespace sample;

template <class L>
class EveryLaw : public ::testing::Test {
protected:
    static constexpr bool linear = std::same_as<L, LinearElastic>;
    static constexpr bool stress_law = StressLaw<L>;
    static double bulk() { return 1.0 / rubber<L>().inverse_bulk_modulus; }
};
TYPED_TEST_SUITE(EveryLaw, EveryLawType);

TYPED_TEST(EveryLaw, HasNoStressInTheReferenceState) {
    for (const auto volumetric : volumetric_laws) {
        Tensor expected{};
        if constexpr (TestFixture::stress_law)  // kraken's formula at B = I, J = 1
            for (int i = 0; i < 3; ++i) expected[4 * i] = mu_Pa;
        const auto r = rubber<TypeParam>(volumetric);
        EXPECT_LE(distance(displacement(r, identity_tensor).first_piola, expected), 1e-13 * mu_Pa);
        if constexpr (!TestFixture::stress_law) {
            EXPECT_LE(size_of(mixed(r, identity_tensor, 0.0).first_piola), 1e-13 * mu_Pa);
        }
    }
}

TYPED_TEST(EveryLaw, IsFrameIndifferent) {  // P(Q F) = Q P(F)
    if constexpr (!TestFixture::linear)
        for (const auto volumetric : volumetric_laws) {
            const auto r = rubber<TypeParam>(volumetric);
            const Tensor Q = rotation(0.7);
            const auto turned = displacement(r, multiply(Q, F));
            const auto expected = multiply(Q, displacement(r, F).first_piola);
            EXPECT_LE(distance(turned.first_piola, expected), 1e-12 * size_of(expected));
        }
}

TYPED_TEST(EveryLaw, IsIsotropicWithoutFibres) {  // P(F Q) = P(F) Q
    if constexpr (!TestFixture::linear && !FiberLaw<TypeParam>)
        for (const auto volumetric : volumetric_laws) {
            const auto r = rubber<TypeParam>(volumetric);
            const Tensor Q = rotation(0.7);
            const auto turned = displacement(r, multiply(F, Q));
            const auto expected = multiply(displacement(r, F).first_piola, Q);
            EXPECT_LE(distance(turned.first_piola, expected), 1e-12 * size_of(expected));
        }
}

/// |P(F + h H) - P(F) - h A : H|
template <class L>
double remainder(const Rubber<L>& r, const PointResponse& at, const Tensor& H, double h) {
    Tensor moved = F;
    for (int m = 0; m < 9; ++m) moved[m] += h * H[m];
    const Tensor step = contracted(at.tangent, H);
    Tensor rest = displacement(r, moved).first_piola;
    for (int m = 0; m < 9; ++m) rest[m] -= at.first_piola[m] + h * step[m];
    return std::sqrt(std::inner_product(rest.begin(), rest.end(), rest.begin(), 0.0));
}

TYPED_TEST(EveryLaw, TangentHasASecondOrderTaylorRemainder) {
    constexpr Tensor H{0.4, -0.7, 0.2, 0.9, 0.3, -0.5, -0.1, 0.6, -0.8};
    for (const auto volumetric : volumetric_laws) {
        const auto r = rubber<TypeParam>(volumetric);
        const auto at = displacement(r, F);
        if constexpr (TestFixture::linear) {
            EXPECT_LE(remainder(r, at, H, 1e-2), 1e-13 * kappa_Pa);
        } else {
            double last = remainder(r, at, H, 2e-3);
            for (const double h : {1e-3, 5e-4, 2.5e-4}) {
                const double now = remainder(r, at, H, h);
                EXPECT_NEAR(last / now, 4.0, 0.03);
                last = now;
            }
        }
    }
}

TYPED_TEST(EveryLaw, TangentIsSymmetricIfThereIsAnEnergy) {
    // kraken: P = kappa (J - 1) cof F + mu J F has the asymmetric part mu (F (x) cof F - cof F (x) F)/2, as d(J F) =
    // F (x) cof F + J d F and the other terms are symmetric.
    const auto r = rubber<TypeParam>();
    const Tensor cof = cofactor(F);
    const auto A = displacement(r, F).tangent;
    EXPECT_EQ(has_symmetric_tangent(AnyRubber{r}), !TestFixture::stress_law);
    for (int m = 0; m < 9; ++m)
        for (int n = 0; n < 9; ++n) {
            const double expected = TestFixture::stress_law ? mu_Pa * (F[m] * cof[n] - cof[m] * F[n]) : 0.0;
            EXPECT_NEAR(A[9 * m + n] - A[9 * n + m], expected, 1e-13 * size_of(A));
        }
}

TYPED_TEST(EveryLaw, HasTheStatedInitialModuli) {
    for (const auto volumetric : volumetric_laws) {
        const auto r = rubber<TypeParam>(volumetric);
        const auto A = displacement(r, identity_tensor).tangent;
        // Simple shear F = I + g e1 e2: dP_12/dg. Equal stretches F = l I: dP_11/dl = 3 kappa, a ninth of the sum of
        // A_iikk each; kraken: P_11 = kappa (l^3 - 1) l^2 + mu l^4 with the slope 3 kappa + 4 mu.
        double bulk = 0;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) bulk += A[9 * 4 * i + 4 * k] / 9.0;
        EXPECT_NEAR(A[9 * 1 + 1], r.law.initial_shear_modulus_Pa(), 1e-12 * kappa_Pa);
        EXPECT_NEAR(bulk, kappa_Pa + (TestFixture::stress_law ? 4.0 / 3.0 * mu_Pa : 0.0), 1e-12 * kappa_Pa);
    }
}

TYPED_TEST(EveryLaw, DisplacementFormIsTheMixedFormWithThePressureEliminated) {  // p = K Theta
    if constexpr (!TestFixture::stress_law)
        for (const auto volumetric : volumetric_laws) {
            const auto r = rubber<TypeParam>(volumetric);
            const double K = this->bulk(), p = K * energy_parts(r, {}, F)->dilatation;
            const auto one = displacement(r, F), two = mixed(r, F, p);
            EXPECT_NEAR(two.theta, p / K, 1e-15);
            EXPECT_LE(distance(one.first_piola, two.first_piola), 1e-13 * kappa_Pa);
            Tangent expected = two.tangent;
            for (int m = 0; m < 9; ++m)
                for (int n = 0; n < 9; ++n) expected[9 * m + n] += K * two.dtheta_dF[m] * two.dtheta_dF[n];
            EXPECT_LE(distance(one.tangent, expected), 1e-12 * kappa_Pa);
        }
    else
        EXPECT_THROW(static_cast<void>(mixed(rubber<TypeParam>(), F, 0.0)), std::logic_error);
}

TYPED_TEST(EveryLaw, StressDoesNotDependOnWhetherTheTangentIsComputed) {
    const auto r = rubber<TypeParam>();
    PointResponse alone;
    displacement_response(r, {}, F, Wanted::stress, alone);
    EXPECT_EQ(alone.first_piola, displacement(r, F).first_piola);
    EXPECT_DOUBLE_EQ(alone.jacobian, determinant(F));
}

TEST(LinearElastic, HasAnErrorOfSecondOrderInTheRotationAngle) {
    // R = I + sin a W + (1 - cos a) W^2 with W the cross product of the axis n, so e = (cos a - 1)(I - n n): tr e =
    // -2 (1 - cos a), of order a^2. P from the formula in the header.
    const auto r = rubber<LinearElastic>();
    const Vector3 n{1.0 / 3, 2.0 / 3, 2.0 / 3};
    for (const double angle : {1e-3, 1e-2, 0.1, 0.5}) {
        const double c = 1 - std::cos(angle);
        const auto P = displacement(r, rotation(angle)).first_piola;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const double e = -c * ((i == j ? 1.0 : 0.0) - n[i] * n[j]);
                const double expected = 2 * mu_Pa * (e + (i == j ? 2 * c / 3 : 0)) - (i == j ? kappa_Pa * 2 * c : 0);
                EXPECT_NEAR(P[3 * i + j], expected, 1e-14 * kappa_Pa);
            }
        EXPECT_NEAR(size_of(P) / (kappa_Pa * angle * angle), 1.0, 0.1);
    }
}

TEST(Theta, MatchesItsDefinitionAndIsSmoothThroughTheReferenceVolume) {
    for (const double J : {0.5, 0.9, 0.99, 1.01, 1.2, 2.0}) {
        EXPECT_DOUBLE_EQ(theta(VolumetricLaw::quadratic, J), J - 1);
        EXPECT_DOUBLE_EQ(theta(VolumetricLaw::log, J), std::log(J));
        const double t = theta(VolumetricLaw::mixed, J);
        EXPECT_NEAR(t * t, (J * J - 1 - 2 * std::log(J)) / 2, 1e-15);
        EXPECT_EQ(t > 0, J > 1);
    }
    // The series near J = 1 and its derivatives agree with the closed form.
    for (const double edge : {1.0 - 2e-3, 1.0 + 2e-3}) {
        const auto inside = theta(VolumetricLaw::mixed, Dual<1>::variable(edge + (edge < 1 ? 1e-9 : -1e-9), 0));
        const auto outside = theta(VolumetricLaw::mixed, Dual<1>::variable(edge + (edge < 1 ? -1e-9 : 1e-9), 0));
        EXPECT_NEAR(inside.v, outside.v, 3e-9);
        EXPECT_NEAR(inside.g[0], outside.g[0], 1e-8);
        EXPECT_NEAR(inside.h[0], outside.h[0], 1e-6);
    }
}

TEST(Gent, IsUndefinedBeyondTheLockingStretch) {
    const auto r = rubber<Gent>();  // I1 - 3 = l^2 + 2/l - 3 = 12 at l = 3.797
    for (const double l : {3.7, 3.9, 6.0}) {
        const double t = 1 / std::sqrt(l);
        const auto point = displacement(r, {l, 0, 0, 0, t, 0, 0, 0, t});
        EXPECT_EQ(std::isfinite(point.first_piola[0]), l < 3.797) << l;
        EXPECT_EQ(std::isfinite(point.tangent[0]), l < 3.797) << l;
        EXPECT_EQ(std::isfinite(energy_parts(r, {}, {l, 0, 0, 0, t, 0, 0, 0, t})->shear), l < 3.797) << l;
    }
}

}  // namespace
}  // namespace soft::material
