#pragma once
/// What the command line of solve asks for.
#include <optional>
#include <string>
#include <vector>

#include "cli.hpp"

namespace soft::cli {

struct SolveOptions {
    CommonOptions common;
    std::string input;
    std::vector<std::string> sets;
    std::string resume;  ///< file of an interrupted solve; then there is no input
    std::string fields = "all";
    std::optional<double> tolerance;  ///< on the error bars of the load
    bool profile = false;             ///< a table of where the time went
    bool batch = false;               ///< command lines from stdin
    std::vector<std::string> petsc;   ///< what stands behind --
    double cpu_before_s = 0;          ///< of the process, spent on other lines of its batch
};

[[nodiscard]] const About& solve_about() noexcept;

/// nullopt where the command line asked for --help and the like, which is done then. Errors: ExitCode::usage.
[[nodiscard]] std::optional<SolveOptions> parse_solve_options(int argc, char** argv);

/// A line that `solve --batch` has read, as the shell would take it: blanks part the words, quotes hold them together. Its data
/// go to files: stdin and stdout are the batch's. Errors: as above, and where the line asks for what is the batch's.
[[nodiscard]] std::optional<SolveOptions> parse_batch_line(const std::string& line);

}  // namespace soft::cli
