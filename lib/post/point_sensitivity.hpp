#pragma once
/// Derivatives of the load and of all outputs by the numbers of the design, at a fixed value of any one of these quantities.
/// Quantity 0 is the leading load, quantity 1 + i the output i. With the derivatives D at a fixed first output and the slopes s over the
/// first output along the path,
///   dq/dtheta at a fixed h = D_q - s_q D_h / s_h          (theory manual, 6.10).
/// Where the load is held (model::holds_load), its value fixes no point of the path: then the derivative at a fixed load is that at the same
/// progress of the loads, D_q + s_q D_1 with that of the first output, D_1.
/// On a path in time D is the derivative at a fixed time, and nothing else is held.
/// D and s are smooth along the path, so they are interpolated as columns of the curve. Tested by post/point_sensitivity_test and
/// pipeline/sweep_sensitivity.
#include <cstddef>
#include <span>

#include "post/curve.hpp"

namespace soft::post {

/// The columns that add_sensitivity_columns appends to a curve: the slopes, and for each number of the design its D and D_1.
struct SensitivityColumns {
    std::size_t first = 0;       ///< index of the first one
    std::size_t quantities = 0;  ///< 0: the steps have no derivatives
    bool in_time = false;
};

/// Appends the columns, in SI units, with the role of dependent columns. Rows without derivatives (bifurcations) are interpolated.
SensitivityColumns add_sensitivity_columns(Curve& curve, const model::Case& model, std::span<const model::Step> steps);

struct Sensitivity {
    std::size_t quantity = 0;   ///< that is differentiated
    std::size_t held = 0;       ///< quantity with a fixed value; in time ignored
    std::size_t parameter = 0;  ///< index in Case::parameters
};

/// The derivative [SI] at a row of all columns, for example of rows_at. Not finite where the held quantity has an extremum.
[[nodiscard]] double sensitivity_at(std::span<const double> row, const SensitivityColumns& columns,
                                    const Sensitivity& which);

}  // namespace soft::post
