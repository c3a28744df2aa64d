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

/// The same of one change to a design that has its overrides already, after which it has this too.
[[nodiscard]] io::DesignText apply_change(const design::Override& change, const io::DesignText& design,
                                          model::Case& model);

/// Whether one of them is to another set of a silicone's constants (design::fitting_set).
[[nodiscard]] bool has_other_set(const io::DesignText& design);

}  // namespace soft::cli
