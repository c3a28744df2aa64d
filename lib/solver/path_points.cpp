#include <cmath>
#include <numbers>

#include "solver/path_follower.hpp"

namespace soft::solver {

PathPoint PathFollower::measure(State state, PathTangent tangent) {
    PathPoint point{std::move(state), std::move(tangent)};
    read_values(point);
    if (control_.kind == ConstraintKind::arc) scale_slopes(point, 1.0 / linalg::norm(point.tangent.x));
    linalg::copy(point.state.x, scratch_);
    linalg::add(scratch_, -1.0, last_->state.x);
    point.q = controlled_value(point, last_->q + linalg::norm(scratch_));
    return point;
}

/// Pressures, volumes and outputs with their slopes along the point's tangent.
void PathFollower::read_values(PathPoint& point) {
    const LoadLevels levels = loads_->levels(point.state.load_factor, point.state.pressures_Pa);
    const LoadLevels& rate = loads_->rate();
    system_.prescribe(levels);
    std::vector<double> by_motion(rate.motions.size());
    const auto slope_along = [&] {
        double slope = linalg::dot(scratch_, point.tangent.x);
        for (std::size_t m = 0; m < by_motion.size(); ++m) slope += by_motion[m] * rate.motions[m] * point.tangent.load_factor;
        return slope;
    };
    point.pressures_Pa = levels.pressures_Pa;
    for (const double r : rate.pressures_Pa) point.pressure_slopes.push_back(r * point.tangent.load_factor);
    const auto& free = loads_->free_supplies();
    for (std::size_t k = 0; k < free.size(); ++k) point.pressure_slopes[free[k]] = point.tangent.pressures[k];
    for (std::size_t cavity = 0; cavity < system_.cavity_count(); ++cavity) {
        point.volumes_m3.push_back(system_.enclosed_volume(cavity, point.state.x, scratch_, by_motion));
        point.volume_slopes.push_back(slope_along());
    }
    for (std::size_t load = 0, cavity = 0; load < input_.loads.size(); ++load) {
        point.load_volumes_m3.push_back(0.0);
        point.load_volume_slopes.push_back(0.0);
        for (std::size_t n = 0; n < input_.loads[load].targets.size() && system_.encloses_volume(load); ++n, ++cavity) {
            point.load_volumes_m3.back() += point.volumes_m3[cavity];
            point.load_volume_slopes.back() += point.volume_slopes[cavity];
        }
    }
    for (std::size_t i = 0; i < system_.output_count(); ++i) {
        double value = system_.output(i, point.state.x, scratch_, by_motion);
        if (input_.outputs[i].measure != model::Measure::displacement && last_)   // a turn goes on beyond 180 degrees
            value = last_->outputs[i] + std::remainder(value - last_->outputs[i], 2.0 * std::numbers::pi);
        point.outputs.push_back(value);
        point.output_slopes.push_back(slope_along());
    }
    switch (model::leading_load(input_)) {
        case model::LeadingLoad::pressure:
            point.leading = point.pressures_Pa[0];
            point.leading_slope = point.pressure_slopes[0];
            break;
        case model::LeadingLoad::traction: {
            const auto& t = input_.tractions[0].traction_Pa;
            const double size = std::hypot(t[0], t[1], t[2]);
            point.leading = levels.tractions[0] * size;
            point.leading_slope = rate.tractions[0] * size * point.tangent.load_factor;
            break;
        }
        case model::LeadingLoad::load_factor:
            point.leading = point.state.load_factor;
            point.leading_slope = point.tangent.load_factor;
            break;
    }
}

void PathFollower::append(const PathPoint& point) {
    const bool several_loads = input_.loads.size() > 1, several_cavities = system_.cavity_count() > 1;
    const double direction = step_ < 0.0 ? -1.0 : 1.0;   // tangents point in the direction of travel
    const auto travelling = [direction](std::vector<double> slopes) {
        for (double& slope : slopes) slope *= direction;
        return slopes;
    };
    solution::Step step;
    step.stage = stage_;
    step.load_factor = point.state.load_factor;
    step.pressure_Pa = point.leading;
    if (!input_.loads.empty() && system_.encloses_volume(0)) {
        step.volume_m3 = point.load_volumes_m3[0];
        step.tangent_volume = direction * point.load_volume_slopes[0];
    }
    if (several_loads) {
        step.pressures_Pa = point.pressures_Pa;
        step.tangent_pressures = travelling(point.pressure_slopes);
    }
    if (several_cavities) {
        step.volumes_m3 = point.volumes_m3;
        step.tangent_volumes = travelling(point.volume_slopes);
    }
    step.outputs = point.outputs;
    step.tangent_outputs = travelling(point.output_slopes);
    step.tangent_load_factor = direction * point.tangent.load_factor;
    step.tangent_pressure = direction * point.leading_slope;
    step.newton_iterations = iterations_since_row_;
    step.factorizations = newton_.factorizations() - factorizations_at_row_;
    step.stable = is_stable(point);
    system_.prescribe(loads_->levels(point.state.load_factor, point.state.pressures_Pa));
    const auto stretch = system_.stretches(point.state.x);
    step.stretch_p99 = stretch.p99;
    step.max_stretch = stretch.largest;
    step.min_jacobian = stretch.min_jacobian;
    stretch_p99_ = stretch.p99;
    iterations_since_row_ = 0;
    factorizations_at_row_ = newton_.factorizations();
    ++rows_;
    listeners_.step(step, point.state.x);
}

/// Under a controlled volume or output the tangent may have one more direction that gives way than at fixed load, exactly
/// where the load falls: the bordered matrix is then still definite on the constraint.
bool PathFollower::is_stable(const PathPoint& point) const {
    const bool load_follows = control_.kind == ConstraintKind::volume || control_.kind == ConstraintKind::output;
    if (!point.tangent.unstable_modes) return load_follows || !load_falls(point);
    return *point.tangent.unstable_modes == (load_follows && load_falls(point) ? 1 : 0);
}

solution::LimitPoint PathFollower::place_of(const PathPoint& point) const {
    solution::LimitPoint place{rows_, point.leading, std::nullopt, point.outputs};
    if (!input_.loads.empty() && system_.encloses_volume(0)) place.volume_m3 = point.load_volumes_m3[0];
    return place;
}

}  // namespace soft::solver
