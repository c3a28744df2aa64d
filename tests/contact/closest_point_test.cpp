#include "contact/closest_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>

#include "mesh/shape.hpp"

namespace soft::contact {
namespace {

using mesh::CellType;
using mesh::Point;

/// A facet of the size of its reference cell, bent out of its plane by up to `bend`.
Patch curved_patch(CellType type, double bend, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-bend, bend);
    surface::FacetMap map{type, {}};
    const auto& topology = mesh::topology(type);
    for (std::size_t a = 0; a < static_cast<std::size_t>(topology.node_count); ++a) {
        const bool line = mesh::dimension(type) == 1;
        map.nodes[a] = {topology.nodes[a][0], line ? uniform(random) : topology.nodes[a][1],
                        line ? 0 : uniform(random)};
    }
    return make_patch(map);
}

/// The smallest distance from points on a fine grid of the facet.
double sampled_distance(const Patch& patch, const Point& x) {
    constexpr int n = 200;
    const mesh::Shape shape = mesh::topology(patch.type).shape;
    const bool unit = shape == mesh::Shape::triangle;
    double least = 1e9;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= (patch.is_line() ? 0 : n); ++j) {
            surface::FacetPoint xi{unit ? 1.0 * i / n : 2.0 * i / n - 1, unit ? 1.0 * j / n : 2.0 * j / n - 1};
            if (patch.is_line()) xi[1] = 0;
            if (surface::is_inside(shape, xi, 1e-12)) least = std::min(least, norm(difference(x, patch(xi).x)));
        }
    return least;
}

class ClosestPointOf : public testing::TestWithParam<CellType> {};

TEST_P(ClosestPointOf, IsNoFartherThanAnyPointOfTheFacet) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.5, 1.5), near(-0.3, 0.3);
    for (int trial = 0; trial < 40; ++trial) {
        const Patch patch = curved_patch(GetParam(), 0.1, random);
        const bool line = patch.is_line();
        const Point x{uniform(random), line ? near(random) : uniform(random), line ? 0 : near(random)};
        const ClosestPoint closest = closest_point(patch, x);
        const double sampled = sampled_distance(patch, x);
        EXPECT_LE(closest.distance_m, sampled + 1e-12);
        EXPECT_GE(closest.distance_m, sampled - 0.02);  // of the grid
        EXPECT_NEAR(norm(difference(x, patch(closest.xi).x)), closest.distance_m, 1e-12);
        EXPECT_LE(at_least(patch, x), closest.distance_m + 1e-12);
        if (!closest.is_interior) continue;
        const auto at = patch(closest.xi);
        EXPECT_NEAR(dot(difference(x, at.x), at.t1), 0, 1e-9);
        if (!line) {
            EXPECT_NEAR(dot(difference(x, at.x), at.t2), 0, 1e-9);
        }
    }
}

TEST_P(ClosestPointOf, BoundsDoNotExceedDistancesOfTurnedFacets) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto turned_patch = [&] {
        const Patch flat = curved_patch(GetParam(), 0.6, random);
        const double angle = 3 * uniform(random), c = std::cos(angle), s = std::sin(angle);
        const Point offset{2 * uniform(random), 2 * uniform(random), flat.is_line() ? 0 : 2 * uniform(random)};
        surface::FacetMap map{flat.type, flat.nodes};
        for (Point& x : map.nodes)
            x = flat.is_line() ? Point{c * x[0] - s * x[1], s * x[0] + c * x[1], 0}
                               : Point{c * x[0] - s * x[2], c * x[1] + s * (s * x[0] + c * x[2]),
                                       c * (s * x[0] + c * x[2]) - s * x[1]};
        for (Point& x : map.nodes) x = along(x, 1, offset);
        return make_patch(map);
    };
    for (int trial = 0; trial < 20; ++trial) {
        const Patch a = turned_patch(), b = turned_patch();
        for (const auto& node : std::span{b.nodes}.first(static_cast<std::size_t>(mesh::node_count(b.type)))) {
            const double distance = sampled_distance(a, node);
            EXPECT_LE(at_least(a, node), distance + 1e-12);
            EXPECT_LE(at_least(a, b), distance + 1e-12);
        }
    }
}

TEST_P(ClosestPointOf, EdgesAndCornersAreThoseOfTheFacet) {
    std::mt19937 random(11);
    const Patch patch = curved_patch(GetParam(), 0.1, random);
    if (patch.is_line()) return;
    const auto& topology = mesh::topology(GetParam());
    for (std::size_t k = 0; k < (topology.shape == mesh::Shape::triangle ? 3 : 4); ++k) {
        const auto [first, last] = edge_corners(GetParam(), k);
        for (const std::size_t corner : {first, last}) {
            const Point& node = patch.nodes[corner];
            EXPECT_NEAR(closest_on_edge(patch, k, node).distance_m, 0, 1e-12);
            EXPECT_NEAR(at_corner(patch, corner, node).distance_m, 0, 1e-12);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(AllFacets, ClosestPointOf,
                         testing::Values(CellType::line2, CellType::line3, CellType::triangle3, CellType::triangle6,
                                         CellType::quad4, CellType::quad9));

}  // namespace
}  // namespace soft::contact
