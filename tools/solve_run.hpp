#pragma once
/// The main function of solve: reads the case or the interrupted path, follows the path and writes the result.
#include "linalg/session.hpp"
#include "solve_options.hpp"

namespace soft::cli {

/// Call on every rank. Returns ExitCode::stopped_early if the path ended before its goal, check_failed if the tolerance is not met or
/// the energy balance is violated.
[[nodiscard]] ExitCode run_solve(const SolveOptions& options, const linalg::Session& session);

}  // namespace soft::cli
