#pragma once
/// The command line of fit-material. Tested by tests/pipeline/fit.sh.
#include <optional>
#include <string>
#include <vector>

#include "cli.hpp"
#include "fit/history_fit.hpp"

namespace soft::cli {

struct TestFile {
    std::string name;  ///< empty or "-": stdin
    fit::Mode mode = fit::Mode::uniaxial;
    double weight = 1;
};

struct FitOptions {
    CommonOptions common;
    std::vector<TestFile> files;
    fit::ReadSettings reading;
    fit::Settings settings;
    fit::HistorySettings history;
    const fit::Candidate* candidate = nullptr;
    bool rank = false;
    std::string plot, notice, protocol;

    /// Whether the tests are histories in time.
    [[nodiscard]] bool in_time() const { return history.branches > 0 || history.softening; }
};

[[nodiscard]] const About& fit_about();

/// Errors as cli::parse; throws Error(usage) for invalid values.
[[nodiscard]] std::optional<FitOptions> parse_fit_options(int argc, char** argv);

}  // namespace soft::cli
