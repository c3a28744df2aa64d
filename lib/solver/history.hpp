#pragma once
/// The last two converged states with their tangents, and the cubic through them: predictor of the next state and
/// interpolant between the two.
///   y(q) = h00 y0 + h10 h y0' + h01 y1 + h11 h y1',  h = q1 - q0, evaluated at s = (q - q0)/h (s > 1 extrapolates).
/// q is the controlled quantity. With one state only, the tangent line. Tested by solver/solver_test.
#include <optional>

#include "solver/newton.hpp"

namespace soft::solver {

/// A converged state with the values that the path needs. Slopes are per unit q.
struct PathPoint {
    State state;
    PathTangent tangent;
    double q = 0;                                                 ///< value of the controlled quantity
    std::vector<double> pressures_Pa = {}, pressure_slopes = {};  ///< of all pressure loads
    std::vector<double> volumes_m3 = {}, volume_slopes = {};      ///< of all measured cavities
    std::vector<double> load_volumes_m3 = {},
                        load_volume_slopes = {};  ///< of the cavities of each pressure load together
    std::vector<double> outputs = {}, output_slopes = {};
    LoadLevels levels = {}, level_slopes = {};  ///< of all loads
    double load_work_J = 0;                     ///< of the loads since the path began, of the modelled part
    std::optional<double> step_work_J = {};     ///< of the loads since the point before, once it has been computed
    double lost_J = 0;                          ///< set free by a snap that leads to this point, of the modelled part
    std::optional<double> stored_J = {};    ///< energy of the rubber, of the modelled part, once it has been computed
    bool is_singular = false;               ///< a bifurcation: derivatives are not unique
    bool touches = false;                   ///< the actuator touches itself or an obstacle
    double leading = 0, leading_slope = 0;  ///< the load a curve shows (model::leading_load): [Pa], or the load factor
};

/// Value of the quantity that a constraint prescribes, and its slope (per unit q), at a point whose values have been read; not for arc.
[[nodiscard]] double value_of(const Constraint& constraint, const PathPoint& point);
[[nodiscard]] double slope_of(const Constraint& constraint, const PathPoint& point);

/// |a - b|
[[nodiscard]] double distance(Vec a, Vec b);

/// to += length x direction
void add(State& to, double length, const PathTangent& direction);

/// `from` + `length` x `direction`
[[nodiscard]] State moved(const State& from, double length, const PathTangent& direction);

/// Cubic Hermite weights of (y0, y0', y1, y1') at q.
struct HermiteWeights {
    double y0, slope0, y1, slope1;
};
[[nodiscard]] HermiteWeights hermite_weights(double q0, double q1, double q);

/// Value of a scalar that changes along the path, between or beyond two points.
[[nodiscard]] double hermite(const HermiteWeights& weights, double y0, double slope0, double y1, double slope1);

/// State at q on the cubic through `before` and `last`, or on the tangent of `last` where there is no `before`.
[[nodiscard]] State predict(const PathPoint* before, const PathPoint& last, double q);

/// Rounds a step to few digits, so that rounding errors, which depend on the number of ranks, do not move the rows of the path.
[[nodiscard]] double round_step_size(double step);

/// A position on the path and the value of a function there.
struct Sample {
    double q, value;
};

/// The next trial position for the zero between two samples of opposite sign: the secant's root, moved towards the farther end by as
/// much as the root has moved since the last one, so that the bracket closes from both sides. `last` is the previous root.
[[nodiscard]] double next_between(const Sample& a, const Sample& b, std::optional<double>& last);

}  // namespace soft::solver
