#include "solver/path_end.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "solver/path_text.hpp"

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
/// Where no step converges beyond path.stretch_limit: growth of the load per relative growth of the unknowns, over the remaining load.
constexpr double hardly_rising = 1e-2;
/// det F at a quadrature point, or scaled Jacobian at a node, below which a cell counts as nearly inverted.
constexpr double nearly_inverted = 0.05;

constexpr const char* remedy = "; use smaller cells there (mesh.size)";
constexpr const char* end_earlier = "; set path.until to end the path earlier, or request a smaller load";

bool is_past_limit_point(const PathState& path) {
    const auto& found = path.end.limit_points;
    return !found.empty() && found.back().step >= path.first_row && path.load_falls(*path.last);
}

/// Whether the requested load was larger at a limit point of this stage: also after a minimum, where it rises again.
bool is_below_limit_point(const PathState& path, const model::Stage& stage) {
    if (!stage.supplies.empty() && stage.supplies.front().what != model::Prescription::pressure) return false;
    return std::ranges::any_of(path.end.limit_points, [&](const model::LimitPoint& point) {
        return point.step >= path.first_row && std::abs(point.pressure_Pa) > std::abs(path.last->leading);
    });
}

bool is_stalled(const PathState& path, model::StepRule steps) {
    if (steps == model::StepRule::constant || path.visited.size() <= stalled_rows) return false;
    return length_of(std::span(path.visited).last(stalled_rows + 1)) < stalled_length * length_of(path.visited);
}

/// d load factor / d log of the unknowns
double rise_of(const PathPoint& point) {
    const double norm = linalg::norm(point.state.x);
    return point.tangent.load_factor * norm * norm / linalg::dot(point.tangent.x, point.state.x);
}

/// Message of a load that approaches an asymptote.
std::string asymptote_text(const std::string& here) {
    return "the requested load is never reached: the load approaches a limit just above its value at " + here +
           ", and the stretch exceeds path.stretch_limit" + end_earlier;
}

/// A load that still grows, but too slowly to reach its value with finite numbers, as that of a long tube of neo-Hookean rubber,
/// which has an asymptote instead of a maximum; or one whose rate falls with a power of the unknowns such that its limit is far below.
bool is_out_of_reach(const PathState& path, double stretch_limit) {
    if (path.stretch_p99 <= stretch_limit || !path.before) return false;
    const PathPoint &before = *path.before, &last = *path.last;
    const double size = linalg::norm(last.state.x), growth = distance(last.state.x, before.state.x) / size;
    const double gain = last.state.load_factor - before.state.load_factor, left = 1.0 - last.state.load_factor;
    if (left <= 0.0 || growth <= steady_growth) return false;
    if (std::abs(gain) < out_of_reach * growth * left) return true;
    if (path.stretch_p99 <= far_beyond * stretch_limit || growth < growth_for_a_power) return false;
    const double rise = rise_of(last), rise_before = rise_of(before);
    const double log_growth = std::log(size / linalg::norm(before.state.x));
    const double power = std::log(rise_before / rise) / log_growth, mean = gain / log_growth;
    return rise > 0.0 && rise < mean && mean < rise_before && power > min_power && rise / power < reachable * left;
}

/// Whether the stage moves an obstacle: the actuator may then be where it was, as where an obstacle slides along it, and the obstacle is not.
bool moves_obstacle(const PathState& path, const model::Case& input) {
    const std::vector<double>& rates = path.loads->rate().motions;
    for (std::size_t m = 0; m < rates.size(); ++m)
        if (rates[m] != 0.0 && model::moves_obstacle(input, input.motions[m])) return true;
    return false;
}

