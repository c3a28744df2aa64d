#include "solver/refined_path.hpp"

#include <algorithm>
#include <cmath>

#include "solver/goals.hpp"
#include "solver/snap.hpp"

namespace soft::solver {

namespace {

/// Relative tolerance to find the goal that ended a stage from the state nearest to the coarse one: the largest change due to the mesh.
constexpr double meets_goal = 5e-2;

/// Change of the unknowns that may be left in rows that are only compared; a quadratic step leaves far less.
constexpr double enough_to_compare = 1e-5;

/// Bound of the extrapolation of the difference between the meshes.
constexpr double max_growth = 2;

/// Of the load factor: where an obstacle moves with the load, the state nearest to one in contact may be one that has left it, at a load
/// farther away.
constexpr double same_load = 0.05;
/// Of the load factor, which ends a stage at its full load.
constexpr double full_load = 1e-9;

/// The most parts in which a row is approached from the one before.
constexpr int max_parts = 64;

}  // namespace

RefinedPath::RefinedPath(fem::System& fine, const mesh::Refined& refined)
    : system_(fine),
      refined_(refined),
      corrector_(fine),
      origin_(fine.make_vector()),
      direction_(fine.make_vector()),
      correction_(fine.make_vector()),
      undeformed_volumes_m3_(undeformed_volumes_m3(fine)),
      moves_obstacle_(std::ranges::any_of(fine.input().motions, [&](const model::Motion& motion) {
          return model::moves_obstacle(fine.input(), motion);
      })) {
    const int frequencies = fine.input().path.frequencies;
    if (frequencies > 0) frequencies_.emplace(fine, frequencies);
}

void RefinedPath::set_stage(int stage) {
    if (stage == stage_) return;
    const model::Case& input = system_.input();
    StageStart start = last_ ? stage_start_at(input, *loads_, *last_) : unloaded(input, undeformed_volumes_m3_);
    stage_ = stage;
    of_last_ = FromTangent::of_another_stage;
    loads_.emplace(input, stage, std::move(start), undeformed_volumes_m3_);
    corrector_.newton().set_loads(*loads_);
}

State RefinedPath::carry_over(const RowState& coarse) {
    const auto carried = [&](const std::vector<double>& field) {
        return field.empty() ? field : mesh::prolong(refined_, field, 3);
    };
    const auto displacement = carried(coarse.displacement_m);
    SOFT_PETSC(VecZeroEntries(origin_));
    system_.fields().spread(displacement, origin_);
    SOFT_PETSC(VecZeroEntries(direction_));
    system_.fields().spread(carried(coarse.tangent), direction_);
    nearest_ = {};
    if (const double length = linalg::norm(direction_); length > 0.0 && !coarse.step.time_s) {
        SOFT_PETSC(VecScale(direction_, 1.0 / length));
        nearest_ = {ConstraintKind::arc, 0, origin_, direction_, linalg::norm(origin_)};
    }
    State state{copy_of(origin_), coarse.step.load_factor, coarse.free_pressures_Pa};
    if (corrected_m_ > 0.0) {  // the difference between the meshes grows with the displacement, as do pressures
        const double growth = std::min(linalg::norm(origin_) / corrected_m_, max_growth);
        SOFT_PETSC(VecAXPY(state.x, growth, correction_));
    }
    return state;
}

bool RefinedPath::is_at_load(const State& state, const RowState& coarse) const {
    return !moves_obstacle_ || std::abs(state.load_factor - coarse.step.load_factor) <= same_load;
}

bool RefinedPath::correct_to_nearest(State& state, const RowState& coarse) {
    return corrector_.correct(nearest_, 0.0, state) && is_at_load(state, coarse);
}

/// Solves for the goal that the coarse path has reached, from the state of the row. False if no goal is close enough, or the solution does
/// not converge.
bool RefinedPath::end_stage(State& state, const RowState& coarse) {
    const auto goals = make_goals(system_.input(), stage_, *loads_, undeformed_volumes_m3_);
    system_.prescribe(loads_->levels(state.load_factor, state.pressures_Pa));
    const bool at_full_load = std::abs(coarse.step.load_factor - 1.0) <= full_load;
    const Goal* met = nullptr;
    double smallest = meets_goal;
    for (const Goal& goal : goals) {
        if ((goal.constraint.kind == ConstraintKind::load_factor) != at_full_load) continue;
        const double value = corrector_.value(goal.constraint, *loads_, state);
        const double off = std::abs(remaining(goal.constraint, system_.input(), goal.target, value) / goal.target);
        if (!at_full_load && !(off < smallest)) continue;
        smallest = off;
        met = &goal;
    }
    if (met == nullptr) return false;
    corrector_.newton().keep_factor();
    return corrector_.correct(met->constraint, met->target, state);
}

std::optional<State> RefinedPath::equilibrium(const RowState& coarse, RowPosition position) {
    if (position == RowPosition::first) {
        State state = carry_over(coarse);
        SOFT_PETSC(VecZeroEntries(state.x));
        if (system_.has_initial_stress() && !corrector_.correct({ConstraintKind::load_factor}, 0.0, state))
            return std::nullopt;
        return state;
    }
    State state = carry_over(coarse);
    if (nearest_.kind != ConstraintKind::arc) {  // a stage in which nothing changes, or in time
        if (corrector_.correct(nearest_, coarse.step.load_factor, state)) return state;
        return std::nullopt;
    }
    const auto at_goal = [&](State found) {
        if (position == RowPosition::ends_stage)
            if (State goal = copy_of(found); end_stage(goal, coarse)) return goal;
        const auto is_of_stage = [](double load_factor) { return load_factor >= 0.0 && load_factor <= 1.0; };
        if (is_of_stage(coarse.step.load_factor) && !is_of_stage(found.load_factor))
            if (auto equal = at_equal_load(coarse, Settle::no)) return std::move(*equal);
        return found;
    };
    if (correct_to_nearest(state, coarse)) return at_goal(std::move(state));
    // Where the state that is carried over does not touch the obstacle that moves, the load does not move it.
    const NewtonEnd end = corrector_.last_result().end;
    if (moves_obstacle_ && (end == NewtonEnd::singular || end == NewtonEnd::converged))
        if (auto found = at_equal_load(coarse, Settle::no)) return found;
    corrected_m_ = 0;  // retry without the row before
    state = carry_over(coarse);
    if (correct_to_nearest(state, coarse)) return at_goal(std::move(state));
    // What an obstacle moves follows it, and hardly moves along the path where it slides.
    auto followed = moves_obstacle_ ? follow_from_last(coarse, Approach::by_load) : std::nullopt;
    if (!followed) followed = follow_from_last(coarse, Approach::to_the_nearest);
    return followed ? at_goal(std::move(*followed)) : at_equal_load(coarse, Settle::yes);
}

std::optional<State> RefinedPath::at_equal_load(const RowState& coarse, Settle settling) {
    State state = carry_over(coarse);
    nearest_ = {ConstraintKind::load_factor};
    if (State start = copy_of(state); !corrector_.correct(nearest_, coarse.step.load_factor, state)) {
        if (settling == Settle::no) return std::nullopt;
        auto settled = settle(corrector_, start, nearest_, coarse.step.load_factor);  // a crease of another size
        if (!settled) return std::nullopt;
        state = std::move(*settled);
    }
    linalg::Vector difference = copy_of(state.x);
    SOFT_PETSC(VecAXPY(difference, -1.0, origin_));
    if (linalg::norm(difference) > 2.0 * linalg::norm(origin_)) return std::nullopt;  // another branch
    return state;
}

std::optional<State> RefinedPath::follow_from_last(const RowState& coarse, Approach approach) {
    if (!last_ || of_last_ == FromTangent::of_another_stage) return std::nullopt;
    linalg::Vector step = system_.make_vector(), origin = system_.make_vector();  // step: of the coarse path
    SOFT_PETSC(VecWAXPY(step, 1.0, correction_, origin_));
    SOFT_PETSC(VecAXPY(step, -1.0, last_->state.x));
    for (int parts = 2; parts <= max_parts; parts *= 2) {
        State state = copy_of(last_->state);
        for (int part = 1; part <= parts; ++part) {
            const double to_do = 1.0 / (parts - part + 1);  // of the rest
            SOFT_PETSC(VecAXPY(state.x, 1.0 / parts, step));
            state.load_factor += to_do * (coarse.step.load_factor - state.load_factor);
            for (std::size_t i = 0; i < state.pressures_Pa.size(); ++i)
                state.pressures_Pa[i] += to_do * (coarse.free_pressures_Pa[i] - state.pressures_Pa[i]);
            SOFT_PETSC(VecWAXPY(origin, static_cast<double>(part) / parts - 1.0, step, origin_));
            Constraint nearest = nearest_;
            nearest.arc_origin = origin;
            const bool by_load = approach == Approach::by_load;
            if (!corrector_.correct(by_load ? Constraint{ConstraintKind::load_factor} : nearest,
                                    by_load ? state.load_factor : 0.0, state))
                break;
            if (part == parts && is_at_load(state, coarse)) return state;
        }
    }
    return std::nullopt;
}

std::optional<RowState> RefinedPath::solve(const RowState& coarse, RowPosition position, Keep keep) {
    set_stage(coarse.step.stage);
    if (keep == Keep::values) corrector_.newton().accept_change(enough_to_compare);
    const WorkCount before = work();
    auto state = equilibrium(coarse, position);
    if (!state) return std::nullopt;
    SOFT_PETSC(VecWAXPY(correction_, -1.0, origin_, state->x));
    corrected_m_ = linalg::norm(origin_);
    std::optional<PathTangent> tangent =
        keep == Keep::fields ? corrector_.newton().tangent(nearest_, *state) : std::optional{no_tangent(*state)};
    if (!tangent) return std::nullopt;
    PathPoint point{std::move(*state), std::move(*tangent)};
    PathPoint near;
    near.outputs = coarse.step.outputs;
    read_values(system_, *loads_, &near, point);
    if (last_ && keep == Keep::fields)
        point.load_work_J = last_->load_work_J + work_between(system_, *last_, point, of_last_);
    RowState row{step_of(system_, point, 1.0), {}, {}, {}, {}};
    row.step.stage = coarse.step.stage;
    row.step.newton_iterations = work().iterations - before.iterations;
    row.step.factorizations = work().factorizations - before.factorizations;
    if (keep == Keep::fields) row = with_fields(std::move(row.step), point, coarse.step);
    system_.prescribe(point.levels);
    system_.accept_step(point.state.x);
    last_ = std::move(point);
    of_last_ = FromTangent::along_the_path;
    return row;
}

RowState RefinedPath::with_fields(model::Step step, const PathPoint& point, const model::Step& coarse) {
    step.stable = coarse.stable;
    step.stable_under_control = coarse.stable_under_control;
    read_rubber(system_, point, 1.0, step);
    if (step.energies && coarse.energies && !step.energies->dissipated_J)  // snaps are found on the first mesh alone
        step.energies->dissipated_J = coarse.energies->dissipated_J;
    if (frequencies_) step.frequencies_Hz = frequencies_->evaluate(point.state.x, point.levels);
    return row_state(system_, point, 1.0, std::move(step));
}

}  // namespace soft::solver
