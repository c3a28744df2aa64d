#include "contact/distance.hpp"

#include <gtest/gtest.h>

#include "contact/barrier.hpp"

namespace soft::contact {
namespace {

using mesh::Point;

TEST(Barrier, HasTwoContinuousDerivativesAndRepels) {
    constexpr double h = 0.3, step = 1e-6;
    for (const auto part : {Nearness::closest, Nearness::other})
        for (const double d : {-0.7, -0.4, -0.05, 0.01, 0.1, 0.25}) {
            const Barrier at = barrier(d, h, part), before = barrier(d - step, h, part),
                          after = barrier(d + step, h, part);
            EXPECT_NEAR((after.value_m - before.value_m) / (2 * step), at.slope, 1e-6 * std::abs(at.slope));
            EXPECT_NEAR((after.slope - before.slope) / (2 * step), at.curvature_1_m, 1e-6 * at.curvature_1_m);
            EXPECT_LT(at.slope, 0);
        }
    for (const double d : {-1.5 * h, 0.0, 0.2 * h})  // where its parts meet
        EXPECT_NEAR(barrier(d - 1e-9, h).curvature_1_m, barrier(d + 1e-9, h).curvature_1_m,
                    1e-6 * barrier(d, h).curvature_1_m);
    // The pressures of the header.
    EXPECT_NEAR(-barrier(0, h).slope, 12.8, 0.05);
    EXPECT_NEAR(-barrier(-0.5 * h, h).slope, 380, 1);
    EXPECT_NEAR(-barrier(-h, h).slope, 5200, 5);
    EXPECT_NEAR(barrier(h * (1 - 1e-8), h).curvature_1_m, 0, 1e-6);
    EXPECT_EQ(barrier(h, h).value_m, 0);
}

TEST(Distance, DerivativesAreExact) {
    const model::Plane plane{{1, 2, 3}, {0.6, 0, 0.8}};
    const model::Cylinder cylinder{{0.5, 0, 1}, {0, 0.6, 0.8}, 0.7, model::Side::inside};
    const model::Sphere sphere{{0.1, 0.2, 0.3}, 0.4};
    const auto check = [](const auto& shape, const Point& x = {0.9, -0.4, 0.7}) {
        const Distance at = distance(shape, x);
        constexpr double step = 1e-5;
        for (std::size_t i = 0; i < 3; ++i) {
            Point low = x, high = x;
            low[i] -= step;
            high[i] += step;
            const Distance before = distance(shape, low), after = distance(shape, high);
            EXPECT_NEAR((after.value_m - before.value_m) / (2 * step), at.gradient[i], 1e-8);
            for (std::size_t j = 0; j < 3; ++j)
                EXPECT_NEAR((after.gradient[j] - before.gradient[j]) / (2 * step), at.hessian[i][j], 1e-8);
        }
        EXPECT_NEAR(norm(at.gradient), 1, 1e-12);
    };
    check(plane);
    check(cylinder);
    check(sphere);
    const model::Box box{{-1, 0, 1}, {1, 2, 4}, 0.2};
    for (const Point& x :
         {Point{0.3, -0.4, 2}, {1.3, 0.9, 3}, {1.1, -0.1, 2}, {-1.2, 2.1, 3}, {1.4, 2.3, 4.2}, {0.3, 0.1, 2}})
        check(box, x);
    EXPECT_NEAR(distance(box, Point{0.3, -0.4, 2}).value_m, 0.4, 1e-12);
    EXPECT_NEAR(distance(box, Point{0.3, 0.1, 2}).value_m, -0.1, 1e-12);
    EXPECT_NEAR(distance(box, Point{0.8 + 0.3, 0.2 - 0.4, 2}).value_m, 0.3, 1e-12);
    EXPECT_NEAR(distance(box, Point{0.8 + 0.2, 1.8 + 0.3, 3.8 + 0.6}).value_m, 0.5, 1e-12);
    EXPECT_NEAR(distance(cylinder, Point{0.5, 0, 1}).value_m, 0.7, 1e-12);
    EXPECT_NEAR(distance(sphere, Point{0.1, 0.2, 1.3}).value_m, 0.6, 1e-12);
}

}  // namespace
}  // namespace soft::contact
