/// Work of the loads from row to row, held to the energy that the rubber stores on the way.
#include <algorithm>
#include <cmath>

#include "solver/path_follower.hpp"

namespace soft::solver {

namespace {

/// An energy that hardly changes over a step is compared to this part of itself.
constexpr double flat_energy = 0.1;
/// Halving a smooth way reduces the error of its work to a sixteenth, at a corner to a half. A difference that stays is no error of
/// the quadrature.
constexpr double falling = 0.7;
constexpr int halvings = 7;

}  // namespace

double PathFollower::stored_energy_of(PathPoint& point) {
    if (!point.stored_J) {
        system_.prescribe(point.levels);
        point.stored_J = system_.stored_energy(point.state.x);
    }
    return *point.stored_J;
}

double PathFollower::work_on_the_way(PathPoint& from, PathPoint& to) {
    const double work_J = work_between(system_, from, to, FromTangent::along_the_path);
    if (!system_.has_symmetric_tangent()) return work_J;
    const Way way{work_J, stored_energy_of(from), stored_energy_of(to)};
    const double size_J = std::max(std::abs(way.gain_J()), flat_energy * std::abs(way.to_J));
    const double wanted_J = settings_.step_accuracy * size_J;
    if (!(std::abs(way.gap_J()) > wanted_J)) return work_J;
    const int pivots = newton_.confirmed_pivots();
    const NewtonResult result = newton_result_;
    const double refined_J = refined_work(from, to, way, wanted_J, halvings);
    newton_result_ = result;
    newton_.confirm_pivots(pivots);
    return refined_J;
}

/// Through the state of equilibrium in the middle of the way, and so on.
double PathFollower::refined_work(const PathPoint& from, const PathPoint& to, const Way& way, double wanted_J,
                                  int halvings_left) {
    if (!(std::abs(way.gap_J()) > wanted_J) || halvings_left == 0 || !(std::abs(to.q - from.q) > 0.0))
        return way.work_J;
    auto middle = solve_between(from, to, 0.5 * (from.q + to.q));
    if (!middle) return way.work_J;
    const double stored_J = stored_energy_of(*middle);
    const Way first{work_between(system_, from, *middle, FromTangent::along_the_path), way.from_J, stored_J};
    const Way second{work_between(system_, *middle, to, FromTangent::along_the_path), stored_J, way.to_J};
    if (!(std::abs(first.gap_J()) + std::abs(second.gap_J()) < falling * std::abs(way.gap_J()))) return way.work_J;
    return refined_work(from, *middle, first, 0.5 * wanted_J, halvings_left - 1) +
           refined_work(*middle, to, second, 0.5 * wanted_J, halvings_left - 1);
}

}  // namespace soft::solver
