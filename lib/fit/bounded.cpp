#include "fit/bounded.hpp"

#include <cmath>
#include <optional>

namespace soft::fit {
namespace {

enum class State { free, low, high };

/// The triangular factor of the QR of [A y]; the columns of A are scaled to length 1.
struct Triangle {
    Eigen::MatrixXd R;  // n + 1 rows
    Eigen::VectorXd rhs, low, high;

    [[nodiscard]] std::optional<BoundedFit> solve(const std::vector<State>& states) const {
        const Eigen::Index n = R.cols();
        BoundedFit fit{Eigen::VectorXd::Zero(n), std::vector<bool>(states.size()), 0};
        Eigen::MatrixXd part(R.rows(), n);
        Eigen::Index count = 0;
        for (Eigen::Index i = 0; i < n; ++i) {
            const State state = states[static_cast<std::size_t>(i)];
            if (state == State::free)
                part.col(count++) = R.col(i);
            else
                fit.c[i] = state == State::low ? low[i] : high[i];
        }
        if (!fit.c.allFinite()) return std::nullopt;  // an infinite bound
        if (count > 0) {
            const Eigen::VectorXd free = part.leftCols(count).colPivHouseholderQr().solve(rhs - R * fit.c);
            for (Eigen::Index i = 0, k = 0; i < n; ++i)
                if (states[static_cast<std::size_t>(i)] == State::free) fit.c[i] = free[k++];
        }
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto at = static_cast<std::size_t>(i);
            fit.free[at] = states[at] == State::free;
            if (fit.free[at] && !(fit.c[i] >= low[i] && fit.c[i] <= high[i])) return std::nullopt;
        }
        fit.residual_squared = (R * fit.c - rhs).squaredNorm();
        return fit;
    }
};

/// Moves to the next combination of states; returns false after the last.
bool advance(std::vector<State>& states) {
    for (State& state : states) {
        if (state == State::high) {
            state = State::free;
            continue;
        }
        state = state == State::free ? State::low : State::high;
        return true;
    }
    return false;
}

}  // namespace

BoundedFit solve_bounded(const Eigen::MatrixXd& A, const Eigen::VectorXd& y, const Eigen::VectorXd& low,
                         const Eigen::VectorXd& high) {
    const Eigen::Index n = A.cols();
    Eigen::VectorXd scale(n);
    for (Eigen::Index i = 0; i < n; ++i) scale[i] = A.col(i).norm() > 0.0 ? A.col(i).norm() : 1.0;
    Eigen::MatrixXd both(A.rows(), n + 1);
    both << A * scale.cwiseInverse().asDiagonal(), y;
    const Eigen::Index rows = std::min(A.rows(), n + 1);
    const Eigen::MatrixXd R = both.householderQr().matrixQR().topRows(rows).triangularView<Eigen::Upper>();
    const Triangle triangle{R.leftCols(n), R.col(n), low.cwiseProduct(scale), high.cwiseProduct(scale)};

    std::vector<State> states(static_cast<std::size_t>(n), State::free);
    std::optional<BoundedFit> best = triangle.solve(states);
    while (!best) {
        std::optional<BoundedFit> minimum;
        std::vector<State> trial(states.size(), State::free);
        while (advance(trial)) {
            auto fit = triangle.solve(trial);
            if (fit && (!minimum || fit->residual_squared < minimum->residual_squared)) minimum = std::move(fit);
        }
        best = std::move(minimum);  // never empty: the combination with all unknowns at a bound is feasible
    }
    best->c = best->c.cwiseQuotient(scale);
    return *std::move(best);
}

}  // namespace soft::fit
