#pragma once
/// One step along the path, without what happens on it: where it aims, how well the predictor has met the state there, whether
/// that state is accepted, and the size of the next step. Internal to the module. Tested by solver/step_rules_test, solver/kink_test.
#include "solver/corrector.hpp"

namespace soft::solver {

/// Consecutive failures before a path that may have kinks is assumed to be at one.
inline constexpr int failures_before_kink = 3;
/// Times the tolerance of equilibrium, relative to the state or load: a predictor error below the accuracy of the state itself
/// gives no information about the step.
inline constexpr double equilibrium_margin = 10.0;

/// Target of a step: its end by the cubic (or tangent), or the first goal it reaches. The forecast is the predictor's state there,
/// whether or not Newton's method starts from it.
struct Aim {
    std::optional<Crossing> crossing = {};
    bool straight = false;   ///< predicted by the tangent, not the cubic
    bool by_series = false;  ///< the cubic is the Taylor polynomial at the start of a stage
    State forecast = {};
    Constraint constraint = {};
    double target = 0;
};
[[nodiscard]] Aim aim_of(const PathState& path, Corrector& corrector);

/// The initial guess of Newton's method.
[[nodiscard]] State guess_of(const Aim& aim, const PathState& path, model::Predictor predictor);

/// Where the direction of the path may jump (kink.hpp): with fibres, and in contact.
[[nodiscard]] bool may_have_kinks(const fem::System& system, const PathPoint& point);

/// Relative to the step: of the state, and of the leading load.
struct PredictorError {
    double state = 0, load = 0;
    bool is_negligible = false;  ///< of the whole state and load
    /// The error that the step size is chosen by.
    [[nodiscard]] double larger() const;
};
[[nodiscard]] PredictorError error_of(const fem::System& system, const PathState& path, const Aim& aim,
                                      const PathPoint& point);

/// A changed inertia means another branch, unless the predictor shows that the path has just passed a bifurcation (by arc length without a
/// control of the user only at kinks and in contact). Steps that
/// are chosen by the predictor's error are also repeated where it is large.
[[nodiscard]] bool is_refused(const fem::System& system, const PathState& path, const PredictorError& error,
                              const PathPoint& point);

/// Whether relaxation limits the steps of the stage.
[[nodiscard]] bool limits_steps_in_time(const fem::System& system, const PathState& path);
/// Error of a step in time relative to the one allowed (model::PathSettings::time_accuracy); nullopt on a path without time, and where
/// it cannot be estimated.
[[nodiscard]] std::optional<double> error_in_time(fem::System& system, const PathState& path, const PathPoint& point);
/// Shortens a step with too large an error in time. False where the step was short enough.
[[nodiscard]] bool shorten_for_time(const fem::System& system, PathState& path, std::optional<double> error,
                                    const PathPoint& point);
/// The longest step after one with this error in time, where steps are limited.
[[nodiscard]] double longest_in_time(const PathState& path, std::optional<double> error);

/// Shortens the step where the curve between its rows would be far from the path, though both rows are exact: the length of the first
/// step comes from the loads, which may lie far beyond the end of the path. False where the step was short enough. Not applied where
/// the error does not fall with the step, at a kink. In contact, and where contact begins, steps are judged by the cubic too: its error does
/// not tell how much of a step lies beyond the first contact.
[[nodiscard]] bool shorten_for_the_curve(const fem::System& system, PathState& path, const Aim& aim, double error,
                                         const PathPoint& point);

/// The first step of a stage, to which the shortest one is relative, becomes this one if it is shorter.
void reduce_first_step(PathState& path, double step);

/// The first step comes from the requested load, which may exceed what the body can carry: it is cut as long as it still moves
/// the body, by the root mean square of the unknowns.
[[nodiscard]] bool is_first_try(const fem::System& system, const PathState& path, double step);

/// The step after one that was accepted.
[[nodiscard]] double next_step(const model::Case& input, const PathState& path, const Aim& aim,
                               const PredictorError& error, const NewtonResult& result);

/// This number changes with each eigenvalue that passes through zero between two points without a limit point of the load.
[[nodiscard]] std::optional<int> branch_index(const PathState& path, const PathPoint& point);

}  // namespace soft::solver
