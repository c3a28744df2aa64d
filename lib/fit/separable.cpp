#include "fit/separable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace soft::fit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Exponents beyond these differ from their neighbours by less than the noise (small) or overflow at long stretches.
constexpr double min_exponent = 0.05, max_exponent = 12.0;
/// The pole is at a distance of exp(-8) to exp(8) = 3000 times the largest I1: outside this range the data do not determine q.
constexpr double max_q = 8.0;
/// ln b of yeoh-5: a modulus that rises and levels off below a strain of about 30 % indicates slack or a zero error of the load cell.
constexpr double max_log_rise = 1.0;
constexpr double near_bound = 1e-6;
/// Lower bound of the first modulus of a law that requires a positive one, in units of S: much smaller than that of any rubber.
constexpr double min_modulus = 1e-6;
/// Central differences in q of smooth parts: truncation error of order step^2, rounding error 1e-16 / step.
constexpr double slope_step = 1e-5;

/// b of yeoh-5 ranges from 1/max(I1 - 3), below which the data cannot separate its term from those of c1 and c2, to its upper bound;
/// for data of small strains the range is a factor of e.
double log_rise_width(const Rows& rows) { return std::max(1.0, max_log_rise + std::log(rows.max_I1 - 3.0)); }
double rise_at(const Rows& rows, double q) { return std::exp(q * log_rise_width(rows)) / (rows.max_I1 - 3.0); }

double max_stress(const std::vector<TestCurve>& tests) {
    double largest = 0;
    for (const TestCurve& test : tests)
        for (const double stress : test.nominal_Pa) largest = std::max(largest, std::abs(stress));
    return largest > 0.0 ? largest : 1.0;
}

struct RowKey {
    std::size_t test, row;
};

std::vector<RowKey> sorted_rows(const std::vector<TestCurve>& tests) {
    std::vector<RowKey> order;
    for (std::size_t t = 0; t < tests.size(); ++t)
        for (std::size_t i = 0; i < tests[t].stretch.size(); ++i) order.push_back({t, i});
    const auto key = [&](const RowKey& p) {
        const TestCurve& test = tests[p.test];
        return std::tuple{test.mode, test.stretch[p.row], test.nominal_Pa[p.row], test.weight};
    };
    std::sort(order.begin(), order.end(), [&](const RowKey& a, const RowKey& b) { return key(a) < key(b); });
    return order;
}

struct Bounds {
    Eigen::VectorXd low, high;
};

/// Sign constraints: no constant is negative, and the first is positive unless another one can be the only modulus. They are sufficient for
/// (Drucker) stability of laws with StableBy::signs: neo-Hookean, Gent, Arruda-Boyce mu > 0; mooney-rivlin-2 c10, c01 >= 0; Yeoh c1 > 0,
/// the others >= 0; Ogden mu_i alpha_i >= 0.
Bounds bounds_of(const Candidate& candidate, const Rows& rows, Signs signs) {
    const auto n = static_cast<Eigen::Index>(candidate.linear);
    const auto offsets = static_cast<Eigen::Index>(rows.offset == Offset::fitted ? rows.test_count : 0);
    Bounds bounds{Eigen::VectorXd::Constant(n + offsets, -infinity), Eigen::VectorXd::Constant(n + offsets, infinity)};
    if (signs == Signs::stable) bounds.low.head(n).setZero();
    const bool needs_positive = candidate.law != "mooney-rivlin" && candidate.law != "ogden";
    if (signs == Signs::stable && needs_positive) bounds.low[0] = min_modulus;
    bounds.low.tail(offsets).setConstant(-max_offset_Pa / rows.scale_Pa);
    bounds.high.tail(offsets).setConstant(max_offset_Pa / rows.scale_Pa);
    return bounds;
}

Eigen::VectorXd mixed(const Rows& rows, const Eigen::VectorXd& column) {
    if (rows.mix.size() == 0) return column;
    return rows.mix * column;
}

Eigen::VectorXd offset_column(const Rows& rows, std::size_t test) {
    Eigen::VectorXd column = Eigen::VectorXd::Zero(rows.weight.size());
    for (Eigen::Index i = 0; i < column.size(); ++i)
        if (rows.test[static_cast<std::size_t>(i)] == test) column[i] = rows.weight[i];
    return mixed(rows, column);
}

}  // namespace

