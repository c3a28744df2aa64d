/// sweep-plan: lists the checked designs of a sweep (YAML), one row each (CSV), or the results of the computed designs.
///     sweep-plan designs/sweeps/tube.yaml
///     sweep-plan designs/sweeps/tube.yaml --folder results/sweeps/tube --results
/// scripts/sweep computes the designs.
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>

#include "cli.hpp"
#include "core/text.hpp"
#include "geometry/build.hpp"
#include "geometry/family.hpp"
#include "geometry/variations.hpp"
#include "library_versions.hpp"
#include "sweep/derivatives.hpp"
#include "sweep/plot.hpp"
#include "sweep_folder.hpp"
#include "view/sweep_report.hpp"

namespace {

using namespace soft;
namespace fs = std::filesystem;

const cli::About about{
    .tool = "sweep-plan",
    .summary = "lists the designs of a sweep (YAML), one row each (CSV); with --results their results",
    .examples = {{"sweep-plan designs/sweeps/tube.yaml", "Lists the designs with their values and IDs"},
                 {"sweep-plan designs/sweeps/tube.yaml --folder results/sweeps/tube -o plan.csv",
                  "Also marks those that scripts/sweep has computed in this folder"}},
    .libraries =
        [] {
            return std::vector<cli::Library>{{"gmsh", cli::built_with::gmsh},
                                             {"HDF5", cli::built_with::hdf5},
                                             {"yaml-cpp", cli::built_with::yaml_cpp}};
        },
    .exit_codes = {{ExitCode::stopped_early,
                    "--results: some designs are not computed, or failed for a reason outside the design (killed, disk "
                    "full)"}}};

struct SweepPlanOptions {
    cli::CommonOptions common;
    std::string input, folder, programs, waiting, report, plot;
    post::PlotRequest axes;
    bool prepare = false, results = false;
};

std::optional<SweepPlanOptions> parse_sweep_plan_options(int argc, char** argv) {
    SweepPlanOptions options;
    CLI::App app;
    cli::add_input(app, options.input, "SWEEP", "The sweep (YAML)");
    auto* folder = app.add_option("--folder", options.folder,
                                  "Working folder of the sweep, with a folder per design: marks those that are done");
    folder->type_name("FOLDER");
    app.add_flag("--prepare", options.prepare, "Also write the waiting designs as FOLDER/designs/ID.yaml")
        ->needs(folder);
    app.add_option("--waiting", options.waiting, "Also write the IDs of the waiting designs, one per line")
        ->type_name("FILE");
    app.add_flag("--results", options.results,
                 "Print the results of the designs in FOLDER instead of the plan, and write the "
                 "curve of each next to its result")
        ->needs(folder);
    auto* results = app.get_option("--results");
    app.add_option("--report", options.report,
                   "With --results: write them as a page for the browser: scatter plot with Pareto front, parallel "
                   "coordinates, curves and table of the selected designs")
        ->type_name("FILE.html")
        ->needs(results);
    auto* plot =
        app.add_option("--plot", options.plot,
                       "With --results: draw the curves of all designs to FILE.svg, FILE.png or FILE.pdf; needs "
                       "gnuplot")
            ->type_name("FILE")
            ->needs(results);
    app.add_option("--x", options.axes.x,
                   "Quantity on the x axis: a column of the curves (elongation), or of the results "
                   "(geometry.wall, pressure_kPa_at_end), then with a point for each design")
        ->type_name("QUANTITY")
        ->needs(plot);
    app.add_option("--y", options.axes.y, "Quantity on the y axis")->type_name("QUANTITY")->needs(plot);
    app.add_option("--colour", options.axes.colour,
                   "Column of the results shown by the colour; default: the first key that varies")
        ->type_name("QUANTITY")
        ->needs(plot);
    app.add_option("--programs", options.programs,
                   "File with the versions of the programs, which are part of the hash ID")
        ->type_name("FILE");
    cli::add_common_options(app, options.common, about);
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    cli::require_at_most_one(app, std::vector<std::string>{"--prepare", "--results"});
    cli::check_distinct({{"SWEEP", options.input}, {"--programs", options.programs}}, options.common,
                        {{"--waiting", options.waiting}, {"--report", options.report}, {"--plot", options.plot}});
    if (!options.plot.empty()) static_cast<void>(post::picture_format(options.plot));  // before any work
    if (!options.report.empty() && !options.report.ends_with(".html") && !options.report.ends_with(".htm"))
        throw Error(ExitCode::usage, "--report " + options.report, "a report is an HTML file; use the extension .html");
    return options;
}

/// Prints "1000 designs: 990 done, 10 refused", and writes the same as JSON.
void print_summary(const SweepPlanOptions& options, std::size_t designs,
                   const std::vector<std::pair<std::string, std::ptrdiff_t>>& counts) {
    nlohmann::ordered_json json = cli::summary_head(about.tool);
    json["designs"] = designs;
    std::vector<std::string> words;
    for (const auto& [word, count] : counts) {
        json[word] = count;
        std::string text = std::to_string(count) + " " + word;
        std::ranges::replace(text, '_', ' ');
        words.push_back(std::move(text));
    }
    if (!options.prepare)
        cli::Console{about, options.common}.say(core::counted(designs, "design") + ": " + core::join(words));
    if (!options.common.json.empty()) cli::write_json(options.common.json, json);
}

/// Writes the report and the plot, if requested.
void draw_results(const SweepPlanOptions& options, const cli::Input& input, const sweep::Sweep& sweep,
                  const sweep::Plan& plan, const std::vector<sweep::Outcome>& outcomes) {
    const std::vector<sweep::TableColumn> factors = sweep::factor_columns(sweep, plan),
                                          outputs = sweep::output_columns(outcomes);
    if (!options.report.empty()) {
        std::vector<std::string> ids;
        for (const sweep::PlannedDesign& design : plan.designs) ids.push_back(design.id);
        cli::write_output(options.report, view::make_sweep_report(
                                              {.title = "Sweep " + fs::path(input.source).stem().string(),
                                               .ids = ids,
                                               .factors = factors,
                                               .outputs = outputs,
                                               .outcomes = outcomes,
                                               .sweep_text = std::string{input.text()},
                                               .made_by = std::string{about.tool} + " " + std::string{cli::version()} +
                                                          " (" + std::string{cli::revision()} + ")"}));
    }
    if (!options.plot.empty())
        post::run_gnuplot(
            sweep::plot_script(factors, outputs, outcomes, options.axes, post::picture_format(options.plot)),
            options.plot);
}

ExitCode write_results(const SweepPlanOptions& options, const cli::Input& input, const sweep::Sweep& sweep,
                       const sweep::Plan& plan) {
    const bool draws = !options.report.empty() || !options.plot.empty();
    const std::vector<sweep::Outcome> outcomes =
        outcomes_in(options.folder, sweep, plan, draws ? view::trace_points(plan.designs.size()) : 0);
    cli::write_output(options.common.output, sweep::results_csv(sweep, plan, outcomes));
    draw_results(options, input, sweep, plan, outcomes);
    const auto count = [&](std::string_view reason) {
        return std::ranges::count(outcomes, reason, &sweep::Outcome::stop_reason);
    };
    const auto done = std::ranges::count(outcomes, std::optional{0}, &sweep::Outcome::exit_code);
    const auto refused = count("refused"), failed = count("failed"), open = count("not_computed");
    const auto early = static_cast<std::ptrdiff_t>(outcomes.size()) - done - refused - failed - open;
    print_summary(
        options, outcomes.size(),
        {{"done", done}, {"ended_early", early}, {"refused", refused}, {"failed", failed}, {"not_computed", open}});
    return failed + open > 0 ? ExitCode::stopped_early : ExitCode::ok;
}

/// Values of the factors with listed choices. The columns of a curve depend on loads, outputs and cavities, not on lengths and moduli;
/// therefore check_requests needs one design per combination of choices.
std::vector<std::string> listed_values(const sweep::Sweep& sweep, const sweep::PlannedDesign& design) {
    std::vector<std::string> values;
    for (std::size_t f = 0; f < sweep.factors.size(); ++f)
        if (std::holds_alternative<sweep::Choices>(sweep.factors[f].values)) values.push_back(design.values[f]);
    return values;
}

/// Throws Error(bad_input), with the location in the sweep file, for a case without derivatives.
void require_differentiable(const sweep::Sweep& sweep, const model::Case& model) {
    try {
        geometry::require_differentiable(model);
    } catch (const Error& error) {
        constexpr std::string_view option = "--";
        std::string reason = error.what();
        if (reason.starts_with(option)) reason.erase(0, option.size());
        throw Error(ExitCode::bad_input, sweep.sensitivity.front().location, reason);
    }
}

/// Rejects requested outputs that no curve of the sweep has, before anything is computed. A design that cannot be meshed is skipped;
/// its row reports the error.
void check_requests(const sweep::Sweep& sweep, const sweep::Plan& plan, const std::vector<sweep::State>& states) {
    std::set<std::vector<std::string>> seen;
    std::optional<Error> refusal;
    for (std::size_t d = 0; d < states.size(); ++d) {
        const sweep::PlannedDesign& row = plan.designs[d];
        if (states[d] != sweep::State::waiting || seen.contains(listed_values(sweep, row))) continue;
        std::optional<model::Case> model;
        try {
            model = geometry::build_case(design::read_design(row.design_yaml, row.id, geometry::catalogue_keys(), {}));
        } catch (const Error& error) {
            if (error.code() != ExitCode::bad_input) throw;
            continue;
        }
        seen.insert(listed_values(sweep, row));
        try {
            if (!sweep.sensitivity.empty()) require_differentiable(sweep, *model);
            const post::Curve curve = sweep::unsolved_curve(*model);
            sweep::check_requests(sweep, curve);
            sweep::check_derivatives(sweep, curve);
            return;
        } catch (const Error& error) {
            if (!refusal) refusal = error;
        }
    }
    if (refusal) throw Error(*refusal);
}

ExitCode write_plan(const SweepPlanOptions& options, const sweep::Sweep& sweep, const sweep::Plan& plan) {
    const std::vector<sweep::State> states = states_in(options.folder, plan);
    check_requests(sweep, plan, states);
    if (options.prepare) write_designs(options.folder, plan, states);
    const std::vector<std::string> waiting = sweep::waiting_ids(plan, states);
    if (!options.waiting.empty())
        cli::write_output(options.waiting, core::join(waiting, "\n") + (waiting.empty() ? "" : "\n"));
    cli::write_output(options.common.output, sweep::plan_csv(sweep, plan, states));
    const auto count = [&](sweep::State state) { return std::ranges::count(states, state); };
    if (options.prepare)
        cli::Console{about, options.common}.say(core::counted(states.size(), "design") + ", " +
                                                std::to_string(waiting.size()) + " to compute in " + options.folder);
    print_summary(options, states.size(),
                  {{"waiting", count(sweep::State::waiting)},
                   {"done", count(sweep::State::done)},
                   {"refused", count(sweep::State::refused)}});
    return ExitCode::ok;
}

constexpr std::size_t max_programs = std::size_t{1} << 20;  // bytes

std::string text_of(const core::Bytes& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

ExitCode sweep_plan(const SweepPlanOptions& options) {
    const cli::Input input = cli::read_design(options.input);
    const sweep::Sweep sweep = sweep::read_sweep(input.text(), input.source);
    const fs::path file = design::file_from(sweep.design.location, sweep.design.text);
    std::error_code unknown;
    if (!fs::exists(file, unknown))
        throw Error(ExitCode::cannot_open, sweep.design.location + ": design", file.string() + " does not exist",
                    "the path is relative to the folder of the sweep");
    const std::string design = text_of(core::read_regular_file(file, cli::max_design_bytes)),
                      source = file.lexically_normal().string();
    const std::string programs = options.programs.empty()
                                     ? std::string{cli::version()} + " " + std::string{cli::revision()}
                                     : text_of(core::read_file(options.programs, max_programs));
    const sweep::Plan plan =
        sweep::make_plan(sweep, {design, source, geometry::catalogue_keys(), programs, geometry::check_geometry});
    return options.results ? write_results(options, input, sweep, plan) : write_plan(options, sweep, plan);
}

}  // namespace

int main(int argc, char** argv) { return soft::cli::run_guarded(argc, argv, parse_sweep_plan_options, sweep_plan); }
