#pragma once
/// Which formulation goes with which order, cells and compressibility. Private to the module.
/// Tested by design/formulation_test. What the cells of the finished mesh allow is checked in element/reference_cell (why_not).
#include "design/design.hpp"

namespace soft::design {

/// Error(bad_input) for: mixed of first order (no stable pair of displacement and pressure); f-bar of second order, on
/// simplices or incompressible; displacement with an incompressible rubber. Each with a choice that works.
void check_formulation(const Values& values);

}  // namespace soft::design
