#pragma once
/// `solve --set`: what a solver may still change of a case.
#include <optional>
#include <string>
#include <vector>

#include "design/design.hpp"
#include "io/case_file.hpp"

namespace soft::cli {

/// Applies the overrides to the case and returns the design they make of its own; nullopt without overrides.
/// Errors: those of design::apply_overrides.
[[nodiscard]] std::optional<io::DesignText> apply_sets(const std::vector<std::string>& sets, io::CaseFile& file);

}  // namespace soft::cli
