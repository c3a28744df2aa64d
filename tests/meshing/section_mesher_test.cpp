#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/error.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"
#include "meshing/section_mesher.hpp"
#include "meshing/sweep.hpp"

namespace soft::meshing {
namespace {

/// A quarter ring about the origin, radii 1 and 2, first side on the x axis.
Section quarter_ring(int through, int around) {
    Section s;
    const int centre = add_point(s, {0, 0});
    const int a = add_point(s, {1, 0}), b = add_point(s, {2, 0}), c = add_point(s, {0, 2}), d = add_point(s, {0, 1});
    add_line(s, {a, b}, through, {"start"});
    add_arc(s, {b, c}, centre, around, {"outer", "round"});
    add_line(s, {c, d}, through, {"end"});
    add_arc(s, {d, a}, centre, around, {"inner", "round"});
    add_block(s, {{{a, b}, {b, c}, {c, d}, {d, a}}});
    return s;
}

double radius(const mesh::Point& p) { return std::hypot(p[0], p[1]); }

TEST(SectionMesher, NodesOnArcsLieOnTheExactArc) {
    const mesh::Mesh mesh = mesh_section(quarter_ring(2, 3));
    ASSERT_EQ(mesh.cell_count(), 6);
    ASSERT_EQ(mesh.facet_sets.at("outer").size(), 3u);
    for (const mesh::Facet& facet : mesh.facet_sets.at("outer"))
        for (const mesh::Index n : facet_nodes(mesh, facet)) EXPECT_NEAR(radius(mesh.point(n)), 2, 1e-13);
    for (const mesh::Facet& facet : mesh.facet_sets.at("inner"))
        for (const mesh::Index n : facet_nodes(mesh, facet)) EXPECT_NEAR(radius(mesh.point(n)), 1, 1e-13);
}

TEST(SectionMesher, RejectsEdgesFarShorterThanTheSection) {
    for (const double edge :
         {0.0, 1e-300, 1e-12, 5e-7}) {  // relative to 2: gmsh aborts the program if it merges the ends
        Section s;
        const int a = add_point(s, {0, 0}), b = add_point(s, {2, 0}), c = add_point(s, {2, edge}),
                  d = add_point(s, {0, edge});
        add_line(s, {a, b}, 2);
        add_line(s, {b, c}, 1);
        add_line(s, {c, d}, 2);
        add_line(s, {d, a}, 1);
        add_block(s, {{{a, b}, {b, c}, {c, d}, {d, a}}});
        try {
            (void)mesh_section(s);
            FAIL() << edge;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input) << edge;
            EXPECT_NE(std::string{error.what()}.find("less than a millionth of the section's 2 m"), std::string::npos)
                << error.what();
        }
    }
}

TEST(SectionMesher, InnerMidNodesFollowTheCurvedGridLines) {
    const mesh::Mesh mesh = mesh_section(quarter_ring(2, 3));
    for (const mesh::Point& p : mesh.points) {
        const double level = (radius(p) - 1) * 4;  // two cells, so four half steps through the ring
        EXPECT_NEAR(level, std::round(level), 1e-6) << p[0] << " " << p[1];
    }
}

TEST(SectionMesher, AreaOfARingConvergesWithFourthOrder) {
    const double exact = 0.25 * std::numbers::pi * 3;
    const auto error = [&](int around) {
        return std::abs(mesh::measure(mesh_section(quarter_ring(1, around)), mesh::Measure::plain) - exact);
    };
    EXPECT_NEAR(std::log2(error(2) / error(4)), 4, 0.1);
    EXPECT_NEAR(std::log2(error(4) / error(8)), 4, 0.1);
}

TEST(SectionMesher, BlocksOfDifferentRegionsShareNodes) {
    Section s;
    const std::array<int, 6> p{add_point(s, {0, 1}), add_point(s, {1, 1}), add_point(s, {1, 2}),
                               add_point(s, {0, 2}), add_point(s, {1, 3}), add_point(s, {0, 3})};
    for (const auto& [a, b, cells] :
         std::vector<std::array<int, 3>>{{0, 1, 2}, {1, 2, 1}, {2, 3, 2}, {3, 0, 1}, {2, 4, 3}, {4, 5, 2}, {5, 3, 3}})
        add_line(s, {p[a], p[b]}, cells);
    add_block(s, {{{p[0], p[1]}, {p[1], p[2]}, {p[2], p[3]}, {p[3], p[0]}}}, "layer");
    add_block(s, {{{p[3], p[2]}, {p[2], p[4]}, {p[4], p[5]}, {p[5], p[3]}}});
    const mesh::Mesh plane = mesh_section(s);
    EXPECT_EQ(plane.region_names, (std::vector<std::string>{"layer", "rubber"}));
    EXPECT_EQ(plane.points.size(), 5u * 9u);
    const auto cells_of = [](const mesh::Mesh& mesh, int region) {
        return std::ranges::count(mesh.cell_regions, region);
    };
    EXPECT_EQ(cells_of(plane, 0), 2);
    EXPECT_EQ(cells_of(plane, 1), 6);
    const mesh::Mesh drawn = extrude(plane, {1.0, 3, {}, {}}), turned = revolve(plane, Turn::quarter, Sectors::even(3));
    for (const mesh::Mesh* solid : {&drawn, &turned}) {
        EXPECT_EQ(solid->region_names, plane.region_names);
        EXPECT_EQ(cells_of(*solid, 0), 3 * 2);
        EXPECT_EQ(cells_of(*solid, 1), 3 * 6);
    }
}

TEST(SectionMesher, FacesMayOverlapAndCoverTheOutline) {
    const mesh::Mesh mesh = mesh_section(quarter_ring(2, 3));
    EXPECT_EQ(mesh.facet_sets.at("round").size(), 6u);
    EXPECT_EQ(mesh::boundary_facets(mesh).size(), 10u);
    std::vector<mesh::Facet> named;
    for (const char* face : {"start", "end", "round"})
        named.insert(named.end(), mesh.facet_sets.at(face).begin(), mesh.facet_sets.at(face).end());
    std::sort(named.begin(), named.end());
    EXPECT_EQ(named, mesh::boundary_facets(mesh));
}

TEST(SectionMesher, ClockwiseBlocksGiveValidCells) {
    Section s = quarter_ring(2, 3);
    const auto sides = s.blocks.front().sides;
    s.blocks.clear();
    auto clockwise = sides;
    std::reverse(clockwise.begin(), clockwise.end());
    for (auto& side : clockwise) std::reverse(side.begin(), side.end());
    add_block(s, clockwise);
    EXPECT_GT(mesh::quality(mesh_section(s)).min_scaled_jacobian, 0.4);
}

TEST(SectionMesher, NeighboursShareTheNodesOfTheirCurve) {
    // Two adjacent squares; the upper side of the right one is a chain of two curves.
    Section s;
    const int a = add_point(s, {0, 0}), b = add_point(s, {1, 0}), c = add_point(s, {1, 1}), d = add_point(s, {0, 1});
    const int e = add_point(s, {2, 0}), f = add_point(s, {2, 1}), g = add_point(s, {1.6, 1});
    add_line(s, {a, b}, 2);
    add_line(s, {b, c}, 3);
    add_line(s, {c, d}, 2);
    add_line(s, {d, a}, 3);
    add_line(s, {b, e}, 4);
    add_line(s, {e, f}, 3);
    add_line(s, {f, g}, 1, {"short"});
    add_line(s, {g, c}, 3, {"long"});
    add_block(s, {{{a, b}, {b, c}, {c, d}, {d, a}}});
    add_block(s, {{{b, e}, {e, f}, {f, g, c}, {c, b}}});
    const mesh::Mesh mesh = mesh_section(s);
    EXPECT_EQ(mesh.cell_count(), 6 + 12);
    EXPECT_EQ(mesh.points.size(), std::size_t{13 * 7});  // one grid without duplicate nodes
    EXPECT_EQ(mesh.facet_sets.at("short").size(), 1u);
    for (const mesh::Facet& facet : mesh.facet_sets.at("long"))
        for (const mesh::Index n : facet_nodes(mesh, facet)) {
            EXPECT_EQ(mesh.point(n)[1], 1);
            EXPECT_LE(mesh.point(n)[0], 1.6 + 1e-12);
        }
    EXPECT_NEAR(mesh::measure(mesh, mesh::Measure::plain), 2, 1e-13);
}

TEST(SectionMesher, NodesOnTheAxisHaveRadiusZeroExactly) {
    const mesh::Mesh mesh = mesh_section(quarter_ring(3, 4));
    for (const mesh::Facet& facet : mesh.facet_sets.at("start"))
        for (const mesh::Index n : facet_nodes(mesh, facet)) EXPECT_EQ(mesh.point(n)[1], 0);
}

TEST(SectionMesher, SmallSectionsKeepTheirPrecision) {
    Section s = quarter_ring(2, 3);
    for (PlanePoint& p : s.points) p = {p[0] * 1e-6, p[1] * 1e-6};  // a ring of one micrometre
    const mesh::Mesh mesh = mesh_section(s);
    for (const mesh::Facet& facet : mesh.facet_sets.at("outer"))
        for (const mesh::Index n : facet_nodes(mesh, facet)) EXPECT_NEAR(radius(mesh.point(n)) / 2e-6, 1, 1e-13);
}

TEST(SectionMesher, IsReproducible) {
    const mesh::Mesh one = mesh_section(quarter_ring(2, 3)), two = mesh_section(quarter_ring(2, 3));
    EXPECT_EQ(one.points, two.points);
    EXPECT_EQ(one.connectivity, two.connectivity);
}

TEST(Section, OppositeSidesMustHaveEqualCells) {
    Section s = quarter_ring(2, 3);
    s.curves[0].cells = 3;
    EXPECT_THROW((void)mesh_section(s), std::logic_error);
}

TEST(Section, PointsOfASideMustBeConnected) {
    Section s = quarter_ring(2, 3);
    EXPECT_THROW((void)curve_between(s, {1, 3}), std::logic_error);
}

TEST(Section, DivisionsAreRoundedToTheNearestInteger) {
    EXPECT_EQ(divisions(3e-3, 1.5e-3), 2);
    EXPECT_EQ(divisions(3e-3, 1.3e-3), 2);
    EXPECT_EQ(divisions(3e-3, 1.1e-3), 3);
    EXPECT_EQ(divisions(1e-3, 1), 1);
    EXPECT_EQ(divisions(1e-3, 1, 4), 4);
}

}  // namespace
}  // namespace soft::meshing
