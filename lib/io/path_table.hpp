#pragma once
/// /path: the rows of the equilibrium path as columns. Internal to the room.
#include <span>
#include <string>
#include <vector>

#include "io/hdf5_read.hpp"
#include "solution/path.hpp"

namespace soft::io {

/// Throws Error (internal) unless the step has one value for each output and only finite values.
void require_sound(const solution::Step& step, std::size_t outputs);

/// `outputs`: names in the order of Step::outputs_m. Volumes are written if the first step has one.
void write_steps(hid_t path, std::span<const solution::Step> steps, const std::vector<std::string>& outputs);
[[nodiscard]] std::vector<solution::Step> read_steps(const GroupReader& path, const std::vector<std::string>& outputs);

/// `steps`: rows of the path, to check limit points against.
void write_end(hid_t path, const solution::PathEnd& end, const std::vector<std::string>& outputs, std::size_t steps);
[[nodiscard]] solution::PathEnd read_end(const GroupReader& path, const std::vector<std::string>& outputs,
                                         std::size_t steps);

}  // namespace soft::io
