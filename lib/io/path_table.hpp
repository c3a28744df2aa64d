#pragma once
/// The groups /path (rows of the equilibrium path as columns, and its end) and /modes. Internal to the module.
#include <span>
#include <vector>

#include "io/hdf5_read.hpp"
#include "model/case.hpp"
#include "model/path.hpp"

namespace soft::io {

/// Throws Error (internal) unless the step matches the case and has only finite values: its stage exists, it has one value per output
/// (and per load and cavity if there are several), and it has a time and energies of motion exactly if the case is dynamic.
void require_valid(const model::Step& step, const model::Case& model);

/// Volumes are written if the first step has a volume.
void write_steps(hid_t path, std::span<const model::Step> steps, const model::Case& model);
[[nodiscard]] std::vector<model::Step> read_steps(const GroupReader& path, const model::Case& model);

/// `steps`: number of rows of the path, for checking limit points and bifurcations.
void write_end(hid_t path, const model::PathEnd& end, const model::Case& model, std::size_t steps);
[[nodiscard]] model::PathEnd read_end(const GroupReader& path, const model::Case& model, std::size_t steps);

/// The modes of the bifurcations that have one; the group is absent if none has.
void write_modes(hid_t root, const model::PathEnd& end, std::size_t points);
void read_modes(const GroupReader& root, model::PathEnd& end, std::size_t points);

}  // namespace soft::io
