/// solve: a case -> a result: follows the equilibrium path R(u, p) = 0 of a pressurised hyperelastic body,
///     int P : grad(du) dV = pressure x (change of enclosed volume),   int dp (Theta(J) - p/kappa) dV = 0.
///     mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv
///     mpirun -n 2 solve case.h5 -o result.h5 -- -mat_mumps_icntl_14 120
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli.hpp"
#include "core/text.hpp"
#include "design/design.hpp"
#include "io/result_file.hpp"
#include "library_versions.hpp"
#include "linalg/session.hpp"
#include "ranks.hpp"
#include "solve_summary.hpp"
#include "solver/path.hpp"

namespace soft {
namespace {

struct SolveOptions {
    cli::CommonOptions common;
    std::string input;
    std::vector<std::string> sets;
    std::string resume;
    std::string fields = "all";
    std::vector<std::string> petsc;
};

std::vector<cli::Library> libraries() {
    return {{"PETSc", linalg::petsc_version()}, {"HDF5", cli::built_with::hdf5}, {"BLAS", linalg::blas_name()}};
}

const cli::About about{
    .tool = "solve",
    .summary = "follows the equilibrium path of a case, through limit points, to its full load or goal",
    .examples = {{"mesh-gen designs/bellows.yaml | solve | postprocess > curve.csv", "the whole way from design to curve"},
                 {"mpirun -n 2 solve case.h5 -o result.h5 --set path.control=pressure -- -log_view",
                  "two ranks, another control, and an option of PETSc behind --"}},
    .libraries = libraries};

std::optional<SolveOptions> parse_solve_options(int argc, char** argv) {
    SolveOptions options;
    options.petsc = cli::take_rest(argc, argv);
    CLI::App app;
    cli::add_input(app, options.input, "CASE", "case written by mesh-gen");
    app.add_option("--fields", options.fields, "Steps that keep their displacements and pressures: all, last, none or every=N")
        ->type_name("WHICH")->capture_default_str();
    app.add_option("--resume", options.resume, "Goes on with the file that an interrupted `solve -o FILE` has left; no CASE")
        ->type_name("FILE");
    cli::add_set_option(app, options.sets);
    cli::add_common_options(app, options.common, about);
    if (!cli::parse(app, about, options.common, argc, argv)) return std::nullopt;
    static_cast<void>(io::parse_fields_policy(options.fields));   // before any work
    if (!options.resume.empty() && (!options.input.empty() || !options.sets.empty() || options.common.output != "-" ||
                                    app.count("--fields") > 0))
        throw Error(ExitCode::usage, "--resume", "the file holds its case, its settings and its place",
                    "leave out CASE, --set, --fields and -o");
    for (const std::string& set : options.sets) static_cast<void>(design::parse_override(set));
    if (!options.petsc.empty() && !options.petsc.front().starts_with('-'))
        throw Error(ExitCode::usage, "", core::quoted(options.petsc.front()) + " behind -- is no option of PETSc",
                    "they begin with -, for example -ksp_monitor");
    return options;
}

/// Applies --set to what a solver may still change.
std::optional<io::DesignText> apply_sets(const std::vector<std::string>& sets, io::CaseFile& file) {
    if (sets.empty()) return std::nullopt;
    std::vector<design::Override> overrides;
    for (const std::string& set : sets) overrides.push_back(design::parse_override(set));
    design::SolveChanges changes = design::apply_overrides(file.design.effective_yaml, overrides);
    for (model::Material& material : file.model.materials) {   // the mesh decides names and fibre frame
        changes.material.name = material.name;
        changes.material.fiber_frame = material.fiber_frame;
        material = changes.material;
    }
    file.model.loads = std::move(changes.loads);
    std::vector<model::TractionLoad> tractions;
    for (const design::TractionChange& change : changes.tractions) {
        tractions.push_back(file.model.tractions.at(change.index));
        for (double& component : tractions.back().traction_Pa) component *= change.factor;
    }
    file.model.tractions = std::move(tractions);
    file.model.path = std::move(changes.path);
    file.model.solver = changes.solver;
    return io::DesignText{file.design.family, std::move(changes.effective_yaml), sets};
}

io::ResultWriter make_writer(const SolveOptions& options, const cli::Input& input, const io::ResultOptions& result) {
    const io::Provenance provenance{std::string{about.tool}, std::string{cli::version()}, std::string{cli::revision()},
                                    cli::library_lines(about), options.common.command_line};
    if (options.common.output == "-") return {input.bytes, input.source, provenance, result};
    return {options.common.output, input.bytes, input.source, provenance, result};
}

ExitCode run(const SolveOptions& options, const linalg::Session& session) {
    const auto start = std::chrono::steady_clock::now();
    const bool first = session.rank() == 0;
    cli::Console console{about.tool, first ? options.common.verbosity : cli::Verbosity::quiet};
    const bool resumes = !options.resume.empty();
    const std::string output = resumes ? options.resume : options.common.output;
    const cli::Input input = cli::read_input_on_first_rank(resumes ? options.resume : options.input, session.rank());
    io::Interrupted from;
    if (resumes)
        from = io::read_interrupted(input.bytes, input.source);
    else
        from.file = io::read_case_file(input.bytes, input.source);
    io::CaseFile& file = from.file;
    const auto changed = apply_sets(from.changed_design ? from.changed_design->overrides : options.sets, file);
    assembly::System system{file.model, PETSC_COMM_WORLD};
    std::optional<io::ResultWriter> writer;
    if (first)
        writer = resumes ? io::ResultWriter::resume(output, input.bytes)
                         : make_writer(options, input, {io::parse_fields_policy(options.fields), changed});

    cli::SolveSummary summary;
    std::optional<solution::Step> undeformed;
    if (from.checkpoint) {
        undeformed = from.steps.front();
        summary.steps = from.checkpoint->rows;
        console.say("goes on from row " + std::to_string(summary.steps - 1) + ", " +
                    cli::step_text(from.steps.back(), file.model));
    }
    double share = 0;   // the load may fall past a limit point; progress does not
    const auto sink = [&](const solution::Step& step, Vec x) {
        const auto fields = system.gather_fields(x);
        if (!first) return;
        writer->append(step, fields.displacement_m, fields.pressure_Pa);
        if (!undeformed) undeformed = step;
        share = std::max(share, cli::share_done(*undeformed, step, file.model));
        console.progress(share, cli::step_text(step, file.model));
        ++summary.steps;
    };
    const solver::Log log = [&](const std::string& line) { console.detail(line); };
    {
        const cli::StdoutKeptForData kept;
        const auto keep = [&](const solution::Checkpoint& checkpoint) {
            if (first) writer->remember(checkpoint);
        };
        const bool on_disk = output != "-";
        summary.end = solver::follow_path(
            system, {sink, on_disk ? solver::CheckpointSink(keep) : solver::CheckpointSink(), log},
            from.checkpoint ? &*from.checkpoint : nullptr);
    }
    --summary.steps;   // the undeformed state is no step
    summary.unknowns = system.dofs().total;
    summary.ranks = session.size();
    if (first) {
        const auto bytes = writer->finish(summary.end);
        if (output == "-") cli::write_output("-", bytes, cli::Content::binary);
        cli::measure_process(summary);
        summary.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        console.say(cli::summary_line(summary));
        for (const std::string& option : session.unused_options()) console.warn("PETSc knows no option -" + option);
        if (!options.common.json.empty()) cli::write_json(options.common.json, cli::summary_json(summary, file.model));
    }
    return summary.end.reason == solution::StopReason::done ? ExitCode::ok : ExitCode::stopped_early;
}

ExitCode solve(const SolveOptions& options) {
    if (options.resume.empty()) cli::check_output(options.common.output, cli::Content::binary);
    const linalg::Session session{options.petsc};
    return cli::on_all_ranks(session.rank(), session.size(), [&] { return run(options, session); });
}

/// OpenBLAS picks its kernels when it is loaded; where it has picked badly the program starts itself again with the
/// right name set. Any value the user has set is left alone.
void choose_blas_kernel(char** argv) {
    std::string better;
    if (std::getenv("OPENBLAS_CORETYPE") != nullptr || !linalg::blas_kernel_is_poor(better)) return;
    setenv("OPENBLAS_CORETYPE", better.c_str(), 0);
    execv("/proc/self/exe", argv);   // returns only on failure: then it runs on, slower
}

}  // namespace
}  // namespace soft

int main(int argc, char** argv) {
    soft::choose_blas_kernel(argv);
    return soft::cli::run_guarded(argc, argv, soft::parse_solve_options, soft::solve);
}
