#include "fit/fit.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/error.hpp"
#include "fit/quality.hpp"
#include "fit/separable.hpp"

namespace soft::fit {
namespace {

// The sum of squares is flat at its minimum: with these tolerances the shapes are accurate to at least about half the digits.
constexpr double function_tolerance = 1e-15, gradient_tolerance = 1e-13, step_tolerance = 1e-11;
constexpr int max_iterations = 150;
// A search that stops this close to a bound may have stalled on its way along the bound.
constexpr double pin_distance = 0.02;
constexpr double same_exponent = 1e-3;
constexpr std::array pole_starts{-4.0, -2.0, 0.0, 2.0, 5.0};  // q: distance of the pole from the data
constexpr std::array rise_starts{0.1, 0.3, 0.5, 0.7, 0.9};    // q of yeoh-5, between its bounds

/// Residual and Jacobian of the projected problem. The gradient is exact; Kaufman's approximation drops second-derivative terms that
/// are small at a good fit (Kaufman, BIT 15 (1975) 49).
class ProjectedResidual final : public ceres::CostFunction {
public:
    ProjectedResidual(const Candidate& candidate, const Rows& rows, Signs signs)
        : candidate_(candidate), rows_(rows), signs_(signs) {
        set_num_residuals(static_cast<int>(rows.target.size()));
        mutable_parameter_block_sizes()->assign(static_cast<std::size_t>(candidate.shapes), 1);
    }

    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        std::vector<double> q;
        for (int k = 0; k < candidate_.shapes; ++k) q.push_back(*parameters[k]);
        const Projection at = project(candidate_, rows_, q, signs_);
        if (!at.residual.allFinite()) return false;
        const Eigen::Index n = at.residual.size();
        Eigen::Map<Eigen::VectorXd>(residuals, n) = at.residual;
        if (jacobians == nullptr) return true;
        Eigen::MatrixXd free(n, at.A.cols());
        Eigen::Index count = 0;
        for (Eigen::Index j = 0; j < at.A.cols(); ++j)
            if (at.linear.free[static_cast<std::size_t>(j)]) free.col(count++) = at.A.col(j).normalized();
        Eigen::MatrixXd slopes(n, q.size());
        for (std::size_t k = 0; k < q.size(); ++k)
            slopes.col(static_cast<Eigen::Index>(k)) =
                part_slope(candidate_, rows_, candidate_.part_of_shape(k), q[k]) *
                at.linear.c[static_cast<Eigen::Index>(candidate_.part_of_shape(k))];
        if (count > 0) {
            const Eigen::HouseholderQR<Eigen::MatrixXd> qr(free.leftCols(count));
            Eigen::MatrixXd turned = qr.householderQ().adjoint() * slopes;
            turned.topRows(count).setZero();
            slopes = qr.householderQ() * turned;
        }
        for (int k = 0; k < candidate_.shapes; ++k)
            if (jacobians[k] != nullptr) Eigen::Map<Eigen::VectorXd>(jacobians[k], n) = slopes.col(k);
        return true;
    }

private:
    const Candidate& candidate_;
    const Rows& rows_;
    Signs signs_;
};

/// Keeps values that are exactly at a bound constant.
void search(const Candidate& candidate, const Rows& rows, Signs signs, std::vector<double>& q) {
    ceres::Problem problem;
    std::vector<double*> blocks;
    for (double& value : q) blocks.push_back(&value);
    problem.AddResidualBlock(new ProjectedResidual(candidate, rows, signs), nullptr, blocks);  // owned by the problem
    for (double* const value : blocks) {
        const SearchBounds bounds = search_bounds(candidate, *value);
        problem.SetParameterLowerBound(value, 0, bounds.low);
        problem.SetParameterUpperBound(value, 0, bounds.high);
        if (*value == bounds.low || *value == bounds.high) problem.SetParameterBlockConstant(value);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = max_iterations;
    options.function_tolerance = function_tolerance;
    options.gradient_tolerance = gradient_tolerance;
    options.parameter_tolerance = step_tolerance;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
}

/// Moves values near a bound onto it; returns true if any was moved.
bool pin_to_bounds(const Candidate& candidate, std::vector<double>& q) {
    bool moved = false;
    for (double& value : q) {
        const SearchBounds bounds = search_bounds(candidate, value);
        for (const double bound : {bounds.low, bounds.high})
            if (value != bound && std::abs(value - bound) < pin_distance) value = bound, moved = true;
    }
    return moved;
}

std::vector<std::vector<double>> starts_of(const Candidate& candidate, const Rows& rows, Signs signs) {
    if (candidate.law == "ogden") return ogden_starts(candidate, rows, signs);
    std::vector<std::vector<double>> starts;
    for (const double q : candidate.law == "yeoh" ? rise_starts : pole_starts) starts.push_back({q});
    return starts;
}

std::optional<Solution> solve(const Candidate& candidate, const Rows& rows, Signs signs) {
    if (candidate.shapes == 0) return Solution{candidate, {}, project(candidate, rows, {}, signs), signs, false};
    std::optional<Solution> best;
    const auto consider = [&](const std::vector<double>& q) {
        Projection at = project(candidate, rows, q, signs);
        if (!at.residual.allFinite()) return;
        if (best && !(at.residual.squaredNorm() < best->projection.residual.squaredNorm())) return;
        best = Solution{candidate, q, std::move(at), signs,
                        std::ranges::any_of(q, [&](double value) { return is_at_search_bound(candidate, value); })};
    };
    const Rows short_rows = candidate.law == "ogden" ? condensed(rows) : rows;
    for (std::vector<double> q : starts_of(candidate, short_rows, signs)) {
        search(candidate, short_rows, signs, q);
        consider(q);
        if (pin_to_bounds(candidate, q)) {
            search(candidate, short_rows, signs, q);
            consider(q);
        }
    }
    return best;
}

/// True if an ogden term is redundant: its modulus is at the bound 0, or its exponent equals that of another term.
bool has_redundant_term(const Solution& solution) {
    for (std::size_t i = 0; i < solution.q.size(); ++i) {
        if (!solution.projection.linear.free[i]) return true;
        for (std::size_t j = 0; j < i; ++j)
            if (std::abs(solution.q[i] - solution.q[j]) < same_exponent) return true;
    }
    return false;
}

/// With constrained signs fewer ogden terms may suffice: takes the smallest number of terms that reaches the best sum of squares.
Solution solve_stable(const Candidate& candidate, const Rows& rows) {
    constexpr double no_better = 1e-9;  // relative reduction of the sum of squares by another term
    std::optional<Solution> best;
    if (candidate.law != "ogden")
        best = solve(candidate, rows, Signs::stable);
    else
        for (int terms = 1; terms <= candidate.shapes; ++terms) {
            Candidate fewer = candidate;
            fewer.linear = fewer.shapes = terms;
            auto solution = solve(fewer, rows, Signs::stable);
            if (!solution || (terms > 1 && has_redundant_term(*solution))) break;
            if (best && solution->projection.residual.squaredNorm() >
                            (1.0 - no_better) * best->projection.residual.squaredNorm())
                break;
            best = std::move(solution);
        }
    if (!best)
        throw Error(ExitCode::bad_input, "", "no stable law " + std::string{candidate.name} + " fits the data",
                    "choose another law, or --stability reported");
    return *std::move(best);
}

/// True if the stress does positive work on the strain over the whole curve; otherwise no law of a rubber fits it.
bool resists_strain(const TestCurve& test) {
    double work = 0;
    for (std::size_t i = 0; i < test.stretch.size(); ++i) work += test.nominal_Pa[i] * (test.stretch[i] - 1.0);
    return work > 0.0;
}

void check(const Candidate& candidate, const std::vector<TestCurve>& tests, const Settings& settings) {
    std::size_t rows = 0, unknowns = static_cast<std::size_t>(candidate.linear + candidate.shapes);
    for (const TestCurve& test : tests) {
        rows += test.stretch.size();
        if (test.mode == Mode::simple_shear)
            throw Error(ExitCode::bad_input, test.source, "simple shear cannot be fitted",
                        "use uniaxial, equibiaxial or planar tests");
        if (!resists_strain(test))
            throw Error(ExitCode::bad_input, test.source, "stress and strain have opposite signs",
                        "choose the right columns: a tensile test has positive stress and strain");
    }
    if (settings.offset == Offset::fitted) unknowns += tests.size();
    if (rows <= unknowns)
        throw Error(ExitCode::bad_input, tests.empty() ? "" : tests.front().source,
                    std::to_string(rows) + " rows are too few for the " + std::to_string(unknowns) + " constants of " +
                        std::string{candidate.name},
                    "give more rows than constants");
}

}  // namespace

double Fit::nominal_stress_Pa(Mode mode, double stretch) const {
    const std::array modes{mode};
    const std::array stretches{stretch};
    std::array<double, 1> stress{};
    add_stresses(candidate, constants, {modes, stretches}, stress);
    return stress[0];
}

Fit fit(const Candidate& candidate, const std::vector<TestCurve>& tests, const Settings& settings) {
    check(candidate, tests, settings);
    const Rows rows = rows_of(tests, settings);
    const bool tries_free = settings.stability != Stability::everywhere;
    if (const auto free = tries_free ? solve(candidate, rows, Signs::free) : std::nullopt) {
        Fit result = describe(*free, tests, rows);
        if (settings.stability == Stability::reported || result.stable) return result;
    }
    const Solution solution = solve_stable(candidate, rows);
    Fit result = describe(solution, tests, rows);
    if (solution.candidate.shapes < candidate.shapes) {
        result.flags.push_back("terms:" + std::to_string(solution.candidate.shapes));
    }
    result.candidate.name = candidate.name;
    return result;
}

double prediction_rmse_Pa(const Fit& fit, const TestCurve& test) {
    double squares = 0;
    for (std::size_t i = 0; i < test.stretch.size(); ++i) {
        const double residual = fit.nominal_stress_Pa(test.mode, test.stretch[i]) - test.nominal_Pa[i];
        squares += residual * residual;
    }
    return std::sqrt(squares / static_cast<double>(test.stretch.size()));
}

}  // namespace soft::fit
