/// fit-material: tensile, equibiaxial and planar test data -> the `material:` block of a design.
///     fit-material TEST.csv --law yeoh --range 0:110% > material.yaml
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli.hpp"
#include "core/text.hpp"
#include "fit/rank.hpp"
#include "fit/report.hpp"
#include "fit_options.hpp"
#include "fit_plot.hpp"
#include "fit_summary.hpp"
#include "post/plot.hpp"

namespace soft {
namespace {

using cli::FitOptions;

/// A law that explains less of the spread of the stress was given the wrong columns, or data with a fault.
constexpr double poor_r2 = 0.9;

std::vector<fit::TestCurve> read_tests(const FitOptions& options, cli::Console& console) {
    std::vector<fit::TestCurve> tests;
    for (const cli::TestFile& file : options.files) {
        const cli::Input input = cli::read_input(file.name, cli::longest_table);
        tests.push_back(fit::read_test(input.text(), input.source, file.mode, options.reading));
        tests.back().weight = file.weight;
        if (!input.text().ends_with('\n') && !input.text().ends_with('\r'))
            console.warn(input.source + ": the last line has no end: is the file whole?");
    }
    return tests;
}

fit::Provenance provenance_of(const FitOptions& options) {
    return {.command_line = std::string{cli::fit_about().tool} + " " + std::string{cli::version()} + " (" +
                            std::string{cli::revision()} + "): " + options.common.command_line,
            .notice = options.notice,
            .protocol = options.protocol};
}

void tell(const std::vector<fit::Ranked>& ranked, cli::Console& console) {
    for (const fit::Ranked& one : ranked) {
        const fit::Fit& fitted = one.fit;
        if (!fitted.stable && (ranked.size() == 1 || &one == &ranked.front()))
            console.warn(std::string{fitted.candidate.name} +
                         ": not stable where the data are: " + core::join(fitted.flags, " "));
    }
    const fit::Fit& best = ranked.front().fit;
    if (best.r2 < poor_r2)
        console.warn("the best fit is poor (R2 " + core::rounded_text(best.r2, 3) +
                     "): are the columns the right ones, and does the range end before the specimen breaks?");
    console.say(std::string{best.candidate.name} + ": RMSE " + core::rounded_text(best.rmse_Pa / 1e3, 4) + " kPa, R2 " +
                core::rounded_text(best.r2, 6) + ", " + std::to_string(best.rows) +
                " rows, flags: " + (best.flags.empty() ? "none" : core::join(best.flags, " ")));
}

ExitCode fit_material(const FitOptions& options) {
    cli::Console console{cli::fit_about().tool, options.common.verbosity};
    const std::vector<fit::TestCurve> tests = read_tests(options, console);
    const std::vector<fit::Ranked> ranked =
        options.rank ? fit::rank(tests, options.settings)
                     : std::vector<fit::Ranked>{{fit::fit(*options.candidate, tests, options.settings), {}}};
    cli::write_output(
        options.common.output,
        options.rank ? fit::rank_table(ranked) : fit::material_yaml(ranked.front().fit, tests, provenance_of(options)));
    if (!options.plot.empty()) cli::draw_fits(ranked, tests, options.plot);
    if (!options.common.json.empty()) cli::write_json(options.common.json, cli::fit_summary(ranked, tests));
    tell(ranked, console);
    return ExitCode::ok;
}

}  // namespace
}  // namespace soft

int main(int argc, char** argv) {
    return soft::cli::run_guarded(argc, argv, soft::cli::parse_fit_options, soft::fit_material);
}
