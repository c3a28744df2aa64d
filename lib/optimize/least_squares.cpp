#include <ceres/ceres.h>

#include <algorithm>
#include <exception>

#include "optimize/record.hpp"

namespace soft::optimize {
namespace {

constexpr int max_iterations = 40;
// The sum of squares is flat at its minimum: 1e-4 of it is a few hundredths of a standard error. The steps of the path, which differ between
// trials, change it by about as much. Values have seven digits as text.
constexpr double squares_tolerance = 1e-4, parameter_tolerance = 1e-6, gradient_tolerance = 1e-14;

class Differences final : public ceres::CostFunction {
public:
    Differences(const Goal& goal, Record& record, const UnitCube& cube) : goal_(goal), record_(record), cube_(cube) {
        for (std::size_t i = 0; i < goal.conditions.size(); ++i)
            if (goal.conditions[i].relation == Condition::Relation::equal) targets_.push_back(i);
        set_num_residuals(static_cast<int>(targets_.size()));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(cube.size()));
    }

    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        // An exception does not pass through Ceres.
        const Trial* trial = nullptr;
        try {
            if (!thrown_) trial = &record_.at(cube_.values_at(parameters[0]));
        } catch (...) {
            thrown_ = std::current_exception();
        }
        if (trial == nullptr || !trial->failure.empty()) return false;
        for (std::size_t row = 0; row < targets_.size(); ++row) {
            const Condition& condition = goal_.conditions[targets_[row]];
            const auto& [value, gradient] = trial->conditions[targets_[row]];
            residuals[row] = (value - condition.value_SI) / condition.allowed_SI();
            if (jacobians != nullptr && jacobians[0] != nullptr)
                cube_.fill(gradient, 1 / condition.allowed_SI(), jacobians[0] + row * cube_.size());
        }
        return true;
    }

    void rethrow() const {
        if (thrown_) std::rethrow_exception(thrown_);
    }

private:
    const Goal& goal_;
    Record& record_;
    const UnitCube& cube_;
    std::vector<std::size_t> targets_;
    mutable std::exception_ptr thrown_;
};

}  // namespace

void run_least_squares(const Goal& goal, Record& record, const std::vector<double>& start) {
    if (!record.at(start).failure.empty()) return;  // Ceres would print an error
    const UnitCube cube(goal, start);
    std::vector<double> u = cube.start();
    ceres::Problem problem;
    auto* const differences = new Differences(goal, record, cube);  // owned by the problem
    problem.AddResidualBlock(differences, nullptr, u.data());
    for (int k = 0; k < static_cast<int>(u.size()); ++k) {
        problem.SetParameterLowerBound(u.data(), k, 0);
        problem.SetParameterUpperBound(u.data(), k, 1);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = max_iterations;
    options.function_tolerance = squares_tolerance;
    options.parameter_tolerance = parameter_tolerance;
    options.gradient_tolerance = gradient_tolerance;
    options.max_num_line_search_step_size_iterations = 0;  // a step that does not help is shortened by the trust region
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    differences->rethrow();
    // Ceres projects its step onto the ranges and stops where nothing is left of it, also where another direction leads on.
    const std::vector<double> end = cube.values_at(u.data());
    const bool is_at_an_end = std::ranges::any_of(u, [](double value) { return value <= 0 || value >= 1; });
    const bool is_met = !goal.has_data() && record.of_conditions(record.at(end)) <= 0;
    if (is_at_an_end && !is_met) run_quadratic_programming(goal, record, end);
}

}  // namespace soft::optimize
