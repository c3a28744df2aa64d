#pragma once
/// The exception type of the project and the exit codes of all tools (printed by --help).
#include <stdexcept>
#include <string>
#include <string_view>

namespace soft {

enum class ExitCode : int {
    ok = 0,
    check_failed = 1,    ///< a comparison or regression check failed
    stopped_early = 2,   ///< the path ended early for a physical or numerical reason; the converged steps are kept
    usage = 64,          ///< unknown option, invalid combination of options, binary output to a terminal
    bad_input = 65,      ///< invalid design, mesh, HDF5 or CSV file
    cannot_open = 66,    ///< an input cannot be opened
    internal = 70,       ///< a bug
    cannot_create = 73,  ///< an output cannot be created
    io_error = 74,       ///< disk full, short read or write
};

/// An unexpected failure: its location, the problem and the remedy. `what()` is the single line "location: problem; remedy"
/// without the parts that are empty. `run_guarded` (tools/cli.hpp) prepends the name of the tool.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, std::string_view location, std::string_view problem, std::string_view remedy = {})
        : std::runtime_error(join(location, problem, remedy)), code_(code) {}

    [[nodiscard]] ExitCode code() const noexcept { return code_; }

private:
    static std::string join(std::string_view location, std::string_view problem, std::string_view remedy) {
        std::string text{location};
        if (!text.empty()) text += ": ";
        text += problem;
        if (!remedy.empty()) text.append("; ").append(remedy);
        return text;
    }

    ExitCode code_;
};

}  // namespace soft
