#pragma once
/// The same least-squares problem with far fewer rows, for laws whose stress is smooth in the stretch for all searched shapes
/// (ogden: sums of powers, no pole). Over one test a part equals the polynomial through its values at Chebyshev points in ln l to
/// better than 1e-12 of its largest value (l^12 over a factor of 19 in stretch: error of order (a/2)^n/n!, a = 18). All rows are
/// therefore a matrix times these values, and the QR of this matrix leaves a triangle. The minimisers equal those of the full
/// problem; the sum of squares differs by a constant. Private to the module. Source: Trefethen, Approximation Theory (2013), 5 and 8.
/// Tested by fit/condensed_test.
#include "fit/separable.hpp"

namespace soft::fit {

/// Returns the rows unchanged if condensation would not halve their number.
[[nodiscard]] Rows condensed(const Rows& rows);

}  // namespace soft::fit