/// Why the path ends: it has returned to states it has passed. Empty where it has not.
std::string return_text(const PathState& path, const model::Case& input, const std::string& here) {
    const auto found = find_return(path.visited);
    if (!found || (found->sense == Return::Sense::forward && moves_obstacle(path, input))) return {};
    const auto row = [&](std::size_t index) { return std::to_string(path.first_row + static_cast<int>(index)); };
    if (found->sense == Return::Sense::forward)
        return "the requested load is not reached: the path is closed and has returned to row " + row(found->earlier) +
               ", " + here;
    return "the requested load is not reached: the path retraces itself, from row " + row(found->first) +
           " on it passes its earlier states in the opposite direction, most recently row " + row(found->earlier) +
           ", " + here;
}

/// The last row, in which a cell is nearly inverted, or inverted at a node although not at its quadrature points: what it does from there on
/// is not that of the part.
std::optional<Stop> inverted_stop(const PathState& path, fem::System& system) {
    if (path.min_jacobian < nearly_inverted)
        return Stop{StopReason::inverted_element,
                    "an element is nearly inverted (det F = " + short_text(path.min_jacobian) + ") at " +
                        state_text(*path.last, system.input()) + remedy};
    system.prescribe(path.last->levels);
    const mesh::Index cell = system.fields().inverted_at_a_node(path.last->state.x, nearly_inverted);
    if (cell < 0) return std::nullopt;
    return Stop{StopReason::inverted_element, "an element is inverted or nearly inverted at a node " +
                                                  location_text(cell, system.input()) + " at " +
                                                  state_text(*path.last, system.input()) + remedy};
}

}  // namespace

Error start_error(NewtonEnd end, const std::string& problem) {
    if (end == NewtonEnd::not_definite)
        return Error(
            ExitCode::bad_input, "solver.linear",
            "cholmod needs a positive definite tangent, which this case does not have",
            "use mumps-ldlt; the pressure unknowns of mixed cells (mesh.formulation) make the tangent indefinite");
    if (end == NewtonEnd::linear_solver)
        return Error(ExitCode::bad_input, "solver.linear", problem + ": the linear solver does not converge",
                     "use another solver.linear or solver.preconditioner, or increase solver.linear_limit");
    return Error(ExitCode::bad_input, "materials", problem, "check the moduli of the materials");
}

std::optional<Stop> stop_before_step(const PathState& path, fem::System& system) {
    const model::Case& input = system.input();
    const int limit = input.solver.step_limit * input.path.cycles;
    if (path.rows > limit)
        return Stop{StopReason::step_limit, core::counted(limit, "step") + (limit == 1 ? " was" : " were") +
                                                " not enough; increase solver.step_limit"};
    if (stage_of(input, path).time_s || !is_stalled(path, input.solver.steps)) return std::nullopt;
    if (path.refused && path.rows - path.refused->row < static_cast<int>(stalled_rows))
        return unresolved(path.refused->crossing, state_text(*path.last, input));
    const std::string where = ": the last " + std::to_string(stalled_rows) +
                              " steps cover less than 1 % of its length, at " + state_text(*path.last, input);
    if (auto inverted = inverted_stop(path, system)) return inverted;
    if (is_past_limit_point(path) || is_below_limit_point(path, stage_of(input, path)))
        return Stop{
            StopReason::limit_point,
            "the requested load is not reached: the path is past the limit point and stalls" + where + end_earlier};
    return Stop{StopReason::diverged, "the path stalls" + where + "; try another mesh.size"};
}

std::optional<Stop> stop_before_row(const PathState& path, const PathPoint& point, const fem::System& system) {
    constexpr double runaway = 1e4, farthest = 1e6,
                     unmoved = 1e-8;  // change of the load factor; of the state by the loads of the stage
    const double by_loads = linalg::norm(point.tangent.x) / std::abs(point.tangent.load_factor);
    const auto last = [&] { return state_text(*path.last, system.input()); };
    if (std::abs(point.state.load_factor - path.last->state.load_factor) >= runaway &&
        by_loads <= unmoved * linalg::norm(point.state.x))
        return Stop{
            StopReason::limit_point,
            "the requested load is not reached: the path has turned back to " + last() +
                ", beyond which the load changes and the state does not, as where an obstacle that moves has left it" +
                end_earlier};
    if (point.state.load_factor < -farthest)
        return Stop{StopReason::limit_point,
                    "the requested load is not reached: the loads have turned back by more than " +
                        short_text(farthest) + " times their change, after " + last() + end_earlier};
    return std::nullopt;
}

