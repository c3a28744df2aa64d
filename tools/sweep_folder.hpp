#pragma once
/// The folder in which a sweep is computed: designs/ID.yaml waits, ID/ holds what came of it (status, result.h5 and more),
/// written by scripts/sweep-design.
#include <filesystem>
#include <vector>

#include "sweep/outcome.hpp"
#include "sweep/plan.hpp"
#include "sweep/results.hpp"

namespace soft {

/// One a design. A design is done when its status is final and, where it has a path, the result is still there. With an
/// empty folder all that are not refused wait.
[[nodiscard]] std::vector<sweep::State> states_in(const std::filesystem::path& folder, const sweep::Plan& plan);

/// One a design, with the outputs from its result; where it has one, its curve.csv is written if it is not there.
/// A result that cannot be read is a failure of its design.
[[nodiscard]] std::vector<sweep::Outcome> outcomes_in(const std::filesystem::path& folder, const sweep::Sweep& sweep,
                                                      const sweep::Plan& plan);

/// Writes designs/ID.yaml of those that wait; what is there already has the same content, its name says so.
void write_designs(const std::filesystem::path& folder, const sweep::Plan& plan,
                   const std::vector<sweep::State>& states);

}  // namespace soft
