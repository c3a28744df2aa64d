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

/// A smaller R2 usually means wrong columns or faulty data.
constexpr double poor_r2 = 0.9;

std::vector<fit::TestCurve> read_tests(const FitOptions& options, cli::Console& console) {
    std::vector<fit::TestCurve> tests;
    for (const cli::TestFile& file : options.files) {
        const cli::Input input = cli::read_input(file.name, cli::max_table_bytes);
        tests.push_back(fit::read_test(input.text(), input.source, file.mode, options.reading));
        tests.back().weight = file.weight;
        if (!input.text().ends_with('\n') && !input.text().ends_with('\r'))
            console.warn(input.source + ": the last line has no line ending; check that the file is complete");
    }
    return tests;
}

fit::Provenance provenance_of(const FitOptions& options) {
    return {.command_line = cli::stamp(cli::fit_about(), options.common),
            .notice = options.notice,
            .protocol = options.protocol};
}

void print_summary(const std::vector<fit::RankedFit>& ranked, cli::Console& console) {
    for (const fit::RankedFit& one : ranked) {
        const fit::Fit& fitted = one.fit;
        if (!fitted.stable && (ranked.size() == 1 || &one == &ranked.front()))
            console.warn(std::string{fitted.candidate.name} +
                         ": not stable within the range of the data: " + core::join(fitted.flags, " "));
    }
    const fit::Fit& best = ranked.front().fit;
    if (best.r2 < poor_r2)
        console.warn("the best fit is poor (R2 " + core::rounded_text(best.r2, 3) +
                     "); check the columns, and that the range ends before the specimen breaks");
    console.say(std::string{best.candidate.name} + ": RMSE " + core::rounded_text(best.rmse_Pa / 1e3, 4) + " kPa, R2 " +
                core::rounded_text(best.r2, 6) + ", " + std::to_string(best.rows) +
                " rows, flags: " + (best.flags.empty() ? "none" : core::join(best.flags, " ")));
}

ExitCode fit_material(const FitOptions& options) {
    cli::Console console{cli::fit_about(), options.common};
    const std::vector<fit::TestCurve> tests = read_tests(options, console);
    const auto fit_of = [&](const fit::Candidate& candidate) {
        return options.in_time() ? fit::fit_history(candidate, tests, options.history, options.settings)
                                 : fit::fit(candidate, tests, options.settings);
    };
    const std::vector<fit::RankedFit> ranked = !options.rank
                                                   ? std::vector<fit::RankedFit>{{fit_of(*options.candidate), {}}}
                                               : options.in_time() ? fit::rank_by(fit_of)
                                                                   : fit::rank(tests, options.settings);
    cli::write_output(
        options.common.output,
        options.rank ? fit::rank_table(ranked) : fit::material_yaml(ranked.front().fit, tests, provenance_of(options)));
    if (!options.plot.empty()) cli::draw_fits(ranked, tests, options.plot);
    if (!options.common.json.empty()) cli::write_json(options.common.json, cli::fit_summary(ranked, tests));
    print_summary(ranked, console);
    return ExitCode::ok;
}

}  // namespace
}  // namespace soft

int main(int argc, char** argv) {
    return soft::cli::run_guarded(argc, argv, soft::cli::parse_fit_options, soft::fit_material);
}
