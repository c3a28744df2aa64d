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
    return {{"PETSc", linalg::petsc_version()}, {"HDF5", built_with::hdf5}, {"BLAS", linalg::blas_name()}};
}

const About about{.tool = "solve",
                  .summary = "follows the equilibrium path of a case, through limit points, to its full load or goal",
                  .examples = {{"mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv",
                                "the whole way from design to curve"},
                               {"mpirun -n 2 solve case.h5 -o result.h5 --set path.control=pressure -- -log_view",
                                "two ranks, another control, and an option of PETSc behind --"}},
                  .libraries = libraries};

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
        throw Error(ExitCode::usage, "--resume", "the file holds its case, its settings and its place",
                    "leave out CASE, --set, --fields and -o");
    if (!options.resume.empty() && options.tolerance)
        throw Error(ExitCode::usage, "--tolerance",
                    "an interrupted path cannot be judged: only its whole has error bars",
                    "solve the case again with --tolerance");
    for (const std::string& set : options.sets) static_cast<void>(design::parse_override(set));
    if (!options.petsc.empty() && !options.petsc.front().starts_with('-'))
        throw Error(ExitCode::usage, "", core::quoted(options.petsc.front()) + " behind -- is no option of PETSc",
                    "they begin with -, for example -ksp_monitor");
    for (const CLI::Option* option : app.get_options())
        if (options.batch && option->count() > 0 && !option->check_lname("batch"))
            throw Error(ExitCode::usage, option->get_name(), "says nothing to --batch itself",
                        "give it in the lines that --batch reads");
}

}  // namespace

const About& solve_about() noexcept { return about; }

std::optional<SolveOptions> parse_solve_options(int argc, char** argv) {
    SolveOptions options;
    options.petsc = take_rest(argc, argv);
    CLI::App app;
    add_input(app, options.input, "CASE", "case written by mesh-gen");
    app.add_option("--fields", options.fields,
                   "Steps that keep their displacements and pressures: all, last, none or every=N")
        ->type_name("WHICH")
        ->capture_default_str();
    std::string tolerance;
    app.add_option(
           "--tolerance", tolerance,
           "Halves all cells until the error bars of the load are within this part of it (0.1% or 0.001), and writes them")
        ->type_name("PART");
    app.add_option("--resume", options.resume,
                   "Goes on with the file that an interrupted `solve -o FILE` has left; no CASE")
        ->type_name("FILE");
    app.add_flag("--profile", options.profile,
                 "After the solve a table of where the time went, and the most memory used");
    app.add_flag(
        "--batch", options.batch,
        "Reads lines from stdin, each with the arguments of a solve of its own (CASE -o FILE ...), and answers each with its "
        "exit code and its user, system and wall seconds: many small cases without many starts");
    add_set_option(app, options.sets);
    add_common_options(app, options.common, about);
    if (!parse(app, about, options.common, argc, argv)) return std::nullopt;
    static_cast<void>(io::parse_fields_policy(options.fields));  // before any work
    check_distinct({{"CASE", options.input}, {"--resume", options.resume}},
                   {{"--output", options.common.output}, {"--json", options.common.json}});
    if (app.count("--tolerance") > 0) options.tolerance = parse_tolerance(tolerance);
    check(app, options);
    return options;
}

std::optional<SolveOptions> parse_batch_line(const std::string& line) {
    std::string visible = line;
    std::ranges::replace(visible, '\t', ' ');
    if (core::one_line(visible, visible.size()) != visible)
        throw Error(ExitCode::usage, "--batch", "a line with control characters, or that is not UTF-8",
                    "for example CASE -o FILE");
    auto words = core::shell_words(line);
    if (!words)
        throw Error(ExitCode::usage, "--batch", "a quote in the line is not closed, or it ends with a backslash",
                    "quote as in a shell: \"my case.h5\" -o 'my result.h5'");
    words->insert(words->begin(), std::string{about.tool});
    std::vector<char*> pointers;
    for (std::string& word : *words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    auto options = parse_solve_options(static_cast<int>(words->size()), pointers.data());
    if (!options) return options;
    const bool resumes = !options->resume.empty();
    if (options->batch || options->profile || !options->petsc.empty())
        throw Error(ExitCode::usage, "--batch", "--batch, --profile and options of PETSc are not for one of its lines",
                    "for example CASE -o FILE --json FILE");
    if (!resumes && (options->input.empty() || options->input == "-" || options->common.output == "-"))
        throw Error(ExitCode::usage, "--batch", "stdin and stdout are its own, a line names the files of its solve",
                    "for example CASE -o FILE");
    return options;
}

}  // namespace soft::cli
