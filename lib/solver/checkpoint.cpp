#include <algorithm>

#include "core/error.hpp"
#include "solver/recorder.hpp"
#include "solver/stages.hpp"

namespace soft::solver {

namespace {

/// Internal variables are many times the size of a row: writing them after each one cost 5 % of a cyclic bellows.
constexpr int rows_between_large_checkpoints = 10;

model::StatePoint stored_point(const PathPoint& point) {
    return {linalg::gather(point.state.x),
            linalg::gather(point.tangent.x),
            point.state.pressures_Pa,
            point.tangent.pressures,
            point.state.load_factor,
            point.tangent.load_factor,
            point.tangent.power,
            point.outputs,
            point.q,
            point.load_work_J,
            point.tangent.unstable_modes};
}

[[noreturn]] void refuse_checkpoint(const std::string& problem,
                                    const char* remedy = "solve the case again without --resume") {
    throw Error(ExitCode::bad_input, "checkpoint", problem, remedy);
}

void check_fit(const model::Checkpoint& from, const Corrector& corrector) {
    const model::Case& input = corrector.input();
    int ranks = 1;
    MPI_Comm_size(corrector.system().comm(), &ranks);
    if (ranks != from.ranks)
        refuse_checkpoint(
            "it was written by " + std::to_string(from.ranks) + " ranks, but this run has " + std::to_string(ranks),
            "use the same number of ranks");
    const auto loads = input.loads.size();
    const bool fits = from.stage >= 0 && static_cast<std::size_t>(from.stage) < input.path.stages.size() &&
                      from.start.pressures_Pa.size() == loads && from.start.volumes_m3.size() == loads &&
                      from.start.masses_kg.size() == loads && from.start.dead_loads.size() == input.dead_loads.size() &&
                      from.start.motions.size() == input.motions.size() && from.control >= 0 &&
                      from.control <= static_cast<int>(ConstraintKind::arc);
    if (!fits) refuse_checkpoint("its loads or stages differ from those of the case");
    const auto kind = static_cast<ConstraintKind>(from.control);
    const auto controlled = static_cast<std::size_t>(from.controlled);
    if (kind == ConstraintKind::volume ? controlled >= loads
                                       : kind == ConstraintKind::output && controlled >= input.outputs.size())
        refuse_checkpoint("its loads or outputs differ from those of the case");
    if (from.visited.size() % (2 * sketch_size) != 0) refuse_checkpoint("its list of visited states is invalid");
}

PathPoint restored_point(const model::StatePoint& stored, fem::System& system, const StageLoads& loads) {
    const auto size = static_cast<std::size_t>(system.dofs().total), free = loads.free_supplies().size();
    if (stored.unknowns.size() != size || stored.tangent_unknowns.size() != size ||
        stored.pressures_Pa.size() != free || stored.tangent_pressures.size() != free ||
        stored.outputs.size() != system.outputs().count())
        refuse_checkpoint("its number of unknowns differs from that of the case");
    PathPoint point;
    point.state = {system.make_vector(), stored.load_factor, stored.pressures_Pa};
    linalg::spread(stored.unknowns, point.state.x);
    point.tangent = {system.make_vector(), stored.tangent_load_factor, stored.tangent_pressures, stored.unstable_modes,
                     stored.power};
    linalg::spread(stored.tangent_unknowns, point.tangent.x);
    point.q = stored.q;
    read_values(system, loads, nullptr, point);
    point.outputs = stored.outputs;  // angles beyond 180 degrees
    point.load_work_J = stored.load_work_J;
    return point;
}

}  // namespace

void Recorder::keep_checkpoint(const PathState& path) {
    if (!listeners_.checkpoint) return;
    const bool is_large = !corrector_.system().internal().is_empty();
    if (is_large && checkpoint_rows_ > 0 && path.rows - checkpoint_rows_ < rows_between_large_checkpoints) return;
    checkpoint_rows_ = path.rows;
    model::Checkpoint checkpoint;
    MPI_Comm_size(corrector_.system().comm(), &checkpoint.ranks);
    checkpoint.rows = path.rows;
    checkpoint.stage = path.stage;
    checkpoint.stage_first_row = path.first_row;
    checkpoint.start = path.loads->start();
    checkpoint.control = static_cast<int>(path.control.kind);
    checkpoint.controlled = static_cast<std::int64_t>(path.control.index);
    checkpoint.user_control_failed = path.user_control.has_value();
    checkpoint.on_branch = path.on_branch;
    checkpoint.pending_factorizations = corrector_.work().factorizations - at_row_.factorizations;
    checkpoint.confirmed_pivots = corrector_.memory().second;
    if (path.before) checkpoint.before = stored_point(*path.before);
    checkpoint.last = stored_point(*path.last);
    checkpoint.step = path.step;
    checkpoint.first_step = path.first_step;
    checkpoint.dissipated_J = path.dissipated_J;
    checkpoint.size = path.size;
    checkpoint.friction = corrector_.system().contact().friction_start();
    checkpoint.internal = corrector_.system().internal().gather();
    checkpoint.work_before_stage_J = path.work_before_J;
    checkpoint.first_slope = path.first_slope;
    for (const VisitedState& state : path.visited)
        for (const Sketch* sketch : {&state.state, &state.tangent})
            checkpoint.visited.insert(checkpoint.visited.end(), sketch->begin(), sketch->end());
    checkpoint.so_far = end_of(path);
    listeners_.checkpoint(checkpoint);
}

void restore(const model::Checkpoint& from, Corrector& corrector, PathState& path) {
    check_fit(from, corrector);
    fem::System& system = corrector.system();
    set_stage(from.stage, from.start, corrector, path);
    const Constraint control{static_cast<ConstraintKind>(from.control), static_cast<std::size_t>(from.controlled)};
    if (control.kind != path.control.kind && from.user_control_failed) path.user_control = path.control;
    path.control = control;
    path.first_row = from.stage_first_row;
    path.rows = from.rows;
    path.on_branch = from.on_branch;
    if (from.before) path.before = restored_point(*from.before, system, *path.loads);
    path.last = restored_point(from.last, system, *path.loads);
    corrector.newton().confirm_pivots(from.confirmed_pivots);
    path.step = from.step;
    path.first_step = from.first_step;
    path.dissipated_J = from.dissipated_J;
    path.size = from.size;
    system.prescribe(path.last->levels);
    if (!system.contact().start_friction(path.last->state.x, from.friction))
        refuse_checkpoint("its friction does not fit the case");
    if (!system.internal().restore(from.internal)) refuse_checkpoint("its internal variables do not fit the case");
    path.work_before_J = from.work_before_stage_J;
    path.first_slope = from.first_slope;
    for (auto next = from.visited.begin(); next != from.visited.end(); next += 2 * sketch_size) {
        VisitedState& state = path.visited.emplace_back();
        std::copy_n(next, sketch_size, state.state.begin());
        std::copy_n(next + sketch_size, sketch_size, state.tangent.begin());
    }
    path.end = from.so_far;
}

}  // namespace soft::solver
