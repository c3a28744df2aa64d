#include <cmath>

#include "solver/path_follower.hpp"

namespace soft::solver {

PathPoint PathFollower::measure(State state, PathTangent tangent) {
    if (control_.kind == ConstraintKind::arc) scale(tangent, 1.0 / linalg::norm(tangent.x));
    PathPoint point{std::move(state), std::move(tangent)};
    read_values(point);
    linalg::copy(point.state.x, scratch_);
    linalg::add(scratch_, -1.0, last_->state.x);
    point.q = controlled_value(point, last_->q + linalg::norm(scratch_));
    return point;
}

void PathFollower::read_values(PathPoint& point) {
    const bool is_first = !last_ || &*last_ == &point;
    solver::read_values(system_, *loads_, is_first ? nullptr : &*last_, point);
}

double PathFollower::leading_of(const State& state) const { return solver::leading_of(input_, *loads_, state); }

/// Changes the parameter of a point's slopes. They are recomputed, as after a resumption, so that both agree to the byte.
void PathFollower::rescale(PathPoint& point, double factor) {
    scale(point.tangent, factor);
    auto outputs = std::move(point.outputs);  // angles stay beyond half a turn
    solver::read_values(system_, *loads_, nullptr, point);
    point.outputs = std::move(outputs);
}

/// Writes a row and sets its work.
void PathFollower::append(PathPoint& point) {
    if (&point != &*last_)
        point.load_work_J = last_->load_work_J + (point.step_work_J ? *point.step_work_J : work_of_step(*last_, point));
    const double direction = step_ < 0.0 ? -1.0 : 1.0;  // tangents point in the direction of travel
    model::Step step = step_of(system_, point, direction);
    step.stage = stage_;
    step.newton_iterations = iterations_since_row_;
    step.factorizations = newton_.factorizations() - factorizations_at_row_;
    step.stable = is_stable(point);
    step.stable_under_control = is_stable_under_control(point);
    read_rubber(system_, point, direction, step);
    if (frequencies_) step.frequencies_Hz = frequencies_->evaluate(point.state.x, point.levels);
    stretch_p99_ = step.stretch_p99;
    visited_.push_back({sketch_of(point.state.x), sketch_of(point.tangent.x)});
    const double size = linalg::norm(point.tangent.x);
    if (size > 0.0)
        for (double& component : visited_.back().tangent) component *= direction / size;
    iterations_since_row_ = 0;
    factorizations_at_row_ = newton_.factorizations();
    ++rows_;
    listeners_.step(step, point.state.x);
    if (listeners_.row) listeners_.row(row_state(system_, point, direction, std::move(step)));
}

bool PathFollower::is_stable(const PathPoint& point) const {
    return point.tangent.unstable_modes ? *point.tangent.unstable_modes == 0 : !load_falls(point);
}

/// Under volume or output control the tangent may have one more unstable direction than at fixed load, exactly where the load
/// falls: the bordered matrix is then still definite on the constraint.
bool PathFollower::is_stable_under_control(const PathPoint& point) const {
    const bool load_follows = control_.kind == ConstraintKind::volume || control_.kind == ConstraintKind::output;
    if (!load_follows) return is_stable(point);
    if (!point.tangent.unstable_modes) return true;
    return *point.tangent.unstable_modes == (load_falls(point) ? 1 : 0);
}

model::LimitPoint PathFollower::location_of(const PathPoint& point) const {
    model::LimitPoint location{rows_, point.leading, std::nullopt, point.outputs};
    if (!input_.loads.empty() && system_.encloses_volume(0)) location.volume_m3 = point.load_volumes_m3[0];
    return location;
}

}  // namespace soft::solver
