#pragma once
/// `solve --tolerance`: refines the path that was found, says what it does next, and keeps the curve known so far in the output.
#include <functional>
#include <optional>
#include <vector>

#include "cli.hpp"
#include "io/result_file.hpp"
#include "solve_summary.hpp"
#include "solver/accuracy.hpp"

namespace soft::cli {

struct CurveOutput {
    io::ResultWriter* writer = nullptr;             ///< of the first rank
    std::function<io::ResultWriter()> rows_writer;  ///< in memory, of the same case, for the rows of another mesh
};

/// Solves the path again on finer meshes. The output gets the curve of the given mesh first, then each that has error bars, so
/// that a kill leaves the last of them. SIGINT and SIGTERM end the refinement instead of the process, the second one ends it.
/// `path_s`: what the path took. Sets the accuracy, the end and the last row of `summary`.
void judge(assembly::System& system, std::vector<solver::RowState> rows, double tolerance, double path_s,
           const CurveOutput& output, Console& console, SolveSummary& summary);

}  // namespace soft::cli
