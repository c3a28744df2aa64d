#pragma once
/// Elimination order of a direct solver. Internal to the module. Tested by linalg/elimination_order_test.
#include <vector>

#include "linalg/matrix_rows.hpp"

namespace soft::linalg {

/// Returns position[unknown], from 0, by nested dissection (METIS, through CHOLMOD) of the unknowns before `interior`. The other
/// unknowns come last, in ascending order. Unknowns with the same columns, such as those of a node, stay together: the graph of these
/// groups gives an equally good order and is several times smaller. The order depends on the pattern only. The pattern must be
/// symmetric, and each row must contain its diagonal.
[[nodiscard]] std::vector<PetscInt> elimination_order(const MatrixRows& rows, PetscInt interior);

}  // namespace soft::linalg
