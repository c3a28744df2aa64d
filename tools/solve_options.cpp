#include "solve_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/text.hpp"
#include "core/units.hpp"
#include "design/design.hpp"
#include "io/result_file.hpp"
#include "library_versions.hpp"
#include "linalg/session.hpp"

namespace soft::cli {
namespace {

std::vector<Library> libraries() {
    return {{"PETSc", linalg::petsc_version()},
            {"SLEPc", built_with::slepc},
            {"HDF5", built_with::hdf5},
            {"BLAS", linalg::blas_name()}};
}

const About about{
    .tool = "solve",
    .summary = "follows the equilibrium path of a case, also past limit points, to its full load or to path.until",
    .examples = {{"mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv",
                  "Complete pipeline from design to curve"},
                 {"mpirun -n 2 solve case.h5 -o result.h5 --set path.control=pressure -- -log_view",
                  "Two ranks, another control, and a PETSc option after --"}},
    .libraries = libraries,
    .exit_codes = {
        {ExitCode::check_failed, "the error bars exceed --tolerance, or the result violates the energy balance"},
        {ExitCode::stopped_early,
         "the path ended early for a physical or numerical reason; the message states "
         "stop_reason; the converged steps are in the file"}}};

double parse_tolerance(const std::string& text) {
    const double tolerance = core::quantity_or_throw(text, core::Dimension::ratio, ExitCode::usage, "--tolerance");
    if (!(tolerance > 0.0 && tolerance < 1.0))
        throw Error(ExitCode::usage, "--tolerance", core::quoted(text) + " is not between 0 and 1",
                    "for example 0.1% or 0.001");
    return tolerance;
}

void check(const CLI::App& app, const SolveOptions& options) {
    if (!options.resume.empty() &&
        (!options.input.empty() || !options.sets.empty() || options.common.output != "-" || app.count("--fields") > 0))
        throw Error(ExitCode::usage, "--resume", "the file contains the case, its settings and the last row",
                    "omit CASE, --set, --fields and -o");
    if (!options.resume.empty() && options.tolerance)
        throw Error(ExitCode::usage, "--tolerance", "cannot be combined with --resume: error bars need the whole path",
                    "solve the case again with --tolerance");
    for (const std::string& set : options.sets) static_cast<void>(design::parse_override(set));
    if (!options.petsc.empty() && !options.petsc.front().starts_with('-'))
        throw Error(ExitCode::usage, "", core::quoted(options.petsc.front()) + " after -- is not a PETSc option",
                    "PETSc options begin with -, for example -ksp_monitor");
    for (const CLI::Option* option : app.get_options())
        if (options.batch && option->count() > 0 && !option->check_lname("batch"))
            throw Error(ExitCode::usage, option->get_name(), "cannot be combined with --batch",
                        "give it in the lines that --batch reads");
}

}  // namespace

const About& solve_about() noexcept { return about; }

std::optional<SolveOptions> parse_solve_options(int argc, char** argv) {
    SolveOptions options;
    options.petsc = take_library_options(argc, argv);
    CLI::App app;
    add_input(app, options.input, "CASE", "Case written by mesh-gen");
    app.add_option("--fields", options.fields,
                   "Steps whose displacements and pressures are stored: all, last, none or every=N")
        ->type_name("WHICH")
        ->capture_default_str();
    std::string tolerance;
    app.add_option(
           "--tolerance", tolerance,
           "Solve again on meshes with all cells halved until the error bars of the load are below PART of the load "
           "(0.1% or 0.001); write the error bars")
        ->type_name("PART");
    app.add_option("--resume", options.resume, "Continue an interrupted `solve -o FILE`; omit CASE")->type_name("FILE");
    app.add_option("--cores", options.cores, "Cores to use; the results do not depend on it (default: all)")
        ->type_name("N")
        ->check(CLI::Range(1, 256));
    app.add_flag("--profile", options.profile, "Print the time of each phase and the peak memory");
    app.add_flag(
        "--batch", options.batch,
        "Solve many cases in one process: each line of stdin has the arguments of one solve (CASE -o FILE ...); print its exit "
        "code and user, system and wall time in seconds");
    add_set_option(app, options.sets);
    add_common_options(app, options.common, about);
    if (!parse(app, about, options.common, argc, argv)) return std::nullopt;
    static_cast<void>(io::parse_fields_policy(options.fields));  // before any work
    check_distinct({{"CASE", options.input}, {"--resume", options.resume}}, options.common);
    if (app.count("--tolerance") > 0) options.tolerance = parse_tolerance(tolerance);
    check(app, options);
    return options;
}

std::optional<SolveOptions> parse_batch_line(const std::string& line) {
    std::string visible = line;
    std::ranges::replace(visible, '\t', ' ');
    if (core::one_line(visible, visible.size()) != visible)
        throw Error(ExitCode::usage, "--batch", "a line contains control characters or is not UTF-8",
                    "for example CASE -o FILE");
    auto words = core::shell_words(line);
    if (!words)
        throw Error(ExitCode::usage, "--batch", "a quote in the line is not closed, or the line ends with a backslash",
                    "quote as in a shell: \"my case.h5\" -o 'my result.h5'");
    words->insert(words->begin(), std::string{about.tool});
    std::vector<char*> pointers;
    for (std::string& word : *words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    auto options = parse_solve_options(static_cast<int>(words->size()), pointers.data());
    if (!options) return options;
    const bool resumes = !options->resume.empty();
    if (options->batch || options->profile || !options->petsc.empty())
        throw Error(ExitCode::usage, "--batch", "--batch, --profile and PETSc options are not allowed in its lines",
                    "for example CASE -o FILE --json FILE");
    if (!resumes && (options->input.empty() || options->input == "-" || options->common.output == "-"))
        throw Error(ExitCode::usage, "--batch",
                    "a line must name the files of its solve, since --batch uses stdin and stdout",
                    "for example CASE -o FILE");
    return options;
}

}  // namespace soft::cli
