/// optimize: a goal (YAML) -> the design (YAML) that reaches it.
///     optimize goal.yaml | mesh-gen | solve | postprocess > curve.csv
#include <omp.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "cli.hpp"
#include "contact_check.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "design/material_library.hpp"
#include "design/tree.hpp"
#include "geometry/build.hpp"
#include "geometry/family.hpp"
#include "interrupt.hpp"
#include "library_versions.hpp"
#include "linalg/session.hpp"
#include "optimize/data.hpp"
#include "optimize_report.hpp"
#include "optimize_trials.hpp"

namespace {

using namespace soft;

const cli::About about{
    .tool = "optimize",
    .summary = "finds the design (YAML) that reaches a goal (YAML)",
    .examples = {{"optimize goal.yaml | mesh-gen | solve | postprocess > curve.csv",
                  "The curve of the design that reaches the goal"},
                 {"optimize goal.yaml --json report.json > found.yaml",
                  "The design, and how well each condition is met"},
                 {"optimize measured.yaml --starts 6 --jobs 2 --folder trials > fitted.yaml",
                  "Constants from measured curves, with their errors; --resume continues after an interruption"}},
    .libraries =
        [] {
            return std::vector<cli::Library>{{"PETSc", linalg::petsc_version()},
                                             {"gmsh", cli::built_with::gmsh},
                                             {"yaml-cpp", cli::built_with::yaml_cpp}};
        },
    .exit_codes = {{ExitCode::stopped_early, "no design meets all conditions; the nearest is printed"}}};

struct OptimizeOptions {
    cli::CommonOptions common;
    std::string input, folder, starts = "3", jobs = "1", global = "0";
    bool resume = false;
};

void check_count(const std::string& option, const std::string& text, long least) {
    constexpr long most = 1000;
    const auto count = core::parse_count(text);
    if (const long* number = std::get_if<long>(&count); number == nullptr || *number < least || *number > most)
        throw Error(
            ExitCode::usage, option,
            core::quoted(text) + " is not a number from " + std::to_string(least) + " to " + std::to_string(most));
}

std::optional<OptimizeOptions> parse_optimize_options(int argc, char** argv) {
    OptimizeOptions options;
    CLI::App app;
    cli::add_input(app, options.input, "GOAL", "The goal (YAML)");
    app.add_option("--starts", options.starts, "Number of points from which the search starts; the first is the design")
        ->type_name("N")
        ->capture_default_str();
    app.add_option(
           "--global", options.global,
           "Number of trials over the whole ranges, without derivatives, for goals with several optima or whole numbers")
        ->type_name("N")
        ->capture_default_str();
    app.add_option("--jobs", options.jobs, "Number of starts that run side by side, each on one core")
        ->type_name("N")
        ->capture_default_str();
    auto* const folder = app.add_option("--folder", options.folder, "Keep the trials in FOLDER")->type_name("FOLDER");
    app.add_flag("--resume", options.resume, "Continue the search whose trials are in FOLDER")->needs(folder);
    cli::add_common_options(app, options.common, about);
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    check_count("--starts", options.starts, 1);
    check_count("--global", options.global, 0);
    check_count("--jobs", options.jobs, 1);
    cli::check_distinct({{"GOAL", options.input}}, options.common);
    return options;
}

/// The designs of the runs, from the folder of the goal.
std::vector<optimize::Base> read_bases(const optimize::Goal& goal) {
    std::vector<optimize::Base> bases;
    for (const optimize::Run& run : goal.runs) {
        const cli::Input input = cli::read_design(design::file_from(run.location, run.design_file));
        bases.push_back({std::string{input.text()}, input.source});
    }
    return bases;
}

/// The values of the variables in the designs; also completes the goal.
std::vector<double> complete(optimize::Goal& goal, std::span<const optimize::Base> bases) {
    std::vector<design::Design> designs;
    for (std::size_t run = 0; run < bases.size(); ++run)
        designs.push_back(
            design::read_design(bases[run].text, bases[run].source, geometry::catalogue_keys(), goal.runs[run].set));
    optimize::add_data(goal, bases);
    return optimize::start_of(goal, designs);
}

/// Names of files that are not valid from `folder` become absolute.
void name_files_from(const std::filesystem::path& folder, const design::Values& values, design::Node& root) {
    const auto full = [](const std::filesystem::path& path) { return absolute(path).lexically_normal(); };
    for (const std::string& key : values.file_keys()) {
        const std::filesystem::path file = full(design::file_from(values.location(key), values.text(key)));
        if (full(folder / values.text(key)) != file) design::put(root, key, design::scalar_node(file.string(), "file"));
    }
}

/// The base design with the values that were found, and the report as comments, as a file in `folder`.
std::string found_design(const optimize::Goal& goal, const optimize::Found& found, const optimize::Base& base,
                         const std::filesystem::path& folder, const std::vector<std::string>& lines) {
    const std::vector<design::Override>& set = goal.runs.front().set;
    design::Node root = design::parse_yaml(base.text, base.source);
    design::expand_material_names(root);
    for (const design::Override& change : set)
        design::put(root, change.path, design::parse_fragment(change.value, change.location));
    for (const std::size_t i : goal.runs.front().variables)
        design::put(root, goal.variables[i].key,
                    design::parse_fragment(goal.variables[i].text_of(found.values[i]), "vary"));
    name_files_from(folder, design::read_design(base.text, base.source, geometry::catalogue_keys(), set).values, root);
    std::string text;
    for (const std::string& line : lines) text += "# " + core::one_line(line, std::string::npos) + "\n";
    return text + design::write_yaml(root);
}

/// A folder that lasts as long as this object, unless the user named one.
class Folder {
public:
    explicit Folder(const std::string& named) : path_(named), is_temporary_(named.empty()) {
        if (is_temporary_) {
            std::string name = (std::filesystem::temp_directory_path() / "optimize-XXXXXX").string();
            if (::mkdtemp(name.data()) == nullptr)
                throw Error(ExitCode::cannot_create, name, std::generic_category().message(errno));
            path_ = name;
        } else {
            cli::make_folder(named);
        }
    }
    ~Folder() {
        std::error_code ignored;
        if (is_temporary_) std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

private:
    std::filesystem::path path_;
    bool is_temporary_;
};

/// The search, with its trials in a file. Starts that run side by side only fill the file.
class FiledSearch {
public:
    FiledSearch(const OptimizeOptions& options, cli::Console& console, const optimize::Goal& goal,
                std::span<const optimize::Base> bases, const std::vector<double>& first, const std::string& identity)
        : options_(options),
          console_(console),
          goal_(goal),
          bases_(bases),
          first_(first),
          folder_(options.folder),
          notice_(about.tool, options.common.verbosity),
          trials_(folder_.path(), identity, options.resume) {
        notice_.set("the same command with --folder " + folder_.path().string() + " --resume continues");
        if (options.resume) console.say(core::counted(trials_.size(), "trial") + " in " + folder_.path().string());
    }

