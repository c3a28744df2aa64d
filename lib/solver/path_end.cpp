/// Where a path ends though the load asked for is not reached.
#include <cmath>

#include "solver/path_follower.hpp"

namespace soft::solver {

using solution::StopReason;

namespace {

/// Of what is left of the load, for a growth of the unknowns by themselves: less is an asymptote. Looked at over steps in which
/// they do grow: nothing is said of a path that hardly moves.
constexpr double out_of_reach = 1e-4, steady_growth = 1e-3;
/// Times path.stretch_limit: no rubber is stretched so far. There a load whose rise falls with this power of the unknowns, or a
/// higher one, is taken to go on so; what is still to come must be less than this part of what is left. Looked at over steps long
/// enough for a power to be seen.
constexpr double far_beyond = 10.0, min_power = 0.5, reachable = 0.5, growth_for_a_power = 0.02;
/// det F.
constexpr double crushed = 0.05;

}  // namespace

bool PathFollower::is_past_a_maximum() const {
    return !end_.limit_points.empty() && end_.limit_points.back().step >= stage_first_row_ && load_falls(*last_);
}

bool PathFollower::is_goal_unreachable() const { return is_past_a_maximum() && stretch_p99_ > input_.path.stretch_limit; }

bool PathFollower::is_stalled() const {
    if (settings_.steps == model::StepRule::constant || visited_.size() <= stalled_rows) return false;
    return length_of(std::span(visited_).last(stalled_rows + 1)) < stalled_length * length_of(visited_);
}

/// A load that still grows, but so little that the way to its value is beyond all numbers, as that of a long tube of
/// neo-Hookean rubber, which has an asymptote in place of a maximum; or that, by the power of the unknowns with which its rise falls,
/// ends far below.
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
        return "the load asked for is not reached: the path is closed, it is back at row " + row(found->earlier) +
               ", " + describe(*last_);
    return "the load asked for is not reached: the path has turned back, from row " + row(found->first) +
           " on it passes its earlier states in the opposite direction, now those of row " + row(found->earlier) +
           ", " + describe(*last_);
}

bool PathFollower::is_crushed() const { return newton_result_.min_jacobian < crushed; }

void PathFollower::give_up() {
    const std::string place = location_text(newton_result_.worst_cell, input_);
    log("no step goes on: smaller cells (mesh.size) would be next");
    if (newton_result_.end == NewtonEnd::inverted)
        return finish(StopReason::inverted_element,
                      "a cell turns inside out (det F = " + short_text(newton_result_.min_jacobian) + ") " + place +
                          "; use smaller cells there (mesh.size)");
    if (is_crushed())
        return finish(StopReason::inverted_element,
                      "a cell is all but inside out (det F = " + short_text(newton_result_.min_jacobian) + ") " +
                          place + " at " + describe(*last_) + "; use smaller cells there (mesh.size)");
    if (newton_result_.end == NewtonEnd::linear_solver)
        return finish(StopReason::diverged, "no equilibrium found beyond " + describe(*last_) + ": " + linear_remedy);
    finish(StopReason::diverged, "no equilibrium found beyond " + describe(*last_) + " (" +
                                     std::string(text_of(newton_result_.end)) + "); the most distorted cell is " +
                                     place + ", det F = " + short_text(newton_result_.min_jacobian) +
                                     "; smaller cells there (mesh.size) may go on");
}

}  // namespace soft::solver
