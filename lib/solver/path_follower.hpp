#pragma once
/// The state machine behind follow_path (path.hpp), internal to the module. One concern per file: path.cpp begins and ends the path,
/// stages.cpp begins and ends stages and changes the control, path_step.cpp takes steps and recovers from failed ones,
/// path_points.cpp measures states and writes rows, path_work.cpp integrates the work of the loads, events.cpp locates limit points,
/// bifurcations and contact, path_kink.cpp passes kinks of the path of bodies with fibres, path_end.cpp ends paths that do not reach
/// their load, path_resume.cpp saves and restores checkpoints.
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "solver/goals.hpp"
#include "solver/history.hpp"
#include "solver/natural_frequencies.hpp"
#include "solver/path.hpp"
#include "solver/path_text.hpp"
#include "solver/visited_states.hpp"

namespace soft::solver {

/// The clause for a path that ends because of its linear solver; the caller puts the location before it.
inline constexpr const char* linear_remedy =
    "the linear solver does not converge; use another solver.linear or solver.preconditioner, or increase solver.linear_limit";

/// The error of a path that cannot start: names solver.linear where the linear solver failed, else `problem` of the materials.
[[nodiscard]] Error start_error(NewtonEnd end, const std::string& problem);

/// A path stalls when its last `stalled_rows` steps are together shorter than `stalled_length` of the whole path.
inline constexpr std::size_t stalled_rows = 150;
inline constexpr double stalled_length = 0.01;

/// Something that happens between two rows.
struct Event {
    PathPoint point;
    bool is_limit_point = false;
    int modes = 0;  ///< eigenvalues that pass through zero; 0 if not a bifurcation
    std::optional<linalg::Vector> mode;
};

class PathFollower {
public:
    PathFollower(fem::System& system, const Listeners& listeners)
        : system_(system),
          input_(system.input()),
          settings_(input_.solver),
          newton_(system, settings_),
          listeners_(listeners),
          scratch_(system.make_vector()) {}

    model::PathEnd run(const model::Checkpoint* from);

private:
    // path.cpp
    void prepare();
    void start();
    void finish(model::StopReason reason, std::string detail);

    // stages.cpp
    [[nodiscard]] const model::Stage& stage() const { return input_.path.stages[static_cast<std::size_t>(stage_)]; }
    void set_stage(int index, model::StageStart start);
    void begin_stage(State state);
    void end_stage(const std::string& text);
    [[nodiscard]] Constraint stage_control() const;
    void leave_volume_control_of_tiny_loads(const PathPoint& by_load);
    [[nodiscard]] Constraint softer_control() const;
    void change_control(const Constraint& control, const std::string& why);
    void report_control() const;
    [[nodiscard]] double control_slope(const Constraint& control, const PathPoint& point) const;
    [[nodiscard]] double bend_under(const Constraint& control);
    [[nodiscard]] double controlled_value(const PathPoint& point, double arc_length) const;
    [[nodiscard]] bool is_near_maximum();
    void leave_load_control();
    [[nodiscard]] int wanted_steps() const;
    [[nodiscard]] double first_step(double slope, double sense) const;
    void begin_without_direction(State state);

    // path_step.cpp
    void advance();
    [[nodiscard]] std::optional<PathPoint> solve_at(const Constraint& constraint, double target, State guess);
    [[nodiscard]] std::optional<PathPoint> solve_between(const PathPoint& a, const PathPoint& b, double q);
    [[nodiscard]] Constraint bind(const Constraint& constraint, const PathPoint& origin) const;
    void accept(PathPoint point);
    void handle_failure();
    /// Target of the next step. The forecast is the predictor's state there, whether or not Newton's method starts from it.
    struct Aim {
        std::optional<Crossing> crossing = {};
        bool straight = false;  ///< predicted by the tangent, not the cubic
        State forecast = {};
        Constraint constraint = {};
        double target = 0;
    };
    /// Relative to the step: of the state, and of the leading load.
    struct PredictorError {
        double state = 0, load = 0;
        bool is_negligible = false;  ///< of the whole state and load
    };
    [[nodiscard]] bool is_first_try(double step) const;
    [[nodiscard]] double next_q() const;
    [[nodiscard]] Aim aim();
    [[nodiscard]] State start_of(const Aim& aim) const;
    [[nodiscard]] PredictorError error_of(const Aim& aim, const PathPoint& point) const;
    [[nodiscard]] bool is_refused(const PredictorError& error, const PathPoint& point) const;
    [[nodiscard]] bool is_too_long(const Aim& aimed, double missed, double taken);
    [[nodiscard]] bool arrive(PathPoint point, const Goal* goal);
    /// `order`: of the predictor's relative error in the step, 3 for the cubic and 1 for the tangent.
    void adapt_step(double predictor_error, double order);

    // path_end.cpp
    [[nodiscard]] bool is_past_limit_point() const;
    [[nodiscard]] bool is_goal_unreachable() const;
    /// Whether the last steps are too short for progress.
    [[nodiscard]] bool is_stalled() const;
    [[nodiscard]] bool is_out_of_reach();
    /// Why the path ends: it has returned to states it has passed. Empty where it has not.
    [[nodiscard]] std::string return_text() const;
    /// Whether a cell of the last attempt is nearly inverted: the material would have failed, or the cells are too large.
    [[nodiscard]] bool is_nearly_inverted() const;
    void abandon_path();

