#pragma once
/// The same least-squares problem with far fewer rows, for laws whose stress is smooth in the stretch wherever the search
/// goes (ogden: sums of powers, no pole). Over a test a part is the polynomial through its values at Chebyshev points in
/// ln l to better than 1e-12 of its largest value (l^12 over a factor of 19 in stretch: error of order (a/2)^n/n!, a = 18),
/// so all rows are a matrix times those values, and its QR leaves a triangle. Minima are those of all rows; the sum of
/// squares lacks a constant. Private to the module. Source: Trefethen, Approximation Theory (2013), 5 and 8.
/// Tested by fit/condensed_test.
#include "fit/separable.hpp"

namespace soft::fit {

/// Unchanged where it would not be half as long.
[[nodiscard]] Rows condensed(const Rows& rows);

}  // namespace soft::fit
