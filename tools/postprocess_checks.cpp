#include "postprocess_checks.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli.hpp"
#include "core/table.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "post/golden.hpp"
#include "post/junit.hpp"

namespace soft {
namespace {

nlohmann::ordered_json comparison_json(const post::Curve& curve, const Comparison& comparison) {
    auto list = nlohmann::ordered_json::array();
    for (const post::ErrorSummary& error : comparison.errors) {
        const post::Column& of = curve.columns[error.of];
        list.push_back({{"quantity", of.quantity},
                        {"unit", of.unit},
                        {"at_equal", curve.columns[error.at].quantity},
                        {"points", error.points},
                        {"left_out", error.left_out},
                        {"mean", error.mean},
                        {"mean_absolute", error.mean_absolute},
                        {"rms", error.rms},
                        {"largest", error.largest},
                        {"max_line", comparison.measured.lines[error.max_row]},
                        {"r2", error.r2 ? nlohmann::ordered_json(*error.r2) : nlohmann::ordered_json(nullptr)}});
    }
    return list;
}

void check_comparison(const CompareOptions& options, const post::Curve& curve, const Comparison& comparison,
                      CheckReport& checks) {
    checks.lines = post::summary_lines(curve, comparison.measured, comparison.errors);
    if (options.max_error.empty()) return;
    for (post::Claim& claim : post::check_max_error(curve, comparison.measured, comparison.errors, options.max_error)) {
        if (checks.failure.empty()) checks.failure = claim.failure;
        checks.claims.push_back(std::move(claim));
    }
}

/// A truncated table still agrees with the path, so the message reports an incomplete coverage.
std::string coverage_text(double covered) {
    constexpr double whole = 0.99;
    return covered < whole ? "; it covers " + core::rounded_text(100 * covered, 2) + " % of the path" : "";
}

void check_golden_table(const CheckOptions& options, const post::Curve& curve, CheckReport& checks,
                        nlohmann::ordered_json& summary) {
    const double relative = core::quantity_or_throw(options.rtol, core::Dimension::ratio, ExitCode::usage, "--rtol");
    if (relative < 0) throw Error(ExitCode::usage, "--rtol", core::quoted(options.rtol) + " is negative");
    post::Tolerance tolerance{relative, {}};
    for (const std::string& text : options.atol) tolerance.absolute.push_back(post::parse_allowance(text, curve));
    const core::Table golden = read_csv(options.file);
    const post::Verdict verdict = post::check_golden(curve, golden, tolerance);
    for (const post::ColumnVerdict& column : verdict.columns)
        checks.claims.push_back({column.name + " agrees", post::failure_text(verdict, column, golden)});
    summary["check"] = {
        {"golden", golden.source},
        {"agrees", verdict.agrees()},
        {"rows", verdict.rows},
        {"differing_rows", verdict.differing_rows},
        {"covered", verdict.covered},
        {"max_share_of_allowed", std::isfinite(verdict.nearest_miss) ? nlohmann::ordered_json(verdict.nearest_miss)
                                                                     : nlohmann::ordered_json(nullptr)}};
    if (!verdict.agrees())
        checks.failure = post::failure_text(verdict, golden);
    else
        checks.lines.push_back(golden.source + ": " + core::counted(verdict.rows, "row") + " of " +
                               core::counted(verdict.columns.size(), "column") + " agree; the largest difference is " +
                               core::rounded_text(100 * verdict.nearest_miss, 2) + " % of what is allowed" +
                               coverage_text(verdict.covered));
}

}  // namespace

core::Table read_csv(const std::string& file) {
    const cli::Input input = cli::read_input(file, cli::max_table_bytes);
    return core::read_table(input.text(), input.source);
}

std::optional<Comparison> compare(const CompareOptions& options, const post::Curve& curve) {
    if (options.file.empty()) return std::nullopt;
    const auto choices = post::parse_column_choices(options.columns);
    post::Measured measured = post::read_measured(read_csv(options.file), curve, choices);
    auto errors = post::compare(curve, measured);
    return Comparison{std::move(measured), std::move(errors)};
}

CheckReport run_checks(const PostprocessOptions& options, const post::Curve& curve,
                       const std::optional<Comparison>& comparison, nlohmann::ordered_json& summary) {
    CheckReport checks;
    if (comparison) {
        summary["comparison"] = comparison_json(curve, *comparison);
        check_comparison(options.compare, curve, *comparison, checks);
    }
    if (!options.check.file.empty()) check_golden_table(options.check, curve, checks, summary);
    return checks;
}

void finish_checks(const PostprocessOptions& options, const CheckReport& checks) {
    if (!options.check.junit.empty())
        cli::write_output(options.check.junit, post::junit_xml("postprocess " + options.input, checks.claims));
    if (!checks.failure.empty()) throw Error(ExitCode::check_failed, "", checks.failure);
}

}  // namespace soft
