#pragma once
/// The one exception of the project and the exit codes every tool shares (printed by --help).
#include <stdexcept>
#include <string>
#include <string_view>

namespace soft {

enum class ExitCode : int {
    ok = 0,
    check_failed = 1,    ///< a comparison or regression check failed
    stopped_early = 2,   ///< the path ended early for a physical or numerical reason; the steps reached are kept
    usage = 64,          ///< unknown option, bad combination, binary data to a terminal
    bad_input = 65,      ///< design, mesh, HDF5 or CSV refused
    cannot_open = 66,    ///< an input cannot be opened
    internal = 70,       ///< a bug
    cannot_create = 73,  ///< an output cannot be created
    io_error = 74,       ///< disk full, short read or write
};

/// An unexpected failure: where, what is wrong, what would be right. `what()` is "place: problem; remedy"
/// (empty parts are left out), one line; the tool's name is put in front by `run_guarded` (tools/cli.hpp).
class Error : public std::runtime_error {
public:
    Error(ExitCode code, std::string_view place, std::string_view problem, std::string_view remedy = {})
        : std::runtime_error(join(place, problem, remedy)), code_(code) {}

    [[nodiscard]] ExitCode code() const noexcept { return code_; }

private:
    static std::string join(std::string_view place, std::string_view problem, std::string_view remedy) {
        std::string text{place};
        if (!text.empty()) text += ": ";
        text += problem;
        if (!remedy.empty()) text.append("; ").append(remedy);
        return text;
    }

    ExitCode code_;
};

}  // namespace soft
