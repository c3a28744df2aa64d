#include "meshing/box_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"

namespace soft::meshing {
namespace {

constexpr Spacing even{1, {1, 1, 1}, 1};
constexpr double sums = 1e-11;  // rounding, of volumes and areas up to 50

/// Distinct coordinates of the corner nodes along an axis.
std::vector<double> coordinates(const mesh::Mesh& mesh, std::size_t axis) {
    std::set<double> all;
    for (mesh::Index c = 0; c < mesh.cell_count(); ++c)
        for (const mesh::Index node : mesh.cell_nodes(c).first(8)) all.insert(mesh.point(node)[axis]);
    return {all.begin(), all.end()};
}

double area(const mesh::Mesh& mesh, const std::string& face) {
    double sum = 0;
    for (const mesh::Facet& facet : mesh.facet_sets.at(face))
        for (const mesh::QuadraturePoint& point : mesh::volume_rule(mesh::facet_type(mesh, facet))) {
            const auto n = mesh::facet_normal(mesh, facet, mesh::shape_values(mesh::facet_type(mesh, facet), point.xi));
            sum += point.weight * std::hypot(n[0], n[1], n[2]);
        }
    return sum;
}

/// A block of 4 x 2 x 2 with a step of 4 x 1 x 2 on its half y < 1: one re-entrant edge, along x at y = 1, z = 2.
BoxBody step() {
    BoxBody body;
    body.boxes = {{{0, 0, 0}, {4, 2, 2}, Fill::solid, "foot"}, {{0, 0, 2}, {4, 1, 4}, Fill::solid, "step"}};
    return body;
}

TEST(GradedShares, GrowGeometricallyFromTheSharpEnd) {
    const auto shares = graded_shares(3, 4, {true, false});
    EXPECT_NEAR(shares[0], 1.0 / 7, 1e-15);
    EXPECT_NEAR(shares[1], 2.0 / 7, 1e-15);
    EXPECT_NEAR(shares[2], 4.0 / 7, 1e-15);
    EXPECT_NEAR(graded_shares(3, 4, {false, true})[2], 1.0 / 7, 1e-15);
    const std::vector<double> both = graded_shares(5, 4, {true, true});
    for (const auto& [cell, share] : std::map<std::size_t, double>{{0, 0.1}, {1, 0.2}, {2, 0.4}, {3, 0.2}, {4, 0.1}})
        EXPECT_NEAR(both[cell], share, 1e-15);
    for (const double share : graded_shares(4, 9, {false, false})) EXPECT_EQ(share, 0.25);
    EXPECT_EQ(graded_shares(1, 9, {true, true}), std::vector<double>{1});
    EXPECT_EQ(graded_shares(2, 9, {true, true}), (std::vector<double>{0.5, 0.5}));
}

TEST(GrowingShares, BeginAtTheSharpEndsAndGrowUpToTheSize) {
    const Spacing spacing{4, {1, 1, 1}, 4, 2};  // 1, 2, 4, 4, ... from a sharp end
    const auto expect_lengths = [&](double length, SharpEnds sharp, const std::vector<double>& lengths) {
        const auto shares = growing_shares(length, 1, spacing, sharp);
        ASSERT_EQ(shares.size(), lengths.size()) << length;
        for (std::size_t i = 0; i < shares.size(); ++i) EXPECT_NEAR(length * shares[i], lengths[i], 1e-12) << length;
    };
    expect_lengths(11, {true, false}, {1, 2, 4, 4});
    expect_lengths(11, {false, true}, {4, 4, 2, 1});
    expect_lengths(14, {true, true}, {1, 2, 4, 4, 2, 1});
    expect_lengths(1, {true, true}, {1});
    expect_lengths(1.5, {true, true}, {0.75, 0.75});  // two of 1 are enough
    expect_lengths(12, {false, false}, {4, 4, 4});
    EXPECT_EQ(growing_shares(1, 3, spacing, {true, true}).size(), 3u);
    Spacing stretched{4, {1, 1, 1}, 4, 2, 1.5};
    EXPECT_EQ(growing_shares(1.5, 1, stretched, {true, true}).size(), 1u);
    EXPECT_EQ(growing_shares(1.6, 1, stretched, {true, true}).size(), 2u);
    stretched.one_sided_stretch = 2;
    EXPECT_EQ(growing_shares(2, 1, stretched, {true, false}).size(), 1u);
    EXPECT_EQ(growing_shares(2.1, 1, stretched, {false, true}).size(), 2u);
    EXPECT_EQ(growing_shares(2, 1, stretched, {true, true}).size(), 2u);
}

TEST(BoxGrid, CountsTheCellsOfGrowingLengths) {
    const Spacing spacing{1, {1, 1, 1}, 3, 2};
    EXPECT_EQ(cells_of_boxes(step(), spacing), static_cast<double>(mesh_of_boxes(step(), spacing).cell_count()));
}

TEST(BoxGrid, CellsGetShorterOnlyTowardReentrantEdges) {
    const mesh::Mesh mesh = mesh_of_boxes(step(), {1, {2, 2, 2}, 3});
    EXPECT_EQ(coordinates(mesh, 0), (std::vector<double>{0, 1, 2, 3, 4}));  // the edge runs along x: no grading
    const std::vector<double> y = coordinates(mesh, 1), z = coordinates(mesh, 2);
    ASSERT_EQ(y.size(), 5u);
    ASSERT_EQ(z.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(y[i], (std::vector<double>{0, 0.75, 1, 1.25, 2})[i], 1e-14);
        EXPECT_NEAR(z[i], (std::vector<double>{0, 1.5, 2, 2.5, 4})[i], 1e-14);
    }
}

TEST(BoxGrid, CellsGetShorterTowardAFixedFace) {
    BoxBody body{.boxes = {{{0, 0, 0}, {3, 1, 1}, Fill::solid, "bar"}}};
    body.borders[0][0] = {"fixed", true};
    const std::vector<double> x = coordinates(mesh_of_boxes(body, {1.5, {1, 1, 1}, 2}), 0);
    ASSERT_EQ(x.size(), 3u);
    EXPECT_NEAR(x[1], 1, 1e-15);
}

TEST(BoxGrid, RegionsAndFacesHaveTheNamesOfTheBoxes) {
    BoxBody body = step();
    body.boxes.push_back({{1, 0.5, 0.5}, {3, 1, 1.5}, Fill::hollow, "hole"});
    body.borders[2][0] = {"bottom"};
    const mesh::Mesh mesh = mesh_of_boxes(body, even);
    EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"foot", "step"}));
    EXPECT_NEAR(mesh::measure(mesh, mesh::Measure::plain), 16 + 8 - 1, sums);
    EXPECT_NEAR(area(mesh, "hole"), 2 * (2 * 0.5 + 2 * 1 + 0.5 * 1), sums);
    EXPECT_NEAR(area(mesh, "bottom"), 8, sums);
    EXPECT_NEAR(area(mesh, "outer"), 4 * 4 /* z */ - 8 + 4 * 4 * 2 /* y */ + 2 * (2 * 2 + 1 * 2) /* x */, sums);
    std::set<mesh::Facet> named;
    std::size_t sides = 0;
    for (const auto& [name, facets] : mesh.facet_sets) {
        named.insert(facets.begin(), facets.end());
        sides += facets.size();
    }
    const auto boundary = mesh::boundary_facets(mesh);
    EXPECT_EQ(named, std::set<mesh::Facet>(boundary.begin(), boundary.end()));
    EXPECT_EQ(sides, boundary.size());  // each facet has one name
}

