#include "fit/history_fit.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/error.hpp"
#include "core/text.hpp"
#include "fit/history_stress.hpp"
#include "fit/quality.hpp"
#include "material/response.hpp"

namespace soft::fit {
namespace {

constexpr int most_iterations = 100;
constexpr double cost_tolerance = 1e-12;
/// Bounds of the logarithms of moduli and of r - 1, and of beta.
constexpr double min_modulus = 1e-4, max_modulus = 20, max_r = 100, max_beta = 10;
constexpr double correlated = 1e4;  // condition
/// Starts: relaxation times relative to those spread over the data, and softening r.
constexpr std::array<double, 2> time_starts{1.0, 0.2};
constexpr std::array<double, 2> r_starts{1.5, 4.0};

/// The unknowns: the constants of the law relative to `scale`, then ln g, ln tau, ln (r - 1), ln m, beta.
struct Unknowns {
    const Candidate* candidate;
    const HistorySettings* settings;
    std::vector<double> scale, value, low, high;

    [[nodiscard]] std::size_t of_law() const { return scale.size(); }
    [[nodiscard]] std::size_t given() const { return settings->elastic ? of_law() : 0; }
    [[nodiscard]] std::size_t size() const { return value.size(); }
    void add(double start, double from, double to) {
        value.push_back(std::clamp(start, from, to));
        low.push_back(from);
        high.push_back(to);
    }
    /// Value and derivative of constant `i` by its unknown.
    [[nodiscard]] std::pair<double, double> constant(std::size_t i, const double* x) const {
        if (i < scale.size()) return {scale[i] * x[i], scale[i]};
        const std::size_t branches = static_cast<std::size_t>(settings->branches), j = i - scale.size();
        if (j == 2 * branches + 2) return {x[i], 1.0};
        const double power = std::exp(x[i]);
        return {j == 2 * branches ? 1 + power : power, power};
    }
    [[nodiscard]] material::Constants law_constants(const double* x) const {
        std::vector<double> values;
        for (std::size_t i = 0; i < scale.size(); ++i) values.push_back(constant(i, x).first);
        material::Constants constants;
        if (candidate->law == "ogden") {
            const auto half = static_cast<std::ptrdiff_t>(values.size() / 2);
            constants["mu"] = {values.begin(), values.begin() + half};
            constants["alpha"] = {values.begin() + half, values.end()};
            return constants;
        }
        const auto& parameters = material::find_law(candidate->law)->parameters;
        for (std::size_t i = 0; i < values.size(); ++i) constants[std::string{parameters[i].name}] = {values[i]};
        return constants;
    }
    [[nodiscard]] material::Inelastic inelastic(const double* x) const {
        material::Inelastic found;
        std::size_t i = scale.size();
        for (int k = 0; k < settings->branches; ++k) found.moduli.push_back(constant(i++, x).first);
        for (int k = 0; k < settings->branches; ++k) found.times_s.push_back(constant(i++, x).first);
        if (settings->softening)
            found.softening = {constant(i, x).first, constant(i + 1, x).first, constant(i + 2, x).first};
        return found;
    }
    [[nodiscard]] std::optional<material::AnyRubber> rubber(const double* x) const {
        try {
            return material::make_rubber(
                {.law = candidate->law, .constants = law_constants(x), .inelastic = inelastic(x)});
        } catch (const Error&) {
            return std::nullopt;
        }
    }
};

struct Residual {
    const Unknowns& unknowns;
    const std::vector<TestCurve>& tests;
    const std::vector<double>& weights;  // by row

