#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"
#include "mesh/split.hpp"
#include "pieces.hpp"

namespace soft::mesh {
namespace {

/// The same mesh with permuted node numbers, which changes the choice of diagonals.
Mesh renumbered(const Mesh& mesh, unsigned seed) {
    std::vector<Index> numbers(mesh.points.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    std::shuffle(numbers.begin(), numbers.end(), std::mt19937{seed});
    Mesh result = mesh;
    for (std::size_t n = 0; n < numbers.size(); ++n)
        result.points[static_cast<std::size_t>(numbers[n])] = mesh.points[n];
    for (Index& n : result.connectivity) n = numbers[static_cast<std::size_t>(n)];
    return result;
}

struct Expected {
    CellType type;
    Index pieces;                 ///< simplices per cell
    std::size_t boundary_of_two;  ///< boundary facets of a row of two cells
};

class EverySplit : public testing::TestWithParam<Expected> {};

TEST_P(EverySplit, IsConformingForEveryNumbering) {
    const Mesh row = sample::row_of(GetParam().type, 2);
    for (unsigned seed = 0; seed < 300; ++seed) {
        const Mesh mesh = renumbered(row, seed);
        const Mesh split = split_into_simplices(mesh);
        ASSERT_EQ(split.cell_count(), 2 * GetParam().pieces);
        sample::expect_conforming(split);
        EXPECT_EQ(boundary_facets(split).size(), GetParam().boundary_of_two);
        EXPECT_NEAR(quality(split).min_scaled_jacobian, 1, 1e-12);  // straight edges with mid nodes at their midpoints
        EXPECT_NEAR(measure(split, Measure::plain), measure(mesh, Measure::plain), 1e-12);
    }
}

TEST_P(EverySplit, KeepsEveryNodeInUse) {
    const Mesh split = split_into_simplices(sample::row_of(GetParam().type, 2));
    const std::set<Index> used(split.connectivity.begin(), split.connectivity.end());
    EXPECT_EQ(used.size(), split.points.size());
}

TEST_P(EverySplit, PreservesTheAreaOfFacetSets) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Mesh mesh = renumbered(sample::row_of(GetParam().type, 2), seed);
        for (const Facet& facet : boundary_facets(mesh))
            mesh.facet_sets[std::to_string(facet.cell) + "/" + std::to_string(facet.local)] = {facet};
        const Mesh split = split_into_simplices(mesh);
        for (const auto& [name, facets] : mesh.facet_sets) {
            const auto before = sample::vector_area(mesh, facets),
                       after = sample::vector_area(split, split.facet_sets.at(name));
            for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(before[d], after[d], 1e-13) << name;
        }
    }
}

// The two wedges of the row do not touch: 2 x 8 triangles.
INSTANTIATE_TEST_SUITE_P(Split, EverySplit,
                         testing::Values(Expected{CellType::hex27, 6, 20}, Expected{CellType::hex8, 6, 20},
                                         Expected{CellType::wedge18, 3, 16}, Expected{CellType::quad9, 2, 6}),
                         [](const auto& test) { return std::string{topology(test.param.type).name}; });

TEST(Split, LeavesSimplicesUnchanged) {
    const Mesh mesh = sample::reference_cell(CellType::tet10);
    const Mesh split = split_into_simplices(mesh);
    EXPECT_EQ(split.connectivity, mesh.connectivity);
}

}  // namespace
}  // namespace soft::mesh
