#pragma once
/// How a case is solved (/control/solver, /control/dynamics) and how loads go with time (time_function). Internal to the module.
#include <cstdint>
#include <vector>

#include "io/hdf5_read.hpp"
#include "model/case.hpp"

namespace soft::io {

/// Creates the groups solver and, of a dynamic case, dynamics in `control`.
void write_settings(hid_t control, const model::Case& model);
/// Replaces both in `model`; without the group dynamics the path is static.
void read_settings(const GroupReader& control, model::Case& model);

/// Creates the group time_function in `loads`, one row a load.
void write_time_functions(hid_t loads, const std::vector<model::TimeFunction>& time_functions);
[[nodiscard]] std::vector<model::TimeFunction> read_time_functions(const GroupReader& loads, std::int64_t count);

}  // namespace soft::io
