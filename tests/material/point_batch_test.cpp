// Batch evaluation compared with point-by-point evaluation by mixed_response and displacement_response, which derivative_test compares
// with differentiation by F.
#include <gtest/gtest.h>

#include "law_types.hpp"
#include "material/point_batch.hpp"
#include "samples.hpp"

namespace soft::material {
namespace {

using namespace sample;

template <class L>
class Batches : public ::testing::Test {};
TYPED_TEST_SUITE(Batches, EveryLawType);

/// Five points: one more than a vector has lanes, so that some lanes are unused. The first point is undeformed.
Tensor state(int q) {
    Tensor at = identity_tensor;
    for (std::size_t m = 0; m < 9; ++m) at[m] += 0.25 * q * (F[m] - identity_tensor[m]);
    return at;
}

template <class L>
PointBatch batch_of_states() {
    PointBatch batch(5);
    for (int q = 0; q < 5; ++q) {
        batch.set_gradient(q, state(q));
        batch.p[q] = 1e4 * q;
        batch.axes[q] = {{0.6, 0.8, 0}, {-0.8, 0.6, 0}};
    }
    return batch;
}

void expect_same(const PointResponse& expected, const PointResponse& found) {
    const double scale = size_of(expected.tangent);
    EXPECT_LE(distance(found.first_piola, expected.first_piola), 1e-14 * scale);
    EXPECT_LE(distance(found.tangent, expected.tangent), 1e-14 * scale);
}

TYPED_TEST(Batches, EqualPointwiseEvaluationInDisplacementForm) {
    const auto r = rubber<TypeParam>(VolumetricLaw::mixed);
    auto batch = batch_of_states<TypeParam>();
    evaluate_batch(r, Form::displacement, Wanted::stress_and_tangent, batch);
    for (int q = 0; q < 5; ++q) expect_same(displacement(r, state(q), batch.axes[q]), batch.response(q));
}

TYPED_TEST(Batches, EqualPointwiseEvaluationInMixedForm) {
    const auto r = rubber<TypeParam>(VolumetricLaw::log);
    auto batch = batch_of_states<TypeParam>();
    if constexpr (StressLaw<TypeParam>) {
        EXPECT_THROW(evaluate_batch(r, Form::mixed, Wanted::stress, batch), std::logic_error);
    } else {
        evaluate_batch(r, Form::mixed, Wanted::stress_and_tangent, batch);
        for (int q = 0; q < 5; ++q) {
            const PointResponse expected = mixed(r, state(q), batch.p[q], batch.axes[q]);
            expect_same(expected, batch.response(q));
            EXPECT_NEAR(batch.theta[q], expected.theta, 1e-15);
            EXPECT_LE(distance(batch.response(q).dtheta_dF, expected.dtheta_dF), 1e-14);
        }
    }
}

TYPED_TEST(Batches, EqualPointwiseEvaluationWithFibres) {
    if constexpr (MayHaveFibers<TypeParam>) {
        const auto r = fibered<TypeParam>();
        auto batch = batch_of_states<TypeParam>();
        evaluate_batch(r, Form::mixed, Wanted::stress_and_tangent, batch);
        for (int q = 0; q < 5; ++q) expect_same(mixed(r, state(q), batch.p[q], batch.axes[q]), batch.response(q));
    }
}

TYPED_TEST(Batches, StressDoesNotDependOnWhetherTheTangentIsComputed) {
    const auto r = rubber<TypeParam>(VolumetricLaw::quadratic);
    auto with_tangent = batch_of_states<TypeParam>(), alone = batch_of_states<TypeParam>();
    evaluate_batch(r, Form::displacement, Wanted::stress_and_tangent, with_tangent);
    evaluate_batch(r, Form::displacement, Wanted::stress, alone);
    EXPECT_EQ(with_tangent.first_piola, alone.first_piola);
}

}  // namespace
}  // namespace soft::material
