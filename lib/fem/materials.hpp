#pragma once
/// The rubbers of a case, checked against the formulation of the elements. Tested by fem/system_test.
#include "model/rubber.hpp"

namespace soft::fem {

using material::AnyRubber;

/// Throws Error (bad_input, location materials/<region>/<constant>) for an unknown law, a missing constant, one outside its
/// range, or a law that the case's formulation does not support.
[[nodiscard]] AnyRubber make_rubber(const model::Material& material, model::Formulation formulation);

}  // namespace soft::fem
