#include "solver/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/row_state.hpp"

namespace soft::solver {

namespace {

/// The rounding error of the residual relative to the loads of `small`: the third term is its error times (reach / small)^3.
constexpr double visible_loads = 1e7;

/// Of the error of the load, relative to that of the state: between the start and the first row, loads are far smaller than at that row.
constexpr double load_weight = 3.0;
/// Bound of the correction of an estimated reach, the ratio of both that ends the estimates, and their number.
constexpr double most_correction = 3.0, near_enough = 0.6;
constexpr int estimates = 4;

/// What states beside the start miss, less what the start itself misses within its tolerance.
struct Misses {
    Newton& newton;
    const Constraint& control;
    const PathPoint& start;
    Newton::Miss own;

    [[nodiscard]] std::optional<Newton::Miss> at(double s, const State& there) const {
        auto miss = newton.miss(control, start.q + s, there);
        newton.evaluate_rows(control, start.state);
        if (!miss) return std::nullopt;
        linalg::add(miss->R, -1.0, own.R);
        for (std::size_t k = 0; k < own.rows.size(); ++k) miss->rows[k] -= own.rows[k];
        return miss;
    }
};

/// Terms of the polynomial at s = `small`: small^2 y2 and small^3 y3.
struct Terms {
    PathTangent second, third;
};

std::optional<Terms> terms_at(const Misses& misses, const PathPoint& start, double small) {
    const auto miss_at = [&](double s, const PathTangent* second) {
        State there = moved(start.state, s, start.tangent);
        if (second != nullptr) add(there, 1.0, *second);
        return misses.at(s, there);
    };
    const auto solve = [&](const Newton::Miss& miss) { return misses.newton.bordered_solve(miss.R, miss.rows); };
    const auto half = miss_at(0.5 * small, nullptr);
    auto whole = miss_at(small, nullptr);
    if (!half || !whole) return std::nullopt;
    linalg::add(whole->R, -8.0, half->R);
    for (std::size_t k = 0; k < whole->rows.size(); ++k) whole->rows[k] -= 8.0 * half->rows[k];
    auto second = solve(*whole);
    if (!second) return std::nullopt;
    scale(*second, -1.0);
    const auto rest = miss_at(small, &*second);
    auto third = rest ? solve(*rest) : std::nullopt;
    if (!third) return std::nullopt;
    return Terms{std::move(*second), std::move(*third)};
}

PathPoint point_behind(const PathPoint& start, const Terms& terms, double small) {
    const PathTangent& first = start.tangent;
    PathPoint behind{moved(start.state, -small, first),
                     {linalg::duplicate(first.x), 0.0, std::vector(first.pressures.size(), 0.0), {}, 0.0},
                     start.q - small};
    add(behind.state, 1.0, terms.second);
    add(behind.state, -1.0, terms.third);
    add(behind.tangent, 1.0, first);
    add(behind.tangent, -2.0 / small, terms.second);
    add(behind.tangent, 3.0 / small, terms.third);
    return behind;
}

}  // namespace

std::optional<Series> series_at(Corrector& corrector, const PathState& path, const PathPoint& start, double small,
                                double longest) {
    Newton& newton = corrector.newton();
    if (newton.rounding_of_loads(start.tangent) * visible_loads > std::abs(small)) return std::nullopt;
    const Constraint control = bind(path.control, start);
    auto own = newton.miss(control, start.q, start.state);
    if (!own) return std::nullopt;
    const Misses misses{newton, control, start, std::move(*own)};
    const auto terms = terms_at(misses, start, small);
    if (!terms) return std::nullopt;
    PathPoint behind = point_behind(start, *terms, small);
    read_values(corrector.system(), *path.loads, &start, behind);

    const double speed = linalg::norm(start.tangent.x), load_speed = std::abs(start.tangent.load_factor);
    // At half of a length too, where terms of higher order cancel each other less; the error relative to the step is of third order.
    const auto error_at = [&](double length) {
        double error = 0;
        for (const double part : {1.0, 0.5}) {
            const double s = std::copysign(part * length, small);
            const auto miss = misses.at(s, predict(&behind, start, start.q + s));
            const auto left_out = miss ? newton.bordered_solve(miss->R, miss->rows) : std::nullopt;
            if (!left_out) return std::numeric_limits<double>::infinity();
            double there = linalg::norm(left_out->x) / speed;
            if (load_speed > 0.0) there = std::max(there, load_weight * std::abs(left_out->load_factor) / load_speed);
            if (!std::isfinite(there)) return std::numeric_limits<double>::infinity();
            error = std::max(error, there / (std::abs(s) * part * part * part));
        }
        return error;
    };
    const double wanted = corrector.input().solver.step_accuracy, size = std::abs(small) * speed;
    const double inverse_radius = std::max(linalg::norm(terms->second.x) / size,
                                           std::sqrt(linalg::norm(terms->third.x) / size));  // per `small`
    double length = std::cbrt(wanted) / std::max(inverse_radius, wanted) * std::abs(small);
    length = std::clamp(length, std::abs(small), longest);
    for (int i = 0; i < estimates; ++i) {
        const double factor = std::clamp(std::cbrt(wanted / error_at(length)), 1.0 / most_correction, most_correction);
        const double estimated = std::exchange(length, std::min(factor * length, longest));
        if (length >= near_enough * estimated && estimated >= near_enough * length) break;
    }
    corrector.system().prescribe(start.levels);
    if (length < std::abs(small)) return std::nullopt;
    return Series{std::move(behind), std::copysign(length, small)};
}

}  // namespace soft::solver
