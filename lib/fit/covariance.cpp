#include "fit/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soft::fit {
namespace {

struct Jacobian {
    Eigen::MatrixXd columns;  ///< scaled to length 1
    Eigen::VectorXd inverse_length;
    std::vector<std::size_t> which;  ///< index in the list of constants; indices beyond its end are offsets
};

Jacobian jacobian_of(const Solution& solution, const Rows& rows) {
    const auto linear = static_cast<std::size_t>(solution.candidate.linear), shapes = solution.q.size();
    const Projection& at = solution.projection;
    Jacobian J{Eigen::MatrixXd(rows.target.size(), at.A.cols() + static_cast<Eigen::Index>(shapes)), {}, {}};
    const auto add = [&](const Eigen::VectorXd& column, std::size_t index) {
        J.columns.col(static_cast<Eigen::Index>(J.which.size())) = column;
        J.which.push_back(index);
    };
    for (std::size_t j = 0; j < static_cast<std::size_t>(at.A.cols()); ++j)
        if (at.linear.free[j]) add(at.A.col(static_cast<Eigen::Index>(j)), j < linear ? j : shapes + j);
    for (std::size_t k = 0; k < shapes; ++k) {
        const std::size_t j = solution.candidate.part_of_shape(k);
        if (at.linear.free[j] && !is_at_search_bound(solution.candidate, solution.q[k]))
            add(part_slope(solution.candidate, rows, j, solution.q[k]) * at.linear.c[static_cast<Eigen::Index>(j)],
                linear + k);
    }
    const auto count = static_cast<Eigen::Index>(J.which.size());
    J.columns.conservativeResize(Eigen::NoChange, count);
    J.inverse_length =
        J.columns.colwise().norm().transpose().cwiseMax(std::numeric_limits<double>::min()).cwiseInverse();
    J.columns = (J.columns * J.inverse_length.asDiagonal()).eval();
    return J;
}

/// T: derivatives of the constants with respect to the fit variables.
Eigen::MatrixXd to_constants(const Solution& solution, const Rows& rows, const Fit& fit,
                             const std::vector<std::size_t>& which) {
    const auto linear = static_cast<std::size_t>(solution.candidate.linear), size = fit.list.size();
    const bool ogden = solution.candidate.law == "ogden";  // whose linear constants are mu alpha
    Eigen::MatrixXd T = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(which.size()));
    for (std::size_t i = 0; i < which.size(); ++i) {
        const std::size_t index = which[i];
        const auto row = static_cast<Eigen::Index>(index), column = static_cast<Eigen::Index>(i);
        if (index >= size) continue;
        if (index < linear) {
            T(row, column) = rows.scale_Pa / (ogden ? solution.q[index] : 1.0);
            continue;
        }
        const std::size_t term = index - linear;
        T(row, column) = shape_slope(solution.candidate, rows, solution.q[term]);
        if (ogden) T(static_cast<Eigen::Index>(term), column) = -fit.list[term].value / solution.q[term];
    }
    return T;
}

}  // namespace

void add_covariance(const Solution& solution, const Rows& rows, Fit& fit) {
    const std::size_t size = fit.list.size();
    fit.covariance.assign(size * size, 0.0);
    const Jacobian J = jacobian_of(solution, rows);
    const auto count = static_cast<Eigen::Index>(J.which.size());
    if (count == 0) return;
    const Eigen::MatrixXd R = J.columns.householderQr().matrixQR().topRows(count).triangularView<Eigen::Upper>();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(R, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd& values = svd.singularValues();
    fit.condition = values[count - 1] > 0.0 ? values[0] / values[count - 1] : std::numeric_limits<double>::infinity();
    // The covariance is that of the combinations which the data determine; the constants in another one have an unlimited error.
    const double least = static_cast<double>(rows.target.size()) * std::numeric_limits<double>::epsilon() * values[0];
    const Eigen::VectorXd inverse = values.unaryExpr([least](double v) { return v > least ? 1.0 / v : 0.0; });
    const Eigen::VectorXd undetermined = values.unaryExpr([least](double v) { return v > least ? 0.0 : 1.0; });
    const double freedom = std::max(1.0, static_cast<double>(rows.target.size() - count));
    const double deviation = std::sqrt(solution.projection.residual.squaredNorm() / freedom);
    const Eigen::MatrixXd by_combination =
        to_constants(solution, rows, fit, J.which) * J.inverse_length.asDiagonal() * svd.matrixV();
    const Eigen::MatrixXd root = deviation * by_combination * inverse.asDiagonal(),
                          covariance = root * root.transpose();
    const Eigen::VectorXd unknown = (by_combination * undetermined.asDiagonal()).rowwise().norm(),
                          whole = by_combination.rowwise().norm();
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j)
            fit.covariance[i * size + j] = covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        constexpr double share_of_rounding = 1e-6;
        const auto row = static_cast<Eigen::Index>(i);
        fit.list[i].standard_error = unknown[row] > share_of_rounding * whole[row]
                                         ? std::numeric_limits<double>::infinity()
                                         : std::sqrt(fit.covariance[i * size + i]);
    }
}

}  // namespace soft::fit
