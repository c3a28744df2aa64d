#include "mesh/arcs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"
#include "mesh/raise_order.hpp"
#include "mesh/refine.hpp"
#include "pieces.hpp"

namespace soft::mesh {
namespace {

constexpr double pi = std::numbers::pi;

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// A point on a circle of this radius in a plane of general orientation.
Point on_circle(double radius, double angle) {
    const Point e1{2 / 3.0, 2 / 3.0, 1 / 3.0}, e2{-2 / 3.0, 1 / 3.0, 2 / 3.0};
    Point p{0.3, -0.1, 0.7};
    for (std::size_t d = 0; d < 3; ++d) p[d] += radius * (std::cos(angle) * e1[d] + std::sin(angle) * e2[d]);
    return p;
}

TEST(Arc, LiesOnTheCircleAtTheQuadraticallyInterpolatedAngle) {
    for (const double whole : {1e-6, 1e-3, 0.1, 1.0, 3.0, 4.5})
        for (const double share : {0.5, 0.4, 0.62}) {
            const double radius = 1 / whole;  // arcs of length one
            const Point a = on_circle(radius, 0.2), m = on_circle(radius, 0.2 + share * whole),
                        b = on_circle(radius, 0.2 + whole);
            for (const double xi : {-0.5, 0.5, 0.3}) {
                const double angle = whole * (share * (1 - xi * xi) + xi * (xi + 1) / 2);
                EXPECT_NEAR(distance(arc_point(a, m, b, xi), on_circle(radius, 0.2 + angle)), 0, 3e-16 * radius + 1e-15)
                    << whole << ' ' << xi;
            }
        }
}

TEST(Arc, IsTheParabolaOnAStraightEdgeAndContinuousNearIt) {
    for (const double rise : {0.0, 1e-12, 0.99e-9, 1.01e-9, 1e-8, 1e-7}) {
        const Point p = arc_point({0, 0, 0}, {0.45, rise, 0}, {1, 0, 0}, 0.5);
        EXPECT_NEAR(p[0], 0.75 * 0.45 + 0.375, 1e-13);
        EXPECT_NEAR(p[1], 0.75 * rise, 0.1 * rise);
    }
    EXPECT_EQ(arc_point({1, 2, 3}, {1, 2, 3}, {1, 2, 3}, 0.5), (Point{1, 2, 3}));  // collapsed onto an axis
}

TEST(Arc, DoesNotDependOnTheDirectionOfTheEdge) {
    const Point a = on_circle(1, 0), m = on_circle(1, 0.4), b = on_circle(1, 1.1);
    EXPECT_LT(distance(arc_point(a, m, b, 0.5), arc_point(b, m, a, -0.5)), 1e-15);
}

/// Nodes of a cell at the images of its reference nodes under a map.
std::vector<Point> nodes_on(CellType type, const auto& map) {
    std::vector<Point> nodes;
    for (const auto& xi : topology(type).nodes) nodes.push_back(map(xi));
    return nodes;
}

TEST(ArcMap, ReproducesItsNodesAndMapsOfDegreeTwoWithStraightEdges) {
    for (const CellType type : sample::all_types) {
        const auto affine = [](const Point& xi) {
            return Point{1 + xi[0] + 0.2 * xi[1], 0.3 * xi[0] - xi[1] + xi[2], xi[2] - 0.1 * xi[1]};
        };
        const auto nodes = nodes_on(type, affine);
        const ArcMap map(type);
        for (std::size_t a = 0; a < nodes.size(); ++a)
            EXPECT_LT(distance(map(nodes, topology(type).nodes[a]), nodes[a]), 1e-15);
        Point xi{0.2, 0.3, 0.15};
        for (std::size_t d = static_cast<std::size_t>(dimension(type)); d < 3; ++d) xi[d] = 0;
        EXPECT_LT(distance(map(nodes, xi), affine(xi)), 1e-14) << topology(type).name;
    }
}

/// A piece of a thick tube: angle, axis and radius each linear in one reference coordinate.
Point tube_piece(const Point& xi) {
    const double r = 2 + 0.5 * xi[1], angle = 0.4 * xi[0];
    return {0.7 * xi[2] + 0.1, r * std::sin(angle), r * std::cos(angle)};
}

TEST(ArcMap, IsExactForRevolvedAndExtrudedTensorCells) {
    for (const CellType type : {CellType::line3, CellType::quad9, CellType::hex27}) {
        const auto nodes = nodes_on(type, tube_piece);
        Point xi{-0.37, 0.61, 0.2};
        for (std::size_t d = static_cast<std::size_t>(dimension(type)); d < 3; ++d) xi[d] = 0;
        EXPECT_LT(distance(ArcMap(type)(nodes, xi), tube_piece(xi)), 1e-15) << topology(type).name;
    }
}

TEST(ArcMap, KeepsFacetsOnSpheresAndCylinders) {
    const auto radius_at = [](const Point& p) { return std::hypot(p[0], p[1], p[2]); };
    const auto ball_piece = [](const Point& xi) {  // between spheres of radius 1 and 2
        const Point p{1, std::tan(0.5 * xi[0]), std::tan(0.5 * xi[1])};
        const double r = (1.5 + 0.5 * xi[2]) / std::hypot(p[0], p[1], p[2]);
        return Point{r * p[0], r * p[1], r * p[2]};
    };
    const auto nodes = nodes_on(CellType::hex27, ball_piece);
    const ArcMap hexahedron(CellType::hex27);
    for (const double zeta : {-1.0, 0.0, 1.0})
        for (const double xi : {-0.5, 0.1, 0.5})
            EXPECT_NEAR(radius_at(hexahedron(nodes, {xi, 0.5, zeta})), 1.5 + 0.5 * zeta, 1e-15);
    const auto cylinder = [](const Point& xi) { return Point{xi[2], std::sin(xi[0]), std::cos(xi[0])}; };
    const ArcMap wedge(CellType::wedge18);
    const auto column = nodes_on(CellType::wedge18, [&](const Point& xi) {  // one side, xi[1] = 0, on the cylinder
        const Point p = cylinder(xi);
        return Point{p[0], p[1] * (1 - 0.5 * xi[1]), p[2] * (1 - 0.5 * xi[1])};
    });
    for (const double xi : {0.25, 0.5, 0.75}) {
        const Point p = wedge(column, {xi, 0, 0.5});
        EXPECT_NEAR(std::hypot(p[1], p[2]), 1, 1e-15);
        EXPECT_NEAR(p[0], 0.5, 1e-15);
    }
}

/// A quarter annulus of n x 1 second-order cells (angle x radius) with nodes exactly on the polar map.
Mesh annulus(int cells_around, CellType type, double inner, double outer) {
    Mesh mesh = sample::row_of(type, cells_around);  // [-1, 2 n - 1] x [-1, 1] (x [-1, 1])
    for (Point& p : mesh.points) {
        const double angle = pi / 2 * (p[0] + 1) / (2 * cells_around), r = inner + (outer - inner) * (p[1] + 1) / 2;
        p = {-r * std::cos(angle), r * std::sin(angle), p[2]};  // keeps the orientation
    }
    return mesh;
}

TEST(RefineAlongArcs, EqualsTheFinerMeshOfTheSameAnnulus) {
    for (const CellType type : {CellType::quad9, CellType::hex27}) {
        const Mesh fine = refine(annulus(2, type, 1, 3), 2, Curve::circle);
        for (const Point& p : fine.points) {
            const double radius_steps = 8 * (std::hypot(p[0], p[1]) - 1) / 2,
                         angle_steps = std::atan2(p[1], -p[0]) / (pi / 2) * 16;
            EXPECT_NEAR(radius_steps, std::round(radius_steps), 1e-13);
            EXPECT_NEAR(angle_steps, std::round(angle_steps), 1e-13);
        }
        EXPECT_GT(quality(fine).min_scaled_jacobian, 0.4);
    }
}

/// The new nodes lie on the exact geometry, so the volume error decreases by a factor of 16 per level. With Curve::parabola the
/// volume does not change.
TEST(RefineAlongArcs, VolumeConvergesToTheExactValue) {
    struct Sample {
        Mesh mesh;
        Measure kind;
        double formula;
    };
    const double area = pi / 4 * (9 - 1);
    Mesh ring = annulus(2, CellType::quad9, 1, 3);  // quarter disc turned about x: half a spherical shell
    std::vector<Sample> samples{{ring, Measure::plain, area},
                                {ring, Measure::revolved, 2 * pi / 3 * (27 - 1)},
                                {annulus(2, CellType::hex27, 1, 3), Measure::plain, 2 * area},
                                {split_into_simplices(ring), Measure::plain, area}};
    for (const auto& [coarse, kind, formula] : samples) {
        const double start = measure(coarse, kind) / formula - 1;
        EXPECT_NEAR(measure(refine(coarse, 2), kind) / formula - 1, start, 1e-12);
        double before = start;
        for (int times = 1; times <= (coarse.dimension == 2 ? 6 : 3); ++times) {
            const double error = measure(refine(coarse, times, Curve::circle), kind) / formula - 1;
            EXPECT_NEAR(error / before, 1 / 16.0, 0.02);
            before = error;
        }
        EXPECT_LT(std::abs(before), 1e-12 + std::abs(start) / (coarse.dimension == 2 ? 1e7 : 3e3));
    }
}

TEST(RefineAlongArcs, SphericalShellStaysSphericalAndItsVolumeConverges) {
    Mesh coarse = sample::reference_cell(CellType::hex27);  // one of the six sides of a cube
    for (Point& xi : coarse.points) {
        const Point p{std::tan(pi / 4 * xi[0]), std::tan(pi / 4 * xi[1]), 1};
        const double r = (1.5 + 0.5 * xi[2]) / std::hypot(p[0], p[1], p[2]);
        xi = {r * p[0], r * p[1], r * p[2]};
    }
    const double formula = 4 * pi / 3 * (8 - 1) / 6;
    double before = measure(coarse, Measure::plain) / formula - 1;
    for (int times = 1; times <= 4; ++times) {
        const Mesh fine = refine(coarse, times, Curve::circle);
        const double error = measure(fine, Measure::plain) / formula - 1;
        EXPECT_LT(std::abs(error / before), times == 1 ? 0.15 : 0.08) << times;
        before = error;
        for (const Facet& facet : boundary_facets(fine)) {
            bool inner = true, outer = true;
            for (const Index node : facet_nodes(fine, facet)) {
                const Point& p = fine.point(node);
                const double r = std::hypot(p[0], p[1], p[2]);
                inner = inner && r < 1 + 1e-14;
                outer = outer && r > 2 - 1e-14;
                EXPECT_TRUE(r > 1 - 1e-14 && r < 2 + 1e-14);
            }
        }
    }
}

}  // namespace
}  // namespace soft::mesh
