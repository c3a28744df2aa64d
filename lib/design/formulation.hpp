#pragma once
/// Checks that the formulation is compatible with order, cells and compressibility. Private to the module. Tested by
/// design/formulation_test. fem/reference_cell checks the formulation against the cell types of the mesh.
#include "design/design.hpp"

namespace soft::design {

/// Throws Error(bad_input) for: mixed with first-order cells (no inf-sup stable pair of displacement and pressure); f-bar with
/// second-order cells, simplices or an incompressible material; displacement with an incompressible material. Each error names an
/// alternative.
void check_formulation(const Values& values);

}  // namespace soft::design
