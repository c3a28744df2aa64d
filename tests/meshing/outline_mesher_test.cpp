#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "geometry/profile.hpp"  // outlines from tables
#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"
#include "mesh/split.hpp"
#include "meshing/outline_mesher.hpp"
#include "meshing/outline_sizes.hpp"
#include "meshing/section_mesher.hpp"
#include "meshing/sweep.hpp"

namespace soft::meshing {
namespace {

using geometry::Across;
using geometry::outline_from;

using std::numbers::pi;

Outline sized(const std::string& text, Across across, const SizeRequest& request) {
    Outline outline = outline_from(text, "part.csv", across);
    outline.size_m = cell_sizes(outline, request);
    return outline;
}

/// A ring of radii 10 and 20 mm, two loops of arcs.
const std::string ring =
    "x_mm,y_mm,tag,loop,curve,via_x_mm,via_y_mm\n"
    "20,0,outer,1,arc,0,20\n-20,0,outer,1,arc,0,-20\n10,0,inner,2,arc,0,-10\n-10,0,inner,2,arc,0,10\n";

/// A ball of radius 10 mm about the axis with a concentric spherical hole; and an L with a re-entrant corner at (4, 4).
const std::string ball =
    "x_mm,r_mm,tag,curve,via_x_mm,via_r_mm\n5,0,axis,,,\n10,0,outer,arc,0,10\n-10,0,axis,,,\n-5,0,cavity,arc,0,5\n";
const std::string corner = "x_mm,y_mm,tag\n0,0,base\n10,0,side\n10,4,side\n4,4,side\n4,10,top\n0,10,side\n";

class EitherCells : public testing::TestWithParam<FreeCells> {};

TEST_P(EitherCells, NodesLieOnArcsAndFacesCoverTheOutline) {
    const mesh::Mesh mesh = mesh_outline(sized(ring, Across::y, {4e-3, 2, 1, {}}), GetParam());
    EXPECT_GT(mesh::quality(mesh).min_scaled_jacobian, 0.25);
    std::vector<mesh::Facet> named;
    for (const auto& [face, radius_m] : {std::pair{"outer", 20e-3}, {"inner", 10e-3}})
        for (const mesh::Facet& facet : mesh.facet_sets.at(face)) {
            named.push_back(facet);
            for (const mesh::Index n : facet_nodes(mesh, facet))
                EXPECT_NEAR(std::hypot(mesh.point(n)[0], mesh.point(n)[1]), radius_m, 1e-12);
        }
    std::sort(named.begin(), named.end());
    EXPECT_EQ(named, mesh::boundary_facets(mesh));
    EXPECT_NEAR(mesh::measure(mesh, mesh::Measure::plain) / (pi * 3e-4), 1, 1e-4);
}

TEST_P(EitherCells, HaveOneType) {
    const mesh::CellType wanted =
        GetParam() == FreeCells::triangles ? mesh::CellType::triangle6 : mesh::CellType::quad9;
    for (const std::string& text : {ring, corner})
        for (const double size_m : {5e-3, 1e-3, 0.37e-3})
            for (const mesh::CellType type :
                 mesh_outline(sized(text, Across::y, {size_m, 1, 4, {}}), GetParam()).cell_types)
                ASSERT_EQ(type, wanted);
}

TEST_P(EitherCells, AreReproducible) {
    const Outline outline = sized(corner, Across::y, {1e-3, 1, 4, {"base"}});
    const mesh::Mesh one = mesh_outline(outline, GetParam()), two = mesh_outline(outline, GetParam());
    EXPECT_EQ(one.points, two.points);
    EXPECT_EQ(one.connectivity, two.connectivity);
    EXPECT_EQ(one.facet_sets, two.facet_sets);
}

/// Longest side of the cells at a point.
double size_at(const mesh::Mesh& mesh, mesh::Point point) {
    double nearest = 1, size = 0;
    for (mesh::Index c = 0; c < mesh.cell_count(); ++c) {
        const auto nodes = mesh.cell_nodes(c);
        const mesh::Point &a = mesh.point(nodes[0]), &b = mesh.point(nodes[1]), &d = mesh.point(nodes[2]);
        const double away = std::hypot(a[0] - point[0], a[1] - point[1]);
        if (away < nearest) size = std::max(std::hypot(b[0] - a[0], b[1] - a[1]), std::hypot(d[0] - b[0], d[1] - b[1]));
        nearest = std::min(away, nearest);
    }
    return size;
}

TEST_P(EitherCells, FollowTheRequestedSizes) {
    const mesh::Mesh even = mesh_outline(sized(corner, Across::y, {1e-3, 1, 1, {}}), GetParam());
    const mesh::Mesh graded = mesh_outline(sized(corner, Across::y, {1e-3, 1, 8, {"base"}}), GetParam());
    EXPECT_NEAR(size_at(even, {4e-3, 4e-3, 0}), 1e-3, 0.6e-3);
    EXPECT_NEAR(size_at(graded, {4e-3, 4e-3, 0}), 0.125e-3, 0.1e-3);  // re-entrant
    EXPECT_NEAR(size_at(graded, {10e-3, 0, 0}), 0.125e-3, 0.1e-3);    // end of a fixed face
    EXPECT_GT(size_at(graded, {0, 10e-3, 0}), 0.4e-3);                // neither
    const mesh::Mesh thin =
        mesh_outline(sized("x_mm,y_mm,tag\n0,0,a\n40,0,a\n40,1,a\n0,1,a\n", Across::y, {10e-3, 3, 1, {}}), GetParam());
    EXPECT_NEAR(size_at(thin, {20e-3, 0, 0}), 1e-3 / 3, 0.2e-3);
    EXPECT_GT(mesh::quality(thin).min_scaled_jacobian, 0.25);
}

/// A wall around a middle line of radius `radius_mm`, given as two splines through `spans` + 1 points each.
template <class Radius>
std::string spline_wall(double length_mm, double wall_mm, int spans, Radius&& radius_mm) {
    const auto row = [&](int i, double off_mm, const char* tag, const char* curve) {
        constexpr double step = 1e-5;
        const double x = length_mm * i / spans;
        const double slope = (radius_mm(x + step) - radius_mm(x - step)) / (2 * step), stretch = std::hypot(1, slope);
        return std::to_string(x - off_mm * slope / stretch) + "," + std::to_string(radius_mm(x) + off_mm / stretch) +
               "," + tag + "," + curve + "\n";
    };
    std::string text = "x_mm,r_mm,tag,curve\n";
    for (int i = 0; i < spans; ++i) text += row(i, -wall_mm / 2, "cavity", "spline");
    text += row(spans, -wall_mm / 2, "end", "line");
    for (int i = spans; i > 0; --i) text += row(i, wall_mm / 2, "outer", "spline");
    return text + row(0, wall_mm / 2, "fixed", "line");
}

/// A corner that belongs to only one cell would be flat on a smooth outline, whatever the cell length.
TEST_P(EitherCells, AreValidInSmoothOutlines) {
    const auto bellows = [](double x) { return 14 - 3 * std::cos(2 * pi * x / 12); };
    const auto bulb = [](double x) { return 5 + 9 * std::exp(-(x - 20) * (x - 20) / 40); };
    const auto wavy = [](double x) { return 10 + 0.8 * std::sin(2 * pi * x / 5) + 0.03 * x; };
    for (const int through_wall : {1, 3}) {
        const SizeRequest request{2e-3, through_wall, 4, {"fixed"}};
        for (const int points : {8, 12, 24}) {
            const Outline outline = sized(spline_wall(72, 1.2, 6 * points, bellows), Across::r, request);
            EXPECT_GT(mesh::quality(mesh_outline(outline, GetParam())).min_scaled_jacobian, 0.15) << points;
        }
        for (const auto& text : {spline_wall(40, 1.5, 30, bulb), spline_wall(40, 1, 64, wavy)})
            EXPECT_GT(mesh::quality(mesh_outline(sized(text, Across::r, request), GetParam())).min_scaled_jacobian,
                      0.15);
    }
}

INSTANTIATE_TEST_SUITE_P(OutlineMesher, EitherCells, testing::Values(FreeCells::quadrilaterals, FreeCells::triangles),
                         [](const auto& test) {
                             return test.param == FreeCells::triangles ? "triangles" : "quadrilaterals";
                         });

TEST(OutlineMesher, NodesOfASplineLieOnItsFormula) {
    const Outline outline = sized(
        "x_mm,y_mm,tag,curve\n0,0,base,\n30,0,wave,spline\n31,6,wave,spline\n22,9,wave,spline\n12,5,wave,spline\n4,8,wave,spline\n0,4,side,\n",
        Across::y, {1e-3, 1, 1, {}});
    const OutlineEdge& wave = outline.loops[0][1];
    const mesh::Mesh mesh = mesh_outline(outline, FreeCells::quadrilaterals);
    constexpr int steps = 4000;
    for (const mesh::Facet& facet : mesh.facet_sets.at("wave"))
        for (const mesh::Index n : facet_nodes(mesh, facet)) {
            double nearest = 1;
            for (int k = 0; k <= steps; ++k) {
                const PlanePoint p = spline_at(wave.points, 5.0 * k / steps);
                nearest = std::min(nearest, std::hypot(p[0] - mesh.point(n)[0], p[1] - mesh.point(n)[1]));
            }
            EXPECT_LT(nearest, 1e-5);  // half the distance between the sampled points
        }
}

/// Wedges off the axis and tetrahedra on it conform after splitting: the boundary is that of the sphere, without gaps.
TEST(OutlineMesher, TrianglesOnTheAxisGiveAValidSolid) {
    const Outline outline = sized(ball, Across::r, {3e-3, 2, 1, {}});
    const mesh::Mesh section = mesh_outline(outline, FreeCells::triangles);
    for (const auto& [turn, part] : {std::pair{Turn::quarter, 0.25}, {Turn::half, 0.5}, {Turn::full, 1.0}}) {
        const mesh::Mesh solid = mesh::split_into_simplices(revolve(section, turn, Sectors::even(4)));
        EXPECT_GT(mesh::quality(solid).min_scaled_jacobian, 0.1);
        EXPECT_NEAR(mesh::measure(solid, mesh::Measure::plain) / part / (4 * pi / 3 * 875e-9), 1, 2e-3);
        std::set<mesh::Facet> named;
        std::size_t sides = 0;
        for (const auto& [face, facets] : solid.facet_sets) {
            named.insert(facets.begin(), facets.end());
            sides += facets.size();
            if (face != "outer") continue;
            for (const mesh::Facet& facet : facets)
                for (const mesh::Index n : facet_nodes(solid, facet))
                    EXPECT_NEAR(std::hypot(solid.point(n)[0], solid.point(n)[1], solid.point(n)[2]), 10e-3, 1e-11);
        }
        const auto boundary = mesh::boundary_facets(solid);
        EXPECT_EQ(sides, boundary.size());
        EXPECT_EQ(named, std::set<mesh::Facet>(boundary.begin(), boundary.end()));
        const std::set<mesh::Index> used(solid.connectivity.begin(), solid.connectivity.end());
        EXPECT_EQ(used.size(), solid.points.size());
    }
}

TEST(OutlineMesher, ExpectedNumberOfCellsIsApproximatelyCorrect) {
    for (const double size_m : {2e-3, 0.5e-3}) {
        const Outline outline = sized(corner, Across::y, {size_m, 1, 4, {}});
        const double cells = static_cast<double>(mesh_outline(outline, FreeCells::quadrilaterals).cell_count());
        EXPECT_GT(expected_cells(outline), 0.3 * cells);  // unpaired triangles become three cells
        EXPECT_LT(expected_cells(outline), 2.5 * cells);
    }
}

/// Options that an unstructured mesh sets in gmsh must not affect the next structured grid.
TEST(OutlineMesher, DoesNotAffectALaterGrid) {
    const Section section = rectangle({2, 1, 4, 2, {"bottom"}, {"right"}, {"top"}, {"left"}});
    const mesh::Mesh before = mesh_section(section);
    (void)mesh_outline(sized(corner, Across::y, {1e-3, 1, 4, {}}), FreeCells::quadrilaterals);
    EXPECT_EQ(mesh_section(section).points, before.points);
}

}  // namespace
}  // namespace soft::meshing
