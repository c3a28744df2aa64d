#pragma once
/// Reads the case from an open file. Internal to the module.
#include "io/case_file.hpp"
#include "io/hdf5_read.hpp"

namespace soft::io {

[[nodiscard]] CaseFile read_case_groups(const GroupReader& root);

/// Effective YAML, its hash (checked) and overrides, and `family` if the group has one.
[[nodiscard]] DesignText read_design_text(const GroupReader& group);

}  // namespace soft::io
