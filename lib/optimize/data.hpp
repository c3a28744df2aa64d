#pragma once
/// The rows of the measured curves of a goal as conditions: one for each row and measured quantity other than `at`, with the standard
/// deviation `within` times the largest value of the quantity. `at` is the load unless it is given, or the time if the file has it; where
/// the load has an extremum in the file, the first output that has none. A load that the design states over time is not compared. Rows with
/// `at` outside `from` to `to`, and rows at which all quantities are 0 (the undeformed state, which every design has), are left out.
/// Columns are found as by `postprocess --compare` (post/measured.hpp).
/// Tested by optimize/data_test and pipeline/calibration.
#include <span>

#include "core/table.hpp"
#include "optimize/trial.hpp"
#include "post/curve.hpp"

namespace soft::optimize {

/// `bases`: one for each run. Throws Error (bad_input) for a file that cannot be read, columns that are not found, and a curve without rows
/// in its range.
void add_data(Goal& goal, std::span<const Base> bases);

/// Whether the design states the load at each time; else it follows from the design.
enum class LoadIs { found, stated };

/// The same for one curve, with the columns of its design.
void add_rows(Goal& goal, std::size_t curve, const core::Table& table, const post::Curve& columns,
              LoadIs load = LoadIs::found);

}  // namespace soft::optimize
