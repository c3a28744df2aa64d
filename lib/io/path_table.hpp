#pragma once
/// /path: the rows of the equilibrium path as columns, its end, and /modes. Internal to the module.
#include <span>
#include <vector>

#include "io/hdf5_read.hpp"
#include "model/case.hpp"
#include "solution/path.hpp"

namespace soft::io {

/// Throws Error (internal) unless the step fits the case (its stage exists, one value for each output, and for each load
/// and cavity where there are several, a time and energies just where it is dynamic) and has only finite values.
void require_sound(const solution::Step& step, const model::Case& model);

/// Volumes are written if the first step has one.
void write_steps(hid_t path, std::span<const solution::Step> steps, const model::Case& model);
[[nodiscard]] std::vector<solution::Step> read_steps(const GroupReader& path, const model::Case& model);

/// `steps`: rows of the path, to check limit points and bifurcations against.
void write_end(hid_t path, const solution::PathEnd& end, const model::Case& model, std::size_t steps);
[[nodiscard]] solution::PathEnd read_end(const GroupReader& path, const model::Case& model, std::size_t steps);

/// The modes of the bifurcations that have one; the group is absent where none has.
void write_modes(hid_t root, const solution::PathEnd& end, std::size_t points);
void read_modes(const GroupReader& root, solution::PathEnd& end, std::size_t points);

}  // namespace soft::io
