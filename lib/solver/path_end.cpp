/// Ends of a path that does not reach the requested load.
#include <cmath>

#include "solver/path_follower.hpp"

namespace soft::solver {

using model::StopReason;

namespace {

/// An asymptote: per relative growth of the unknowns, the load grows by less than `out_of_reach` of its remainder. Checked only over
/// steps in which the unknowns grow by more than `steady_growth`: a path that hardly moves shows no asymptote.
constexpr double out_of_reach = 1e-4, steady_growth = 1e-3;
/// Beyond `far_beyond` times path.stretch_limit, which no rubber reaches: a load whose rate falls with the power `min_power` of the
/// unknowns, or a higher one, is extrapolated by that power; the result must be less than `reachable` of the remaining load. Checked
/// over steps that are long enough to show a power.
constexpr double far_beyond = 10.0, min_power = 0.5, reachable = 0.5, growth_for_a_power = 0.02;
/// det F below which a cell counts as nearly inverted.
constexpr double nearly_inverted = 0.05;

}  // namespace

bool PathFollower::is_past_limit_point() const {
    return !end_.limit_points.empty() && end_.limit_points.back().step >= stage_first_row_ && load_falls(*last_);
}

bool PathFollower::is_goal_unreachable() const {
    return is_past_limit_point() && stretch_p99_ > input_.path.stretch_limit;
}

bool PathFollower::is_stalled() const {
    if (settings_.steps == model::StepRule::constant || visited_.size() <= stalled_rows) return false;
    return length_of(std::span(visited_).last(stalled_rows + 1)) < stalled_length * length_of(visited_);
}

/// A load that still grows, but too slowly to reach its value with finite numbers, as that of a long tube of neo-Hookean rubber,
/// which has an asymptote instead of a maximum; or one whose rate falls with a power of the unknowns such that its limit is far below.
bool PathFollower::is_out_of_reach() {
    if (stretch_p99_ <= input_.path.stretch_limit || !before_) return false;
    linalg::copy(last_->state.x, scratch_);
    linalg::add(scratch_, -1.0, before_->state.x);
    const double growth = linalg::norm(scratch_) / linalg::norm(last_->state.x);
    const double gain = last_->state.load_factor - before_->state.load_factor, left = 1.0 - last_->state.load_factor;
    if (left <= 0.0 || growth <= steady_growth) return false;
    if (std::abs(gain) < out_of_reach * growth * left) return true;
    if (stretch_p99_ <= far_beyond * input_.path.stretch_limit || growth < growth_for_a_power) return false;
    const auto rise_of = [](const PathPoint& point) {  // d load factor / d log of the unknowns
        const double size = linalg::norm(point.state.x);
        return point.tangent.load_factor * size * size / linalg::dot(point.tangent.x, point.state.x);
    };
    const double rise = rise_of(*last_), before = rise_of(*before_);
    const double log_growth = std::log(linalg::norm(last_->state.x) / linalg::norm(before_->state.x));
    const double power = std::log(before / rise) / log_growth, mean = gain / log_growth;
    return rise > 0.0 && rise < mean && mean < before && power > min_power && rise / power < reachable * left;
}

std::string PathFollower::return_text() const {
    const auto found = find_return(visited_);
    if (!found) return {};
    const auto row = [&](std::size_t index) { return std::to_string(stage_first_row_ + static_cast<int>(index)); };
    if (found->sense == Return::Sense::forward)
        return "the requested load is not reached: the path is closed and has returned to row " + row(found->earlier) +
               ", " + describe(*last_);
    return "the requested load is not reached: the path retraces itself, from row " + row(found->first) +
           " on it passes its earlier states in the opposite direction, most recently row " + row(found->earlier) +
           ", " + describe(*last_);
}

bool PathFollower::is_nearly_inverted() const { return newton_result_.min_jacobian < nearly_inverted; }

void PathFollower::abandon_path() {
    const std::string location = location_text(newton_result_.worst_cell, input_);
    log("no step converges: use smaller cells (mesh.size)");
    if (newton_result_.end == NewtonEnd::inverted)
        return finish(StopReason::inverted_element,
                      "an element inverted (det F = " + short_text(newton_result_.min_jacobian) + ") " + location +
                          "; use smaller cells there (mesh.size)");
    if (is_nearly_inverted())
        return finish(StopReason::inverted_element,
                      "an element is nearly inverted (det F = " + short_text(newton_result_.min_jacobian) + ") " +
                          location + " at " + describe(*last_) + "; use smaller cells there (mesh.size)");
    if (newton_result_.end == NewtonEnd::linear_solver)
        return finish(StopReason::diverged, "no equilibrium found beyond " + describe(*last_) + ": " + linear_remedy);
    finish(StopReason::diverged, "no equilibrium found beyond " + describe(*last_) + " (" +
                                     std::string(text_of(newton_result_.end)) + "); the largest distortion is " +
                                     location + ", det F = " + short_text(newton_result_.min_jacobian) +
                                     "; try smaller cells there (mesh.size)");
}

}  // namespace soft::solver