    // path_kink.cpp
    [[nodiscard]] bool pass_kink(double failed_step);
    [[nodiscard]] std::optional<PathTangent> oriented_direction(const State& state);
    [[nodiscard]] bool begins_at_rest() const;
    [[nodiscard]] PathTangent leave_rest(const State& rest, PathTangent slack);
    [[nodiscard]] bool stays_in_piece(const State& base, double length, PathTangent& direction);
    [[nodiscard]] bool find_consistent_direction(const State& base, double length, PathTangent& direction);
    [[nodiscard]] std::optional<PathTangent> piece_between(double step, const PathTangent& far);
    [[nodiscard]] bool turns_within(double step, const PathTangent& turned, Vec x);
    [[nodiscard]] std::optional<PathPoint> point_along(double step, const PathTangent& turned);

    // path_points.cpp
    [[nodiscard]] PathPoint measure(State state, PathTangent tangent);
    void read_values(PathPoint& point);
    void rescale(PathPoint& point, double factor);
    [[nodiscard]] double leading_of(const State& state) const;
    void append(PathPoint& point);
    /// With the loads prescribed as the case states them, and under the control in use.
    [[nodiscard]] bool is_stable(const PathPoint& point) const;
    [[nodiscard]] bool is_stable_under_control(const PathPoint& point) const;
    /// Along the direction of travel.
    [[nodiscard]] bool load_falls(const PathPoint& point) const { return point.tangent.load_factor * step_ < 0.0; }
    [[nodiscard]] model::LimitPoint location_of(const PathPoint& point) const;
    [[nodiscard]] std::string describe(const PathPoint& point) const { return state_text(point, input_); }
    void log(const std::string& line) const {
        if (listeners_.log) listeners_.log(line);
    }

    // path_work.cpp
    /// Work of the loads between two points, and the energy stored at both; of the modelled part.
    struct WorkInterval {
        double work_J = 0, from_J = 0, to_J = 0;
        [[nodiscard]] double gain_J() const { return to_J - from_J; }
        [[nodiscard]] double gap_J() const { return work_J - gain_J(); }
    };
    /// To the accuracy of the path (step_accuracy) where the law has an energy, through as many intermediate states as necessary.
    [[nodiscard]] double work_of_step(PathPoint& from, PathPoint& to);
    /// True if the loads have done other work than the rubber has stored: `to` lies on another equilibrium path than `from`.
    [[nodiscard]] bool breaks_energy_balance(PathPoint& from, PathPoint& to);
    [[nodiscard]] double refined_work(const PathPoint& from, const PathPoint& to, const WorkInterval& interval,
                                      double wanted_J, int halvings_left);
    [[nodiscard]] double stored_energy_of(PathPoint& point);

    // events.cpp
    [[nodiscard]] std::optional<ContactEvent> find_contact(PathPoint& point);
    /// Appends the events between two points in the order of the path; true if the path ends or turns there.
    [[nodiscard]] bool pass_events(const PathPoint& from, const PathPoint& to);
    [[nodiscard]] std::optional<PathPoint> locate_extremum(const PathPoint& from, const PathPoint& to,
                                                           double (*slope)(const PathPoint&, std::size_t),
                                                           std::size_t index);
    [[nodiscard]] std::optional<Event> locate_bifurcation(const PathPoint& from, const PathPoint& to);
    [[nodiscard]] std::string check_bifurcation(const PathPoint& from, const PathPoint& to, const PathPoint& left,
                                                const PathPoint& right, const std::optional<linalg::Vector>& mode);
    [[nodiscard]] std::optional<int> branch_index(const PathPoint& point) const;
    [[nodiscard]] bool take_branch(const Event& event);

    // path_resume.cpp
    void restore(const model::Checkpoint& from);
    void keep_checkpoint();

    fem::System& system_;
    const model::Case& input_;
    model::SolverSettings settings_;
    Newton newton_;
    const Listeners& listeners_;
    std::optional<NaturalFrequencies> frequencies_;  // of every row
    linalg::Vector scratch_;
    std::vector<double> undeformed_volumes_m3_;  // by load

    int stage_ = 0, stage_first_row_ = 0;
    std::optional<StageLoads> loads_;
    std::vector<Goal> goals_;
    Constraint control_;
    std::optional<Constraint> chosen_;  // the user's control, while another one is used to find why the path ends
    std::optional<PathPoint> before_, last_;
    std::vector<VisitedState> visited_;  // rows of the stage
    double step_ = 0, first_step_ = 0;   // of q, signed
    double stretch_p99_ = 1;             // of the last row
    double work_before_stage_J_ = 0;
    double first_slope_ = 0;                                       // |dx / d load factor| at the start of the stage
    int failures_ = 0;                                             // in a row
    std::optional<double> rejected_error_, rejected_curve_error_;  // of the predictor, in the last attempt at this row
    NewtonResult newton_result_;
    int iterations_since_row_ = 0, factorizations_at_row_ = 0;
    int factorizations_before_ = 0;  // of the interrupted run
    int rows_ = 0;
    bool on_branch_ = false;
    bool finished_ = false;
    model::PathEnd end_;
};

}  // namespace soft::solver
