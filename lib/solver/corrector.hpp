#pragma once
/// Finds states of the path: Newton's method, the tangent of the path there, and the values of the state. Internal to the module.
#include <utility>

#include "solver/path_state.hpp"

namespace soft::solver {

/// What a state is measured with: the loads, the control, and the last state of the path.
struct Frame {
    const StageLoads& loads;
    const Constraint& control;
    const PathPoint& last;
};

[[nodiscard]] inline Frame frame_of(const PathState& path) { return {*path.loads, path.control, *path.last}; }

/// The arc constraint of a step runs along the tangent of the state it starts from.
[[nodiscard]] Constraint bind(const Constraint& constraint, const PathPoint& origin);

struct WorkCount {
    int iterations = 0, factorizations = 0;
};

/// Without contact, bodies pass through each other, and the path does not bend.
enum class WithContact { no, yes, if_met };

class Corrector {
public:
    explicit Corrector(fem::System& system)
        : system_(system), newton_(system, system.input().solver), scratch_(system.make_vector()) {}

    /// Moves `state` to equilibrium where the constraint has its target; last_result() is the outcome.
    [[nodiscard]] bool correct(const Constraint& constraint, double target, State& state);

    /// With contact `if_met`, a path that touches nothing is solved without it, so that it costs nothing and does not change the iterates,
    /// and again with it where something touches. After `no`, contact rests until the next solve or wake_contact_if_met().
    /// nullopt also where the actuator would be on another side of an obstacle than at the frame's last state.
    [[nodiscard]] std::optional<PathPoint> solve_at(const Frame& frame, const Constraint& constraint, double target,
                                                    State guess, WithContact contact = WithContact::if_met);
    /// The state at q between two points of the path.
    [[nodiscard]] std::optional<PathPoint> solve_between(const Frame& frame, const PathPoint& a, const PathPoint& b,
                                                         double q, WithContact contact = WithContact::if_met);
    /// The state at which `crossing` is reached between two converged points, where its quantity jumps the first beyond the jump. `guess`: near
    /// it, used where the goal has a slope. nullopt if no state is found.
    [[nodiscard]] std::optional<PathPoint> solve_goal(const Frame& frame, const Crossing& crossing,
                                                      const PathPoint& from, PathPoint to, State guess);
    /// Whether a state solved without contact touches or has passed through anything. If so, or with friction, which may have dissipated
    /// energy before, contact no longer rests.
    [[nodiscard]] bool wake_contact_if_met(const Frame& frame, const PathPoint& point);
    /// A converged state with its values. The arc length continues from the frame's last point.
    [[nodiscard]] PathPoint measure(const Frame& frame, State state, PathTangent tangent);
    /// Value of a constraint at a state.
    [[nodiscard]] double value(const Constraint& constraint, const StageLoads& loads, const State& state);

    [[nodiscard]] fem::System& system() const { return system_; }
    [[nodiscard]] const model::Case& input() const { return system_.input(); }
    [[nodiscard]] Newton& newton() { return newton_; }
    [[nodiscard]] const NewtonResult& last_result() const { return last_result_; }
    [[nodiscard]] WorkCount work() const { return {iterations_, newton_.factorizations()}; }

    /// What side computations must not change: the last result, and the pivots that the next tangent is compared with.
    using Memory = std::pair<NewtonResult, int>;
    [[nodiscard]] Memory memory() const { return {last_result_, newton_.confirmed_pivots()}; }
    void restore(const Memory& memory);

private:
    [[nodiscard]] std::optional<PathPoint> solve_from(const Frame& frame, const Constraint& constraint, double target,
                                                      State guess);

    fem::System& system_;
    Newton newton_;
    linalg::Vector scratch_;
    NewtonResult last_result_;
    int iterations_ = 0;
};

}  // namespace soft::solver
