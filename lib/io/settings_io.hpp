#pragma once
/// How a case is solved (/control/solver, /control/dynamics) and how loads go with time (course). Internal to the module.
#include <cstdint>
#include <vector>

#include "io/hdf5_read.hpp"
#include "model/case.hpp"

namespace soft::io {

/// Creates the groups solver and, of a dynamic case, dynamics in `control`.
void write_settings(hid_t control, const model::Case& model);
/// Replaces both in `model`; without the group dynamics the path is static.
void read_settings(const GroupReader& control, model::Case& model);

/// Creates the group course in `loads`, one row a load.
void write_courses(hid_t loads, const std::vector<model::TimeCourse>& courses);
[[nodiscard]] std::vector<model::TimeCourse> read_courses(const GroupReader& loads, std::int64_t count);

}  // namespace soft::io
