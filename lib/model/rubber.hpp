#pragma once
/// From a case's material (law name and constants) to the law itself. Held by assembly/materials_test, design/material_test.
#include "material/catalogue.hpp"
#include "model/case.hpp"

namespace soft::model {

/// Errors of material::make_rubber: bad_input, with the constant's name as place.
[[nodiscard]] material::AnyRubber make_rubber(const Material& material);

}  // namespace soft::model
