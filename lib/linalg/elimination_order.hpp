#pragma once
/// Elimination order of a direct solver. Internal to the module. Tested by linalg/elimination_order_test.
#include <span>
#include <vector>

#include "linalg/matrix_rows.hpp"

namespace soft::linalg {

/// The unknowns before `interior` in groups with the same columns, such as those of a node, and which groups couple: the graph of a matrix
/// with several times fewer vertices and many times fewer edges. The pattern must be symmetric, and each row must contain its diagonal.
class GroupGraph {
public:
    GroupGraph(const MatrixRows& rows, PetscInt interior);

    [[nodiscard]] std::size_t size() const { return unknowns_.size(); }
    [[nodiscard]] const std::vector<PetscInt>& unknowns(int group) const {
        return unknowns_[static_cast<std::size_t>(group)];
    }
    /// Sorted, without the group itself.
    [[nodiscard]] std::span<const int> neighbours(int group) const {
        const auto g = static_cast<std::size_t>(group);
        return {others_.data() + begin_[g], others_.data() + begin_[g + 1]};
    }
    [[nodiscard]] std::size_t couplings() const { return others_.size(); }
    [[nodiscard]] int group_of(PetscInt unknown) const { return group_of_[static_cast<std::size_t>(unknown)]; }

private:
    std::vector<int> group_of_;
    std::vector<std::vector<PetscInt>> unknowns_;
    std::vector<std::size_t> begin_{0};
    std::vector<int> others_;
};

/// The groups in elimination order, by nested dissection (METIS, through CHOLMOD). It depends on the pattern only. Groups on the faces
/// and inside of cells are left to the order of the others. The groups `last` are the last ones.
[[nodiscard]] std::vector<int> elimination_order(const GroupGraph& graph, const std::vector<int>& last = {});

/// Returns position[unknown], from 0. The unknowns from `interior` on come last, in ascending order.
[[nodiscard]] std::vector<PetscInt> elimination_order(const MatrixRows& rows, PetscInt interior);

}  // namespace soft::linalg
