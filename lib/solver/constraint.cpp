#include "solver/constraint.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace soft::solver {

linalg::Vector copy_of(Vec x) {
    linalg::Vector copy = linalg::duplicate(x);
    linalg::copy(x, copy);
    return copy;
}

State copy_of(const State& state) { return {copy_of(state.x), state.load_factor, state.pressures_Pa}; }

State between(const State& a, const State& b, double share) {
    State state = copy_of(a);
    SOFT_PETSC(VecAXPBY(state.x, share, 1.0 - share, b.x));
    state.load_factor = std::lerp(a.load_factor, b.load_factor, share);
    for (std::size_t k = 0; k < a.pressures_Pa.size(); ++k)
        state.pressures_Pa[k] = std::lerp(a.pressures_Pa[k], b.pressures_Pa[k], share);
    return state;
}

std::string_view name(ConstraintKind kind) {
    switch (kind) {
        case ConstraintKind::load_factor: return "load factor";
        case ConstraintKind::volume: return "volume";
        case ConstraintKind::output: return "output";
        case ConstraintKind::arc: return "arc length";
        case ConstraintKind::pressure: return "pressure";
    }
    throw std::logic_error("name: unknown constraint");
}

ConstraintValue evaluate(const Constraint& constraint, fem::System& system, const StageLoads& loads, const State& state,
                         Vec gradient) {
    ConstraintValue result{0.0, 0.0, std::vector(loads.free_supplies().size(), 0.0)};
    SOFT_PETSC(VecZeroEntries(gradient));
    std::vector<double> by_motion(loads.rate().motions.size(), 0.0);
    fem::LoadLevels by_levels;
    const auto& free = loads.free_supplies();
    switch (constraint.kind) {
        case ConstraintKind::load_factor: return {state.load_factor, 1.0, result.by_pressures};
        case ConstraintKind::pressure:
            result.value = state.pressures_Pa.at(constraint.index);
            result.by_pressures[constraint.index] = 1.0;
            return result;
        case ConstraintKind::volume:
            result.value = system.volumes().of_load(constraint.index, state.x, gradient, by_motion);
            break;
        case ConstraintKind::output:
            result.value = system.outputs().value(constraint.index, state.x, gradient, &by_levels);
            result.by_load_factor = fem::product(by_levels, loads.rate());
            for (std::size_t k = 0; k < free.size(); ++k) result.by_pressures[k] = by_levels.pressures_Pa[free[k]];
            return result;
        case ConstraintKind::arc:
            linalg::copy(constraint.arc_direction, gradient);
            result.value = linalg::dot(gradient, state.x) - linalg::dot(gradient, constraint.arc_origin);
            return result;
    }
    result.by_load_factor = std::inner_product(by_motion.begin(), by_motion.end(), loads.rate().motions.begin(), 0.0);
    return result;
}

double remaining(const Constraint& constraint, const model::Case& input, double target, double value) {
    const bool angle =
        constraint.kind == ConstraintKind::output && model::is_angle(input.outputs.at(constraint.index).measure);
    return angle ? std::remainder(target - value, 2.0 * std::numbers::pi) : target - value;
}

}  // namespace soft::solver
