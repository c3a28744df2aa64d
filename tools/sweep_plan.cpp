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
#include "library_versions.hpp"
#include "sweep_folder.hpp"

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
    std::string input, folder, programs, waiting;
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
    app.add_option("--programs", options.programs,
                   "File with the versions of the programs, which are part of the hash ID")
        ->type_name("FILE");
    cli::add_common_options(app, options.common, about);
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    cli::require_at_most_one(app, std::vector<std::string>{"--prepare", "--results"});
    cli::check_distinct({{"SWEEP", options.input}, {"--programs", options.programs}}, options.common,
                        {{"--waiting", options.waiting}});
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

ExitCode write_results(const SweepPlanOptions& options, const sweep::Sweep& sweep, const sweep::Plan& plan) {
    const std::vector<sweep::Outcome> outcomes = outcomes_in(options.folder, sweep, plan);
    cli::write_output(options.common.output, sweep::results_csv(sweep, plan, outcomes));
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

/// Rejects requested outputs that no curve of the sweep has, before anything is computed. A design that cannot be meshed is skipped;
/// its row reports the error.
void check_requests(const sweep::Sweep& sweep, const sweep::Plan& plan, const std::vector<sweep::State>& states) {
    std::set<std::vector<std::string>> seen;
    std::optional<Error> refusal;
    for (std::size_t d = 0; d < states.size(); ++d) {
        const sweep::PlannedDesign& row = plan.designs[d];
        if (states[d] != sweep::State::waiting || seen.contains(listed_values(sweep, row))) continue;
        std::optional<post::Curve> curve;
        try {
            curve = sweep::unsolved_curve(
                geometry::build_case(design::read_design(row.design_yaml, row.id, geometry::catalogue_keys(), {})));
        } catch (const Error& error) {
            if (error.code() != ExitCode::bad_input) throw;
            continue;
        }
        seen.insert(listed_values(sweep, row));
        try {
            sweep::check_requests(sweep, *curve);
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
    return options.results ? write_results(options, sweep, plan) : write_plan(options, sweep, plan);
}

}  // namespace

int main(int argc, char** argv) { return soft::cli::run_guarded(argc, argv, parse_sweep_plan_options, sweep_plan); }
