/// Work of the loads from row to row, checked against the change of the stored energy.
#include <algorithm>
#include <cmath>

#include "model/cavity_surface.hpp"
#include "solver/path_follower.hpp"

namespace soft::solver {

namespace {

/// An energy that hardly changes over a step is compared to this fraction of itself.
constexpr double flat_energy = 0.1;
/// Halving a smooth interval reduces the error of its work to a sixteenth, at a kink to a half. A difference that does not fall is no
/// error of the quadrature.
constexpr double falling = 0.7;
constexpr int halvings = 7;
/// Of the larger of both energies: half of what ends a solve with an error (post/energy_balance.hpp).
constexpr double energy_jump = 0.005;
/// Mean displacement over the extent of the part below which rounding decides which fibres are taut.
constexpr double rounding_strain = 1e-10;

}  // namespace

double PathFollower::stored_energy_of(PathPoint& point) {
    if (!point.stored_J) {
        system_.prescribe(point.levels);
        point.stored_J = system_.stored_energy(point.state.x);
    }
    return *point.stored_J;
}

double PathFollower::work_of_step(PathPoint& from, PathPoint& to) {
    const double work_J = work_between(system_, from, to, FromTangent::along_the_path);
    if (!system_.has_symmetric_tangent()) return work_J;
    const WorkInterval interval{work_J, stored_energy_of(from), stored_energy_of(to)};
    const double size_J = std::max(std::abs(interval.gain_J()), flat_energy * std::abs(interval.to_J));
    const double wanted_J = settings_.step_accuracy * size_J;
    if (!(std::abs(interval.gap_J()) > wanted_J)) return work_J;
    const int pivots = newton_.confirmed_pivots();
    const NewtonResult result = newton_result_;
    const double refined_J = refined_work(from, to, interval, wanted_J, halvings);
    newton_result_ = result;
    newton_.confirm_pivots(pivots);
    return refined_J;
}

bool PathFollower::breaks_energy_balance(PathPoint& from, PathPoint& to) {
    const double mean_m = linalg::norm(to.state.x) / std::sqrt(static_cast<double>(system_.dofs().total));
    if (!system_.has_symmetric_tangent() || mean_m < rounding_strain * model::extent_m(input_.mesh)) return false;
    to.step_work_J = work_of_step(from, to);
    const double from_J = stored_energy_of(from), to_J = stored_energy_of(to);
    return std::abs(*to.step_work_J - (to_J - from_J)) > energy_jump * std::max(from_J, to_J);
}

/// Recursively bisects the interval at its equilibrium state in the middle.
double PathFollower::refined_work(const PathPoint& from, const PathPoint& to, const WorkInterval& interval,
                                  double wanted_J, int halvings_left) {
    if (!(std::abs(interval.gap_J()) > wanted_J) || halvings_left == 0 || !(std::abs(to.q - from.q) > 0.0))
        return interval.work_J;
    auto middle = solve_between(from, to, 0.5 * (from.q + to.q));
    if (!middle) return interval.work_J;
    const double stored_J = stored_energy_of(*middle);
    const WorkInterval first{work_between(system_, from, *middle, FromTangent::along_the_path), interval.from_J,
                             stored_J};
    const WorkInterval second{work_between(system_, *middle, to, FromTangent::along_the_path), stored_J, interval.to_J};
    if (!(std::abs(first.gap_J()) + std::abs(second.gap_J()) < falling * std::abs(interval.gap_J())))
        return interval.work_J;
    return refined_work(from, *middle, first, 0.5 * wanted_J, halvings_left - 1) +
           refined_work(*middle, to, second, 0.5 * wanted_J, halvings_left - 1);
}

}  // namespace soft::solver
