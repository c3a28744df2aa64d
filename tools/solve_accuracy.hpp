#pragma once
/// `solve --tolerance`: refines the computed path, prints each next step, and keeps the best curve so far in the output.
#include <functional>
#include <optional>
#include <vector>

#include "cli.hpp"
#include "io/result_file.hpp"
#include "solve_summary.hpp"
#include "solver/accuracy.hpp"

namespace soft::cli {

struct CurveOutput {
    io::ResultWriter* writer = nullptr;  ///< on the first rank; nullptr elsewhere
    std::function<io::ResultWriter()>
        rows_writer;  ///< creates an in-memory writer of the same case, for the rows of a finer mesh
};

/// Solves the path again on finer meshes and estimates its discretisation error. The output receives the curve of the given mesh
/// first, then each curve with error bars, so that a killed process leaves the latest one. The first SIGINT or SIGTERM ends the
/// refinement, the second one the process. `path_s`: wall time of the path [s]. Sets accuracy, end and last row of `summary`.
void estimate_error(fem::System& system, std::vector<solver::RowState> rows, double tolerance, double path_s,
                    const CurveOutput& output, Console& console, SolveSummary& summary);

}  // namespace soft::cli
