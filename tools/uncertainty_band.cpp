/// uncertainty-band: converts the errors of fitted constants to a set of materials, and their results to an uncertainty band.
///     uncertainty-band fit.json --samples 40 > materials
///     uncertainty-band fit.json --samples 40 --runs FOLDER --at elongation=20mm,40mm > band.csv
/// scripts/uncertainty runs mesh-gen and solve between the two.
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "cli.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "fit/shifted_constants.hpp"
#include "geometry/build.hpp"
#include "io/result_file.hpp"
#include "library_versions.hpp"
#include "post/band.hpp"
#include "post/plot.hpp"

namespace {

using namespace soft;
namespace fs = std::filesystem;

constexpr long max_samples = 10000;

const cli::About about{
    .tool = "uncertainty-band",
    .summary = "propagates the errors of fitted constants to an uncertainty band of the curve (CSV)",
    .examples = {{"uncertainty-band fit.json --samples 40", "Prints the materials to solve with, one per line"},
                 {"uncertainty-band fit.json --samples 40 --runs runs --at elongation=20mm > band.csv",
                  "Computes the band from runs/run-00000.h5 ..., in the order of the materials"}},
    .libraries = [] {
        return std::vector<cli::Library>{{"HDF5", cli::built_with::hdf5}};
    }};

struct UncertaintyOptions {
    cli::CommonOptions common;
    std::string input, runs, plot;
    std::vector<std::string> at;
    int samples = 0;
};

int sample_count(const std::string& text) {
    const auto parsed = core::parse_count(text);
    const long* count = std::get_if<long>(&parsed);
    if (count == nullptr || *count < 0 || *count == 1 || *count > max_samples)
        throw Error(ExitCode::usage, "--samples", core::quoted(text) + " is not a number of samples",
                    "0, or 2 to " + std::to_string(max_samples));
    return static_cast<int>(*count);
}

std::optional<UncertaintyOptions> parse_uncertainty_options(int argc, char** argv) {
    UncertaintyOptions options;
    std::string samples = "0";
    CLI::App app;
    cli::add_input(app, options.input, "FIT", "The --json file of fit-material; the first fit is used");
    app.add_option("--samples", samples, "Also add N materials with constants drawn from the covariance")
        ->type_name("N");
    app.add_option("--at", options.at, "Values at which the band is computed: quantity=value[,value...]")
        ->type_name("WHERE");
    app.add_option("--runs", options.runs, "Folder with run-00000.h5 ..., one per material; missing files are skipped")
        ->type_name("FOLDER");
    app.add_option("--plot", options.plot, "Draw the curve with its band (.svg, .png or .pdf)")->type_name("FILE");
    cli::add_common_options(app, options.common, about);
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    options.samples = sample_count(samples);
    if (!options.plot.empty()) static_cast<void>(post::picture_format(options.plot));
    if (options.at.empty() && !options.runs.empty())
        throw Error(ExitCode::usage, "--at", "is missing", "give values, for example --at elongation=20mm,40mm");
    cli::check_distinct({{"FIT", options.input}}, options.common, {{"--plot", options.plot}});
    return options;
}

fit::FittedLaw read_fit(const cli::Input& input) {
    const auto refuse = [&input](const std::string& problem) {
        return Error(ExitCode::bad_input, input.source, problem, "give the --json file of fit-material");
    };
    try {
        const nlohmann::json fitted = nlohmann::json::parse(input.text()).at("fits").at(0);
        fit::FittedLaw law{fitted.at("law"), {}, fitted.at("covariance")};
        for (const nlohmann::json& constant : fitted.at("constants"))
            law.constants.push_back({constant.at("name"), constant.at("value"), constant.at("unit") == "Pa"});
        return law;
    } catch (const nlohmann::json::exception& error) {
        throw refuse("is not a fit: " + core::one_line(error.what()));
    }
}

struct Run {
    io::Result result;
    post::Curve curve;
};

std::optional<Run> read_run(const std::string& folder, std::size_t number) {
    std::array<char, 32> name{};
    static_cast<void>(std::snprintf(name.data(), name.size(), "run-%05zu.h5", number));
    const fs::path file = fs::path(folder) / name.data();
    std::error_code unknown;
    if (!fs::exists(file, unknown)) return std::nullopt;
    Run run{io::read_result(core::read_file(file), file.string(), geometry::rebuild_case), {}};
    if (run.result.steps.empty()) return std::nullopt;
    run.curve = post::make_curve(run.result.model, run.result.steps);
    return run;
}

/// Draws the curve over the first requested quantity; if that is the load, the load over the first output.
void draw(const UncertaintyOptions& options, Run fitted, post::Band band) {
    post::PlotRequest request{fitted.result.model.name, {}, {}};
    const std::string request_text = options.at.front().substr(0, options.at.front().find('='));
    const std::string quantity{core::trimmed(request_text)};
    const post::Column* column = fitted.curve.find(quantity);
    (column != nullptr && column->source == post::Source::load ? request.y : request.x) = quantity;
    const post::PlotSeries series{fitted.result.model.name, std::move(fitted.curve),
                                  fitted.result.end.value_or(model::PathEnd{}), std::move(band)};
    post::draw_plot({&series, 1}, nullptr, request, options.plot);
}

ExitCode write_band(const UncertaintyOptions& options, std::size_t constants) {
    std::optional<Run> fitted = read_run(options.runs, 0);
    if (!fitted) throw Error(ExitCode::cannot_open, options.runs, "run-00000.h5 (fitted constants) does not exist");
    std::vector<post::Request> requests;
    for (const std::string& text : options.at)
        std::ranges::copy(post::parse_requests(text, fitted->curve), std::back_inserter(requests));
    post::BandSum sum(fitted->curve, requests);
    const auto curve = [](const std::optional<Run>& run) { return run ? &run->curve : nullptr; };
    for (std::size_t k = 0; k < constants; ++k) {
        const auto plus = read_run(options.runs, 1 + 2 * k), minus = read_run(options.runs, 2 + 2 * k);
        sum.add_pair(curve(plus), curve(minus));
    }
    for (std::size_t s = 0; s < static_cast<std::size_t>(options.samples); ++s)
        sum.add_sample(curve(read_run(options.runs, 1 + 2 * constants + s)));
    const post::Band band = sum.band();
    cli::write_output(options.common.output, post::band_csv(sum.rows(), band));
    if (!options.plot.empty()) draw(options, std::move(*fitted), band);
    cli::Console console{about, options.common};
    for (const std::string& note : sum.notes()) console.warn(note);
    nlohmann::ordered_json json = cli::summary_head(about.tool);
    json.update({{"rows", sum.rows().row_count()}, {"samples", options.samples}, {"left_out", sum.notes()}});
    if (!options.common.json.empty()) cli::write_json(options.common.json, json);
    return ExitCode::ok;
}

ExitCode uncertainty_band(const UncertaintyOptions& options) {
    const cli::Input input = cli::read_input(options.input, cli::max_table_bytes);
    const fit::FittedLaw fitted = read_fit(input);
    const std::vector<std::vector<double>> sets = [&] {
        try {
            return fit::shifted_constants(fitted, options.samples);
        } catch (const Error& error) {
            throw Error(error.code(), input.source, error.what());
        }
    }();
    if (!options.runs.empty()) return write_band(options, fitted.constants.size());
    std::string materials;
    for (const std::vector<double>& constants : sets) materials += fit::material_text(fitted, constants) + "\n";
    cli::write_output(options.common.output, materials);
    return ExitCode::ok;
}

}  // namespace

int main(int argc, char** argv) {
    return soft::cli::run_guarded(argc, argv, parse_uncertainty_options, uncertainty_band);
}
