#pragma once
/// The order in which a direct solver eliminates unknowns. Internal to the module. Tested by linalg/elimination_order_test.
#include <vector>

#include "linalg/matrix_rows.hpp"

namespace soft::linalg {

/// place[unknown], from 0, by nested dissection (METIS, through CHOLMOD) of the unknowns before `interior`; the others come last, in
/// ascending order. Unknowns with the same columns, as those of a node, stay together: the graph is that of such groups, which is
/// as good and several times smaller. Rows hold their diagonal; the pattern, from which alone the order follows, is symmetric.
[[nodiscard]] std::vector<PetscInt> elimination_order(const MatrixRows& rows, PetscInt interior);

}  // namespace soft::linalg
