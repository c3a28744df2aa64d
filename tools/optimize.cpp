/// optimize: a goal (YAML) -> the design (YAML) that reaches it.
///     optimize goal.yaml | mesh-gen | solve | postprocess > curve.csv
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>

#include "cli.hpp"
#include "contact_check.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "design/tree.hpp"
#include "geometry/family.hpp"
#include "library_versions.hpp"
#include "linalg/session.hpp"
#include "optimize/search.hpp"

namespace {

using namespace soft;
using optimize::Condition;

const cli::About about{
    .tool = "optimize",
    .summary = "finds the design (YAML) that reaches a goal (YAML)",
    .examples = {{"optimize goal.yaml | mesh-gen | solve | postprocess > curve.csv",
                  "The curve of the design that reaches the goal"},
                 {"optimize goal.yaml --json report.json > found.yaml",
                  "The design, and how well each condition is met"}},
    .libraries =
        [] {
            return std::vector<cli::Library>{{"PETSc", linalg::petsc_version()},
                                             {"gmsh", cli::built_with::gmsh},
                                             {"yaml-cpp", cli::built_with::yaml_cpp}};
        },
    .exit_codes = {{ExitCode::stopped_early, "no design meets all conditions; the nearest is printed"}}};

struct OptimizeOptions {
    cli::CommonOptions common;
    std::string input, starts = "3";
};

std::optional<OptimizeOptions> parse_optimize_options(int argc, char** argv) {
    OptimizeOptions options;
    CLI::App app;
    cli::add_input(app, options.input, "GOAL", "The goal (YAML)");
    app.add_option("--starts", options.starts, "Number of points from which the search starts; the first is the design")
        ->type_name("N")
        ->capture_default_str();
    cli::add_common_options(app, options.common, about);
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    const auto starts = core::parse_count(options.starts);
    if (const long* number = std::get_if<long>(&starts); number == nullptr || *number < 1 || *number > 1000)
        throw Error(ExitCode::usage, "--starts", core::quoted(options.starts) + " is not a number from 1 to 1000");
    cli::check_distinct({{"GOAL", options.input}}, options.common);
    return options;
}

/// The base design, from the folder of the goal.
cli::Input read_base(const optimize::Goal& goal) {
    return cli::read_design(design::file_from(goal.location, goal.design_file));
}

std::string value_text(const Condition& condition, double value_SI) {
    std::string text = core::rounded_text(value_SI / condition.SI_per_unit, 5);
    if (!condition.unit.empty()) text.append(" ").append(condition.unit);
    return text;
}

std::string relation_text(const Condition& condition) {
    switch (condition.relation) {
        case Condition::Relation::equal: return "wanted " + condition.value_text;
        case Condition::Relation::below: return "below " + condition.value_text;
        case Condition::Relation::above: break;
    }
    return "above " + condition.value_text;
}

/// A bound within this fraction of its value is active.
constexpr double active_share = 2e-3;

std::string condition_text(const Condition& condition, double value_SI) {
    std::string text =
        condition.measure.text + ": " + value_text(condition, value_SI) + ", " + relation_text(condition);
    if (optimize::violation_of(condition, value_SI) > 0) return text + ": not met";
    const bool bound = condition.relation != Condition::Relation::equal;
    if (bound && std::abs(value_SI - condition.value_SI) <= active_share * std::abs(condition.value_SI))
        text += ": active";
    return text;
}

std::vector<std::string> report_lines(const optimize::Goal& goal, const optimize::Found& found) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < goal.variables.size(); ++i) {
        const optimize::Variable& variable = goal.variables[i];
        const bool at_end = found.values[i] - variable.from <= 1e-6 * (variable.to - variable.from) ||
                            variable.to - found.values[i] <= 1e-6 * (variable.to - variable.from);
        lines.push_back(variable.key + ": " + variable.text_of(found.values[i]) +
                        (at_end ? ", at the end of its range" : ""));
    }
    for (std::size_t i = 0; i < goal.conditions.size(); ++i)
        lines.push_back(condition_text(goal.conditions[i], found.trial.conditions[i].value_SI));
    if (goal.stable) lines.emplace_back(found.trial.is_stable ? "stable" : "stable: not met");
    if (goal.minimize) {
        const bool volume = goal.minimize->kind != optimize::Measure::Kind::curve;
        lines.push_back(goal.minimize->text + ": " +
                        (volume ? core::quantity_text(found.trial.objective.value_SI, core::Dimension::volume)
                                : core::rounded_text(found.trial.objective.value_SI, 5)) +
                        ", minimized");
    }
    return lines;
}

