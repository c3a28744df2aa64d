#pragma once
/// One implicit stage of a motion: the state x at time t whose velocity and acceleration follow it,
///   v = v0 + by_velocity (x - x0),   a = a0 + by_acceleration (x - x0),   m_k = m0_k + flow_share dm_k/dt(t, p_k),
/// and that obeys the equations of motion. What makes a stage of every implicit integrator, and the one factorisation of
///   J = K + by_velocity C + by_acceleration M
/// it needs, bordered by the pressures behind the lines (newton.hpp): J d = b, J b_k = f_k, dx = d + sum dp_k b_k.
/// Internal to the module. Tested by dynamics/dynamics_test.
#include "dynamics/equations.hpp"
#include "linalg/linear_solver.hpp"
#include "linalg/small_matrix.hpp"
#include "solver/newton.hpp"

namespace soft::dynamics {

using solver::NewtonEnd;

/// What a line's equation is measured by: of the order of the ambient pressure.
inline constexpr double line_pressure_scale_Pa = 1e5;

struct StageMap {
    double by_velocity = 0, by_acceleration = 0;
    double flow_share = 0;
    std::vector<double> masses_kg;  ///< m0
};

/// A line's linear equation: by_pressure dp + by_volume dV = rhs.
struct LineRow {
    double by_pressure = 1, by_volume = 0, rhs = 0;
};

struct StageResult {
    NewtonEnd end = NewtonEnd::converged;
    int iterations = 0;
    double residual = 0;  ///< over the scale of forces
    double min_jacobian = 1;
    mesh::Index worst_cell = -1;
};

/// Of a residual, from the iteration before to this one: it no longer falls.
[[nodiscard]] inline bool stalls(double residual, double before) { return residual > 0.3 * before; }

class StageSolver {
public:
    explicit StageSolver(MotionEquations& equations);

    /// `state`: a guess of x with the v and a that belong to it, its time that of the stage; on return the solution with its
    /// masses and load force. Where the guess turns a cell inside out it is moved to `fallback` first.
    [[nodiscard]] StageResult solve(const StageMap& map, Vec fallback, MotionState& state);

    // For PETSc's TS, which keeps the loop for itself.
    /// Tangent and line forces at x; false where a cell is inside out or J is singular.
    [[nodiscard]] bool factorize(Vec x, const assembly::LoadLevels& levels, double by_velocity, double by_acceleration);
    /// dx and dp by the last factor; `b` is left as it is.
    [[nodiscard]] bool solve_linear(Vec b, std::span<const LineRow> rows, Vec dx, std::vector<double>& dp);
    /// J as it was factorised.
    [[nodiscard]] Mat matrix() const { return J_; }
    /// dV_k/dx at x, for solve_linear; returns the volumes.
    [[nodiscard]] std::vector<double> read_volumes(Vec x);

    [[nodiscard]] int factorizations() const noexcept { return solver_.factorizations(); }
    /// What residuals are measured by, with a floor where all forces of the motion vanish for a moment.
    [[nodiscard]] double force_scale(const assembly::Evaluation& evaluation, Vec inertia);
    /// Whether a residual [N] at x is no more than the rounding of R there, as that of a stiff body that has hardly moved, or has
    /// moved far. Rounding is what the second difference R(x + 2d) - 2 R(x + d) + R(x) leaves of a d so small that R is linear
    /// in it. Leaves the equations evaluated at x.
    [[nodiscard]] bool is_rounding(double residual_N, Vec x, const assembly::LoadLevels& levels);

private:
    [[nodiscard]] std::vector<LineRow> line_rows(const StageMap& map, const MotionState& state,
                                                 std::span<const double> pressures);
    [[nodiscard]] assembly::Evaluation evaluate(const MotionState& state, std::span<const double> pressures, Mat K,
                                                StageResult& result);
    [[nodiscard]] double balance(const MotionState& state, const assembly::Evaluation& evaluation);
    [[nodiscard]] NewtonEnd correct(const StageMap& map, std::span<const LineRow> rows, MotionState& state,
                                    std::vector<double>& pressures, StageResult& result);
    void move(const StageMap& map, double length, Vec dx, MotionState& state);
    [[nodiscard]] bool factorize_here(double by_velocity, double by_acceleration);

    MotionEquations& equations_;
    const model::SolverSettings& settings_;
    linalg::Matrix J_;
    linalg::LinearSolver solver_;
    linalg::Vector r_, dx_, inertia_, masked_;
    linalg::Vector probe_;  // d of is_rounding, once it is asked for
    std::vector<linalg::Vector> columns_, gradients_;
    assembly::Evaluation evaluation_;  // of the state as it stands
    bool factor_is_of_stage_ = false;
    double max_scale_ = 0;
};

}  // namespace soft::dynamics
