#pragma once
/// The state machine behind integrate_motion (motion.hpp), internal to the module: motion.cpp starts, takes steps, chooses
/// their size and ends; motion_ends.cpp handles failures; motion_rows.cpp integrates the energies and writes rows.
///
/// Steps: constant (Dynamics::step_s), by the stable step (explicit), else by the local error of x,
///   e = method's own (embedded) or constant x h^(q+1) |(q+1)! x[t0 .. t(q+1)]|, the divided difference of the last positions,
/// which must be below `accuracy` x the size of the motion: the largest |x| so far, at least a tenth of the linear response
/// (K0 + M / duration^2)^-1 f to all loads at their full level (with obstacles at most the norm of a motion by ten contact distances), and a
/// hundredth of the motion of the fastest obstacle. Adaptive steps end at the kinks of the loads and are small after them.
///
/// Loads that act suddenly accelerate the body in modes that no step resolves, by F/M of single cells. Generalised alpha, whose first
/// step uses a(0), excites them with velocities of h F/M. With stiffness damping these velocities cause forces far above the load.
/// In this case the first steps use the Runge-Kutta method, which is L-stable (it damps such modes within a step) and has an
/// error estimate from the first step on.
#include <deque>
#include <variant>

#include "solver/explicit.hpp"
#include "solver/history.hpp"
#include "solver/motion.hpp"
#include "solver/path_text.hpp"
#include "solver/petsc_ts.hpp"

namespace soft::solver {

using solver::round_step_size;
using solver::short_text;

class MotionFollower {
public:
    MotionFollower(fem::System& system, const solver::Listeners& listeners);
    model::PathEnd run();

private:
    using Method = std::variant<std::monostate, GeneralizedAlpha, Dirk, TsIntegrator, CentralDifference>;

    // motion.cpp
    void start();
    void make_method();
    void choose_first_step();
    [[nodiscard]] double norm_of_linear_response();
    [[nodiscard]] double norm_of_obstacle_motion() const;
    [[nodiscard]] double norm_of_rigid_motion(double length_m) const;
    void advance();
    [[nodiscard]] double next_step();
    [[nodiscard]] double longest_step() const;
    [[nodiscard]] double limited_by_obstacles(double step_s);
    [[nodiscard]] std::optional<StepResult> attempt(double step_s);
    [[nodiscard]] std::optional<double> relative_error(const StepResult& result, double step_s);
    void accept(double step_s, std::optional<double> error);
    void adapt(std::optional<double> error, double step_s);
    void update_stable_step();
    [[nodiscard]] bool is_constant() const noexcept { return dynamics_.step_s > 0.0; }
    [[nodiscard]] bool is_adaptive() const noexcept { return !is_constant() && !explicit_; }

    // motion_ends.cpp
    void handle_failure(const NewtonResult& failure, double step_s);
    /// Where walls have passed through each other in the next state: the step is cut.
    [[nodiscard]] bool refuses_crossing(double step_s);
    /// False if the step cannot be shorter.
    [[nodiscard]] bool cut(double step_s, const std::string& why);
    /// Why the state of this row is impossible: it is not finite, or explicit steps have created energy. nullopt otherwise.
    [[nodiscard]] std::optional<std::string> check_plausibility(const model::Step& step) const;
    void finish(model::StopReason reason, std::string detail);

    // motion_rows.cpp
    void integrate_energies(const MotionState& from, const MotionState& to);
    [[nodiscard]] double work_of_obstacles(const MotionState& from, const MotionState& to);
    [[nodiscard]] fem::LoadLevels levels_of(const MotionState& state) const;
    [[nodiscard]] solver::PathPoint measure();
    [[nodiscard]] std::optional<ContactEvent> contact_in(const MotionState& state);
    void append();

    fem::System& system_;
    const model::Case& input_;
    const model::Dynamics& dynamics_;
    const model::SolverSettings& settings_;
    const solver::Listeners& listeners_;
    bool explicit_, moves_obstacles_;
    MotionEquations equations_;
    std::optional<StageSolver> stage_;  // of implicit integrators
    std::optional<StableStep> stable_;  // of explicit ones
    Method method_;
    std::optional<Dirk> starter_;  // for the first steps, see above
    MotionState last_, next_;
    std::optional<solver::PathPoint> last_row_;  // for angles
    struct Position {
        double time_s;
        linalg::Vector x;
    };
    std::deque<Position> history_;  // before `last_`, latest first
    std::vector<double> kinks_;
    int order_ = 2;              // the local error is proportional to h^(order_ + 1)
    double error_constant_ = 0;  // of divided differences
    double step_s_ = 0, first_step_s_ = 0, row_interval_s_ = 0, next_row_s_ = 0;
    double stable_step_s_ = 0;
    int between_estimates_ = 0, next_estimate_ = 0;                 // of the stable step, in steps
    double size_ = 0;                                               // of the motion
    double load_work_J_ = 0, damping_work_J_ = 0, max_work_J_ = 0;  // of the modelled part
    int rows_ = 0, steps_ = 0, iterations_since_row_ = 0, factorizations_at_row_ = 0;
    bool is_free_of_stress_ = true;  // the undeformed body
    bool finished_ = false;
    model::PathEnd end_;
};

}  // namespace soft::solver
