#pragma once
/// Reads and writes the settings (/control/solver, /control/dynamics) and the time functions of loads. Internal to the module.
#include <cstdint>
#include <vector>

#include "io/hdf5_read.hpp"
#include "model/case.hpp"

namespace soft::io {

/// Creates the group solver and, in a dynamic case, the group dynamics in `control`.
void write_settings(hid_t control, const model::Case& model);
/// Replaces both settings in `model`; without the group dynamics the path is static.
void read_settings(const GroupReader& control, model::Case& model);

/// Creates the group time_function in `loads`, one row per load.
void write_time_functions(hid_t loads, const std::vector<model::TimeFunction>& time_functions);
[[nodiscard]] std::vector<model::TimeFunction> read_time_functions(const GroupReader& loads, std::int64_t count);

}  // namespace soft::io
