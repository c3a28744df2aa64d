#pragma once
/// The derivatives of the outputs of a sweep by the numbers of the design under `sensitivity`. Tested by sweep/derivatives_test and
/// pipeline/sweep_sensitivity.
///
/// Quantities with derivatives are the load and the outputs of the design (post/point_sensitivity.hpp). The quantity of the point is
/// held: at `elongation=40mm` the elongation, at `pressure=20kPa` the load. At `end` that is the quantity whose goal ended the path; a
/// path that ended early or at a volume has none. At `limit` only the load has a derivative, that of the limit load.
#include <span>

#include "model/case.hpp"
#include "model/path.hpp"
#include "sweep/outcome.hpp"

namespace soft::sweep {

struct SolvedPath {
    const model::Case& model;
    std::span<const model::Step> steps;
    const model::PathEnd& end;
};

/// The derivatives of each requested output at each point. A cell is named like "pressure_by_geometry_wall_kPa_per_mm_at_end". `missing`: a
/// reason for each point without derivatives that the path reaches. Throws as outputs_of.
[[nodiscard]] Outputs derivatives_of(const Sweep& sweep, const post::Curve& curve, const SolvedPath& path);

/// Checks that curves with these columns have derivatives. Errors (bad_input, with the location in the sweep file): a point at a quantity
/// without derivatives; no output that has any.
void check_derivatives(const Sweep& sweep, const post::Curve& curve);

/// The keys under `sensitivity` among the numbers of a design, separated by commas; all of them for `all`.
[[nodiscard]] std::string sensitivity_keys(const Sweep& sweep, std::span<const model::DesignParameter> parameters);

}  // namespace soft::sweep
