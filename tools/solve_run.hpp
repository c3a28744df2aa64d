#pragma once
/// What solve does once its options are read: the case or the interrupted path in, the path followed, the result out.
#include <optional>
#include <string>
#include <vector>

#include "cli.hpp"
#include "linalg/session.hpp"

namespace soft::cli {

struct SolveOptions {
    CommonOptions common;
    std::string input;
    std::vector<std::string> sets;
    std::string resume;  ///< file of an interrupted solve; then there is no input
    std::string fields = "all";
    std::optional<double> tolerance;  ///< on the error bars of the load
    bool profile = false;             ///< a table of where the time went
    std::vector<std::string> petsc;   ///< what stands behind --
};

/// On every rank. ExitCode::stopped_early for a path that ended before its goal, check_failed where the tolerance is missed.
[[nodiscard]] ExitCode run_solve(const SolveOptions& options, const About& about, const linalg::Session& session);

}  // namespace soft::cli
