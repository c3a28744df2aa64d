#pragma once
/// Derivatives of a row by the numbers of a design, where it has them, and along the path. Tested by post/point_sensitivity_test.
#include <functional>
#include <span>

#include "post/curve.hpp"

namespace soft::post {

/// A value that depends on the derivatives of a row. A bifurcation has none (model::no_derivative): linear between the rows before and
/// after, by the first output.
[[nodiscard]] double with_derivatives(std::span<const model::Step> steps, std::size_t row,
                                      const std::function<double(std::size_t)>& value);

/// d of / d by along the path, SI; where one of the columns has no slopes, from the neighbouring rows. 0 where `by` does not change.
[[nodiscard]] double slope_ratio(const Column& of, const Column& by, std::size_t row);

}  // namespace soft::post
