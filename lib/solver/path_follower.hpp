#pragma once
/// The state machine behind follow_path (path.hpp), internal to the room. One concern a file: path.cpp begins and ends,
/// path_step.cpp takes steps and mends failed ones, path_points.cpp measures states and writes rows, limit_point.cpp
/// locates limit points, path_resume.cpp keeps and restores checkpoints.
#include <optional>
#include <string>
#include <vector>

#include "solver/goals.hpp"
#include "solver/history.hpp"
#include "solver/path.hpp"
#include "solver/path_text.hpp"

namespace soft::solver {

/// Steps of few digits, so that rounding, which differs with the number of ranks, does not move the rows of the path.
[[nodiscard]] double coarse(double step);

class PathFollower {
public:
    PathFollower(assembly::System& system, const Listeners& listeners)
        : system_(system), input_(system.input()), settings_(input_.solver), newton_(system, settings_),
          sink_(listeners.step), keep_(listeners.checkpoint), log_(listeners.log), scratch_(system.make_vector()) {}

    solution::PathEnd run(const solution::Checkpoint* from);

private:
    void prepare();
    void start();
    void restore(const solution::Checkpoint& from);
    void keep_checkpoint();
    [[nodiscard]] bool finished() const { return finished_; }
    void advance();
    [[nodiscard]] std::optional<PathPoint> solve_at(const Constraint& constraint, double target, State guess);
    [[nodiscard]] PathPoint measure(State state, PathTangent tangent);
    [[nodiscard]] Constraint bind(const Constraint& constraint, const PathPoint& origin) const;
    void locate_limit_point(const PathPoint& from, const PathPoint& to);
    void accept(PathPoint point);
    void handle_failure();
    void adapt_step(double predictor_error);
    void read_values(PathPoint& point);
    void append(const PathPoint& point);
    void finish(solution::StopReason reason, std::string detail);
    void switch_to_arc_length();
    [[nodiscard]] bool is_stable(const PathPoint& point) const;
    [[nodiscard]] std::string describe(const PathPoint& point) const { return state_text(point, input_); }
    [[nodiscard]] int wanted_steps() const;

    assembly::System& system_;
    const model::Case& input_;
    model::SolverSettings settings_;
    Newton newton_;
    const StepSink& sink_;
    const CheckpointSink& keep_;
    const Log& log_;
    linalg::Vector scratch_;

    Constraint control_;
    bool stop_at_limit_point_ = false;
    std::vector<Goal> goals_;
    std::optional<PathPoint> before_, last_;
    double step_ = 0, first_step_ = 0;          // of q, signed
    int failures_ = 0;                          // in a row
    std::optional<double> rejected_error_;      // of the predictor, at the last attempt from here
    NewtonResult newton_result_;
    int iterations_since_row_ = 0, factorizations_at_row_ = 0;
    int factorizations_before_ = 0;             // of the run that was interrupted
    int rows_ = 0;
    bool finished_ = false;
    solution::PathEnd end_;
};

}  // namespace soft::solver
