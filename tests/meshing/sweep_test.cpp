#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"
#include "mesh/split.hpp"
#include "meshing/section_mesher.hpp"
#include "meshing/sweep.hpp"

namespace soft::meshing {
namespace {

using mesh::CellType;

/// x = 0 .. 3, r = low .. low + 1.
mesh::Mesh bar(double low) {
    mesh::Mesh section = mesh_section(rectangle({3, 1, 3, 2, {"lower"}, {"right"}, {"upper"}, {"left"}}));
    for (mesh::Point& p : section.points) p[1] += low;
    return section;
}

std::size_t boundary_count(const mesh::Mesh& mesh, std::initializer_list<const char*> faces) {
    std::set<mesh::Facet> named;
    for (const char* face : faces) named.insert(mesh.facet_sets.at(face).begin(), mesh.facet_sets.at(face).end());
    const auto boundary = mesh::boundary_facets(mesh);
    EXPECT_EQ(std::set<mesh::Facet>(boundary.begin(), boundary.end()), named);
    return boundary.size();
}

double error_of_ring(int sectors) {
    const double exact = 3 * std::numbers::pi * (3 * 3 - 2 * 2);
    return std::abs(mesh::measure(revolve(bar(2), Turn::full, Sectors::even(sectors)), mesh::Measure::plain) / exact -
                    1);
}

TEST(Revolve, FullTurnIsClosed) {
    const mesh::Mesh ring = revolve(bar(2), Turn::full, Sectors::even(3));
    EXPECT_EQ(ring.cell_count(), 6 * 12);
    EXPECT_EQ(ring.points.size(), std::size_t{7 * 5 * 24});  // section nodes times half layers, without duplicates
    EXPECT_EQ(boundary_count(ring, {"lower", "right", "upper", "left"}), std::size_t{10 * 12});
    EXPECT_GT(mesh::quality(ring).min_scaled_jacobian, 0.5);
}

TEST(Revolve, EveryNodeLiesOnItsExactCircle) {
    const mesh::Mesh section = bar(2), ring = revolve(section, Turn::half, Sectors::even(2));
    std::set<long> radii;
    for (const mesh::Point& p : section.points) radii.insert(std::lround(p[1] * 1e9));
    for (const mesh::Point& p : ring.points) EXPECT_TRUE(radii.contains(std::lround(std::hypot(p[1], p[2]) * 1e9)));
}

TEST(Revolve, VolumeConvergesToPappusWithFourthOrder) {
    EXPECT_LT(error_of_ring(4), 1e-4);
    EXPECT_NEAR(std::log2(error_of_ring(2) / error_of_ring(4)), 4, 0.1);
    EXPECT_NEAR(std::log2(error_of_ring(4) / error_of_ring(8)), 4, 0.1);
}

TEST(Revolve, PartsHaveCellsOfTheirOwnAndAreMirrored) {
    constexpr double quarter = 0.5 * std::numbers::pi, part = 0.3;
    const Sectors sectors{{{part, 1}, {quarter - part, 3}}, {{quarter, 4}}};
    const mesh::Mesh half = revolve(bar(2), Turn::half, sectors), whole = revolve(bar(2), Turn::full, sectors);
    EXPECT_EQ(sectors.cells(Turn::half), 8);
    EXPECT_EQ(whole.cell_count(), 2 * half.cell_count());
    EXPECT_NEAR(mesh::measure(whole, mesh::Measure::plain) / mesh::measure(half, mesh::Measure::plain), 2, 1e-14);
    const auto at_edge = [&](const mesh::Mesh& mesh, double side) {
        return std::ranges::count_if(
            mesh.points, [&](const mesh::Point& p) { return std::abs(std::atan2(side * p[1], -p[2]) - part) < 1e-12; });
    };
    EXPECT_EQ(at_edge(half, 1), 7 * 5);  // every node of the section
    EXPECT_EQ(at_edge(whole, 1), 7 * 5);
    EXPECT_EQ(at_edge(whole, -1), 7 * 5);
    EXPECT_GT(mesh::quality(whole).min_scaled_jacobian, 0.5);
}

TEST(Revolve, QuadrilateralsOnTheAxisBecomeWedges) {
    const mesh::Mesh disc = revolve(bar(0), Turn::full, Sectors::even(4));
    EXPECT_EQ(std::count(disc.cell_types.begin(), disc.cell_types.end(), CellType::wedge18), 3 * 16);
    EXPECT_EQ(std::count(disc.cell_types.begin(), disc.cell_types.end(), CellType::hex27), 3 * 16);
    EXPECT_GT(mesh::quality(disc).min_scaled_jacobian, 0.4);
    EXPECT_NEAR(mesh::measure(disc, mesh::Measure::plain) / (3 * std::numbers::pi), 1, 1e-4);
    EXPECT_EQ(boundary_count(disc, {"right", "upper", "left"}), std::size_t{(2 + 2 + 3) * 16});
    EXPECT_FALSE(disc.facet_sets.contains("lower"));  // it lies on the axis
    for (const mesh::Facet& facet : disc.facet_sets.at("right"))
        for (const mesh::Index n : facet_nodes(disc, facet)) EXPECT_EQ(disc.point(n)[0], 3);
}

/// Rotating the node order of a section cell, so that another edge lies on the axis, gives the same body.
TEST(Revolve, AnyEdgeOfAQuadrilateralMayLieOnTheAxis) {
    mesh::Mesh section = bar(0);
    const auto first = static_cast<std::ptrdiff_t>(section.offsets[1]);
    for (int turn = 1; turn < 4; ++turn) {
        auto& nodes = section.connectivity;  // of cell 0, rotated by one more corner each time
        std::rotate(nodes.begin(), nodes.begin() + 1, nodes.begin() + 4);
        std::rotate(nodes.begin() + 4, nodes.begin() + 5, nodes.begin() + 8);
        ASSERT_EQ(first, 9);
        for (auto& [name, facets] : section.facet_sets)
            for (mesh::Facet& facet : facets)
                if (facet.cell == 0) facet.local = (facet.local + 3) % 4;
        const mesh::Mesh disc = revolve(section, Turn::full, Sectors::even(4));
        EXPECT_NEAR(mesh::measure(disc, mesh::Measure::plain) / (3 * std::numbers::pi), 1, 1e-4);
        EXPECT_EQ(boundary_count(disc, {"right", "upper", "left"}), std::size_t{(2 + 2 + 3) * 16});
        for (const mesh::Facet& facet : disc.facet_sets.at("left"))
            for (const mesh::Index n : facet_nodes(disc, facet)) EXPECT_EQ(disc.point(n)[0], 0);
    }
}

TEST(Revolve, CutPlanesAreExactAndNamed) {
    const mesh::Mesh quarter = revolve(bar(0), Turn::quarter, Sectors::even(3));
    EXPECT_EQ(boundary_count(quarter, {"right", "upper", "left", symmetry_y_face, symmetry_z_face}),
              std::size_t{7 * 3 + 12});
    for (const mesh::Point& p : quarter.points) {
        EXPECT_GE(p[1], 0);
        EXPECT_GE(p[2], 0);
    }
    for (const mesh::Facet& facet : quarter.facet_sets.at(symmetry_y_face))
        for (const mesh::Index n : facet_nodes(quarter, facet)) EXPECT_EQ(quarter.point(n)[1], 0);
    for (const mesh::Facet& facet : quarter.facet_sets.at(symmetry_z_face))
        for (const mesh::Index n : facet_nodes(quarter, facet)) EXPECT_EQ(quarter.point(n)[2], 0);

    const mesh::Mesh half = revolve(bar(0), Turn::half, Sectors::even(3));
    EXPECT_EQ(boundary_count(half, {"right", "upper", "left", symmetry_y_face}), std::size_t{7 * 6 + 12});
    EXPECT_FALSE(half.facet_sets.contains(symmetry_z_face));
    for (const mesh::Point& p : half.points) EXPECT_GE(p[1], 0);
}

TEST(Revolve, TrianglesOffTheAxisBecomeWedgesAndOnTheAxisTetrahedra) {
    const mesh::Mesh ring = revolve(mesh::split_into_simplices(bar(2)), Turn::quarter, Sectors::even(4));
    EXPECT_EQ(std::count(ring.cell_types.begin(), ring.cell_types.end(), CellType::wedge18), ring.cell_count());
    EXPECT_GT(mesh::quality(ring).min_scaled_jacobian, 0.5);
    EXPECT_NEAR(4 * mesh::measure(ring, mesh::Measure::plain) / (15 * std::numbers::pi), 1, 1e-4);
    const mesh::Mesh section = mesh::split_into_simplices(bar(0)),
                     solid = revolve(section, Turn::quarter, Sectors::even(4));
    EXPECT_GT(std::count(solid.cell_types.begin(), solid.cell_types.end(), CellType::tet10), 0);
    const mesh::Mesh split = mesh::split_into_simplices(solid),
                     known = mesh::split_into_simplices(revolve(bar(0), Turn::quarter, Sectors::even(4)));
    EXPECT_GT(mesh::quality(split).min_scaled_jacobian, 0.1);
    EXPECT_NEAR(mesh::measure(split, mesh::Measure::plain) / mesh::measure(known, mesh::Measure::plain), 1, 1e-12);
    EXPECT_EQ(mesh::boundary_facets(split).size(), mesh::boundary_facets(known).size());  // no gap between cells
}

TEST(Revolve, CornerOnTheAxisIsRejected) {
    mesh::Mesh section = bar(2);
    section.points[static_cast<std::size_t>(section.connectivity[0])][1] = 0;
    EXPECT_THROW((void)revolve(section, Turn::quarter, Sectors::even(4)), std::logic_error);
}

TEST(Revolve, BodySplitsIntoConformingTetrahedra) {
    const mesh::Mesh disc = revolve(bar(0), Turn::full, Sectors::even(4)), split = mesh::split_into_simplices(disc);
    EXPECT_EQ(split.cell_count(), 48 * 3 + 48 * 6);
    EXPECT_GT(mesh::quality(split).min_scaled_jacobian, 0.3);
    // Every quadrilateral of the boundary gives two triangles; an inner mismatch would add more.
    EXPECT_EQ(boundary_count(split, {"right", "upper", "left"}), std::size_t{16 * (2 * (1 + 2) + 2 * 3)});
    EXPECT_NEAR(mesh::measure(split, mesh::Measure::plain) / (3 * std::numbers::pi), 1, 1e-4);
}

TEST(Extrude, GivesABoxWithBothEndsNamed) {
    const mesh::Mesh box = extrude(bar(0), {4, 5, {"near", "low"}, {"far"}});
    EXPECT_EQ(box.cell_count(), 30);
    EXPECT_EQ(box.points.size(), std::size_t{7 * 5 * 11});
    // Positive, because x, z and -y are right-handed; gmsh positions nodes along a line to about 1e-11.
    EXPECT_NEAR(mesh::quality(box).min_scaled_jacobian, 1, 1e-9);
    EXPECT_NEAR(mesh::measure(box, mesh::Measure::plain), 12, 1e-12);
    EXPECT_EQ(boundary_count(box, {"lower", "right", "upper", "left", "near", "far"}), std::size_t{10 * 5 + 12});
    EXPECT_EQ(box.facet_sets.at("near"), box.facet_sets.at("low"));
    for (const mesh::Facet& facet : box.facet_sets.at("near"))
        for (const mesh::Index n : facet_nodes(box, facet)) EXPECT_EQ(box.point(n)[1], 0);
    for (const mesh::Facet& facet : box.facet_sets.at("upper"))
        for (const mesh::Index n : facet_nodes(box, facet)) EXPECT_EQ(box.point(n)[2], 1);
}

TEST(Extrude, AlongZKeepsXAndYAndTheOrientation) {
    const mesh::Mesh box = extrude(bar(2), {4, 5, {"near"}, {"far"}, Extrusion::Along::z});
    EXPECT_NEAR(mesh::quality(box).min_scaled_jacobian, 1, 1e-9);
    EXPECT_NEAR(mesh::measure(box, mesh::Measure::plain), 12, 1e-12);
    EXPECT_EQ(boundary_count(box, {"lower", "right", "upper", "left", "near", "far"}), std::size_t{10 * 5 + 12});
    for (const mesh::Facet& facet : box.facet_sets.at("near"))
        for (const mesh::Index n : facet_nodes(box, facet)) EXPECT_EQ(box.point(n)[2], 0);
    for (const mesh::Facet& facet : box.facet_sets.at("far"))
        for (const mesh::Index n : facet_nodes(box, facet)) EXPECT_EQ(box.point(n)[2], 4);
    for (const mesh::Facet& facet : box.facet_sets.at("upper"))
        for (const mesh::Index n : facet_nodes(box, facet)) EXPECT_EQ(box.point(n)[1], 3);
}

TEST(FacetsOnPlane, FindsInnerPlanesOfAFullTurn) {
    const mesh::Mesh disc = revolve(bar(0), Turn::full, Sectors::even(4));
    const auto plane = facets_on_plane(disc, 1);
    EXPECT_EQ(plane.size(), std::size_t{2 * 2 * 6});  // both halves of the section, from both sides
    for (const mesh::Facet& facet : plane)
        for (const mesh::Index n : facet_nodes(disc, facet)) EXPECT_EQ(disc.point(n)[1], 0);
}

}  // namespace
}  // namespace soft::meshing
