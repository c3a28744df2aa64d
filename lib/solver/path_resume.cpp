#include <algorithm>

#include "core/error.hpp"
#include "solver/path_follower.hpp"

namespace soft::solver {

void PathFollower::keep_checkpoint() {
    if (!listeners_.checkpoint) return;
    const auto stored = [](const PathPoint& point) {
        return model::StatePoint{linalg::gather(point.state.x),
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
    };
    model::Checkpoint checkpoint;
    MPI_Comm_size(system_.comm(), &checkpoint.ranks);
    checkpoint.rows = rows_;
    checkpoint.stage = stage_;
    checkpoint.stage_first_row = stage_first_row_;
    checkpoint.start = loads_->start();
    checkpoint.control = static_cast<int>(control_.kind);
    checkpoint.controlled = static_cast<std::int64_t>(control_.index);
    checkpoint.user_control_failed = chosen_.has_value();
    checkpoint.on_branch = on_branch_;
    checkpoint.pending_factorizations = newton_.factorizations() - factorizations_at_row_;
    checkpoint.confirmed_pivots = newton_.confirmed_pivots();
    if (before_) checkpoint.before = stored(*before_);
    checkpoint.last = stored(*last_);
    checkpoint.step = step_;
    checkpoint.first_step = first_step_;
    checkpoint.work_before_stage_J = work_before_stage_J_;
    checkpoint.first_slope = first_slope_;
    for (const VisitedState& state : visited_)
        for (const Sketch* sketch : {&state.state, &state.tangent})
            checkpoint.visited.insert(checkpoint.visited.end(), sketch->begin(), sketch->end());
    checkpoint.so_far = end_;
    checkpoint.so_far.factorizations = factorizations_before_ + newton_.factorizations();
    listeners_.checkpoint(checkpoint);
}

void PathFollower::restore(const model::Checkpoint& from) {
    int ranks = 1;
    MPI_Comm_size(system_.comm(), &ranks);
    const auto refuse = [](const std::string& problem, const char* remedy) {
        throw Error(ExitCode::bad_input, "checkpoint", problem, remedy);
    };
    if (ranks != from.ranks)
        refuse("it was written by " + std::to_string(from.ranks) + " ranks, but this run has " + std::to_string(ranks),
               "use the same number of ranks");
    const auto loads = input_.loads.size();
    const bool fits = from.stage >= 0 && static_cast<std::size_t>(from.stage) < input_.path.stages.size() &&
                      from.start.pressures_Pa.size() == loads && from.start.volumes_m3.size() == loads &&
                      from.start.masses_kg.size() == loads && from.start.tractions.size() == input_.tractions.size() &&
                      from.start.body_forces.size() == input_.body_forces.size() &&
                      from.start.motions.size() == input_.motions.size() && from.control >= 0 &&
                      from.control <= static_cast<int>(ConstraintKind::arc);
    if (!fits) refuse("its loads or stages differ from those of the case", "solve the case again without --resume");
    set_stage(from.stage, from.start);
    const auto size = static_cast<std::size_t>(system_.dofs().total), free = loads_->free_supplies().size();
    const auto point_of = [&](const model::StatePoint& stored) {
        if (stored.unknowns.size() != size || stored.tangent_unknowns.size() != size ||
            stored.pressures_Pa.size() != free || stored.tangent_pressures.size() != free ||
            stored.outputs.size() != system_.output_count())
            refuse("its number of unknowns differs from that of the case", "solve the case again without --resume");
        PathPoint point;
        point.state = {system_.make_vector(), stored.load_factor, stored.pressures_Pa};
        linalg::spread(stored.unknowns, point.state.x);
        point.tangent = {system_.make_vector(), stored.tangent_load_factor, stored.tangent_pressures,
                         stored.unstable_modes, stored.power};
        linalg::spread(stored.tangent_unknowns, point.tangent.x);
        point.q = stored.q;
        read_values(point);
        point.outputs = stored.outputs;  // angles beyond 180 degrees
        point.load_work_J = stored.load_work_J;
        return point;
    };
    if (static_cast<ConstraintKind>(from.control) != control_.kind && from.user_control_failed) chosen_ = control_;
    control_ = {static_cast<ConstraintKind>(from.control), static_cast<std::size_t>(from.controlled)};
    if (control_.kind == ConstraintKind::volume
            ? control_.index >= loads
            : control_.kind == ConstraintKind::output && control_.index >= system_.output_count())
        refuse("its loads or outputs differ from those of the case", "solve the case again without --resume");
    on_branch_ = from.on_branch;
    rows_ = from.rows;
    report_control();
    factorizations_at_row_ = newton_.factorizations() - from.pending_factorizations;
    newton_.confirm_pivots(from.confirmed_pivots);
    if (from.before) before_ = point_of(*from.before);
    last_ = point_of(from.last);
    step_ = from.step;
    first_step_ = from.first_step;
    work_before_stage_J_ = from.work_before_stage_J;
    first_slope_ = from.first_slope;
    stage_first_row_ = from.stage_first_row;
    rows_ = from.rows;
    if (from.visited.size() % (2 * sketch_size) != 0)
        refuse("its list of visited states is invalid", "solve the case again without --resume");
    for (std::size_t i = 0; i < from.visited.size(); i += 2 * sketch_size) {
        const auto state = from.visited.begin() + static_cast<std::ptrdiff_t>(i);
        visited_.emplace_back();
        std::copy_n(state, sketch_size, visited_.back().state.begin());
        std::copy_n(state + sketch_size, sketch_size, visited_.back().tangent.begin());
    }
    end_ = from.so_far;
    factorizations_before_ = from.so_far.factorizations;
}

}  // namespace soft::solver
