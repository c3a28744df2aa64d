#pragma once
/// --check and --compare: verdicts on the path of a result. Tested by tests/pipeline/checks.sh.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "post/compare.hpp"
#include "post/curve.hpp"
#include "postprocess_options.hpp"

namespace soft {

/// A table that the user names.
[[nodiscard]] table::Table read_csv(const std::string& file);

/// Measured data, where --compare names some, with what they say of the path.
struct Comparison {
    post::Measured measured;
    std::vector<post::ErrorSummary> errors;
};
[[nodiscard]] std::optional<Comparison> compare(const CompareOptions& options, const post::Curve& curve);

/// Whether the result is as it should be.
struct Judgement {
    std::vector<std::string> lines;   ///< for people
    std::vector<post::Claim> claims;  ///< for --junit
    std::string failure;              ///< why not, one line; empty where it is
};
/// Adds "comparison" and "check" to the summary.
[[nodiscard]] Judgement judge(const PostprocessOptions& options, const post::Curve& curve,
                              const std::optional<Comparison>& comparison, nlohmann::ordered_json& summary);

/// Writes --junit; Error(check_failed) with the reason where there is a failure.
void conclude(const PostprocessOptions& options, const Judgement& judgement);

}  // namespace soft
