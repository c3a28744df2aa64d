#include "solver/recorder.hpp"

#include <algorithm>

#include "solver/row_state.hpp"
#include "solver/work.hpp"

namespace soft::solver {

namespace {

/// With the loads prescribed as the case states them.
bool is_stable(const PathState& path, const PathPoint& point) {
    return point.tangent.unstable_modes ? *point.tangent.unstable_modes == 0 : !path.load_falls(point);
}

/// Under volume or output control the tangent may have one more unstable direction than at fixed load, exactly where the load
/// falls: the bordered matrix is then still definite on the constraint.
bool is_stable_under_control(const PathState& path, const PathPoint& point) {
    const ConstraintKind kind = path.control.kind;
    const bool load_follows = kind == ConstraintKind::volume || kind == ConstraintKind::output;
    if (!load_follows) return is_stable(path, point);
    if (!point.tangent.unstable_modes) return true;
    return *point.tangent.unstable_modes == (path.load_falls(point) ? 1 : 0);
}

VisitedState visited_state(const PathPoint& point, double direction) {
    VisitedState state{sketch_of(point.state.x), sketch_of(point.tangent.x)};
    const double size = linalg::norm(point.tangent.x);
    if (size > 0.0)
        for (double& component : state.tangent) component *= direction / size;
    return state;
}

}  // namespace

Recorder::Recorder(Corrector& corrector, const Listeners& listeners, Sensitivities* sensitivities)
    : corrector_(corrector), listeners_(listeners), sensitivities_(sensitivities) {
    const int frequencies = corrector.input().path.frequencies;
    if (frequencies > 0) frequencies_.emplace(corrector.system(), frequencies);
}

void Recorder::append(PathState& path, PathPoint& point) {
    fem::System& system = corrector_.system();
    if (&point != &*path.last) {
        if (!point.step_work_J) find_work_of_step(corrector_, path, point);
        point.load_work_J = path.last->load_work_J + *point.step_work_J;
        path.dissipated_J += point.lost_J;
    }
    let_contact_rest(system, *path.last, point);
    const double direction = path.direction();  // tangents point in the direction of travel
    const WorkCount work = corrector_.work();
    model::Step step = step_of(system, point, direction);
    step.stage = path.stage;
    step.newton_iterations = work.iterations - at_row_.iterations;
    step.factorizations = work.factorizations - at_row_.factorizations;
    step.stable = is_stable(path, point);
    step.stable_under_control = is_stable_under_control(path, point);
    read_rubber(system, point, direction, step);
    if (step.energies && (step.energies->dissipated_J || !system.contact().is_empty()))
        step.energies->dissipated_J =
            step.energies->dissipated_J.value_or(0.0) + path.dissipated_J / system.input().model_fraction;
    if (frequencies_) step.frequencies_Hz = frequencies_->evaluate(point.state.x, point.levels);
    if (sensitivities_ != nullptr) sensitivities_->evaluate(corrector_, path, point, step);
    if (point.is_singular) std::ranges::fill(step.derivatives, model::no_derivative);
    path.stretch_p99 = step.stretch_p99;
    path.max_stretch = step.max_stretch;
    path.min_jacobian = step.min_jacobian;
    path.visited.push_back(visited_state(point, direction));
    ++path.rows;
    at_row_ = work;
    listeners_.step(step, point.state.x);
    if (listeners_.row) listeners_.row(row_state(system, point, direction, std::move(step)));
}

void Recorder::accept_step() {
    if (sensitivities_ != nullptr) sensitivities_->accept_step();
}

void Recorder::report_control(const PathState& path) const {
    if (!listeners_.control) return;
    const Constraint& control = path.control;
    const std::string word = control.kind == ConstraintKind::load_factor ? "load" : std::string(name(control.kind));
    const bool output = control.kind == ConstraintKind::output;
    listeners_.control(std::max(path.rows, 1),
                       output ? word + " " + corrector_.input().outputs[control.index].name : word);
}

void Recorder::resume(const model::Checkpoint& from) {
    before_ = {from.so_far.newton_iterations, from.so_far.factorizations};
    at_row_ = corrector_.work();
    at_row_.factorizations -= from.pending_factorizations;
}

model::PathEnd Recorder::end_of(const PathState& path) const {
    model::PathEnd end = path.end;
    end.newton_iterations = before_.iterations + corrector_.work().iterations;
    end.factorizations = before_.factorizations + corrector_.work().factorizations;
    return end;
}

}  // namespace soft::solver
