#pragma once
/// The rubbers of a case, checked against what the elements can run. Tested by assembly/system_test.
#include "model/rubber.hpp"

namespace soft::assembly {

using material::AnyRubber;

/// Throws Error (bad_input, place materials/<region>/<constant>) for an unknown law, a missing constant, one outside its
/// range, or a law that cannot be run in the case's formulation.
[[nodiscard]] AnyRubber make_rubber(const model::Material& material, model::Formulation formulation);

}  // namespace soft::assembly
