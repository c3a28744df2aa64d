/// solve: a case -> a result: follows the equilibrium path R(u, p) = 0 of a pressurised hyperelastic body,
///     int P : grad(du) dV = pressure x (change of enclosed volume),   int dp (Theta(J) - p/kappa) dV = 0.
///     mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv
///     mpirun -n 2 solve case.h5 -o result.h5 -- -mat_mumps_icntl_14 120
#include <CLI/CLI.hpp>
#include <optional>

#include "cli.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "design/design.hpp"
#include "io/result_file.hpp"
#include "library_versions.hpp"
#include "linalg/profile.hpp"
#include "linalg/session.hpp"
#include "ranks.hpp"
#include "solve_run.hpp"

namespace soft {
namespace {

std::vector<cli::Library> libraries() {
    return {{"PETSc", linalg::petsc_version()}, {"HDF5", cli::built_with::hdf5}, {"BLAS", linalg::blas_name()}};
}

const cli::About about{
    .tool = "solve",
    .summary = "follows the equilibrium path of a case, through limit points, to its full load or goal",
    .examples = {{"mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv",
                  "the whole way from design to curve"},
                 {"mpirun -n 2 solve case.h5 -o result.h5 --set path.control=pressure -- -log_view",
                  "two ranks, another control, and an option of PETSc behind --"}},
    .libraries = libraries};

using cli::SolveOptions;

double parse_tolerance(const std::string& text) {
    const double tolerance = core::quantity_or_throw(text, core::Dimension::ratio, ExitCode::usage, "--tolerance");
    if (!(tolerance > 0.0 && tolerance < 1.0))
        throw Error(ExitCode::usage, "--tolerance", core::quoted(text) + " is not between 0 and 1",
                    "for example 0.1% or 0.001");
    return tolerance;
}

std::optional<SolveOptions> parse_solve_options(int argc, char** argv) {
    SolveOptions options;
    options.petsc = cli::take_rest(argc, argv);
    CLI::App app;
    cli::add_input(app, options.input, "CASE", "case written by mesh-gen");
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
    cli::add_set_option(app, options.sets);
    cli::add_common_options(app, options.common, about);
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    static_cast<void>(io::parse_fields_policy(options.fields));  // before any work
    cli::check_distinct({{"CASE", options.input}, {"--resume", options.resume}},
                        {{"--output", options.common.output}, {"--json", options.common.json}});
    if (!options.resume.empty() &&
        (!options.input.empty() || !options.sets.empty() || options.common.output != "-" || app.count("--fields") > 0))
        throw Error(ExitCode::usage, "--resume", "the file holds its case, its settings and its place",
                    "leave out CASE, --set, --fields and -o");
    if (app.count("--tolerance") > 0) options.tolerance = parse_tolerance(tolerance);
    if (!options.resume.empty() && options.tolerance)
        throw Error(ExitCode::usage, "--tolerance",
                    "an interrupted path cannot be judged: only its whole has error bars",
                    "solve the case again with --tolerance");
    for (const std::string& set : options.sets) static_cast<void>(design::parse_override(set));
    if (!options.petsc.empty() && !options.petsc.front().starts_with('-'))
        throw Error(ExitCode::usage, "", core::quoted(options.petsc.front()) + " behind -- is no option of PETSc",
                    "they begin with -, for example -ksp_monitor");
    return options;
}

ExitCode solve(const SolveOptions& options) {
    if (options.resume.empty()) cli::check_output(options.common.output, cli::Content::binary);
    const linalg::Session session{options.petsc};
    if (options.profile) linalg::start_profile();
    return cli::on_all_ranks(session.rank(), session.size(), [&] { return cli::run_solve(options, about, session); });
}

}  // namespace
}  // namespace soft

int main(int argc, char** argv) {
    soft::linalg::choose_blas_kernel(argv);
    return soft::cli::run_guarded(argc, argv, soft::parse_solve_options, soft::solve);
}
