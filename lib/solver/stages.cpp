#include <cmath>
#include <stdexcept>

#include "core/error.hpp"
#include "solver/path_follower.hpp"

namespace soft::solver {

using model::Control;
using model::StopReason;

void PathFollower::set_stage(int index, model::StageStart start) {
    stage_ = index;
    loads_.emplace(input_, index, std::move(start), undeformed_volumes_m3_);
    newton_.set_loads(*loads_);
    goals_ = make_goals(input_, index, *loads_, undeformed_volumes_m3_);
    control_ = stage_control();
    chosen_.reset();
}

/// The control at the start of a stage.
Constraint PathFollower::stage_control() const {
    const auto refuse = [](const char* problem, const char* remedy) {
        throw Error(ExitCode::bad_input, "path.control", problem, remedy);
    };
    switch (stage().control) {
        case Control::automatic:
        case Control::pressure: return {ConstraintKind::load_factor};
        case Control::arc_length: return {ConstraintKind::arc};
        case Control::volume: {
            Constraint constraint{ConstraintKind::volume};
            for (std::size_t load = 0; load < input_.loads.size(); ++load)
                if (stage().controlled.empty() ? system_.encloses_volume(load)
                                               : input_.loads[load].name == stage().controlled) {
                    if (!system_.encloses_volume(load)) break;
                    constraint.index = load;
                    return constraint;
                }
            refuse("volume control needs a loaded cavity", "use pressure, displacement or arc-length");
            break;
        }
        case Control::displacement: {
            Constraint constraint{ConstraintKind::output};
            for (std::size_t output = 0; output < input_.outputs.size(); ++output)
                if (stage().controlled.empty() ? !model::is_reaction(input_.outputs[output].measure)
                                               : input_.outputs[output].name == stage().controlled) {
                    constraint.index = output;
                    return constraint;
                }
            refuse("displacement control needs an output", "define one under outputs");
        }
    }
    return {};
}

/// The control that automatic control changes to: the volume where only the pressure of a single cavity grows, else arc length.
Constraint PathFollower::softer_control() const {
    std::size_t growing = 0, others = loads_->free_supplies().size();
    std::optional<std::size_t> load;
    const LoadLevels& rate = loads_->rate();
    for (std::size_t i = 0; i < rate.pressures_Pa.size(); ++i)
        if (rate.pressures_Pa[i] != 0.0) {
            ++growing;
            load = i;
        }
    for (const auto* list : {&rate.tractions, &rate.body_forces, &rate.motions})
        for (const double r : *list) others += r != 0.0 ? 1 : 0;
    if (growing != 1 || others > 0 || !system_.encloses_volume(*load)) return {ConstraintKind::arc};
    Constraint volume{ConstraintKind::volume};
    volume.index = *load;
    return volume;
}

/// d q / d(parameter of the point's slopes) for a control; an arc grows in the direction of the slopes.
double PathFollower::control_slope(const Constraint& control, const PathPoint& point) const {
    switch (control.kind) {
        case ConstraintKind::load_factor: return point.tangent.load_factor;
        case ConstraintKind::volume: return point.load_volume_slopes[control.index];
        case ConstraintKind::output: return point.output_slopes[control.index];
        case ConstraintKind::arc: return linalg::norm(point.tangent.x);
        case ConstraintKind::pressure: break;  // never a control
    }
    throw std::logic_error("control_slope: not a control");
}

/// Relative change, over the last step, of the path's tangent per unit of a control.
double PathFollower::bend_under(const Constraint& control) {
    const double slope = control_slope(control, *last_), before = control_slope(control, *before_);
    linalg::copy(last_->tangent.x, scratch_);
    linalg::add(scratch_, -slope / before, before_->tangent.x);
    return linalg::norm(scratch_) / linalg::norm(last_->tangent.x);
}

double PathFollower::controlled_value(const PathPoint& point, double arc_length) const {
    switch (control_.kind) {
        case ConstraintKind::load_factor: return point.state.load_factor;
        case ConstraintKind::volume: return point.load_volumes_m3[control_.index];
        case ConstraintKind::output: return point.outputs[control_.index];
        case ConstraintKind::arc: return arc_length;
        case ConstraintKind::pressure: break;
    }
    throw std::logic_error("controlled_value: not a control");
}

/// A relative change of the volume over the whole stage below this is lost in rounding: such a path is straight and is followed by
/// its load factor.
constexpr double min_volume_change = 1e-6;

void PathFollower::leave_volume_control_of_tiny_loads(const PathPoint& by_load) {
    if (control_.kind != ConstraintKind::volume || !loads_->free_supplies().empty()) return;
    const double volume_m3 = by_load.load_volumes_m3[control_.index],
                 slope = by_load.load_volume_slopes[control_.index];
    if (std::abs(slope / by_load.tangent.load_factor) < min_volume_change * std::abs(volume_m3))
        control_ = {ConstraintKind::load_factor};
}

/// Computes the direction of the path and the first step: `first_step` of the stage's loads in the linear response. The sense is
/// the one in which the growing loads do work; in a stable state, and where a face is moved, the one in which the
/// load factor grows.
void PathFollower::begin_stage(State state) {
    stage_first_row_ = rows_;
    visited_.clear();
    before_.reset();
    last_.reset();
    failures_ = 0;
    auto by_load = newton_.tangent({ConstraintKind::load_factor}, state);
    if (!by_load || !std::isfinite(linalg::norm(by_load->x))) {
        if (newton_.tangent_end() == NewtonEnd::linear_solver) {
            begin_without_direction(std::move(state));
            return finish(StopReason::diverged,
                          std::string("the tangent of the path cannot be computed at its start: ") + linear_remedy);
        }
        if (rows_ == 0) throw start_error(newton_.tangent_end(), "the undeformed body has a singular stiffness");
        return finish(StopReason::diverged, "the tangent is singular where stage '" + stage().name + "' begins");
    }
    if (rows_ == 0 && system_.has_fibers()) by_load = leave_rest(state, std::move(*by_load));
    first_slope_ = linalg::norm(by_load->x);
    const bool unstable = by_load->unstable_modes.value_or(0) > 0 || by_load->power < 0.0;
    if (unstable && stage().control == Control::automatic) control_ = softer_control();
    PathPoint point{std::move(state), std::move(*by_load)};
    read_values(point);
    leave_volume_control_of_tiny_loads(point);
    const double sense = control_.kind != ConstraintKind::load_factor && point.tangent.power < 0.0 ? -1.0 : 1.0;
    if (control_.kind == ConstraintKind::arc) rescale(point, sense);
    const double slope = control_slope(control_, point);
    if (loads_->changes() && !std::isfinite(1.0 / slope))
        throw Error(ExitCode::bad_input, "path.control", "the load does not move the controlled quantity",
                    "use another quantity, or auto");
    first_step_ = step_ = first_step(slope, control_.kind == ConstraintKind::arc ? 1.0 : sense);
    if (loads_->changes()) rescale(point, 1.0 / slope);
    point.q = controlled_value(point, 0.0);
    point.load_work_J = work_before_stage_J_;
    last_ = std::move(point);
    report_control();
}

void PathFollower::report_control() const {
    if (!listeners_.control) return;
    const bool load = control_.kind == ConstraintKind::load_factor, output = control_.kind == ConstraintKind::output;
    listeners_.control(rows_ + (rows_ == 0 ? 1 : 0), load     ? "load"
                                                     : output ? "output " + input_.outputs[control_.index].name
                                                              : std::string(name(control_.kind)));
}

/// In units of the controlled quantity, which changes by `slope` per load factor.
double PathFollower::first_step(double slope, double sense) const {
    if (settings_.steps != model::StepRule::constant) return round_step_size(settings_.first_step * sense * slope);
    return control_.kind == ConstraintKind::load_factor ? settings_.first_step : settings_.first_step * sense * slope;
}

/// Stores the state without a tangent, for a path that ends at its start.
void PathFollower::begin_without_direction(State state) {
    PathTangent none{linalg::duplicate(state.x), 0.0, std::vector(state.pressures_Pa.size(), 0.0), std::nullopt, 0.0};
    last_ = PathPoint{std::move(state), std::move(none)};
    read_values(*last_);
    last_->load_work_J = work_before_stage_J_;
}

void PathFollower::end_stage(const std::string& text) {
    if (static_cast<std::size_t>(stage_) + 1 == input_.path.stages.size())
        return finish(StopReason::done, text + " reached");
    log("stage " + stage().name + " ends: " + text + " reached at " + describe(*last_));
    const model::StageStart start = stage_start_at(input_, *loads_, *last_);
    work_before_stage_J_ = last_->load_work_J;
    State state = std::move(last_->state);
    set_stage(stage_ + 1, start);
    state.load_factor = 0.0;
    state.pressures_Pa.clear();
    for (const std::size_t load : loads_->free_supplies()) state.pressures_Pa.push_back(start.pressures_Pa[load]);
    begin_stage(std::move(state));
    if (finished_ || loads_->changes()) return;
    last_->state.load_factor = 1.0;  // nothing changes: the same state again
    append(*last_);
    end_stage("end of a stage without load changes");
}

/// Continues from the last point under another control, in the same direction.
void PathFollower::change_control(const Constraint& control, const std::string& why) {
    log(why + ": following the path by " + std::string(name(control.kind)));
    const double sense = step_ < 0.0 ? -1.0 : 1.0, reach = std::abs(step_) * linalg::norm(last_->tangent.x);
    for (auto* point : {&before_, &last_})
        if (*point) rescale(**point, sense);  // now in the direction of travel
    control_ = control;
    double span = 0;
    if (before_) {
        linalg::copy(last_->state.x, scratch_);
        linalg::add(scratch_, -1.0, before_->state.x);
        span = linalg::norm(scratch_);
        if (control_slope(control_, *before_) * control_slope(control_, *last_) <= 0.0) before_.reset();
    }
    const double direction = control_slope(control_, *last_) < 0.0 ? -1.0 : 1.0;
    for (auto* point : {&before_, &last_})
        if (*point) {
            rescale(**point, 1.0 / control_slope(control_, **point));
            (*point)->q = controlled_value(**point, point == &before_ ? -span : 0.0);
        }
    const double step = direction * reach / linalg::norm(last_->tangent.x);
    step_ = first_step_ = settings_.steps == model::StepRule::constant ? step : round_step_size(step);
    report_control();
    failures_ = 0;
    rejected_error_.reset();
    rejected_curve_error_.reset();
}

/// Whether the load reaches its maximum within a few steps, estimated from the decrease of its slope over the path length, and the
/// steps are already short.
bool PathFollower::is_near_maximum() {
    if (!before_ || std::abs(step_) > short_step_of_load * std::abs(last_->q)) return false;
    linalg::copy(last_->state.x, scratch_);
    linalg::add(scratch_, -1.0, before_->state.x);
    const double length = linalg::norm(scratch_);
    const auto slope = [](const PathPoint& point) {
        return 1.0 / linalg::norm(point.tangent.x);
    };  // d load factor / d length
    const double fall = slope(*before_) - slope(*last_);
    return length > 0.0 && slope(*last_) < steps_to_a_maximum * fall;
}

/// Leaves load control early: under automatic control when another control is better; under user-selected load control before
/// the steps towards a maximum become shorter and shorter.
void PathFollower::leave_load_control() {
    if (control_.kind != ConstraintKind::load_factor) return;
    if (stage().control != Control::automatic) {
        if (settings_.steps != model::StepRule::error_adaptive || !is_near_maximum()) return;
        chosen_ = control_;
        return change_control({ConstraintKind::arc}, "the load nears a maximum");
    }
    const Constraint other = softer_control();
    const bool softer = linalg::norm(last_->tangent.x) > softening * first_slope_;
    const double bend = bend_under(control_);
    if (!softer && !(bend > settings_.step_accuracy * straight_enough && bend_under(other) < straighter * bend)) return;
    change_control(other, softer ? "the body softens" : "the path is straighter there");
}

int PathFollower::wanted_steps() const {
    for (const auto& until : stage().until)
        if (until.quantity == "steps") return stage_first_row_ + static_cast<int>(until.value);
    return settings_.step_limit;
}

}  // namespace soft::solver