nlohmann::ordered_json report_json(const optimize::Goal& goal, const optimize::Found& found) {
    nlohmann::ordered_json json = cli::summary_head(about.tool);
    json["met"] = found.violation <= 0;
    json["violation"] = found.violation;
    json["trials"] = found.trials;
    const auto gradient_json = [&](const std::vector<double>& gradient) {
        nlohmann::ordered_json by_variable;
        for (std::size_t k = 0; k < gradient.size(); ++k)
            if (!goal.variables[k].is_whole) by_variable[goal.variables[k].key] = gradient[k];
        return by_variable;
    };
    for (std::size_t i = 0; i < goal.variables.size(); ++i)
        json["values"][goal.variables[i].key] = goal.variables[i].text_of(found.values[i]);
    for (std::size_t i = 0; i < goal.conditions.size(); ++i) {
        const auto& value = found.trial.conditions[i];
        json["conditions"].push_back({{"text", condition_text(goal.conditions[i], value.value_SI)},
                                      {"value_SI", value.value_SI},
                                      {"violation", optimize::violation_of(goal.conditions[i], value.value_SI)},
                                      {"derivatives_SI", gradient_json(value.gradient)}});
    }
    if (goal.minimize)
        json["objective"] = {{"text", goal.minimize->text},
                             {"value_SI", found.trial.objective.value_SI},
                             {"derivatives_SI", gradient_json(found.trial.objective.gradient)}};
    return json;
}

/// The base design with the values that were found, and the report as comments.
std::string found_design(const optimize::Goal& goal, const optimize::Found& found, const cli::Input& base,
                         const std::vector<std::string>& lines) {
    design::Node root = design::parse_yaml(base.text(), base.source);
    for (const design::Override& change : goal.set)
        design::put(root, change.path, design::parse_fragment(change.value, change.location));
    for (std::size_t i = 0; i < goal.variables.size(); ++i)
        design::put(root, goal.variables[i].key,
                    design::parse_fragment(goal.variables[i].text_of(found.values[i]), "vary"));
    std::string text;
    for (const std::string& line : lines) text += "# " + core::one_line(line, std::string::npos) + "\n";
    return text + design::write_yaml(root);
}

ExitCode run(const OptimizeOptions& options) {
    cli::Console console{about, options.common};
    const cli::Input input = cli::read_input(options.input, cli::max_design_bytes);
    optimize::Goal goal = optimize::read_goal(input.text(), input.source);
    const cli::Input base = read_base(goal);
    const std::vector<double> first =
        optimize::start_of(goal, design::read_design(base.text(), base.source, geometry::catalogue_keys(), goal.set));
    const linalg::Session session{{}};
    if (session.size() > 1) throw Error(ExitCode::usage, "", "runs on one rank only", "omit mpirun");
    optimize::Found found;
    {
        const cli::StdoutRedirection kept;
        int trial = 0;
        found = optimize::search(
            goal, first, std::stoi(options.starts),
            [&](const std::vector<double>& values) {
                ++trial;
                optimize::Trial result =
                    optimize::evaluate(goal, {std::string{base.text()}, base.source}, values, cli::contact_check);
                if (!result.failure.empty()) console.detail("trial " + std::to_string(trial) + ": " + result.failure);
                return result;
            },
            [&](const optimize::Found& best) {
                std::string text;
                for (std::size_t i = 0; i < goal.conditions.size(); ++i)
                    text +=
                        (i == 0 ? "" : "; ") + condition_text(goal.conditions[i], best.trial.conditions[i].value_SI);
                console.say("trial " + std::to_string(trial) + ": " + text);
            });
    }
    const std::vector<std::string> lines = report_lines(goal, found);
    cli::write_output(options.common.output, found_design(goal, found, base, lines));
    if (!options.common.json.empty()) cli::write_json(options.common.json, report_json(goal, found));
    for (const std::string& line : lines) console.say(line);
    if (found.violation <= 0) return ExitCode::ok;
    console.error("no such design: the nearest of " + std::to_string(found.trials) + " trials is printed");
    return ExitCode::stopped_early;
}

}  // namespace

int main(int argc, char** argv) {
    linalg::choose_blas_kernel(argv);
    return cli::run_guarded(argc, argv, parse_optimize_options, run);
}
