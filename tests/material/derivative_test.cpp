// Stress and tangent of every law, compared with differentiation by the nine components of F.
#include <gtest/gtest.h>

#include "law_types.hpp"
#include "oracle.hpp"

namespace soft::material {
namespace {

using namespace sample;

template <class L>
class Derivatives : public ::testing::Test {};
TYPED_TEST_SUITE(Derivatives, EveryLawType);

/// A compressed, sheared and rotated state; F of the samples; a large stretch.
constexpr std::array<Tensor, 3> states{F, Tensor{0.62, -0.31, 0.05, 0.24, 0.81, -0.12, 0.33, 0.07, 1.44},
                                       Tensor{2.1, 0.4, -0.3, -0.6, 0.7, 0.1, 0.2, 0.15, 0.64}};

void expect_near(const PointResponse& point, const Tensor& P, const Tangent& A) {
    EXPECT_LE(distance(point.first_piola, P), 2e-13 * size_of(A));
    EXPECT_LE(distance(point.tangent, A), 2e-12 * size_of(A));
}

/// Compares stress and tangent with the derivatives of the energy.
template <class L>
void expect_derivatives_of_the_energy(const Rubber<L>& r, const Tensor& at) {
    Tensor P;
    Tangent A;
    const Number W = energy_of(r, at);
    for (int m = 0; m < 9; ++m) {
        P[m] = W.g[m];
        for (int n = 0; n < 9; ++n) A[9 * m + n] = W.hessian(m, n);
    }
    const auto parts = energy_parts(r, {}, at);
    const double K = 1.0 / r.inverse_bulk_modulus;
    EXPECT_NEAR(parts->shear + 0.5 * K * parts->dilatation * parts->dilatation, W.v, 1e-13 * size_of(A));
    expect_near(displacement(r, at), P, A);
}

TYPED_TEST(Derivatives, StressAndTangentAreDerivativesOfTheEnergyByF) {
    for (const auto volumetric : volumetric_laws)
        for (const Tensor& at : states) {
            const auto r = rubber<TypeParam>(volumetric);
            if constexpr (StressLaw<TypeParam>) {
                Tensor P;
                Tangent A;
                const auto stress = kraken_stress(kappa_Pa, at);
                for (int m = 0; m < 9; ++m) {
                    P[m] = stress[m].v;
                    for (int n = 0; n < 9; ++n) A[9 * m + n] = stress[m].g[n];
                }
                expect_near(displacement(r, at), P, A);
            } else {
                expect_derivatives_of_the_energy(r, at);
            }
        }
}

TYPED_TEST(Derivatives, StressAndTangentWithFibresAreDerivativesOfTheEnergyByF) {
    if constexpr (MayHaveFibers<TypeParam>)
        for (const Tensor& at : states) expect_derivatives_of_the_energy(fibered<TypeParam>(VolumetricLaw::log), at);
}

TYPED_TEST(Derivatives, DilatationIsTheDerivativeOfTheEnergyByThePressure) {
    // W(F, p) is linear in p except for p^2/(2 K): P(p) - P(0) = p dTheta/dF, and dTheta/dF is the derivative of Theta.
    if constexpr (!StressLaw<TypeParam>)
        for (const auto volumetric : volumetric_laws) {
            const auto r = rubber<TypeParam>(volumetric);
            const double p = 4.2e4;
            const auto loaded = mixed(r, F, p), free = mixed(r, F, 0.0);
            constexpr double h = 1e-4;
            for (int m = 0; m < 9; ++m) {
                EXPECT_NEAR(loaded.first_piola[m] - free.first_piola[m], p * free.dtheta_dF[m], 1e-12 * kappa_Pa);
                const auto moved = [&](double factor) {
                    Tensor G = F;
                    G[m] += factor * h;
                    return mixed(r, G, p).theta;
                };
                const double slope = (8 * (moved(1) - moved(-1)) - (moved(2) - moved(-2))) / (12 * h);  // order h^4
                EXPECT_NEAR(loaded.dtheta_dF[m], slope, 1e-10);
            }
        }
}

}  // namespace
}  // namespace soft::material
