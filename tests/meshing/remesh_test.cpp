#include "meshing/remesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/error.hpp"
#include "meshing/named_faces.hpp"
#include "soups.hpp"
#include "surface/facet_map.hpp"
#include "surface/near.hpp"

namespace soft::meshing {
namespace {

constexpr std::size_t plenty = 100000;

Remeshed remeshed(const BodySurface& surface, double size_m, std::size_t max_points = plenty) {
    return remesh(
        surface, creases_of(surface, named_faces(surface, {})), [=](const mesh::Point&) { return size_m; },
        {"part.stl"}, max_points);
}

double volume_m3(const Remeshed& surface) {
    BodySurface plain;
    plain.points = surface.points;
    plain.triangles = surface.triangles;
    return plain.volume_m3();
}

std::vector<double> edge_lengths_m(const Remeshed& surface) {
    std::vector<double> lengths;
    for (const auto& t : surface.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            lengths.push_back(norm(along(surface.points[static_cast<std::size_t>(t[k])], -1,
                                         surface.points[static_cast<std::size_t>(t[(k + 1) % 3])])));
    std::ranges::sort(lengths);
    return lengths;
}

TEST(Remesh, PreservesVolumeEdgesAndCornersOfACube) {
    const BodySurface cube = test::made(test::box_soup({0, 0, 0}, {10, 10, 10}));
    const Remeshed result = remeshed(cube, 2e-3);
    EXPECT_NEAR(volume_m3(result), 1e-6, 1e-15);
    double creases_m = 0;
    for (const auto& [a, b] : result.creases)
        creases_m +=
            norm(along(result.points[static_cast<std::size_t>(a)], -1, result.points[static_cast<std::size_t>(b)]));
    EXPECT_NEAR(creases_m, 0.12, 1e-12);  // twelve edges
    for (const mesh::Point& corner : cube.points)
        EXPECT_NE(std::ranges::find(result.points, corner), result.points.end());
    const std::vector<double> lengths = edge_lengths_m(result);
    EXPECT_GT(lengths.front(), 0.8e-3);
    EXPECT_LT(lengths.back(), 2.7e-3);  // edges longer than 4/3 of the size are split
    EXPECT_NEAR(lengths[lengths.size() / 2], 2e-3, 0.3e-3);
}

TEST(Remesh, PointsStayOnTheFacetsOfABallAndTheSurfaceStaysClosed) {
    const BodySurface ball = test::made(test::ball_soup({0, 0, 0}, 10, 64));
    const Remeshed result = remeshed(ball, 3e-3);
    const surface::NearestOnTriangles file(ball.points, ball.triangles);
    for (const mesh::Point& p : result.points) EXPECT_LT(file(p).distance_m, 1e-12);
    EXPECT_NEAR(volume_m3(result) / ball.volume_m3(), 1, 0.03);  // chords of h = 0.3 R: h^2 / (8 R) at most inside
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : result.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    for (const auto& [edge, uses] : edges) {
        EXPECT_EQ(uses, 1);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
    EXPECT_LT(result.triangles.size(), ball.triangles.size() / 3);
}

/// The requested size is three times the radius, so the deviation limits the edge length.
TEST(Remesh, NoTriangleDeviatesByMoreThanATwentiethOfItsSize) {
    const BodySurface ball = test::made(test::ball_soup({0, 0, 0}, 1, 48));  // radius 1 mm, requested size 3 mm
    const Remeshed result = remeshed(ball, 3e-3);
    const surface::NearestOnTriangles file(ball.points, ball.triangles);
    for (const auto& t : result.triangles) {
        mesh::Point centre{};
        for (const int corner : t)
            for (std::size_t d = 0; d < 3; ++d) centre[d] += result.points[static_cast<std::size_t>(corner)][d] / 3;
        EXPECT_LT(file(centre).distance_m, 0.05 * 3e-3 * 1.01);
    }
}

TEST(Remesh, EdgeLengthsFollowTheSizeField) {
    const BodySurface bar = test::made(test::box_soup({0, 0, 0}, {40, 5, 5}));
    const Remeshed result = remesh(
        bar, creases_of(bar, named_faces(bar, {})), [](const mesh::Point& p) { return 0.5e-3 + 0.05 * p[0]; },
        {"bar.stl"}, plenty);
    EXPECT_NEAR(volume_m3(result), 1e-6, 1e-15);
    for (const auto& t : result.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const mesh::Point &a = result.points[static_cast<std::size_t>(t[k])],
                              &b = result.points[static_cast<std::size_t>(t[(k + 1) % 3])];
            EXPECT_LT(norm(along(a, -1, b)), 1.4 * (0.5e-3 + 0.05 * std::max(a[0], b[0])));
        }
}

TEST(Remesh, MorePointsThanAllowedAreRefused) {
    const BodySurface cube = test::made(test::box_soup({0, 0, 0}, {10, 10, 10}));
    try {
        static_cast<void>(remeshed(cube, 1e-5, 1000));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_STREQ(error.what(),
                     "part.stl: cells of this size need more than 1000 points on the surface; use a larger mesh.size");
    }
}

TEST(NearestOnTriangles, TheBoundedSearchAgreesWithTheUnboundedSearchWithinItsBound) {
    const BodySurface ball = test::made(test::ball_soup({0, 0, 0}, 10, 24));
    const surface::NearestOnTriangles nearest(ball.points, ball.triangles);
    for (int k = 0; k < 200; ++k) {
        const double a = 0.1 * k, r = 8e-3 + 2e-5 * k;
        const mesh::Point p{r * std::cos(a), r * std::sin(a) * std::cos(3 * a), r * std::sin(a) * std::sin(3 * a)};
        const auto location = nearest(p);
        const auto within = nearest.within(p, 1e-3);
        EXPECT_EQ(within.has_value(), location.distance_m < 1e-3);
        if (within) {
            EXPECT_NEAR(within->distance_m, location.distance_m, 1e-15);
        }
    }
}

}  // namespace
}  // namespace soft::meshing
