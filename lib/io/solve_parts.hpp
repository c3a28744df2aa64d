#pragma once
/// The parts of a case that solve may change: materials, loads and control settings. They are stored in the case, and again in
/// /solve_design if `solve --set` changed them. Internal to the module.
#include "io/hdf5_read.hpp"
#include "model/case.hpp"

namespace soft::io {

/// Creates the groups materials, loads and control in `parent`.
void write_solve_parts(hid_t parent, const model::Case& model);
/// Replaces those parts of `model`.
void read_solve_parts(const GroupReader& parent, model::Case& model);

}  // namespace soft::io
