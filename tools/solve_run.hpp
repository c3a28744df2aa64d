#pragma once
/// What solve does once its options are read: the case or the interrupted path in, the path followed, the result out.
#include "linalg/session.hpp"
#include "solve_options.hpp"

namespace soft::cli {

/// On every rank. ExitCode::stopped_early for a path that ended before its goal, check_failed where the tolerance is missed.
[[nodiscard]] ExitCode run_solve(const SolveOptions& options, const linalg::Session& session);

}  // namespace soft::cli
