#pragma once
/// The working folder of a sweep: designs/ID.yaml are the waiting designs, ID/ contains the status, result.h5 and other files written
/// by scripts/sweep-design.
#include <filesystem>
#include <vector>

#include "sweep/outcome.hpp"
#include "sweep/plan.hpp"
#include "sweep/results.hpp"

namespace soft {

/// State of each design. A design is done if its status is final and, if it has a path, its result still exists. Without a folder
/// every valid design is waiting.
[[nodiscard]] std::vector<sweep::State> states_in(const std::filesystem::path& folder, const sweep::Plan& plan);

/// Outcome of each design, with the outputs of its result. Writes a missing curve.csv next to each result.
/// A result that cannot be read counts as a failure of its design. `trace_points`: points of each curve (sweep/trace.hpp); 0: no curves.
[[nodiscard]] std::vector<sweep::Outcome> outcomes_in(const std::filesystem::path& folder, const sweep::Sweep& sweep,
                                                      const sweep::Plan& plan, std::size_t trace_points = 0);

/// Writes designs/ID.yaml for each waiting design. Existing files are kept: their name is a hash of the content.
void write_designs(const std::filesystem::path& folder, const sweep::Plan& plan,
                   const std::vector<sweep::State>& states);

}  // namespace soft
