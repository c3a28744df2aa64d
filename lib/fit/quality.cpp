#include "fit/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.hpp"

namespace soft::fit {
namespace {

constexpr double max_condition = 1e4;     // above it the constants are strongly correlated
constexpr double offset_strain = 0.25;    // strain at which an offset is compared with the stress
constexpr double min_error_strain = 0.2;  // at smaller strains the zero error of the load cell dominates
constexpr double max_offset_share = 0.1;
constexpr double invariant_tolerance = 1e-9;  // relative; I1 at the end of the data is computed in two ways
constexpr double min_scan = 0.3;              // as material::default_stretch_range

/// Stretch of the mode at which I1 takes the given value above 3, in tension or compression, by bisection.
double stretch_of_invariant(Mode mode, double I1, material::Sense sense) {
    double inner = 1.0, outer = sense == material::Sense::tension ? std::sqrt(I1) + 1.0 : 0.5 / I1;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (inner + outer);
        (first_invariant(mode, middle) < I1 ? inner : outer) = middle;
    }
    return inner;
}

void add_list(const Solution& solution, const Rows& rows, Fit& fit) {
    const bool ogden = solution.candidate.law == "ogden";
    const auto linear = static_cast<std::size_t>(solution.candidate.linear);
    const std::vector<material::Parameter>& parameters = material::find_law(solution.candidate.law)->parameters;
    std::vector<double> c, shapes;
    for (std::size_t j = 0; j < linear; ++j)
        c.push_back(solution.projection.linear.c[static_cast<Eigen::Index>(j)] * rows.scale_Pa);
    for (const double q : solution.q) shapes.push_back(shape_of(solution.candidate, rows, q));
    fit.constants = constants_of(solution.candidate, c, shapes);
    const auto name = [&](std::size_t parameter, std::size_t term) {
        std::string text{parameters[parameter].name};
        if (ogden && linear > 1) text.append(" ").append(std::to_string(term + 1));
        return text;
    };
    for (std::size_t j = 0; j < linear; ++j)
        fit.list.push_back({name(ogden ? 0 : j, j), ogden ? fit.constants.at("mu")[j] : c[j], 0, true});
    for (std::size_t j = 0; j < shapes.size(); ++j)
        fit.list.push_back({name(ogden ? 1 : linear, j), shapes[j], 0, false});
}

struct Sums {
    double squares = 0, largest = 0, total = 0, total_squares = 0;
    std::size_t rows = 0;
    void add(double residual, double stress) {
        squares += residual * residual;
        largest = std::max(largest, std::abs(residual));
        total += stress;
        total_squares += stress * stress;
        ++rows;
    }
    [[nodiscard]] double rmse() const { return std::sqrt(squares / static_cast<double>(rows)); }
    [[nodiscard]] double r2() const {
        const double spread = total_squares - total * total / static_cast<double>(rows);
        return spread > 0.0 ? 1.0 - squares / spread : 0.0;
    }
};

void add_errors(const Solution& solution, const std::vector<TestCurve>& tests, const Rows& rows, Fit& fit) {
    for (std::size_t t = 0; t < tests.size() && rows.offset == Offset::fitted; ++t)
        fit.tests.emplace_back().offset_Pa =
            solution.projection.linear
                .c[static_cast<Eigen::Index>(solution.candidate.linear) + static_cast<Eigen::Index>(t)] *
            rows.scale_Pa;
    add_row_errors(tests,
                   {solution.projection.residual.squaredNorm(),
                    static_cast<std::size_t>(solution.projection.A.cols()) + solution.q.size() + 1},
                   fit);
}

/// True if the signs of the constants guarantee stability at every stretch.
bool signs_suffice(const Solution& solution) {
    return solution.candidate.stable_by == StableBy::signs &&
           solution.projection.linear.c.head(solution.candidate.linear).minCoeff() >= 0.0;
}

}  // namespace

