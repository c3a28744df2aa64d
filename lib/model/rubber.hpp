#pragma once
/// From a case's material (law name and constants) to the law itself. Tested by assembly/system_test, design/material_test.
#include "material/catalogue.hpp"
#include "model/case.hpp"

namespace soft::model {

/// Errors of material::make_rubber: bad_input, with the constant's name as place; "strain" for a rubber without a linear form.
[[nodiscard]] material::AnyRubber make_rubber(const Material& material);

/// Why a case of these kinematics and cuts cannot show what the material does ("problem; remedy"); empty where it can. A
/// single family of fibres about the axis twists a body of revolution: a section has no twist, a half no mirror.
[[nodiscard]] std::string why_not(const Material& material, Kinematics kinematics,
                                  const std::array<bool, 3>& symmetry_planes);

}  // namespace soft::model
