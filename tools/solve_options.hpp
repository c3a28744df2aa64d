#pragma once
/// Command line of solve.
#include <optional>
#include <string>
#include <vector>

#include "cli.hpp"

namespace soft::cli {

struct SolveOptions {
    CommonOptions common;
    std::string input;
    std::vector<std::string> sets;
    std::string resume;  ///< file of an interrupted solve; excludes `input`
    std::string fields = "all";
    std::optional<double> tolerance;  ///< relative tolerance on the error bars of the load
    int cores = 0;                    ///< 0: all
    bool profile = false;             ///< print the time of each phase
    bool batch = false;               ///< read command lines from stdin
    std::vector<std::string> petsc;   ///< PETSc options, after --
    double cpu_before_s = 0;          ///< CPU time that the process spent on earlier lines of its batch [s]
};

[[nodiscard]] const About& solve_about() noexcept;

/// nullopt if help, version or the like was printed. Throws Error(usage).
[[nodiscard]] std::optional<SolveOptions> parse_solve_options(int argc, char** argv);

/// Parses a line of `solve --batch` with the quoting rules of a shell. Its data go to files, since the batch uses stdin and stdout.
/// Errors as above; also for options that are reserved for the batch itself.
[[nodiscard]] std::optional<SolveOptions> parse_batch_line(const std::string& line);

}  // namespace soft::cli