/// Positions rounded to 1e-9: mid nodes are means, and the order of summation differs between the two halves.
using Cell = std::array<long, 3>;
Cell rounded(const mesh::Point& p) {
    return {std::lround(1e9 * p[0]), std::lround(1e9 * p[1]), std::lround(1e9 * p[2])};
}

TEST(BoxGrid, MirroredBodyIsTheOriginalAndItsMirrorImage) {
    BoxBody body = step();
    body.boxes.push_back({{1, 0, 0.5}, {3, 0.5, 1.5}, Fill::hollow, "hole"});  // reaches the symmetry plane
    body.borders[1][1] = {"far"};
    const mesh::Mesh half = mesh_of_boxes(body, {1, {2, 2, 2}, 3});
    body.extent = Extent::mirrored_in_y;
    const mesh::Mesh whole = mesh_of_boxes(body, {1, {2, 2, 2}, 3});
    EXPECT_EQ(whole.cell_count(), 2 * half.cell_count());
    EXPECT_EQ(cells_of_boxes(body, {1, {2, 2, 2}, 3}), static_cast<double>(whole.cell_count()));
    EXPECT_NEAR(mesh::measure(whole, mesh::Measure::plain), 2 * mesh::measure(half, mesh::Measure::plain), sums);
    EXPECT_NEAR(area(whole, "far"), 2 * area(half, "far"), sums);
    EXPECT_NEAR(area(whole, "hole"), 2 * area(half, "hole"), sums);
    std::set<Cell> positions;
    for (const mesh::Point& p : whole.points) positions.insert(rounded(p));
    EXPECT_EQ(positions.size(), whole.points.size());
    for (const mesh::Point& p : half.points) {
        EXPECT_TRUE(positions.contains(rounded(p)));
        EXPECT_TRUE(positions.contains(rounded({p[0], -p[1], p[2]})));
    }
    EXPECT_GT(mesh::quality(whole).min_scaled_jacobian, 0.999);
}

TEST(BoxGrid, PlanesWithinRoundingAreMerged) {
    BoxBody body = step();
    body.boxes[1].high[1] += 1e-15;
    body.boxes.push_back({{0, 0, 4}, {4, 1, 5}, Fill::solid, "step"});
    EXPECT_EQ(mesh_of_boxes(body, even).cell_count(), mesh_of_boxes(step(), even).cell_count() + 4);
}

TEST(BoxGrid, EmptyBodiesAndInvalidSymmetryPlanesThrow) {
    EXPECT_THROW((void)mesh_of_boxes({}, even), std::logic_error);
    BoxBody body = step();
    for (Box& box : body.boxes) box.low[1] += 0.5;
    body.extent = Extent::mirrored_in_y;
    EXPECT_THROW((void)mesh_of_boxes(body, even), std::logic_error);
}

}  // namespace
}  // namespace soft::meshing
