#include <gtest/gtest.h>

#include <cmath>

#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"
#include "mesh/raise_order.hpp"
#include "mesh/refine.hpp"
#include "pieces.hpp"

namespace soft::mesh {
namespace {

struct Choice {
    std::string name;
    int order;
    bool operator==(const Choice&) const = default;
};
void PrintTo(const Choice& choice, std::ostream* out) { *out << choice.name << choice.order; }

class Refinement : public testing::TestWithParam<Choice> {
protected:
    static Mesh straight_mesh(const Choice& choice) {
        const Mesh first = choice.name == "plane"    ? sample::triangles_and_quadrilaterals()
                           : choice.name == "wedges" ? sample::wedges_and_hexahedra()
                                                     : sample::tetrahedra();
        return choice.order == 1 ? first : raise_order(first);
    }
    static Mesh moved(Mesh mesh) {
        for (Point& p : mesh.points) p = mesh.dimension == 2 ? sample::bent_in_plane(p) : sample::bent(p);
        return mesh;
    }
    const Mesh straight = straight_mesh(GetParam());
    const Mesh coarse = moved(straight);
    const Mesh fine = refine(coarse, 1);
};

TEST_P(Refinement, KeepsTheVolumeAndHasPositiveJacobians) {
    EXPECT_EQ(fine.cell_count(), coarse.cell_count() << coarse.dimension);
    EXPECT_NEAR(measure(fine, Measure::plain) / measure(coarse, Measure::plain), 1, 1e-13);
    EXPECT_NEAR(measure(refine(fine, 1), Measure::plain) / measure(coarse, Measure::plain), 1, 1e-13);
    EXPECT_GT(quality(fine).min_scaled_jacobian, quality(coarse).min_scaled_jacobian - 1e-12);
}

TEST_P(Refinement, IsConforming) {
    sample::expect_conforming(fine);
    EXPECT_EQ(boundary_facets(fine).size(), boundary_facets(coarse).size() << (coarse.dimension - 1));
}

TEST_P(Refinement, FacetSetsCoverTheRefinedBoundary) {
    std::vector<Facet> named;
    for (const auto& [name, facets] : fine.facet_sets) {
        EXPECT_EQ(facets.size(), coarse.facet_sets.at(name).size() << (coarse.dimension - 1));
        named.insert(named.end(), facets.begin(), facets.end());
    }
    std::sort(named.begin(), named.end());
    EXPECT_EQ(named, boundary_facets(fine));
    for (const auto& [name, facets] : coarse.facet_sets) {
        const auto before = sample::vector_area(coarse, facets),
                   after = sample::vector_area(fine, fine.facet_sets.at(name));
        for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(before[d], after[d], 1e-13) << name;
    }
}

TEST_P(Refinement, KeepsPointsAndRegions) {
    EXPECT_TRUE(std::equal(coarse.points.begin(), coarse.points.end(), fine.points.begin()));
    EXPECT_EQ(fine.point_sets, coarse.point_sets);
    for (Index c = 0; c < fine.cell_count(); ++c)
        EXPECT_EQ(fine.cell_regions[static_cast<std::size_t>(c)],
                  coarse.cell_regions[static_cast<std::size_t>(c >> coarse.dimension)]);
}

/// Second-order cells represent a quadratic map exactly, so every new node must lie on it.
TEST_P(Refinement, NewNodesLieOnAQuadraticMap) {
    if (GetParam().order == 1) return;
    const Mesh undistorted = refine(straight, 2), finer = refine(coarse, 2);
    ASSERT_EQ(undistorted.points.size(), finer.points.size());
    for (std::size_t p = 0; p < undistorted.points.size(); ++p) {
        const Point expected =
            coarse.dimension == 2 ? sample::bent_in_plane(undistorted.points[p]) : sample::bent(undistorted.points[p]);
        for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(finer.points[p][d], expected[d], 1e-14);
    }
}

/// Curve::circle changes the positions of the new nodes but not the connectivity.
TEST_P(Refinement, AlongCirclesHasTheSameConnectivityAndSimilarPositions) {
    const Mesh round = refine(coarse, 2, Curve::circle), expected = refine(coarse, 2);
    sample::expect_conforming(round);
    EXPECT_EQ(round.connectivity, expected.connectivity);
    EXPECT_EQ(round.facet_sets, expected.facet_sets);
    EXPECT_GT(quality(round).min_scaled_jacobian, 0.9 * quality(expected).min_scaled_jacobian);
    for (std::size_t p = 0; p < round.points.size(); ++p)
        for (std::size_t d = 0; d < 3; ++d)
            EXPECT_NEAR(round.points[p][d], expected.points[p][d], GetParam().order == 1 ? 0 : 2e-3);
}

TEST_P(Refinement, ProlongsFieldsOfTheCoarseSpaceExactly) {
    const auto field = [](const Point& p, int order) {
        const double linear = 1 + p[0] - 2 * p[1] + 0.5 * p[2];
        return std::array<double, 2>{linear, order == 1 ? 3 * linear : linear * linear + p[0] * p[1]};
    };
    const auto nodal = [&](const Mesh& mesh) {
        std::vector<double> values;
        for (const Point& p : mesh.points)
            for (const double value : field(p, GetParam().order)) values.push_back(value);
        return values;
    };
    const Refined refined = refine_once(straight, Curve::parabola);
    const std::vector<double> carried = prolong(refined, nodal(straight), 2), expected = nodal(refined.mesh);
    ASSERT_EQ(carried.size(), expected.size());
    for (std::size_t i = 0; i < carried.size(); ++i) EXPECT_NEAR(carried[i], expected[i], 1e-14);
    const std::vector<double> start = nodal(straight);
    EXPECT_TRUE(std::equal(start.begin(), start.end(), carried.begin()));
    EXPECT_THROW((void)prolong(refined, std::vector<double>(3), 2), std::logic_error);
}

/// The position as a nodal field is in the coarse space, so its prolongation must equal the positions of the refined mesh.
TEST_P(Refinement, ProlongsPositionsToThePositionsOfTheRefinedMesh) {
    const Refined refined = refine_once(coarse, Curve::parabola);
    std::vector<double> positions;
    for (const Point& p : coarse.points) positions.insert(positions.end(), p.begin(), p.end());
    const std::vector<double> carried = prolong(refined, positions, 3);
    for (std::size_t p = 0; p < refined.mesh.points.size(); ++p)
        for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(carried[3 * p + d], refined.mesh.points[p][d], 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Mesh, Refinement,
                         testing::Values(Choice{"plane", 1}, Choice{"plane", 2}, Choice{"wedges", 1},
                                         Choice{"wedges", 2}, Choice{"tetrahedra", 1}, Choice{"tetrahedra", 2}),
                         [](const auto& test) { return test.param.name + std::to_string(test.param.order); });

/// Sorted edge lengths scaled by the refinement level: equal for similar tetrahedra (mirror images included).
std::vector<long> shape_of(const Mesh& mesh, Index cell, int times) {
    std::vector<long> lengths;
    const auto nodes = mesh.cell_nodes(cell);
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = a + 1; b < 4; ++b) {
            double square = 0;
            for (std::size_t d = 0; d < 3; ++d)
                square += std::pow(mesh.point(nodes[a])[d] - mesh.point(nodes[b])[d], 2);
            lengths.push_back(std::lround(1e9 * square * std::pow(4.0, times)));
        }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

TEST(Refine, ProducesAtMostThreeSimilarityClassesPerTetrahedron) {
    Mesh tet = sample::reference_cell(CellType::tet4);
    tet.points = {{0, 0, 0}, {1.1, 0.1, 0}, {0.3, 0.9, 0.2}, {0.2, 0.4, 1.3}};
    std::set<std::vector<long>> shapes;
    for (int times = 0; times <= 4; ++times) {
        const Mesh fine = refine(tet, times);
        for (Index c = 0; c < fine.cell_count(); ++c) shapes.insert(shape_of(fine, c, times));
    }
    EXPECT_LE(shapes.size(), 3u);
    EXPECT_GT(shapes.size(), 1u);
}

TEST(Refine, HalvesLines) {
    const Mesh line = refine(sample::row_of(CellType::line3, 1), 2);
    EXPECT_EQ(line.cell_count(), 4);
    EXPECT_EQ(line.points.size(), 9u);
    EXPECT_NEAR(measure(line, Measure::plain), 2, 1e-14);
}

TEST(Refine, ZeroTimesChangesNothing) {
    const Mesh mesh = sample::tetrahedra();
    EXPECT_EQ(refine(mesh, 0).connectivity, mesh.connectivity);
}

}  // namespace
}  // namespace soft::mesh
