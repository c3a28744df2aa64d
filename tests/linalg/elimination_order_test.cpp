// Reference: symbolic elimination, entry by entry (George and Liu, Computer Solution of Large Sparse Positive Definite Systems (1981)
// 5.1).
#include "linalg/elimination_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

namespace soft::linalg {
namespace {

using Order = std::vector<PetscInt>;

/// A square of `side` x `side` nodes, each coupled with its eight neighbours, with `per_node` unknowns per node.
struct Square {
    std::vector<PetscInt> begin{0}, columns;

    Square(int side, int per_node) {
        for (int node = 0; node < side * side; ++node)
            for (int unknown = 0; unknown < per_node; ++unknown) {
                for (int y = std::max(node / side - 1, 0); y <= std::min(node / side + 1, side - 1); ++y)
                    for (int x = std::max(node % side - 1, 0); x <= std::min(node % side + 1, side - 1); ++x)
                        for (int other = 0; other < per_node; ++other)
                            columns.push_back((y * side + x) * per_node + other);
                begin.push_back(static_cast<PetscInt>(columns.size()));
            }
    }
    [[nodiscard]] MatrixRows rows() const {
        return {static_cast<PetscInt>(begin.size()) - 1, begin.data(), columns.data(), nullptr};
    }
};

/// Number of entries of the factor below the diagonal.
std::size_t entries_of_factor(const MatrixRows& rows, const Order& positions) {
    std::vector<std::set<PetscInt>> below(positions.size());  // by position
    for (PetscInt row = 0; row < rows.count; ++row)
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k) {
            const PetscInt a = positions[static_cast<std::size_t>(row)],
                           b = positions[static_cast<std::size_t>(rows.columns[k])];
            if (b > a) below[static_cast<std::size_t>(a)].insert(b);
        }
    std::size_t entries = 0;
    for (auto& column : below) {
        entries += column.size();
        if (column.empty()) continue;
        const PetscInt parent = *column.begin();
        column.erase(parent);
        below[static_cast<std::size_t>(parent)].merge(column);
    }
    return entries;
}

Order natural(PetscInt count) {
    Order positions(static_cast<std::size_t>(count));
    std::iota(positions.begin(), positions.end(), 0);
    return positions;
}

TEST(EliminationOrder, IsAPermutationThatKeepsTheSharedUnknownsLast) {
    const Square square(9, 2);
    for (const PetscInt interior : {PetscInt{1}, PetscInt{100}, square.rows().count}) {
        Order positions = elimination_order(square.rows(), interior);
        for (PetscInt i = interior; i < square.rows().count; ++i) EXPECT_EQ(positions[static_cast<std::size_t>(i)], i);
        std::ranges::sort(positions);
        EXPECT_EQ(positions, natural(square.rows().count));
    }
}

TEST(EliminationOrder, KeepsTheUnknownsOfANodeTogether) {
    constexpr int per_node = 3;
    const Square square(12, per_node);
    const Order positions = elimination_order(square.rows(), square.rows().count);
    for (std::size_t first = 0; first < positions.size(); first += per_node)
        for (std::size_t i = 1; i < per_node; ++i)
            EXPECT_EQ(positions[first + i], positions[first] + static_cast<PetscInt>(i));
}

// The bound is that of nested dissection by lines, 31/4 n^2 log2 n of an n x n square with nine-point couplings (George, SIAM J.
// Numer. Anal. 10 (1973) 345); a band has n^3.
TEST(EliminationOrder, FillsNoMoreThanDissectionByLines) {
    for (const int side : {64, 96}) {
        const Square square(side, 1);
        const auto rows = square.rows();
        const double bound = 31.0 / 4 * side * side * std::log2(side);
        EXPECT_GT(static_cast<double>(entries_of_factor(rows, natural(rows.count))), bound);
        EXPECT_LT(static_cast<double>(entries_of_factor(rows, elimination_order(rows, rows.count))), bound);
    }
}

/// The graph of `cells` x `cells` squares of second order: vertices, edges and a centre, all of which couple within a cell.
struct SecondOrder {
    std::vector<PetscInt> begin{0}, columns;

    explicit SecondOrder(int cells) {
        const int side = 2 * cells + 1;
        const auto low = [](int i) { return std::max(0, i % 2 == 0 ? i - 2 : i - 1); };
        const auto high = [side](int i) { return std::min(side - 1, i % 2 == 0 ? i + 2 : i + 1); };
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                for (int j = low(y); j <= high(y); ++j)
                    for (int i = low(x); i <= high(x); ++i) columns.push_back(j * side + i);
                begin.push_back(static_cast<PetscInt>(columns.size()));
            }
    }
    [[nodiscard]] MatrixRows rows() const {
        return {static_cast<PetscInt>(begin.size()) - 1, begin.data(), columns.data(), nullptr};
    }
};

// The bound of the test above, for the (2 cells)^2 points; the centres, which four vertices and four edges dominate, are left out of the
// dissection.
TEST(EliminationOrder, FillsNoMoreWithCellsOfSecondOrder) {
    constexpr int cells = 40, side = 2 * cells + 1;
    const SecondOrder mesh(cells);
    const auto rows = mesh.rows();
    const Order positions = elimination_order(rows, rows.count);
    EXPECT_LT(static_cast<double>(entries_of_factor(rows, positions)), 31.0 / 4 * side * side * std::log2(side));
}

TEST(EliminationOrder, KeepsTheLastGroupsLast) {
    const SecondOrder mesh(6);
    const GroupGraph graph(mesh.rows(), mesh.rows().count);
    const std::vector<int> last{graph.group_of(40), graph.group_of(14)};
    auto order = elimination_order(graph, last);
    EXPECT_TRUE(std::equal(last.begin(), last.end(), order.end() - 2));
    std::ranges::sort(order);
    EXPECT_EQ(order, natural(static_cast<PetscInt>(graph.size())));
}

}  // namespace
}  // namespace soft::linalg
