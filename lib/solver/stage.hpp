#pragma once
/// One implicit stage of a motion: the state x at time t with velocity and acceleration linear in x,
///   v = v0 + by_velocity (x - x0),   a = a0 + by_acceleration (x - x0),   m_k = m0_k + flow_share dm_k/dt(t, p_k),
/// that satisfies the equations of motion. Every implicit integrator consists of such stages. Each needs one factorisation of
///   J = K + by_velocity C + by_acceleration M
/// bordered by the pressures behind the lines (newton.hpp): J d = b, J b_k = f_k, dx = d + sum dp_k b_k.
/// Internal to the module. Tested by solver/dynamics_test.
#include "linalg/linear_solver.hpp"
#include "linalg/small_matrix.hpp"
#include "solver/equations.hpp"
#include "solver/newton.hpp"

namespace soft::solver {

using solver::NewtonEnd;

/// Scale of the residual of a line's equation: of the order of the ambient pressure.
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

/// Whether a residual no longer falls from the previous iteration to this one.
[[nodiscard]] inline bool stalls(double residual, double before) { return residual > 0.3 * before; }

class StageSolver {
public:
    explicit StageSolver(MotionEquations& equations);

    /// `state`: an initial guess of x with the corresponding v and a, and the time of the stage; on return the solution with its
    /// masses and load force. If an element is inverted in the guess, the state is moved to `fallback` first.
    [[nodiscard]] NewtonResult solve(const StageMap& map, Vec fallback, MotionState& state);

    // For PETSc's TS, which has its own Newton loop.
    /// Tangent and line forces at x; false where an element is inverted or J is singular.
    [[nodiscard]] bool factorize(Vec x, const fem::LoadLevels& levels, double by_velocity, double by_acceleration);
    /// dx and dp by the last factor; `b` is not modified.
    [[nodiscard]] bool solve_linear(Vec b, std::span<const LineRow> rows, Vec dx, std::vector<double>& dp);
    /// J as factorised.
    [[nodiscard]] Mat matrix() const { return J_; }
    /// dV_k/dx at x, for solve_linear; returns the volumes.
    [[nodiscard]] std::vector<double> read_volumes(Vec x);

    [[nodiscard]] int factorizations() const noexcept { return solver_.factorizations(); }
    /// Scale of the residuals, bounded from below for times at which all forces of the motion vanish.
    [[nodiscard]] double force_scale(const fem::Evaluation& evaluation, Vec inertia);
    /// 0 without any forces, 1 where the scale is 0.
    [[nodiscard]] static double relative_residual(Vec forces, double scale);
    /// Whether a residual [N] at x is no larger than the rounding error of R there, as for a stiff body that has moved very little or
    /// very far. The rounding error is the second difference R(x + 2d) - 2 R(x + d) + R(x) for a d so small that R is linear
    /// in it. Leaves the equations evaluated at x.
    [[nodiscard]] bool is_rounding(double residual_N, Vec x, const fem::LoadLevels& levels);

private:
    [[nodiscard]] std::vector<LineRow> line_rows(const StageMap& map, const MotionState& state,
                                                 std::span<const double> pressures);
    [[nodiscard]] fem::Evaluation evaluate(const MotionState& state, std::span<const double> pressures, Mat K,
                                           NewtonResult& result);
    [[nodiscard]] double balance(const MotionState& state, const fem::Evaluation& evaluation);
    [[nodiscard]] NewtonEnd correct(const StageMap& map, std::span<const LineRow> rows, MotionState& state,
                                    std::vector<double>& pressures, NewtonResult& result);
    void move(const StageMap& map, double length, Vec dx, MotionState& state);
    [[nodiscard]] bool factorize_here(double by_velocity, double by_acceleration);

    MotionEquations& equations_;
    const model::SolverSettings& settings_;
    linalg::Matrix J_;
    linalg::LinearSolver solver_;
    linalg::Vector r_, dx_, inertia_, masked_;
    linalg::Vector probe_;  // d of is_rounding, created at its first call
    std::vector<linalg::Vector> columns_, gradients_;
    fem::Evaluation evaluation_;  // of the current state
    bool factor_is_of_stage_ = false;
    double max_scale_ = 0;
};

}  // namespace soft::solver
