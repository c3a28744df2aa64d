#include "optimize/statistics.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace soft::optimize {

bool is_at_end(const Variable& variable, double value_SI) {
    constexpr double share = 1e-6;
    return std::min(value_SI - variable.from, variable.to - value_SI) <= share * variable.range();
}

bool is_active(const Condition& condition, double value_SI) {
    constexpr double share = 2e-3;
    return condition.relation != Condition::Relation::equal &&
           std::abs(value_SI - condition.value_SI) <=
               share * std::max(std::abs(value_SI), std::abs(condition.value_SI));
}

std::optional<Statistics> statistics_of(const Goal& goal, const Found& found) {
    if (!goal.has_data()) return std::nullopt;
    Statistics result;
    std::vector<std::size_t> targets;
    for (std::size_t i = 0; i < goal.conditions.size(); ++i) {
        if (is_active(goal.conditions[i], found.trial.conditions[i].value_SI)) return std::nullopt;
        if (goal.conditions[i].relation == Condition::Relation::equal) targets.push_back(i);
    }
    for (std::size_t i = 0; i < goal.variables.size(); ++i) {
        if (goal.variables[i].is_whole) continue;
        const bool changes_data = std::ranges::any_of(targets, [&](std::size_t target) {
            constexpr double least = 1e-6;  // of what is allowed, over the whole range
            return std::abs(found.trial.conditions[target].gradient[i]) * goal.variables[i].range() >
                   least * goal.conditions[target].allowed_SI();
        });
        if (!changes_data)
            result.undetermined.push_back(i);
        else if (!is_at_end(goal.variables[i], found.values[i]))
            result.variables.push_back(i);
    }
    const auto n = static_cast<Eigen::Index>(targets.size()), k = static_cast<Eigen::Index>(result.variables.size());
    if (k == 0 || n <= k) return std::nullopt;

    Eigen::MatrixXd J(n, k);  // by the variables over their values
    Eigen::VectorXd values(k);
    double squares = 0;
    for (Eigen::Index j = 0; j < k; ++j) values[j] = found.values[result.variables[static_cast<std::size_t>(j)]];
    for (Eigen::Index i = 0; i < n; ++i) {
        const std::size_t target = targets[static_cast<std::size_t>(i)];
        const Condition& condition = goal.conditions[target];
        const auto& [value, gradient] = found.trial.conditions[target];
        squares += std::pow((value - condition.value_SI) / condition.allowed_SI(), 2);
        for (Eigen::Index j = 0; j < k; ++j)
            J(i, j) =
                gradient[result.variables[static_cast<std::size_t>(j)]] * std::abs(values[j]) / condition.allowed_SI();
    }
    result.degrees_of_freedom = static_cast<std::size_t>(n - k);
    result.scatter = std::sqrt(squares / static_cast<double>(n - k));

    const Eigen::VectorXd length = J.colwise().norm().transpose().cwiseMax(std::numeric_limits<double>::min());
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd((J * length.cwiseInverse().asDiagonal()).eval(), Eigen::ComputeThinV);
    const Eigen::VectorXd singular =
        svd.singularValues().cwiseMax(std::numeric_limits<double>::epsilon() * svd.singularValues()[0]);
    result.condition = singular[0] / singular[k - 1];
    const Eigen::MatrixXd root =
        result.scatter * length.cwiseInverse().asDiagonal() * svd.matrixV() * singular.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd covariance = root * root.transpose();
    const Eigen::VectorXd deviation = covariance.diagonal().cwiseSqrt();
    for (Eigen::Index i = 0; i < k; ++i) {
        result.standard_errors.push_back(deviation[i] * std::abs(values[i]));
        for (Eigen::Index j = 0; j < k; ++j) {
            const double product = deviation[i] * deviation[j];
            result.correlations.push_back(i == j ? 1 : product > 0 ? covariance(i, j) / product : 0);
        }
    }
    const Eigen::VectorXd weakest = length.cwiseInverse().cwiseProduct(svd.matrixV().col(k - 1));
    Eigen::Index largest = 0;
    weakest.cwiseAbs().maxCoeff(&largest);
    result.weakest_error = result.scatter / singular[k - 1] * std::abs(weakest[largest]);
    for (Eigen::Index j = 0; j < k; ++j) result.weakest.push_back(weakest[j] / weakest[largest]);
    return result;
}

}  // namespace soft::optimize
