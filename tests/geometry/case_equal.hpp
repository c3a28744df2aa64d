#pragma once
/// Equality of cases, with one expectation per field.
#include "model/case.hpp"

namespace soft::geometry::sample {

void expect_equal(const model::Case& left, const model::Case& right);

}  // namespace soft::geometry::sample
