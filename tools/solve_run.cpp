#include "solve_run.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <optional>

#include "contact_check.hpp"
#include "core/text.hpp"
#include "design/fitted.hpp"
#include "design/tree.hpp"
#include "event_summary.hpp"
#include "geometry/build.hpp"
#include "geometry/variations.hpp"
#include "interrupt.hpp"
#include "io/result_file.hpp"
#include "linalg/profile.hpp"
#include "material_summary.hpp"
#include "post/path_warnings.hpp"
#include "ranks.hpp"
#include "solve_accuracy.hpp"
#include "solve_summary.hpp"
#include "solver/motion.hpp"
#include "solver/path.hpp"
#include "solver/sensitivities.hpp"

namespace soft::cli {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A case with --set applied, or the state of an interrupted solve.
struct Task {
    Input input;
    std::string output;
    io::InterruptedSolve from;              ///< a new path has only the case
    std::optional<io::DesignText> changed;  ///< design changed by --set of this run
    bool resumes = false;
};

/// Reads the case and applies --set; `changed` receives the changed design. Throws Error (usage) for a --set of a number that the case
/// varies.
io::CaseFile read_changed_case(const Input& input, const std::vector<std::string>& sets,
                               std::optional<io::DesignText>& changed) {
    std::vector<design::Override> overrides;
    for (const std::string& set : sets) overrides.push_back(design::parse_override(set));
    std::vector<std::vector<model::DesignParameter>>
        numbers;  // of the lower and higher case of each parameter, then of the case
    io::CaseFile file = io::read_case_file(
        input.bytes, input.source,
        [&](mesh::Mesh mesh, const model::Shape& shape, std::string_view yaml, std::string_view source) {
            const design::Design design = geometry::read_built_design(mesh, shape, yaml, source, overrides);
            if (!sets.empty()) changed = {design.effective_yaml, sets};  // the last one is the case itself
            numbers.push_back(design.parameters);
            return geometry::build_case(design, std::move(mesh), shape);
        });
    if (!file.model.parameters.empty()) geometry::require_differentiable(file.model);
    for (std::size_t i = 0; i < file.model.parameters.size(); ++i) {
        const model::DesignParameter& parameter = file.model.parameters[i];
        const auto has = [&](const std::vector<model::DesignParameter>& design, double value) {
            const auto found = std::ranges::find(design, parameter.key, &model::DesignParameter::key);
            return found != design.end() && found->value == value;
        };
        if (!has(numbers[2 * i], parameter.lower) || !has(numbers[2 * i + 1], parameter.higher))
            throw Error(ExitCode::usage, "--set", "changes " + parameter.key + ", by which the case has sensitivities",
                        "set it in mesh-gen, with --sensitivity");
    }
    return file;
}

Task read_task(const SolveOptions& options, int rank) {
    Task task;
    task.resumes = !options.resume.empty();
    task.output = task.resumes ? options.resume : options.common.output;
    task.input = read_input_on_first_rank(task.resumes ? options.resume : options.input, rank);
    if (task.resumes) {
        task.from = io::read_interrupted(task.input.bytes, task.input.source, geometry::rebuild_case);
        for (const io::Provenance& stage : task.from.file.provenance)
            if (stage.tool == solve_about().tool && stage.command_line.find(" --tolerance") != std::string::npos)
                throw Error(ExitCode::bad_input, task.input.source, "a run with --tolerance cannot be resumed",
                            "solve the case again with --tolerance; postprocess reads the existing rows");
        task.changed = task.from.changed_design;
        if (!task.from.file.model.parameters.empty()) {
            if (task.from.checkpoint && (task.from.checkpoint->stage > 0 || !task.from.checkpoint->internal.empty()))
                throw Error(
                    ExitCode::bad_input, task.input.source,
                    "a run with sensitivities cannot be resumed after its first stage, or with inelastic rubber",
                    "solve the case again");
            std::optional<io::DesignText> ignored;
            const auto sets = task.changed ? task.changed->overrides : std::vector<std::string>{};
            task.from.file.variations = read_changed_case(task.input, sets, ignored).variations;
        }
    } else {
        task.from.file = read_changed_case(task.input, options.sets, task.changed);
    }
    if (options.cores > 0) task.from.file.model.solver.threads = options.cores;
    return task;
}

void check_motion(const SolveOptions& options, const model::Case& model) {
    if (options.tolerance && !model.parameters.empty())
        throw Error(ExitCode::usage, "--tolerance", "error bars are not available with sensitivities",
                    "solve a case that mesh-gen wrote without --sensitivity");
    if (!model.dynamics) return;
    if (!options.resume.empty())
        throw Error(ExitCode::usage, "--resume", "a motion in time cannot be resumed", "solve the case again");
    if (options.tolerance)
        throw Error(
            ExitCode::usage, "--tolerance", "error bars are not available for a motion in time",
            "omit --tolerance and compare with a finer mesh (mesh.refine) and shorter steps (dynamics.accuracy)");
}

/// `output`: "-" for a writer in memory.
io::ResultWriter new_writer(const SolveOptions& options, const Task& task, const std::string& output) {
    const io::SolveInput given{task.input.bytes, task.input.source, task.from.file.model};
    const About& about = solve_about();
    const io::Provenance provenance{std::string{about.tool}, std::string{version()}, std::string{revision()},
                                    library_lines(about), options.common.command_line};
    const io::ResultOptions result{io::parse_fields_policy(options.fields), task.changed};
    if (output == "-") return {given, provenance, result};
    return {output, given, provenance, result};
}

io::ResultWriter make_writer(const SolveOptions& options, const Task& task) {
    const io::SolveInput given{task.input.bytes, task.input.source, task.from.file.model};
    if (task.resumes) return io::ResultWriter::resume(task.output, given);
    return new_writer(options, task, task.output);
}

/// Follows the path; `writer` is nullptr on all ranks but the first.
SolveSummary follow(fem::System& system, const Task& task, const SolveOptions& options, io::ResultWriter* writer,
                    Console& console, InterruptNotice& notice) {
    const auto begin = std::chrono::steady_clock::now();
    const model::Case& model = task.from.file.model;
    SolveSummary summary;
    Progress progress{model};
    RemainingTime remaining;
    const std::string_view no_resume = model.dynamics      ? "a motion in time cannot be resumed"
                                       : options.tolerance ? "a run with --tolerance cannot be resumed"
                                                           : "";
    const auto report = [&](const model::Step& step, double share) {
        console.progress(share, step_text(step, model) + remaining.text(share));
    };
    const auto count = [&](const model::Step& step) {
        summary.last = step;
        if (!summary.first) summary.first = step;
        if (!step.stable && !summary.first_unstable_row) summary.first_unstable_row = summary.steps;
        if (!step.stable_under_control.value_or(step.stable)) summary.became_unstable = true;
        summary.max_stretch_p99 = std::max(summary.max_stretch_p99, step.stretch_p99);
        if (post::is_crushed_at_a_point(step) && !summary.first_crushed_row) summary.first_crushed_row = summary.steps;
        summary.min_jacobian = std::min(summary.min_jacobian, step.min_jacobian);
        if (step.energies)
            summary.largest_work_J = std::max(summary.largest_work_J, std::abs(step.energies->load_work_J));
        if (step.max_stretch > summary.max_stretch_step.max_stretch) summary.max_stretch_step = step;
        ++summary.steps;
        // Materials without a strain energy (asymmetric tangent) have no energy balance.
        if (system.has_energy()) summary.energy.add(step);
        return progress.advance(step);
    };
    std::vector<solver::RowState> rows;  // kept for --tolerance
    const auto sink = [&](const model::Step& step, Vec x) {
        const auto fields = system.fields().gather(x);
        if (writer == nullptr) return;
        const linalg::ScopedTimer timed(linalg::Phase::writing);
        writer->append(step, fields.displacement_m, fields.pressure_Pa);
        report(step, count(step));
        notice.set(interrupted_text(task.output, summary.steps, no_resume));
    };
    const solver::RowSink keep_row = [&](const solver::RowState& row) { rows.push_back(row); };
    const auto keep = [&](const model::Checkpoint& checkpoint) {
        const linalg::ScopedTimer timed(linalg::Phase::writing);
        if (writer != nullptr) writer->save_checkpoint(checkpoint);
    };
    const solver::Log log = [&](const std::string& line) { console.detail(line); };
    const StdoutRedirection kept;
    const auto& from = task.from;
    if (from.checkpoint)
        console.say("continues from row " + std::to_string(from.checkpoint->rows - 1) + ", " +
                    step_text(from.steps.back(), model));
    for (const model::Step& step : from.steps) remaining.begin_at(count(step));
    notice.set(interrupted_text(task.output, summary.steps, no_resume));
    const solver::Listeners listeners{
        sink,
        task.output == "-" || options.tolerance ? solver::CheckpointSink() : solver::CheckpointSink(keep),
        log,
        contact_check(system),
        options.tolerance ? keep_row : solver::RowSink(),
        [&](int row, const std::string& control) {
            if (summary.controls.empty() || summary.controls.back().second != control)
                summary.controls.emplace_back(row, control);
        }};
    std::optional<solver::Sensitivities> sensitivities;
    if (!model.parameters.empty()) sensitivities.emplace(system, from.file.variations);
    summary.end = model.dynamics ? solver::integrate_motion(system, listeners)
                                 : solver::follow_path(system, listeners, from.checkpoint ? &*from.checkpoint : nullptr,
                                                       sensitivities ? &*sensitivities : nullptr);
    --summary.steps;  // the undeformed state is not counted
    summary.unknowns = system.dofs().total;
    if (options.tolerance)
        estimate_error(system, std::move(rows), *options.tolerance, seconds_since(begin),
                       {writer, [&] { return new_writer(options, task, "-"); }}, console, summary);
    return summary;
}

/// Follows the path of the task; an existing output is replaced.
SolveSummary solve_once(const Task& task, const SolveOptions& options, std::optional<io::ResultWriter>* writer,
                        Console& console, InterruptNotice& notice) {
    const auto begin = std::chrono::steady_clock::now();
    fem::System system{task.from.file.model, PETSC_COMM_WORLD};
    if (writer != nullptr) writer->emplace(make_writer(options, task));
    const double start_s = seconds_since(begin);
    console.say(start_line(system.dofs().total, task.from.file.model.mesh.dimension));
    SolveSummary summary = follow(system, task, options, writer != nullptr ? &**writer : nullptr, console, notice);
    summary.start_s = start_s;
    return summary;
}

}  // namespace

