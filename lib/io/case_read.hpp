#pragma once
/// The case of an open file, for the readers of this room.
#include "io/case_file.hpp"
#include "io/hdf5_read.hpp"

namespace soft::io {

[[nodiscard]] CaseFile read_case_groups(const GroupReader& root);

/// Effective YAML, its hash (checked), overrides; `family` too where the group has one.
[[nodiscard]] DesignText read_design_text(const GroupReader& group);

}  // namespace soft::io
