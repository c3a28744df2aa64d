#pragma once
/// `solve --set`: overrides that do not change the mesh.
#include <optional>
#include <string>
#include <vector>

#include "design/design.hpp"
#include "io/case_file.hpp"

namespace soft::cli {

/// Applies the overrides to the case and returns the changed design; nullopt without overrides.
/// Errors: those of design::apply_overrides.
[[nodiscard]] std::optional<io::DesignText> apply_sets(const std::vector<std::string>& sets, io::CaseFile& file);

}  // namespace soft::cli
