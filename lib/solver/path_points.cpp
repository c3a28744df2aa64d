#include "solver/path_follower.hpp"


namespace soft::solver {

/// The arc constraint of a step runs along the tangent of the state it starts from.
Constraint PathFollower::bind(const Constraint& constraint, const PathPoint& origin) const {
    Constraint bound = constraint;
    if (constraint.kind == ConstraintKind::arc) {
        bound.arc_origin = origin.state.x;
        bound.arc_direction = origin.tangent.x;
    }
    return bound;
}

PathPoint PathFollower::measure(State state, PathTangent tangent) {
    PathPoint point{std::move(state), std::move(tangent), 0, std::nullopt, {}, 0, {}};
    if (control_.kind == ConstraintKind::arc) {
        const double length = linalg::norm(point.tangent.x);
        // Travel on in the direction of the step before; at the start in the direction of growing load.
        const bool forward = last_ && last_->q > 0.0 ? linalg::dot(point.tangent.x, last_->tangent.x) > 0.0
                                                     : point.tangent.load_factor > 0.0;
        const double scale = (forward ? 1.0 : -1.0) / length;
        SOFT_PETSC(VecScale(point.tangent.x, scale));
        point.tangent.load_factor *= scale;
    }
    read_values(point);
    switch (control_.kind) {
        case ConstraintKind::load_factor: point.q = point.state.load_factor; break;
        case ConstraintKind::volume: point.q = *point.volume_m3; break;
        case ConstraintKind::output: point.q = point.outputs_m[control_.output]; break;
        case ConstraintKind::arc:
            if (last_) {
                linalg::copy(point.state.x, scratch_);
                linalg::add(scratch_, -1.0, last_->state.x);
                point.q = last_->q + linalg::norm(scratch_);
            }
            break;
    }
    return point;
}

/// Volume and outputs with their slopes.
void PathFollower::read_values(PathPoint& point) {
    point.volume_m3 = system_.enclosed_volume(point.state.x, scratch_);
    point.volume_slope = linalg::dot(scratch_, point.tangent.x);
    for (std::size_t i = 0; i < system_.output_count(); ++i) {
        point.outputs_m.push_back(linalg::dot(system_.output_weights(i), point.state.x));
        point.output_slopes.push_back(linalg::dot(system_.output_weights(i), point.tangent.x));
    }
}

void PathFollower::append(const PathPoint& point) {
    solution::Step step;
    const double pressure_Pa = model::leading_load(input_).value_Pa;
    step.load_factor = point.state.load_factor;
    step.pressure_Pa = step.load_factor * pressure_Pa;
    step.volume_m3 = point.volume_m3;
    step.outputs_m = point.outputs_m;
    const double direction = step_ < 0.0 ? -1.0 : 1.0;   // tangents point in the direction of travel
    step.tangent_load_factor = direction * point.tangent.load_factor;
    step.tangent_pressure = step.tangent_load_factor * pressure_Pa;
    step.tangent_volume = direction * point.volume_slope;
    for (const double slope : point.output_slopes) step.tangent_outputs.push_back(direction * slope);
    step.newton_iterations = iterations_since_row_;
    step.factorizations = newton_.factorizations() - factorizations_at_row_;
    step.stable = is_stable(point);
    const auto stretch = system_.stretches(point.state.x);
    step.stretch_p99 = stretch.p99;
    step.max_stretch = stretch.largest;
    step.min_jacobian = stretch.min_jacobian;
    iterations_since_row_ = 0;
    factorizations_at_row_ = newton_.factorizations();
    ++rows_;
    sink_(step, point.state.x);
}

}  // namespace soft::solver
