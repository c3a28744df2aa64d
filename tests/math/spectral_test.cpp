#include "math/spectral.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soft {
namespace {

/// Rotation about (1, 2, 2)/3 by 0.7 rad, Rodrigues.
Tensor rotation() {
    const double c = std::cos(0.7), s = std::sin(0.7), t = 1 - c, x = 1.0 / 3, y = 2.0 / 3, z = 2.0 / 3;
    return {t * x * x + c,     t * x * y - s * z, t * x * z + s * y, t * x * y + s * z, t * y * y + c,
            t * y * z - s * x, t * x * z - s * y, t * y * z + s * x, t * z * z + c};
}

/// Q diag(values) Q^T, symmetric to the last bit.
Tensor with_values(const Vector3& values) {
    const Tensor Q = rotation();
    Tensor S{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int a = 0; a < 3; ++a)
                S[3 * std::min(i, j) + std::max(i, j)] += i <= j ? values[a] * Q[3 * i + a] * Q[3 * j + a] : 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j) S[3 * i + j] = S[3 * j + i];
    return S;
}

void expect_spectral_form(const Tensor& S, double size) {
    const Spectral form = spectral_form(S);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            double back = 0, product = 0;
            for (int a = 0; a < 3; ++a) {
                back += form.value[a] * form.vector[3 * i + a] * form.vector[3 * j + a];
                product += form.vector[3 * a + i] * form.vector[3 * a + j];
            }
            EXPECT_NEAR(back, S[3 * i + j], 4e-15 * size);
            EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 2e-15);
        }
}

TEST(SpectralForm, ReconstructsTheTensorWithOrthonormalVectors) {
    expect_spectral_form(with_values({9.0, 4.0, 0.25}), 9.0);
    expect_spectral_form({2, -1, 0, -1, 2, -1, 0, -1, 2}, 4.0);
    expect_spectral_form({1, 1e-9, 0, 1e-9, 1, 0, 0, 0, 1}, 1.0);
    expect_spectral_form(Tensor{}, 1.0);
}

TEST(SpectralForm, ValuesAreAccurateForNearlyEqualEigenvalues) {
    for (const double apart : {0.3, 1e-3, 1e-6, 1e-9, 1e-12, 0.0}) {
        const Vector3 values{1.7, 1.7 * (1 + apart), 0.4};
        auto found = spectral_form(with_values(values)).value;
        std::ranges::sort(found);
        EXPECT_NEAR(found[0], 0.4, 2e-15);
        EXPECT_NEAR(found[1], values[0], 2e-15);
        EXPECT_NEAR(found[2], values[1], 2e-15);
        expect_spectral_form(with_values(values), 2.0);
    }
}

TEST(SpectralForm, DiagonalTensorIsReturnedUnchanged) {
    const Spectral form = spectral_form({4.0, 0, 0, 0, 9.0, 0, 0, 0, 4.0});
    EXPECT_EQ(form.value, (Vector3{4.0, 9.0, 4.0}));
    EXPECT_EQ(form.vector, identity_tensor);
}

}  // namespace
}  // namespace soft