void add_row_errors(const std::vector<TestCurve>& tests, const WeightedSquares& squares, Fit& fit) {
    Sums all;
    fit.tests.resize(tests.size());
    for (std::size_t t = 0; t < tests.size(); ++t) {
        const TestCurve& test = tests[t];
        TestQuality& quality = fit.tests[t];
        quality.mode = test.mode;
        quality.source = test.source;
        quality.rows = test.stretch.size();
        Sums sums;
        for (std::size_t i = 0; i < test.stretch.size(); ++i) {
            const double predicted_Pa =
                fit.predicted_Pa.empty() ? fit.nominal_stress_Pa(test.mode, test.stretch[i]) : fit.predicted_Pa[t][i];
            const double residual = predicted_Pa + quality.offset_Pa.value_or(0) - test.nominal_Pa[i];
            sums.add(residual, test.nominal_Pa[i]);
            all.add(residual, test.nominal_Pa[i]);
            if (std::abs(test.stretch[i] - 1.0) >= min_error_strain && test.nominal_Pa[i] != 0.0)
                fit.max_relative_error =
                    std::max(fit.max_relative_error.value_or(0), std::abs(residual / test.nominal_Pa[i]));
        }
        quality.rmse_Pa = sums.rmse();
        quality.max_Pa = sums.largest;
        quality.r2 = sums.r2();
    }
    fit.rows = all.rows;
    fit.rmse_Pa = all.rmse();
    fit.max_Pa = all.largest;
    fit.r2 = all.r2();
    const double n = static_cast<double>(all.rows);
    const double k = static_cast<double>(squares.unknowns);
    const double mean = std::max(squares.sum / n, std::numeric_limits<double>::min());
    fit.aicc = n - k - 1.0 > 0.0 ? n * std::log(mean) + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0)
                                 : std::numeric_limits<double>::infinity();
}

void add_stability(bool signs_suffice, Fit& fit) {
    const auto rubber = rubber_of(fit.candidate, fit.constants);
    if (!rubber) {
        fit.flags.emplace_back("mu0<=0");
        return;
    }
    fit.stable = true;
    if (signs_suffice) return;
    const double end = fit.max_I1 * (1.0 + invariant_tolerance);
    const material::StretchRange range{
        std::min(min_scan, stretch_of_invariant(Mode::uniaxial, end, material::Sense::compression)),
        std::max(material::default_stretch_range.max,
                 stretch_of_invariant(Mode::uniaxial, end, material::Sense::tension))};
    fit.limits = material::stability_limits(*rubber, range);
    for (const material::StabilityLimit& limit : fit.limits) {
        if (first_invariant(limit.mode, limit.stretch) > end) continue;
        fit.stable = false;
        fit.flags.push_back("unstable:" + std::string{name_of(limit.mode)} + "@" +
                            core::rounded_text(limit.stretch, 4));
    }
}

namespace {

/// Stress of the row nearest to e = 0.25.
double stress_at_offset_strain(const TestCurve& test) {
    const auto nearest = std::min_element(test.stretch.begin(), test.stretch.end(), [](double a, double b) {
        return std::abs(a - 1.0 - offset_strain) < std::abs(b - 1.0 - offset_strain);
    });
    return test.nominal_Pa[static_cast<std::size_t>(nearest - test.stretch.begin())];
}

void add_flags(const Solution& solution, const std::vector<TestCurve>& tests, Fit& fit) {
    const auto& free = solution.projection.linear.free;
    if (solution.at_search_bound || std::find(free.begin(), free.end(), false) != free.end())
        fit.flags.emplace_back("at-bound");
    if (solution.signs == Signs::stable) fit.flags.emplace_back("signs-constrained");
    if (!(fit.condition <= max_condition)) fit.flags.emplace_back("ill-conditioned");
    for (std::size_t t = 0; t < tests.size(); ++t)
        if (fit.tests[t].offset_Pa &&
            std::abs(*fit.tests[t].offset_Pa) > max_offset_share * std::abs(stress_at_offset_strain(tests[t])))
            fit.flags.emplace_back("offset>10%");
}

}  // namespace

Fit describe(const Solution& solution, const std::vector<TestCurve>& tests, const Rows& rows) {
    Fit fit;
    fit.candidate = solution.candidate;
    fit.max_I1 = rows.max_I1;
    add_list(solution, rows, fit);
    add_errors(solution, tests, rows, fit);
    add_covariance(solution, rows, fit);
    add_stability(signs_suffice(solution), fit);
    add_flags(solution, tests, fit);
    return fit;
}

}  // namespace soft::fit
