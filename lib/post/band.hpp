#pragma once
/// The band on a curve that the errors of fitted constants make, as scripts/uncertainty writes it: a table of the curve's own
/// columns and of band_linear and band_sampled, half its width in the unit of the load: one standard deviation.
/// Held by post/band_test.
#include <string>
#include <vector>

#include "post/curve.hpp"
#include "post/measured.hpp"

namespace soft::post {

struct Band {
    Measured points;           ///< the load and what else the table has, a row a place
    std::size_t load = 0;      ///< column of the curve
    std::vector<double> half;  ///< of the load, in its unit: the sampled one where there is one
    bool sampled = false;
};

/// Errors (bad_input): a table without a band, or without the load and another quantity of the curve; a negative width.
[[nodiscard]] Band read_band(const table::Table& table, const Curve& curve);

}  // namespace soft::post
