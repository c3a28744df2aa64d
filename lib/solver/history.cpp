#include "solver/history.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace soft::solver {

double value_of(const Constraint& constraint, const PathPoint& point) {
    switch (constraint.kind) {
        case ConstraintKind::load_factor: return point.state.load_factor;
        case ConstraintKind::pressure: return point.state.pressures_Pa[constraint.index];
        case ConstraintKind::volume: return point.load_volumes_m3[constraint.index];
        case ConstraintKind::output: return point.outputs[constraint.index];
        case ConstraintKind::arc: break;
    }
    throw std::logic_error("value_of: an arc length is no value of a state");
}

double slope_of(const Constraint& constraint, const PathPoint& point) {
    switch (constraint.kind) {
        case ConstraintKind::load_factor: return point.tangent.load_factor;
        case ConstraintKind::pressure: return point.tangent.pressures[constraint.index];
        case ConstraintKind::volume: return point.load_volume_slopes[constraint.index];
        case ConstraintKind::output: return point.output_slopes[constraint.index];
        case ConstraintKind::arc: break;
    }
    throw std::logic_error("slope_of: an arc length is no value of a state");
}

double distance(Vec a, Vec b) {
    const linalg::Vector difference = copy_of(a);
    linalg::add(difference, -1.0, b);
    return linalg::norm(difference);
}

void add(State& to, double length, const PathTangent& direction) {
    linalg::add(to.x, length, direction.x);
    to.load_factor += length * direction.load_factor;
    for (std::size_t k = 0; k < to.pressures_Pa.size(); ++k) to.pressures_Pa[k] += length * direction.pressures[k];
}

State moved(const State& from, double length, const PathTangent& direction) {
    State to = copy_of(from);
    add(to, length, direction);
    return to;
}

HermiteWeights hermite_weights(double q0, double q1, double q) {
    const double h = q1 - q0, s = (q - q0) / h;
    const double s2 = s * s, s3 = s2 * s;
    return {2.0 * s3 - 3.0 * s2 + 1.0, h * (s3 - 2.0 * s2 + s), 3.0 * s2 - 2.0 * s3, h * (s3 - s2)};
}

double hermite(const HermiteWeights& weights, double y0, double slope0, double y1, double slope1) {
    return weights.y0 * y0 + weights.slope0 * slope0 + weights.y1 * y1 + weights.slope1 * slope1;
}

State predict(const PathPoint* before, const PathPoint& last, double q) {
    if (before == nullptr) return moved(last.state, q - last.q, last.tangent);
    State state{linalg::duplicate(last.state.x), 0.0, last.state.pressures_Pa};
    const auto w = hermite_weights(before->q, last.q, q);
    linalg::add(state.x, w.y0, before->state.x);
    linalg::add(state.x, w.slope0, before->tangent.x);
    linalg::add(state.x, w.y1, last.state.x);
    linalg::add(state.x, w.slope1, last.tangent.x);
    state.load_factor = hermite(w, before->state.load_factor, before->tangent.load_factor, last.state.load_factor,
                                last.tangent.load_factor);
    for (std::size_t k = 0; k < state.pressures_Pa.size(); ++k)
        state.pressures_Pa[k] = hermite(w, before->state.pressures_Pa[k], before->tangent.pressures[k],
                                        last.state.pressures_Pa[k], last.tangent.pressures[k]);
    return state;
}

double round_step_size(double step) {
    int exponent = 0;
    const double mantissa = std::frexp(step, &exponent);
    constexpr double divisions = 256;
    return std::ldexp(std::round(mantissa * divisions) / divisions, exponent);
}

double next_between(const Sample& a, const Sample& b, std::optional<double>& last) {
    const double root = a.q + (b.q - a.q) * a.value / (a.value - b.value);
    const double moved = last ? std::abs(root - *last) : 0.0;
    last = root;
    const double toward_farther = std::abs(root - a.q) > std::abs(b.q - root) ? a.q - root : b.q - root;
    return root + std::clamp(moved / std::abs(toward_farther), 0.0, 0.5) * toward_farther;
}

}  // namespace soft::solver
