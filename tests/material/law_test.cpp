// One suite for every law: what is true of any hyperelastic law, checked against nine-variable differentiation in F.
#include "material/law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "material/response.hpp"

namespace soft::material {
namespace {

/// A law for the suite: add a line here and to `Laws` for each new one.
template <class L>
L sample_law();
template <>
NeoHookean sample_law<NeoHookean>() {
    return {0.1644e6};
}

constexpr Tensor sample_F{1.31, 0.22, -0.17, 0.11, 0.87, 0.26, -0.09, 0.31, 1.12};
constexpr double kappa_Pa = 3.0e6;

Tensor rotation() {   // about (1, 2, 2)/3 by 0.7 rad, Rodrigues
    const double c = std::cos(0.7), s = std::sin(0.7), t = 1 - c, x = 1.0 / 3, y = 2.0 / 3, z = 2.0 / 3;
    return {t * x * x + c, t * x * y - s * z, t * x * z + s * y, t * x * y + s * z, t * y * y + c,
            t * y * z - s * x, t * x * z - s * y, t * y * z + s * x, t * z * z + c};
}

/// W(F, p) with F as nine independent variables: the oracle.
template <class L>
Dual<9> energy_of_F(const Rubber<L>& rubber, const Tensor& F, double p) {
    TensorOf<Dual<9>> V;
    for (int m = 0; m < 9; ++m) V[m] = Dual<9>::variable(F[m], m);
    const auto C = right_cauchy_green(V);
    const auto I1 = trace(C);
    Dual<9> trace_C2;
    for (const auto& c : C) trace_C2 += c * c;
    return mixed_energy(rubber, p, I1, 0.5 * (I1 * I1 - trace_C2), determinant(V));
}

template <class L>
class EveryLaw : public ::testing::Test {
protected:
    static Rubber<L> rubber(VolumetricLaw volumetric = VolumetricLaw::quadratic) {
        return {sample_law<L>(), volumetric, 1.0 / kappa_Pa};
    }
    static PointResponse mixed(const Tensor& F, double p, VolumetricLaw volumetric = VolumetricLaw::quadratic) {
        PointResponse point;
        mixed_response(rubber(volumetric), F, p, Wanted::stress_and_tangent, point);
        return point;
    }
};
using Laws = ::testing::Types<NeoHookean>;
TYPED_TEST_SUITE(EveryLaw, Laws);

constexpr VolumetricLaw volumetric_laws[] = {VolumetricLaw::quadratic, VolumetricLaw::log, VolumetricLaw::mixed};

TYPED_TEST(EveryLaw, HasNoStressInTheReferenceState) {
    const auto point = this->mixed(identity_tensor, 0.0);
    for (const double P : point.first_piola) EXPECT_NEAR(P / 0.1644e6, 0.0, 1e-14);
}

TYPED_TEST(EveryLaw, StressIsTheDerivativeOfTheEnergy) {
    for (const auto volumetric : volumetric_laws) {
        const auto point = this->mixed(sample_F, 4.2e4, volumetric);
        const auto oracle = energy_of_F(this->rubber(volumetric), sample_F, 4.2e4);
        for (int m = 0; m < 9; ++m) EXPECT_NEAR(point.first_piola[m], oracle.g[m], 1e-12 * 0.1644e6);
    }
}

TYPED_TEST(EveryLaw, TangentIsTheDerivativeOfTheStressAndSymmetric) {
    for (const auto volumetric : volumetric_laws) {
        const auto point = this->mixed(sample_F, 4.2e4, volumetric);
        const auto oracle = energy_of_F(this->rubber(volumetric), sample_F, 4.2e4);
        for (int m = 0; m < 9; ++m)
            for (int n = 0; n < 9; ++n) {
                EXPECT_NEAR(point.tangent[9 * m + n], oracle.hessian(m, n), 1e-11 * 0.1644e6);
                EXPECT_NEAR(point.tangent[9 * m + n], point.tangent[9 * n + m], 1e-11 * 0.1644e6);
            }
    }
}

TYPED_TEST(EveryLaw, IsFrameIndifferent) {   // P(Q F) = Q P(F)
    const Tensor Q = rotation();
    const auto rotated = this->mixed(multiply(Q, sample_F), 4.2e4);
    const auto expected = multiply(Q, this->mixed(sample_F, 4.2e4).first_piola);
    for (int m = 0; m < 9; ++m) EXPECT_NEAR(rotated.first_piola[m], expected[m], 1e-11 * 0.1644e6);
}

TYPED_TEST(EveryLaw, IsIsotropic) {   // P(F Q) = P(F) Q
    const Tensor Q = rotation();
    const auto rotated = this->mixed(multiply(sample_F, Q), 4.2e4);
    const auto expected = multiply(this->mixed(sample_F, 4.2e4).first_piola, Q);
    for (int m = 0; m < 9; ++m) EXPECT_NEAR(rotated.first_piola[m], expected[m], 1e-11 * 0.1644e6);
}

TYPED_TEST(EveryLaw, StartsWithItsStatedShearModulus) {   // dP_12/dF_12 at F = I for simple shear
    const auto point = this->mixed(identity_tensor, 0.0);
    const double mu = sample_law<TypeParam>().initial_shear_modulus_Pa();
    EXPECT_NEAR(point.tangent[9 * 1 + 1], mu, 1e-12 * mu);
}

TYPED_TEST(EveryLaw, DisplacementFormIsTheMixedFormWithThePressureEliminated) {   // p = kappa Theta(J)
    for (const auto volumetric : volumetric_laws) {
        const auto rubber = this->rubber(volumetric);
        PointResponse point;
        displacement_response(rubber, sample_F, Wanted::stress_and_tangent, point);
        const double p = kappa_Pa * theta(volumetric, determinant(sample_F));
        const auto mixed = this->mixed(sample_F, p, volumetric);
        for (int m = 0; m < 9; ++m)
            EXPECT_NEAR(point.first_piola[m], mixed.first_piola[m], 1e-12 * kappa_Pa);
        for (int m = 0; m < 9; ++m)
            for (int n = 0; n < 9; ++n)
                EXPECT_NEAR(point.tangent[9 * m + n],
                            mixed.tangent[9 * m + n] + kappa_Pa * mixed.dtheta_dF[m] * mixed.dtheta_dF[n],
                            1e-11 * kappa_Pa);
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
    // The series near J = 1 joins the closed form, with its derivatives.
    for (const double edge : {1.0 - 2e-3, 1.0 + 2e-3}) {
        const auto inside = theta(VolumetricLaw::mixed, Dual<1>::variable(edge + (edge < 1 ? 1e-9 : -1e-9), 0));
        const auto outside = theta(VolumetricLaw::mixed, Dual<1>::variable(edge + (edge < 1 ? -1e-9 : 1e-9), 0));
        EXPECT_NEAR(inside.v, outside.v, 3e-9);
        EXPECT_NEAR(inside.g[0], outside.g[0], 1e-8);
        EXPECT_NEAR(inside.h[0], outside.h[0], 1e-6);
    }
}

// Uniaxial, incompressible: sigma = mu (l^2 - 1/l). Treloar, The Physics of Rubber Elasticity (1975) 4.3.
TEST(NeoHookean, UniaxialStressIsTheClosedForm) {
    const Rubber<NeoHookean> rubber{{0.2069e6}, VolumetricLaw::quadratic, 0.0};
    for (const double l : {0.5, 1.5, 6.034}) {
        const double across = 1.0 / std::sqrt(l);
        PointResponse point;
        mixed_response(rubber, {l, 0, 0, 0, across, 0, 0, 0, across}, 0.0, Wanted::stress, point);
        // Cauchy stresses sigma_i = P_i l_i (J = 1); the pressure makes the lateral one vanish.
        const double sigma = point.first_piola[0] * l - point.first_piola[4] * across;
        EXPECT_NEAR(sigma, 0.2069e6 * (l * l - 1 / l), 1e-10 * 0.2069e6 * l * l);
        EXPECT_NEAR(point.theta, 0.0, 1e-14);
    }
}

}  // namespace
}  // namespace soft::material
