#pragma once
/// All trials of a search, and the best of them. Private to the module. Tested by optimize/search_test.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "optimize/search.hpp"

namespace soft::optimize {

class Record {
public:
    Record(const Goal& goal, const Evaluate& evaluate, const Progress& progress);

    /// The trial with these values, evaluated if it is new.
    const Trial& at(const std::vector<double>& values);

    /// The best trial so far; nullptr before the first success.
    [[nodiscard]] const Found* best() const noexcept { return best_ ? &*best_ : nullptr; }
    [[nodiscard]] Found found_of(const std::vector<double>& values, const Trial& trial) const;
    /// Fewer violations, then the smaller objective. Where nothing is minimized, the objective is the sum over the targets: fewer violations of the
    /// other conditions, then all targets met, then the smaller objective.
    [[nodiscard]] bool is_better(const Found& a, const Found& b) const;
    /// The measure to be minimized, or the sum of the squared differences from the targets over what is allowed; gradient by the
    /// variables, SI.
    double objective(const Trial& trial, std::vector<double>* gradient) const;
    /// The largest violation of a condition, stability aside.
    [[nodiscard]] double of_conditions(const Trial& trial) const;
    /// Throws Error (bad_input) if no trial succeeded, with the first failure.
    [[nodiscard]] Found result() const;

private:
    /// The largest violation of what is not a target.
    [[nodiscard]] double of_bounds(const Trial& trial) const;

    const Goal& goal_;
    const Evaluate& evaluate_;
    const Progress& progress_;
    std::map<std::vector<double>, Trial> trials_;
    std::optional<Found> best_;
    std::string first_failure_;
};

/// The continuous variables in the unit cube; the others keep the values of a start.
class UnitCube {
public:
    UnitCube(const Goal& goal, std::vector<double> start);

    [[nodiscard]] std::size_t size() const noexcept { return variables_.size(); }
    [[nodiscard]] std::vector<double> start() const;
    [[nodiscard]] std::vector<double> values_at(const double* u) const;
    /// A gradient by the variables times `factor`, by the coordinates.
    void fill(const std::vector<double>& gradient, double factor, double* out) const;

private:
    const Goal& goal_;
    std::vector<double> start_;
    std::vector<std::size_t> variables_;
};

/// Least squares of the differences from the targets over what is allowed (Levenberg and Marquardt; Ceres). A trial that fails shortens the step.
void run_least_squares(const Goal& goal, Record& record, const std::vector<double>& start);

/// That many trials of DIRECT-L (NLopt), without derivatives, whole numbers included, until is_met().
void run_global(const Goal& goal, Record& record, int trials, const std::function<bool()>& is_met);

/// Sequential quadratic programming (SLSQP; NLopt) in a box of half the size after each trial that fails.
void run_quadratic_programming(const Goal& goal, Record& record, const std::vector<double>& start);

}  // namespace soft::optimize
