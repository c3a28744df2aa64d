#pragma once
/// The groups /path (rows of the equilibrium path as columns, and its end) and /modes. Internal to the module.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/hdf5_read.hpp"
#include "model/case.hpp"
#include "model/path.hpp"

namespace soft::io {

/// A value of a row that is not valid, by its column in /path.
struct RowProblem {
    std::string column, text;
};
/// The first problem of a row: its values are finite and in their ranges, match the case (stage, lists per load, cavity and output, time
/// in a dynamic case) and the row before it (nullptr: none).
[[nodiscard]] std::optional<RowProblem> problem_of(const model::Step& step, const model::Step* before,
                                                   const model::Case& model);

/// Columns whose value is missing in some row are not written.
void write_steps(hid_t path, std::span<const model::Step> steps, const model::Case& model);
/// Throws Error (bad_input) for a row with a problem.
[[nodiscard]] std::vector<model::Step> read_steps(const GroupReader& path, const model::Case& model);

/// `steps`: number of rows of the path, for checking limit points and bifurcations.
void write_end(hid_t path, const model::PathEnd& end, const model::Case& model, std::size_t steps);
[[nodiscard]] model::PathEnd read_end(const GroupReader& path, const model::Case& model, std::size_t steps);

/// The modes of the bifurcations that have one; the group is absent if none has.
void write_modes(hid_t root, const model::PathEnd& end, std::size_t points);
void read_modes(const GroupReader& root, model::PathEnd& end, std::size_t points);

}  // namespace soft::io
