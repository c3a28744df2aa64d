/// Shapes of faces: the measures on motions with known values, and their derivatives.
#include "fem/face_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace soft::fem {
namespace {

/// A strip of points in the plane z = 0, 20 by 6 mm, of uneven weights.
FaceShape strip(model::Measure measure, const Vector3& direction) {
    FaceShape shape{measure, direction, {}, {}};
    for (int i = 0; i <= 8; ++i)
        for (int j = 0; j <= 2; ++j) {
            shape.X.push_back({0.020 * i / 8, 0.006 * j / 2, 0.0});
            shape.weights.push_back(1e-6 * (1 + 0.3 * i + 0.2 * j * j));
        }
    return shape;
}

Vector3 turned(const Vector3& X, const Vector3& axis, double angle) {  // Rodrigues
    const Vector3 across = cross(axis, X);
    const double c = std::cos(angle), s = std::sin(angle), along = dot(axis, X);
    Vector3 x{};
    for (std::size_t i = 0; i < 3; ++i) x[i] = c * X[i] + s * across[i] + (1 - c) * along * axis[i];
    return x;
}

/// The strip bent about y to an arc of this curvature, not stretched; positive turns x toward -z. Then rotated and translated.
std::vector<Vector3> bent(const FaceShape& shape, double curvature, double tilt = 0) {
    std::vector<Vector3> x;
    for (const Vector3& X : shape.X) {
        const double a = curvature * X[0];
        const Vector3 arc = curvature == 0 ? X : Vector3{std::sin(a) / curvature, X[1], (std::cos(a) - 1) / curvature};
        x.push_back(turned(arc, {0, 1, 0}, tilt));
        x.back()[0] += 0.1;
        x.back()[2] -= 0.03;
    }
    return x;
}

/// x = X + smooth displacements of about `size`.
std::vector<Vector3> moved(const std::vector<Vector3>& X, double size, double phase) {
    std::vector<Vector3> x = X;
    for (std::size_t a = 0; a < x.size(); ++a)
        for (std::size_t i = 0; i < 3; ++i)
            x[a][i] += size * std::sin(phase + 0.7 * static_cast<double>(a) + 1.9 * static_cast<double>(i));
    return x;
}

TEST(Curvature, IsExactOnAnArcInAnyPosition) {
    const FaceShape shape = strip(model::Measure::curvature, {0, 1, 0});
    for (const double curvature :
         {-1000.0, -450.0, -180.0, -50.0, -1.0, 1.0, 50.0, 200.0, 700.0})  // 20 rad of bend at most
        for (const double tilt : {0.0, 1.0, 2.5, -3.0})
            EXPECT_NEAR(value_of(shape, bent(shape, curvature, tilt), nullptr), curvature, 1e-8 * std::abs(curvature))
                << tilt;
}

TEST(Curvature, OfAStraightFaceIsZero) {
    const FaceShape shape = strip(model::Measure::curvature, {0, 1, 0});
    for (const double tilt : {0.0, 1.0, 2.5}) EXPECT_NEAR(value_of(shape, bent(shape, 0, tilt), nullptr), 0.0, 1e-9);
    // The derivative also exists there: it gives the curvature of a slightly bent strip.
    std::vector<Vector3> gradient;
    const auto straight = bent(shape, 0), arc = bent(shape, 1e-2);
    (void)value_of(shape, straight, &gradient);
    double slope = 0;
    for (std::size_t a = 0; a < arc.size(); ++a)
        for (std::size_t i = 0; i < 3; ++i) slope += gradient[a][i] * (arc[a][i] - straight[a][i]);
    EXPECT_NEAR(slope, 1e-2, 1e-6);
}

TEST(Curvature, TimesTheLengthIsTheSignedBend) {
    // Bend about +y turns the normal of the end from +x toward -z (loads_test): so does this arc.
    const FaceShape shape = strip(model::Measure::curvature, {0, 1, 0});
    const auto x = bent(shape, 40);
    ASSERT_LT(x.back()[2], x.front()[2]);
    EXPECT_NEAR(value_of(shape, x, nullptr) * 0.020, 0.8, 1e-10);
}

TEST(Rotation, VectorOfARigidMotionIsItsAxisTimesItsAngle) {
    const Vector3 axis{2.0 / 3, -1.0 / 3, 2.0 / 3};
    for (const double angle : {-2.9, -0.4, 0.0, 1e-6, 0.02, 1.0, 3.1})
        for (const Vector3& d : {Vector3{1, 0, 0}, Vector3{0, 0.6, 0.8}}) {
            const FaceShape shape = strip(model::Measure::rotation, d);
            std::vector<Vector3> x;
            for (const Vector3& X : shape.X) {
                x.push_back(turned(X, axis, angle));
                x.back()[1] += 0.05;
            }
            EXPECT_NEAR(value_of(shape, x, nullptr), angle * dot(axis, d), 1e-11);
        }
}

TEST(Radial, IsTheGrowthOfARing) {
    FaceShape shape{model::Measure::radial, {1, 0, 0}, {}, {}};
    for (int i = 0; i < 12; ++i) {
        const double a = 2 * std::numbers::pi * i / 12;
        shape.X.push_back({1e-3 * i, 0.010 * std::cos(a), 0.010 * std::sin(a)});
        shape.weights.push_back(1 + 0.1 * i);
    }
    std::vector<Vector3> x;
    for (const Vector3& X : shape.X)
        x.push_back({X[0] + 0.02, 1.3 * X[2], -1.3 * X[1]});  // also rotated, which has no effect
    EXPECT_NEAR(value_of(shape, x, nullptr), 3e-3, 1e-16);
}

TEST(FaceShapes, GradientIsTheDerivative) {
    for (const auto measure : {model::Measure::radial, model::Measure::rotation, model::Measure::curvature})
        for (const double size : {0.0, 1e-3}) {  // also in the undeformed state
            const FaceShape shape = strip(measure, {0.36, 0.48, 0.8});
            const auto x = moved(bent(shape, size * 4e4), size, 0.3);
            std::vector<Vector3> gradient;
            const double value = value_of(shape, x, &gradient);
            const auto remainder = [&](double h) {
                const auto there = moved(x, h, 1.1);
                double slope = 0;
                for (std::size_t a = 0; a < x.size(); ++a)
                    for (std::size_t i = 0; i < 3; ++i) slope += gradient[a][i] * (there[a][i] - x[a][i]);
                return std::abs(value_of(shape, there, nullptr) - value - slope);
            };
            EXPECT_NEAR(remainder(5e-5) / remainder(2.5e-5), 4.0, 0.5) << model::name_of(measure) << " " << size;
        }
}

}  // namespace
}  // namespace soft::fem
