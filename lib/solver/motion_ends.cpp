// Failures of a motion: steps that are cut or abandoned, rows that are physically impossible.
#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "solver/motion_follower.hpp"
#include "solver/path_end.hpp"

namespace soft::solver {

using model::StopReason;

namespace {

constexpr double cut_after_failure = 0.4;
/// From rest a body cannot gain more energy than the work of its loads; a factor this large is not an error of the quadrature. Only
/// for explicit steps, which resolve all modes: an implicit step may overshoot in the velocity of modes that it does not resolve.
constexpr double max_energy_ratio = 10.0;
/// Below this stretch both energies may be rounding.
constexpr double visible_stretch = 1.01;

bool are_finite(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

bool is_finite(const model::Step& step) {
    const auto& m = *step.motion;
    return are_finite({step.pressure_Pa, step.volume_m3.value_or(0.0), step.tangent_pressure, step.tangent_volume,
                       step.stretch_p99, step.max_stretch, step.min_jacobian, m.kinetic_energy_J, m.stored_energy_J,
                       m.load_work_J, m.damping_work_J}) &&
           are_finite(step.pressures_Pa) && are_finite(step.volumes_m3) && are_finite(step.outputs) &&
           are_finite(step.tangent_pressures) && are_finite(step.tangent_volumes) && are_finite(step.tangent_outputs);
}

}  // namespace

bool MotionFollower::cut(double step_s, const std::string& why) {
    step_s_ = round_step_size(cut_after_failure * step_s);
    listeners_.report("step of " + short_text(step_s) + " s failed (" + why + "): cut to " + short_text(step_s_) +
                      " s");
    return step_s_ >= settings_.min_step * first_step_s_;
}

bool MotionFollower::refuses_crossing(double step_s) {
    if (explicit_ || input_.path.contact != model::Contact::solve) return false;
    const auto crossing = contact_in(next_);
    if (!crossing) return false;
    if (!cut(step_s, crossing->text + ", and walls pass through each other")) {
        const Stop stop = unresolved(*crossing, short_text(last_.time_s) + " s");
        finish(stop.reason, stop.detail);
    }
    return true;
}

void MotionFollower::handle_failure(const NewtonResult& failure, double step_s) {
    const bool inverted = failure.end == NewtonEnd::inverted;
    if (cut(step_s, std::string(text_of(failure.end)) + ", " + core::counted(failure.iterations, "iteration") +
                        ", residual " + short_text(failure.residual) + ", min det F " +
                        short_text(failure.min_jacobian)))
        return;
    const std::string location = solver::location_text(failure.worst_cell, input_),
                      when = short_text(last_.time_s) + " s";
    if (inverted)
        return finish(StopReason::inverted_element, "an element inverted (det F = " + short_text(failure.min_jacobian) +
                                                        ") " + location + " at " + when +
                                                        "; use smaller cells there (mesh.size)");
    if (explicit_)
        return finish(StopReason::diverged,
                      "the motion grows without bound beyond " + when + ": " + std::string(text_of(failure.end)));
    finish(StopReason::diverged, "no solution found beyond " + when + " (" + std::string(text_of(failure.end)) +
                                     "); the largest distortion is " + location +
                                     ", det F = " + short_text(failure.min_jacobian));
}

std::optional<std::string> MotionFollower::check_plausibility(const model::Step& step) const {
    const std::string when = "at " + short_text(last_.time_s) + " s ";
    const std::string remedy = explicit_ ? "use a shorter dynamics.step, damping, or an implicit integrator"
                                         : "use a shorter dynamics.step, or generalized-alpha";
    if (!is_finite(step)) return "the motion grows without bound: " + when + "it is not finite; " + remedy;
    const double work_J = max_work_J_ / input_.model_fraction;
    if (explicit_ && is_free_of_stress_ && work_J > 0.0 && step.max_stretch > visible_stretch &&
        step.motion->kinetic_energy_J > max_energy_ratio * work_J)
        return "the motion grows without bound: " + when + "its kinetic energy is " +
               short_text(step.motion->kinetic_energy_J) + " J, but the work of the loads is only " +
               short_text(work_J) + " J; " + remedy;
    return std::nullopt;
}

void MotionFollower::finish(StopReason reason, std::string detail) {
    end_.reason = reason;
    end_.detail = std::move(detail);
    finished_ = true;
}

}  // namespace soft::solver
