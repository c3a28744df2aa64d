#pragma once
/// --check and --compare: checks on the path of a result. Tested by tests/pipeline/checks.sh.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "post/compare.hpp"
#include "post/curve.hpp"
#include "postprocess_options.hpp"

namespace soft {

/// Reads a CSV file given by the user.
[[nodiscard]] core::Table read_csv(const std::string& file);

/// Measured data of --compare and their errors relative to the path.
struct Comparison {
    post::Measured measured;
    std::vector<post::ErrorSummary> errors;
};
/// nullopt without --compare.
[[nodiscard]] std::optional<Comparison> compare(const CompareOptions& options, const post::Curve& curve);

/// Outcome of --check and --max-error.
struct CheckReport {
    std::vector<std::string> lines;   ///< summary lines
    std::vector<post::Claim> claims;  ///< for --junit
    std::string failure;              ///< reason of a failure, one line; empty if all checks passed
};
/// Runs the checks and adds "comparison" and "check" to the summary.
[[nodiscard]] CheckReport run_checks(const PostprocessOptions& options, const post::Curve& curve,
                                     const std::optional<Comparison>& comparison, nlohmann::ordered_json& summary);

/// Writes the --junit file; throws Error(check_failed) with the reason if a check failed.
void finish_checks(const PostprocessOptions& options, const CheckReport& checks);

}  // namespace soft
