#pragma once
/// The contact of a row of a result: where the obstacles are, and the contact pressure (contact/potential.hpp).
/// Tested by post/contact_pressure_test.
#include <span>
#include <vector>

#include "model/case.hpp"
#include "model/path.hpp"
#include "post/step_fields.hpp"

namespace soft::post {

/// Displacement of each obstacle at a row.
[[nodiscard]] std::vector<Vector3> obstacle_shifts(const model::Case& model, std::span<const model::Step> steps,
                                                   std::size_t row);

/// Whether anything can touch in the case.
[[nodiscard]] bool has_contact(const model::Case& model);

/// Force per deformed area with which a surface is pressed on another or on an obstacle, [mesh point], positive; 0 inside and where
/// nothing touches.
[[nodiscard]] std::vector<double> contact_pressures_Pa(const model::Case& model, const NodalState& state);

}  // namespace soft::post