    optimize::Found run() {
        const int starts = std::stoi(options_.starts), jobs = std::min(starts, std::stoi(options_.jobs));
        if (jobs > 1) {
            run_side_by_side(jobs, [&](int job) {
                const linalg::Session session{{}};
                omp_set_num_threads(1);
                for (int start = job; start < starts; start += jobs)
                    optimize::run_start(goal_, first_, {starts, start}, evaluate(),
                                        progress("start " + std::to_string(start + 1) + ", "));
            });
            trials_.read();
        }
        const linalg::Session session{{}};
        if (session.size() > 1) throw Error(ExitCode::usage, "", "runs on one rank only", "omit mpirun");
        return optimize::search(goal_, first_, {starts, std::stoi(options_.global)}, evaluate(), progress(""));
    }

private:
    [[nodiscard]] optimize::Evaluate evaluate() {
        return [this](const std::vector<double>& values) {
            ++trial_;
            optimize::Trial trial = trials_.at(values, [this](const std::vector<double>& new_values) {
                return optimize::evaluate(goal_, bases_, new_values, cli::contact_check);
            });
            if (!trial.failure.empty()) console_.detail("trial " + std::to_string(trial_) + ": " + trial.failure);
            return trial;
        };
    }
    [[nodiscard]] optimize::Progress progress(const std::string& start) {
        return [this, start](const optimize::Found& best) {
            console_.say(start + "trial " + std::to_string(trial_) + ": " + progress_text(goal_, best));
        };
    }

    const OptimizeOptions& options_;
    cli::Console& console_;
    const optimize::Goal& goal_;
    std::span<const optimize::Base> bases_;
    const std::vector<double>& first_;
    Folder folder_;  // a temporary one remains after an interruption
    cli::InterruptNotice notice_;
    TrialFile trials_;
    int trial_ = 0;
};

/// What the trials in a folder depend on: the goal, its data, the designs and the files that they name, by their meshes.
std::string identity_of(const OptimizeOptions& options, const optimize::Goal& goal, std::string_view text,
                        std::span<const optimize::Base> bases) {
    std::string identity = std::string{cli::version()} + std::string{text} + options.starts;
    for (const optimize::Condition& condition : goal.conditions)
        identity += condition.measure.text + " " + condition.value_text + "\n";
    for (std::size_t run = 0; run < bases.size(); ++run) {
        const design::Design design =
            design::read_design(bases[run].text, bases[run].source, geometry::catalogue_keys(), goal.runs[run].set);
        identity += design.effective_yaml;
        for (const mesh::Point& point : geometry::build_with_figures(design).model.mesh.points)
            for (const double coordinate : point) identity += core::number_text(coordinate) + " ";
    }
    return identity;
}

ExitCode run(const OptimizeOptions& options) {
    cli::Console console{about, options.common};
    cli::check_output(options.common.output, cli::Content::text);
    if (!options.common.json.empty()) cli::check_output(options.common.json, cli::Content::text);
    const cli::Input input = cli::read_input(options.input, cli::max_design_bytes);
    optimize::Goal goal = optimize::read_goal(input.text(), input.source);
    const std::vector<optimize::Base> bases = read_bases(goal);
    const std::vector<double> first = complete(goal, bases);
    const std::string identity = identity_of(options, goal, input.text(), bases);
    optimize::Found found;
    {
        const cli::StdoutRedirection kept;
        found = FiledSearch(options, console, goal, bases, first, identity).run();
    }
    const std::vector<std::string> lines = report_lines(goal, found);
    if (!options.common.json.empty()) cli::write_json(options.common.json, report_json(goal, found));
    const auto folder = std::filesystem::path{options.common.output}.parent_path();  // "-": the working directory
    cli::write_output(options.common.output, found_design(goal, found, bases.front(), folder, lines));
    for (const std::string& line : lines) console.say(line);
    if (found.violation <= 0) return ExitCode::ok;
    console.error("no such design is found: the nearest of " + std::to_string(found.trials) +
                  " trials is printed; try more --starts, or other ranges of vary");
    return ExitCode::stopped_early;
}

}  // namespace

int main(int argc, char** argv) {
    linalg::choose_blas_kernel(argv);
    return cli::run_guarded(argc, argv, parse_optimize_options, run);
}
