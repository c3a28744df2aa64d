#include "solver/stages.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "solver/control.hpp"
#include "solver/kink.hpp"
#include "solver/path_end.hpp"
#include "solver/row_state.hpp"
#include "solver/series.hpp"
#include "solver/stepping.hpp"

namespace soft::solver {

using model::StopReason;

namespace {

/// First step of a stage in time, of the shortest relaxation time: its error is not known before the second one.
constexpr double first_share = 0.05;
/// Distance at which the terms of the path's series are found, as a fraction of the stage's loads in the linear response; and the bound of
/// the first step, in first steps of the settings; the smaller one where derivatives are computed, of which the rows have no slopes.
constexpr double series_share = 0.02, longest_first_step = 25.0, longest_with_derivatives = 5.0;

/// The state without a direction, for a path that ends at its start.
PathPoint point_without_direction(fem::System& system, const StageLoads& loads, State state) {
    PathTangent none = no_tangent(state);
    PathPoint point{std::move(state), std::move(none)};
    read_values(system, loads, nullptr, point);
    return point;
}

/// A longer first step, and a point behind the start that predicts it, where the path is smooth. A body
/// follows a face that is moved in nearly straight lines, although the forces do not. `full`: the stage's loads in the linear
/// response, of q, signed.
void use_series(Corrector& corrector, PathState& path, const PathPoint& start, double full) {
    const fem::System& system = corrector.system();
    const model::SolverSettings& settings = system.input().solver;
    if (settings.steps != model::StepRule::error_adaptive || settings.predictor == model::Predictor::tangent ||
        stage_of(system.input(), path).time_s || may_have_kinks(system, start) || system.contact().has_friction() ||
        std::ranges::any_of(path.loads->rate().motions, [](double rate) { return rate != 0.0; }))
        return;
    const double longest = system.input().parameters.empty() ? longest_first_step : longest_with_derivatives;
    const double share = std::min(longest * settings.first_step, 1.0);
    auto series = series_at(corrector, path, start, std::min(series_share, share) * full, share * std::abs(full));
    if (!series) return;
    path.before = std::move(series->behind);
    if (std::abs(series->reach) > std::abs(path.step)) path.step = round_step_size(series->reach);
}

}  // namespace

void set_stage(int index, StageStart start, Corrector& corrector, PathState& path) {
    const model::Case& input = corrector.input();
    path.stage = index;
    path.loads.emplace(input, index, std::move(start), path.undeformed_volumes_m3);
    corrector.newton().set_loads(*path.loads);
    path.goals = make_goals(input, index, *path.loads, path.undeformed_volumes_m3);
    path.control = first_control(corrector.system(), stage_of(input, path));
    path.user_control.reset();
}

std::optional<Stop> begin_stage(Corrector& corrector, PathState& path, State state) {
    fem::System& system = corrector.system();
    const model::Stage& stage = stage_of(system.input(), path);
    const StageLoads& loads = *path.loads;
    path.first_row = path.rows;
    path.visited.clear();
    path.before.reset();
    path.last.reset();
    path.attempts = {};
    system.internal().forget_rates();
    auto by_load = corrector.newton().tangent({ConstraintKind::load_factor}, state);
    if (!by_load || !std::isfinite(linalg::norm(by_load->x))) {
        const NewtonEnd end = corrector.newton().tangent_end();
        if (end == NewtonEnd::linear_solver) {
            path.last = point_without_direction(system, loads, std::move(state));
            path.last->load_work_J = path.work_before_J;
            return Stop{StopReason::diverged,
                        std::string("the tangent of the path cannot be computed at its start: ") + linear_remedy};
        }
        if (path.rows == 0) throw start_error(end, "the undeformed body has a singular stiffness");
        return Stop{StopReason::diverged, "the tangent is singular where stage '" + stage.name + "' begins"};
    }
    if (path.rows == 0 && system.has_kinks()) by_load = leave_rest(corrector, state, std::move(*by_load));
    path.first_slope = linalg::norm(by_load->x);
    const bool unstable = by_load->unstable_modes.value_or(0) > 0 || by_load->power < 0.0;
    if (unstable && stage.control == model::Control::automatic && !stage.time_s)
        path.control = softer_control(system, loads);
    PathPoint point{std::move(state), std::move(*by_load)};
    read_values(system, loads, nullptr, point);
    if (is_lost_in_rounding(path.control, loads, point)) path.control = {ConstraintKind::load_factor};
    const bool by_arc = path.control.kind == ConstraintKind::arc;
    const bool by_factor = path.control.kind == ConstraintKind::load_factor;
    const double sense = !by_factor && point.tangent.power < 0.0 ? -1.0 : 1.0;
    if (by_arc) rescale(system, loads, point, sense);
    const double slope = control_slope(path.control, point);
    if (loads.changes() && !std::isfinite(1.0 / slope))
        throw Error(ExitCode::bad_input, "path.control", "the load does not move the controlled quantity",
                    "use another quantity, or auto");
    path.first_step = path.step = first_step(system.input().solver, path.control, slope, by_arc ? 1.0 : sense);
    if (limits_steps_in_time(system, path)) {
        const double short_step = first_share * system.internal().shortest_time_s() / *stage.time_s;
        path.first_step = path.step = std::min(path.step, round_step_size(short_step));
    }
    if (loads.changes()) rescale(system, loads, point, 1.0 / slope);
    point.q = controlled_value(path.control, point, 0.0);
    point.load_work_J = path.work_before_J;
    if (loads.changes()) use_series(corrector, path, point, (by_arc ? 1.0 : sense) * slope);
    path.last = std::move(point);
    return std::nullopt;
}

State next_stage(Corrector& corrector, PathState& path) {
    const StageStart start = stage_start_at(corrector.input(), *path.loads, *path.last);
    path.work_before_J = path.last->load_work_J;
    State state = std::move(path.last->state);
    set_stage(path.stage + 1, start, corrector, path);
    state.load_factor = 0.0;
    state.pressures_Pa.clear();
    for (const std::size_t load : path.loads->free_supplies()) state.pressures_Pa.push_back(start.pressures_Pa[load]);
    return state;
}

int last_row_of_stage(const PathState& path, const model::Case& input) {
    for (const auto& until : stage_of(input, path).until)
        if (until.quantity == "steps") return path.start_row() + static_cast<int>(until.value);
    return input.solver.step_limit * input.path.cycles;
}

}  // namespace soft::solver