std::optional<Stop> stop_at_row(const PathState& path, fem::System& system) {
    const model::Case& input = system.input();
    if (stage_of(input, path).time_s) return std::nullopt;  // time goes on, also where nothing moves
    const std::string here = state_text(*path.last, input);
    if (std::string returned = return_text(path, input, here); !returned.empty()) {
        if (auto inverted = inverted_stop(path, system)) return inverted;
        return Stop{StopReason::limit_point, std::move(returned)};
    }
    if (is_out_of_reach(path, input.path.stretch_limit)) return Stop{StopReason::limit_point, asymptote_text(here)};
    const double limit = input.path.stretch_limit;
    const bool at_a_point = path.max_stretch > far_beyond * limit;  // as where a bulge grows in a single cell
    if (is_past_limit_point(path) && (path.stretch_p99 > limit || at_a_point))
        return Stop{StopReason::limit_point,
                    "the requested load is never reached: the path is past the limit point, and the stretch exceeds " +
                        (path.stretch_p99 > limit ? std::string("path.stretch_limit")
                                                  : short_text(far_beyond) + " times path.stretch_limit at a point") +
                        " at " + here + end_earlier};
    return std::nullopt;
}

Stop unresolved(const ContactEvent& crossing, const std::string& state) {
    const std::string text = crossing.text + " at " + state;
    if (crossing.is_driven)
        return {crossing.reason,
                text + ", which does not give way; end the path before (path.until), or move the obstacle"};
    return {crossing.reason, text + ", and the contact is not resolved; use smaller cells there (mesh.size)"};
}

bool is_nearly_inverted(const NewtonResult& attempt) { return attempt.min_jacobian < nearly_inverted; }

Stop stop_without_step(const PathState& path, fem::System& system, const NewtonResult& attempt) {
    const model::Case& input = system.input();
    const std::string location = location_text(attempt.worst_cell, input), here = state_text(*path.last, input);
    const std::string det = "det F = " + short_text(attempt.min_jacobian);
    const double rise = path.stretch_p99 > input.path.stretch_limit ? rise_of(*path.last) : -1.0;
    if (rise >= 0.0 && rise < hardly_rising * (1.0 - path.last->state.load_factor))
        return {StopReason::limit_point, asymptote_text(here)};
    if (attempt.end == NewtonEnd::inverted)
        return {StopReason::inverted_element, "an element inverted (" + det + ") " + location + remedy};
    if (is_nearly_inverted(attempt))
        return {StopReason::inverted_element,
                "an element is nearly inverted (" + det + ") " + location + " at " + here + remedy};
    if (auto inverted = inverted_stop(path, system)) return std::move(*inverted);
    const bool touches = path.last->touches;
    const std::string problem = "no equilibrium found beyond " + here + (touches ? ", where surfaces touch" : "");
    if (stage_of(input, path).time_s && path.loads->free_supplies().empty())
        return {StopReason::diverged, problem +
                                          ", as where a prescribed pressure passes its limit; prescribe the volume or "
                                          "the mass of gas in place of the pressure"};
    if (is_past_limit_point(path))
        return {StopReason::limit_point,
                "the requested load is not reached: the path is past the limit point, and " + problem + end_earlier};
    if (attempt.end == NewtonEnd::linear_solver) return {StopReason::diverged, problem + ": " + linear_remedy};
    return {StopReason::diverged, problem + " (" + std::string(text_of(attempt.end)) + "); the largest distortion is " +
                                      location + ", " + det + "; try smaller cells there (mesh.size)" +
                                      (touches ? ", or a contact.distance of 0.05" : "")};
}

}  // namespace soft::solver
