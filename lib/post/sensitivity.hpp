#pragma once
/// Sensitivities of a curve to numbers of its design, from the derivatives that solve records (solver/sensitivities.hpp).
/// Columns on demand of the curve: `stiffness`, the slope of the leading load over the first output along the path, and
/// `<load>_by_<key>`, the derivative A of the leading load by the number at a fixed first output. The derivative of the output at a fixed
/// load is -A / stiffness. Both columns are smooth across limit points, where A is the derivative of the limit load. Where the load is held
/// (`load_is_held`, model::holds_load), A is 0 and the derivative of the output, at the same progress of the loads, is `<first output>_by_<key>`.
/// On a path in time all derivatives are at a fixed time: `<load>_by_<key>` and `<first output>_by_<key>`, without a stiffness.
/// Band of deviations of the numbers with the covariance C, as half widths of the load at a fixed first output:
///   root of squares  sqrt(sum_kl A_k A_l C_kl),      worst case  sum |A_k| sqrt(C_kk)
/// and of that output at a fixed load, the first over the stiffness; in time of both at a fixed time. Tolerances are independent: C_kk = t_k^2.
/// Tested by post/sensitivity_test, pipeline/sensitivities and pipeline/fit_errors.
#include <span>
#include <string>
#include <vector>

#include "post/curve.hpp"
#include "post/gnuplot.hpp"

namespace soft::post {

/// The table in long form: one line for each row of `table` and each parameter of the case:
///   step,<load>,<first output>,parameter,value,unit,d_load,d_output,d_load_percent,d_output_percent      (in time step,time_s,...)
/// derivatives in the units of the columns per `unit`, and in percent per percent. A cell is empty where the derivative does not exist:
/// d_output at the rows `limit_rows`, percentages of 0.
[[nodiscard]] std::string sensitivity_csv(const Curve& table, const model::Case& model,
                                          std::span<const int> limit_rows);

/// The gnuplot script of a bar chart: d_load_percent of each parameter at the last row of `table`, in time and where the load is held
/// d_output_percent, the largest first. Throws Error (bad_input) where that load or output is 0.
[[nodiscard]] std::string sensitivity_script(const Curve& table, const model::Case& model, PictureFormat format);

/// Deviations of numbers of the made part from those of the design.
struct Deviations {
    std::vector<std::size_t> parameters;  ///< indices in Case::parameters
    std::vector<double> covariance;       ///< by rows, SI

    /// Adds others, which are independent of these.
    void add(const Deviations& others);
};
/// "geometry.wall=0.1mm", "material.mu=5%" (of the value). Throws Error (usage) for a number without sensitivity.
[[nodiscard]] Deviations parse_tolerances(std::span<const std::string> texts, const model::Case& model);

/// Adds the columns band_rss_<load>, band_worst_<load> and band_rss_<first output>. Returns the number that contributes most at the last row.
std::string add_tolerance_band(Curve& curve, const model::Case& model, const Deviations& deviations);

}  // namespace soft::post