ExitCode run_solve(const SolveOptions& options, const linalg::Session& session) {
    const auto begin = std::chrono::steady_clock::now();
    const bool first = session.rank() == 0;
    Console console{solve_about().tool, first ? options.common.verbosity : Verbosity::quiet};
    const Task task = read_task(options, session.rank());
    const model::Case& model = task.from.file.model;
    check_motion(options, model);
    if (task.output == "-" && stdout_is_file())
        console.warn(
            "stdout is a file, which is written only at the end: an interrupted run is lost; use -o FILE to save each row");
    std::optional<InterruptNotice> notice{std::in_place, solve_about().tool,
                                          first ? options.common.verbosity : Verbosity::quiet};
    const double read_s = seconds_since(begin);
    std::optional<io::ResultWriter> writer;
    SolveSummary summary = solve_once(task, options, first ? &writer : nullptr, console, *notice);
    summary.ranks = session.size();
    summary.start_s += read_s;
    if (first) {
        if (!writer->is_in_place())
            console.warn(task.output + " was removed or replaced during the run; it is written again");
        const auto bytes = writer->finish(summary.end);
        if (task.output == "-") write_output("-", bytes, Content::binary);
        const io::DesignText& text = task.changed ? *task.changed : task.from.file.design;
        const design::Node written = design::parse_yaml(text.effective_yaml, "/design");
        summary.linear_solver = design::find_path(written, "solver.linear")->text;
        if (model.dynamics) summary.integrator = design::find_path(written, "dynamics.integrator")->text;
        const ProcessTimes times = process_times();
        summary.cpu_s = times.user_s + times.system_s - options.cpu_before_s;
        summary.peak_memory_MB = peak_memory_MB();
        if (options.profile) summary.profile = linalg::profile_rows();
        summary.wall_s = seconds_since(begin);
        for (const std::string& line : event_lines(summary.end, summary.steps, model)) console.say(line);
        for (const std::string& line : {control_line(summary, model), stability_line(summary)})
            if (!line.empty()) console.say(line);
        console.say(summary_line(summary, model));
        for (const std::string& line : profile_lines(summary)) console.say(line);
        if (summary.accuracy)
            for (const std::string& line : accuracy_lines(*summary.accuracy)) console.warn(line);
        if (const auto advice = design::fit_range_advice(text.effective_yaml, summary.max_stretch_p99))
            console.warn(*advice);
        if (summary.first && summary.last)
            for (const std::string& line :
                 post::path_warnings(model,
                                     {*summary.first, *summary.last, summary.max_stretch_p99, summary.max_stretch_step,
                                      summary.became_unstable, summary.end.limit_points, summary.first_crushed_row,
                                      summary.min_jacobian, model::is_inelastic(model), summary.largest_work_J},
                                     summary.end.reason))
                console.warn(line);
        if (const std::string problem = summary.energy.problem(); !problem.empty())
            model.dynamics ? console.warn_always(problem) : console.error(problem);
        for (const std::string& option : session.unused_options())
            console.warn("unused PETSc option: -" + option +
                         "; check its spelling, and that it applies to the solver in use");
        if (!options.common.json.empty()) {
            auto json = summary_json(summary, model);
            json["materials"] = materials_json(model, text.effective_yaml);
            write_json(options.common.json, json);
        }
    }
    // Raise the caught signal again, so that a shell loop ends too.
    if (summary.accuracy && summary.accuracy->caught_signal != 0) {
        notice.reset();  // the summary has already reported what is saved
        std::raise(summary.accuracy->caught_signal);
    }
    const bool wrong = !model.dynamics && broadcast_from_first_rank(summary.energy.problem().empty() ? 0 : 1) != 0;
    if (wrong) return ExitCode::check_failed;
    if (summary.end.reason != model::StopReason::done) return ExitCode::stopped_early;
    return summary.accuracy && !summary.accuracy->met() ? ExitCode::check_failed : ExitCode::ok;
}

}  // namespace soft::cli