    bool operator()(double const* const* parameters, double* residuals) const {
        // Constants without a law have a residual that no search accepts; a failure would be logged.
        constexpr double unacceptable = 1e6;
        const auto rubber = unknowns.rubber(parameters[0]);
        std::fill_n(residuals, weights.size(), unacceptable);
        if (!rubber) return true;
        std::size_t row = 0;
        for (const TestCurve& test : tests) {
            const auto predicted = stress_of_test(*rubber, test);
            for (std::size_t i = 0; i < predicted.size(); ++i, ++row) {
                residuals[row] = weights[row] * (predicted[i] - test.nominal_Pa[i]);
                if (!std::isfinite(residuals[row])) residuals[row] = unacceptable;
            }
        }
        return true;
    }
};

std::vector<double> weights_of(const std::vector<TestCurve>& tests, const Settings& settings) {
    std::vector<double> weights;
    double largest = 0;
    for (const TestCurve& test : tests)
        for (const double stress : test.nominal_Pa) largest = std::max(largest, std::abs(stress));
    for (const TestCurve& test : tests)
        for (const double stress : test.nominal_Pa)
            weights.push_back(std::sqrt(test.weight) /
                              (settings.weights == RowWeights::uniform
                                   ? largest
                                   : std::max(std::abs(stress), settings.weight_floor * largest)));
    return weights;
}

/// The shortest interval between rows and the length of the longest test.
struct Times {
    double shortest_s = 0, longest_s = 0;
};
Times times_of(const std::vector<TestCurve>& tests) {
    Times times;
    for (const TestCurve& test : tests) {
        if (test.time_s.size() != test.stretch.size())
            throw Error(ExitCode::bad_input, test.source, "the test has no times",
                        "add a column with the title 'time (s)', or name it with --time-column");
        for (std::size_t i = 1; i < test.time_s.size(); ++i) {
            const double dt = test.time_s[i] - test.time_s[i - 1];
            if (!(dt > 0))
                throw Error(ExitCode::bad_input, test.source,
                            "the time does not increase at row " + std::to_string(i + 1),
                            "give the rows in the order of the test");
            if (times.shortest_s == 0 || dt < times.shortest_s) times.shortest_s = dt;
        }
        times.longest_s = std::max(times.longest_s, test.time_s.back() - test.time_s.front());
    }
    return times;
}

bool unloads(const TestCurve& test) {
    constexpr double noticeable = 0.05;
    double furthest = 0;
    for (const double l : test.stretch) {
        if (std::abs(l - 1) < (1 - noticeable) * furthest) return true;
        furthest = std::max(furthest, std::abs(l - 1));
    }
    return false;
}

double largest_energy(const Candidate& candidate, const material::Constants& constants,
                      const std::vector<TestCurve>& tests) {
    const auto rubber = rubber_of(candidate, constants);
    double largest = 0;
    for (const TestCurve& test : tests)
        for (const double stretch : test.stretch) {
            const auto l = stretches_of(test.mode, stretch);
            if (rubber)
                largest = std::max(
                    largest, std::visit(
                                 [&](const auto& r) {
                                     return material::isochoric_energy(r, Tensor{l[0], 0, 0, 0, l[1], 0, 0, 0, l[2]});
                                 },
                                 *rubber));
        }
    return largest;
}

Unknowns start_of(const Fit& elastic, const std::vector<TestCurve>& tests, const HistorySettings& settings,
                  Stability stability, double time_factor, double r) {
    Unknowns unknowns{&elastic.candidate, &settings, {}, {}, {}, {}};
    double size = 0;
    for (const Constant& constant : elastic.list)
        if (constant.is_stress) size = std::max(size, std::abs(constant.value));
    constexpr double small = 1e-2, far = 1e3;
    const bool keeps_signs = stability != Stability::reported;
    for (const Constant& constant : elastic.list) {
        const bool is_term =
            elastic.candidate.law == "ogden" || !constant.is_stress;  // its sign belongs to the exponent
        const bool starts_small =
            !settings.elastic && !is_term && (keeps_signs ? constant.value : std::abs(constant.value)) < small * size;
        unknowns.scale.push_back(starts_small ? small * size : constant.value);
        unknowns.add(1.0, keeps_signs || is_term ? 0.0 : -far, far);
    }
    const Times times = times_of(tests);
    const double first = std::log(std::max(times.shortest_s, 1e-4 * times.longest_s)), last = std::log(times.longest_s);
    for (int k = 0; k < settings.branches; ++k)
        unknowns.add(std::log(0.3 / settings.branches), std::log(min_modulus), std::log(max_modulus));
    for (int k = 0; k < settings.branches; ++k)
        unknowns.add(first + (last - first) * (k + 0.7) / (settings.branches + 0.4) + std::log(time_factor),
                     first - std::log(10.0), last + std::log(10.0));
    if (!settings.softening) return unknowns;
    const double W = largest_energy(elastic.candidate, elastic.constants, tests);
    unknowns.add(std::log(r - 1), std::log(1e-2), std::log(max_r));
    unknowns.add(std::log(0.2 * W), std::log(1e-4 * W), std::log(1e2 * W));
    unknowns.add(0.1, 0, max_beta);
    return unknowns;
}

/// The Maxwell elements sorted by their times.
Unknowns in_order(Unknowns unknowns) {
    const auto first = unknowns.value.begin() + static_cast<std::ptrdiff_t>(unknowns.of_law());
    const auto branches = static_cast<std::ptrdiff_t>(unknowns.settings->branches);
    std::vector<std::pair<double, double>> elements;  // time, modulus
    for (std::ptrdiff_t k = 0; k < branches; ++k) elements.emplace_back(first[branches + k], first[k]);
    std::ranges::sort(elements);
    for (std::ptrdiff_t k = 0; k < branches; ++k)
        std::tie(first[branches + k], first[k]) = elements[static_cast<std::size_t>(k)];
    return unknowns;
}

struct Searched {
    Unknowns unknowns;
    double cost = 0;
    Eigen::MatrixXd jacobian;  // weighted, by the unknowns
    Eigen::VectorXd residual;
};

Searched search(Unknowns unknowns, const std::vector<TestCurve>& tests, const std::vector<double>& weights) {
    ceres::Problem problem;
    auto* function =
        new ceres::DynamicNumericDiffCostFunction<Residual, ceres::CENTRAL>(new Residual{unknowns, tests, weights});
    function->AddParameterBlock(static_cast<int>(unknowns.size()));
    function->SetNumResiduals(static_cast<int>(weights.size()));
    double* x = unknowns.value.data();
    problem.AddResidualBlock(function, nullptr, x);  // owned by the problem
    if (unknowns.given() > 0) {
        std::vector<int> constant(unknowns.given());
        std::iota(constant.begin(), constant.end(), 0);
        problem.SetManifold(x, new ceres::SubsetManifold(static_cast<int>(unknowns.size()), constant));
    }
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        problem.SetParameterLowerBound(x, static_cast<int>(i), unknowns.low[i]);
        problem.SetParameterUpperBound(x, static_cast<int>(i), unknowns.high[i]);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = most_iterations;
    options.function_tolerance = cost_tolerance;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    std::vector<double> residual;
    ceres::CRSMatrix crs;
    if (unknowns.given() > 0) problem.SetManifold(x, nullptr);  // the Jacobian by all unknowns
    Searched found{unknowns, summary.final_cost, {}, {}};
    if (!problem.Evaluate({}, &found.cost, &residual, nullptr, &crs)) {
        found.cost = std::numeric_limits<double>::infinity();
        return found;
    }
    found.residual = Eigen::Map<Eigen::VectorXd>(residual.data(), static_cast<Eigen::Index>(residual.size()));
    found.jacobian = Eigen::MatrixXd::Zero(crs.num_rows, crs.num_cols);
    for (int row = 0; row < crs.num_rows; ++row)
        for (int k = crs.rows[static_cast<std::size_t>(row)]; k < crs.rows[static_cast<std::size_t>(row) + 1]; ++k)
            found.jacobian(row, crs.cols[static_cast<std::size_t>(k)]) = crs.values[static_cast<std::size_t>(k)];
    return found;
}

bool is_at_bound(const Unknowns& unknowns, std::size_t i) {
    constexpr double near = 1e-6;
    const double x = unknowns.value[i], span = unknowns.high[i] - unknowns.low[i];
    return x - unknowns.low[i] < near * span || unknowns.high[i] - x < near * span;
}

/// Fills the covariance of all constants, the condition and the standard errors; constants at a bound have none.
void add_covariance(const Searched& found, Fit& fit) {
    const std::size_t n = found.unknowns.size();
    std::vector<Eigen::Index> free;
    for (std::size_t i = 0; i < n; ++i)
        if (i >= found.unknowns.given() && !is_at_bound(found.unknowns, i))
            free.push_back(static_cast<Eigen::Index>(i));
    fit.covariance.assign(n * n, 0.0);
    if (free.empty()) return;
    Eigen::MatrixXd J = found.jacobian(Eigen::all, free);
    const Eigen::VectorXd length = J.colwise().norm().cwiseMax(std::numeric_limits<double>::min());
    J = (J * length.cwiseInverse().asDiagonal()).eval();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd& values = svd.singularValues();
    fit.condition = values[0] / std::max(values[values.size() - 1], std::numeric_limits<double>::min());
    const double freedom = std::max<double>(1, static_cast<double>(J.rows() - J.cols()));
    const double deviation = std::sqrt(found.residual.squaredNorm() / freedom);
    Eigen::MatrixXd root = deviation * length.cwiseInverse().asDiagonal() * svd.matrixV() *
                           values.cwiseMax(std::numeric_limits<double>::min()).cwiseInverse().asDiagonal();
    for (Eigen::Index k = 0; k < root.rows(); ++k)
        root.row(k) *=
            found.unknowns
                .constant(static_cast<std::size_t>(free[static_cast<std::size_t>(k)]), found.unknowns.value.data())
                .second;
    const Eigen::MatrixXd covariance = root * root.transpose();
    for (std::size_t a = 0; a < free.size(); ++a)
        for (std::size_t b = 0; b < free.size(); ++b)
            fit.covariance[static_cast<std::size_t>(free[a]) * n + static_cast<std::size_t>(free[b])] =
                covariance(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
}

void add_constants(const Searched& found, const Fit& elastic, Fit& fit) {
    const double* x = found.unknowns.value.data();
    fit.constants = found.unknowns.law_constants(x);
    fit.inelastic = found.unknowns.inelastic(x);
    const std::size_t n = found.unknowns.size();
    const auto error = [&](std::size_t i) { return std::sqrt(fit.covariance[i * n + i]); };
    std::size_t i = 0;
    for (const Constant& constant : elastic.list) {
        fit.list.push_back({constant.name, found.unknowns.constant(i, x).first, error(i), constant.is_stress});
        ++i;
    }
    const auto add = [&](const std::string& name, const char* unit) {
        fit.history.push_back({name, found.unknowns.constant(i, x).first, error(i), unit});
        ++i;
    };
    const auto branches = fit.inelastic->moduli.size();
    for (std::size_t k = 0; k < branches; ++k) add("modulus " + std::to_string(k + 1), "1");
    for (std::size_t k = 0; k < branches; ++k) add("time " + std::to_string(k + 1), "s");
    if (!fit.inelastic->softening) return;
    add("r", "1");
    add("m", "Pa");
    add("beta", "1");
}

}  // namespace

Fit fit_history(const Candidate& candidate, const std::vector<TestCurve>& tests, const HistorySettings& history,
                const Settings& settings) {
    const Times times = times_of(tests);
    if (history.softening && std::ranges::none_of(tests, unloads))
        throw Error(ExitCode::bad_input, tests.front().source, "no test unloads, so that softening cannot be seen",
                    "give a test with cycles, or omit --softening");
    const Fit elastic = history.elastic ? *history.elastic : fit(candidate, tests, settings);
    const std::vector<double> weights = weights_of(tests, settings);
    std::optional<Searched> best;
    for (const double factor : time_starts)
        for (const double r : r_starts) {
            if ((history.branches == 0 && factor != time_starts[0]) || (!history.softening && r != r_starts[0]))
                continue;
            Unknowns start = start_of(elastic, tests, history, settings.stability, factor, r);
            const std::size_t fitted = start.size() - start.given();
            if (fitted + 1 >= weights.size())
                throw Error(
                    ExitCode::bad_input, tests.front().source,
                    std::to_string(weights.size()) + " rows are too few for " + std::to_string(fitted) + " constants",
                    "give more rows, or fewer Maxwell elements");
            Searched found = search(std::move(start), tests, weights);
            if (!best || found.cost < best->cost) best = std::move(found);
        }
    if (Unknowns ascending = in_order(best->unknowns); ascending.value != best->unknowns.value)
        best = search(std::move(ascending), tests, weights);
    Fit fit;
    fit.candidate = elastic.candidate;
    fit.law_is_given = history.elastic.has_value();
    fit.max_I1 = max_invariant(tests);
    if (!best->unknowns.rubber(best->unknowns.value.data()))
        throw Error(ExitCode::bad_input, tests.front().source, "no constants of the law give a finite stress",
                    "choose another --law");
    add_covariance(*best, fit);
    add_constants(*best, elastic, fit);
    const auto rubber = best->unknowns.rubber(best->unknowns.value.data());
    for (const TestCurve& test : tests) {
        fit.predicted_Pa.push_back(stress_of_test(rubber.value(), test));
        if (!std::ranges::all_of(fit.predicted_Pa.back(), [](double stress) { return std::isfinite(stress); }))
            throw Error(ExitCode::bad_input, test.source, "the law has no finite stress at the stretches of the test",
                        "choose another law, or limit --range");
    }
    add_row_errors(tests, {best->residual.squaredNorm(), best->unknowns.size() - best->unknowns.given() + 1}, fit);
    add_stability(false, fit);
    for (std::size_t i = best->unknowns.given(); i < best->unknowns.size(); ++i)
        if (is_at_bound(best->unknowns, i)) {
            fit.flags.emplace_back("at-bound");
            break;
        }
    if (!(fit.condition <= correlated)) fit.flags.emplace_back("ill-conditioned");
    for (std::size_t k = 0; k < fit.inelastic->times_s.size(); ++k)
        if (fit.inelastic->times_s[k] < times.shortest_s || fit.inelastic->times_s[k] > times.longest_s)
            fit.flags.push_back("time-outside-data:" + std::to_string(k + 1));
    return fit;
}

}  // namespace soft::fit
