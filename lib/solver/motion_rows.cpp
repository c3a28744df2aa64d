#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "solver/motion_follower.hpp"
#include "solver/path_end.hpp"

namespace soft::solver {

/// Trapezoidal rule for the work of the forces along the step.
void MotionFollower::integrate_energies(const MotionState& from, const MotionState& to) {
    linalg::Vector change = linalg::duplicate(to.x), force = linalg::duplicate(to.x);
    SOFT_PETSC(VecWAXPY(change, -1.0, from.x, to.x));
    SOFT_PETSC(VecPointwiseMult(change, equations_.mask(), change));
    SOFT_PETSC(VecWAXPY(force, 1.0, from.load_force, to.load_force));
    load_work_J_ += 0.5 * linalg::dot(force, change);
    if (moves_obstacles_) load_work_J_ += work_of_obstacles(from, to);
    max_work_J_ = std::max(max_work_J_, std::abs(load_work_J_));
    if (!equations_.has_damping()) return;
    SOFT_PETSC(VecZeroEntries(force));
    equations_.add_damping(force, 0.5, from.v);
    equations_.add_damping(force, 0.5, to.v);
    damping_work_J_ += linalg::dot(force, change);
}

fem::LoadLevels MotionFollower::levels_of(const MotionState& state) const {
    return equations_.levels(state.time_s, equations_.lines().pressures(state.x, state.masses_kg));
}

double MotionFollower::work_of_obstacles(const MotionState& from, const MotionState& to) {
    const linalg::Vector none = system_.make_vector();  // without the motion of the body, only obstacles work
    const fem::LoadLevels before = levels_of(from), after = levels_of(to), change = fem::moved(after, -1.0, before);
    return 0.5 * (system_.assembler().load_power(from.x, none, before, change) +
                  system_.assembler().load_power(to.x, none, after, change));
}

solver::PathPoint MotionFollower::measure() {
    solver::PathTangent velocity;
    velocity.x = copy_of(last_.v);
    velocity.load_factor = 1.0 / dynamics_.duration_s;
    solver::PathPoint point{{copy_of(last_.x), last_.time_s / dynamics_.duration_s, {}}, std::move(velocity)};
    const auto levels = levels_of(last_);
    const auto rates = equations_.rates(last_.time_s, equations_.lines().pressure_rates(last_));
    solver::read_values(system_, levels, rates, last_row_ ? &*last_row_ : nullptr, point);
    return point;
}

std::optional<ContactEvent> MotionFollower::contact_in(const MotionState& state) {
    if (!listeners_.contact || input_.path.contact == model::Contact::ignore) return std::nullopt;
    system_.prescribe(levels_of(state));
    return listeners_.contact(state.x);
}

void MotionFollower::append() {
    solver::PathPoint point = measure();
    model::Step step = solver::step_of(system_, point, 1.0);
    step.newton_iterations = iterations_since_row_;
    const int factorizations = stage_ ? stage_->factorizations() : 0;
    step.factorizations = factorizations - factorizations_at_row_;
    const double whole = 1.0 / input_.model_fraction;
    const double stored_J = solver::read_stretches(system_, last_.x, step).stored_energy_J;
    step.motion = {last_.time_s, whole * kinetic_energy(equations_, last_.v), whole * stored_J, whole * load_work_J_,
                   whole * (damping_work_J_ + system_.internal().dissipated_J())};
    if (auto problem = check_plausibility(step)) return finish(model::StopReason::diverged, std::move(*problem));
    const std::string state = short_text(last_.time_s) + " s, " + solver::state_text(point, input_);
    const bool solved = input_.path.contact == model::Contact::solve;
    const auto contact = solved && !explicit_ ? std::nullopt : contact_in(last_);  // implicit steps are checked
    if (contact && solved) {
        const Stop stop = unresolved(*contact, state);
        return finish(stop.reason, stop.detail);
    }
    iterations_since_row_ = 0;
    factorizations_at_row_ = factorizations;
    listeners_.report("row " + std::to_string(rows_) + ": " + state + ", step " + short_text(step_s_) + " s, " +
                      core::counted(step.newton_iterations, "iteration"));
    ++rows_;
    listeners_.step(step, last_.x);
    if (contact) finish(contact->reason, contact->end_at(state));
    last_row_ = std::move(point);
    next_row_s_ += row_interval_s_;
    while (next_row_s_ <= last_.time_s) next_row_s_ += row_interval_s_;
}

}  // namespace soft::solver
