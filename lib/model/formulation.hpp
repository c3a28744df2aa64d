#pragma once
/// Which cell types each element formulation supports (fem/reference_cell.hpp): mixed needs second-order cells, F-bar first-order
/// quadrilaterals or hexahedra. Tested by fem/matrix_test.
#include <string>

#include "material/form.hpp"
#include "mesh/cell_type.hpp"

namespace soft::model {

/// Why a cell type cannot be used in a formulation, with a remedy ("problem; remedy"); empty if it can.
[[nodiscard]] std::string explain_incompatibility(mesh::CellType type, material::Form form);

}  // namespace soft::model
