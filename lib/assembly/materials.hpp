#pragma once
/// From a case's material (law name and constants) to the law the elements run. Held by assembly/materials_test.
#include "element/reference_cell.hpp"
#include "material/catalogue.hpp"
#include "model/case.hpp"

namespace soft::assembly {

using material::AnyRubber;

[[nodiscard]] material::Form form_of(model::Formulation formulation);

/// Throws Error (bad_input, place materials/<region>/<constant>) for an unknown law, a missing constant, one outside its
/// range, or a law that cannot be run in the case's formulation.
[[nodiscard]] AnyRubber make_rubber(const model::Material& material, model::Formulation formulation);

}  // namespace soft::assembly