Rows rows_of(const std::vector<TestCurve>& tests, const Settings& settings) {
    Rows rows;
    rows.scale_Pa = max_stress(tests);
    rows.max_I1 = max_invariant(tests);
    rows.test_count = tests.size();
    rows.offset = settings.offset;
    const std::vector<RowKey> order = sorted_rows(tests);
    const auto count = static_cast<Eigen::Index>(order.size());
    rows.weight.resize(count);
    rows.target.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto [t, row] = order[static_cast<std::size_t>(i)];
        const double stress = tests[t].nominal_Pa[row] / rows.scale_Pa;
        rows.mode.push_back(tests[t].mode);
        rows.stretch.push_back(tests[t].stretch[row]);
        rows.test.push_back(t);
        const double relative =
            settings.weights == RowWeights::relative ? 1.0 / std::max(stress, settings.weight_floor) : 1.0;
        rows.weight[i] = std::sqrt(tests[t].weight) * relative;
        rows.target[i] = rows.weight[i] * stress;
    }
    return rows;
}

SearchBounds search_bounds(const Candidate& candidate, double start) {
    if (candidate.law == "yeoh") return {0.0, 1.0};
    if (candidate.law != "ogden") return {-max_q, max_q};
    return start > 0.0 ? SearchBounds{min_exponent, max_exponent} : SearchBounds{-max_exponent, -min_exponent};
}

bool is_at_search_bound(const Candidate& candidate, double q) {
    const SearchBounds bounds = search_bounds(candidate, q);
    return std::min(q - bounds.low, bounds.high - q) < near_bound;
}

double shape_of(const Candidate& candidate, const Rows& rows, double q) {
    if (candidate.law == "gent") return (1.0 + std::exp(q)) * (rows.max_I1 - 3.0);
    if (candidate.law == "arruda-boyce") return std::sqrt((1.0 + std::exp(q)) * rows.max_I1 / 3.0);
    if (candidate.law == "yeoh") return rise_at(rows, q);
    return q;
}

double shape_slope(const Candidate& candidate, const Rows& rows, double q) {
    if (candidate.law == "gent") return std::exp(q) * (rows.max_I1 - 3.0);
    if (candidate.law == "arruda-boyce") return std::exp(q) * rows.max_I1 / 6.0 / shape_of(candidate, rows, q);
    if (candidate.law == "yeoh") return rise_at(rows, q) * log_rise_width(rows);
    return 1.0;
}

Eigen::VectorXd part(const Candidate& candidate, const Rows& rows, std::size_t j, double q) {
    Eigen::VectorXd stress = Eigen::VectorXd::Zero(rows.weight.size());
    const CurvePoints points{rows.mode, rows.stretch};
    const std::span<double> out{stress.data(), static_cast<std::size_t>(stress.size())};
    // A single ogden term is a law in itself; the other laws have at most one shape constant.
    const bool alone = candidate.law == "ogden";
    std::vector<double> unit(alone ? 1 : static_cast<std::size_t>(candidate.linear), 0.0), shapes;
    unit[alone ? 0 : j] = 1.0;
    if (candidate.shapes > 0) shapes.push_back(shape_of(candidate, rows, q));
    add_stresses(candidate, constants_of(candidate, unit, shapes), points, out);
    return mixed(rows, stress.cwiseProduct(rows.weight));
}

Eigen::VectorXd part_slope(const Candidate& candidate, const Rows& rows, std::size_t j, double q) {
    return (part(candidate, rows, j, q + slope_step) - part(candidate, rows, j, q - slope_step)) / (2.0 * slope_step);
}

Projection project(const Candidate& candidate, const Rows& rows, const std::vector<double>& q, Signs signs) {
    const Bounds bounds = bounds_of(candidate, rows, signs);
    Projection projection;
    projection.A.setZero(rows.target.size(), bounds.low.size());
    const auto parts = static_cast<std::size_t>(candidate.linear), first_shaped = candidate.part_of_shape(0);
    for (std::size_t j = 0; j < parts; ++j)
        projection.A.col(static_cast<Eigen::Index>(j)) =
            part(candidate, rows, j, first_shaped <= j ? q[j - first_shaped] : 0.0);
    if (rows.offset == Offset::fitted)
        for (std::size_t t = 0; t < rows.test_count; ++t)
            projection.A.col(static_cast<Eigen::Index>(parts + t)) = offset_column(rows, t);
    projection.linear = solve_bounded(projection.A, rows.target, bounds.low, bounds.high);
    projection.residual = projection.A * projection.linear.c - rows.target;
    return projection;
}

}  // namespace soft::fit
