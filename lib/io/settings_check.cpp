#include <cmath>
#include <string>

#include "io/checker.hpp"

namespace soft::io {
namespace {

void check_not_negative(const Checker& check, double value, const std::string& location) {
    check.require(std::isfinite(value) && value >= 0, location, "must not be negative");
}

void check_solver(const Checker& check) {
    const model::SolverSettings& solver = check.model().solver;
    const std::string location = "/control/solver/";
    constexpr int max_threads = 256;
    check.require(solver.residual_tolerance > 0 && solver.residual_tolerance < 1, location + "residual_tolerance",
                  "must be between 0 and 1");
    check.require(solver.linear.tolerance > 0 && solver.linear.tolerance < 1, location + "linear_tolerance",
                  "must be between 0 and 1");
    check.require(solver.newton_limit >= 1, location + "newton_limit", "must be at least 1");
    check.require(solver.linear.iteration_limit >= 1, location + "linear_limit", "must be at least 1");
    check.require(solver.wanted_iterations >= 1, location + "wanted_iterations", "must be at least 1");
    check.require(solver.step_limit >= 1, location + "step_limit", "must be at least 1");
    check.require(solver.threads >= 1 && solver.threads <= max_threads, location + "threads",
                  "must be between 1 and 256");
    check.require_positive(solver.first_step, location + "first_step");
    check.require_positive(solver.min_step, location + "min_step");
    check.require_positive(solver.step_accuracy, location + "step_accuracy");
    check_not_negative(check, solver.max_step, location + "max_step");
}

/// Requirements of a dynamic case on materials and loads.
void check_dynamic_case(const Checker& check) {
    const model::Case& input = check.model();
    for (const model::Material& material : input.materials)
        check.require(material.density_kg_m3.has_value(), "/materials/" + material.name + "/density",
                      "is missing, but a dynamic case requires it");
    check.require(input.path.stages.size() == 1, "/control/stages", "must contain exactly one stage in a dynamic case");
    const auto& supplies = input.path.stages.front().supplies;
    for (std::size_t i = 0; i < supplies.size(); ++i)
        check.require(supplies[i].what == model::Prescription::pressure,
                      Checker::item("/control/stages/0/prescription", i), "must be pressure in a dynamic case");
}

void check_dynamics(const Checker& check) {
    if (!check.model().dynamics) return;
    const model::Dynamics& dynamics = *check.model().dynamics;
    const std::string location = "/control/dynamics/";
    constexpr double min_hht_radius = 0.5;  // the method is unstable below
    check.require_positive(dynamics.duration_s, location + "duration");
    check_not_negative(check, dynamics.step_s, location + "step");
    check.require_positive(dynamics.accuracy, location + "accuracy");
    const double min_radius = dynamics.integrator == model::Integrator::hht ? min_hht_radius : 0;
    check.require(dynamics.spectral_radius >= min_radius && dynamics.spectral_radius <= 1, location + "spectral_radius",
                  "must be between 0 and 1 (hht: between 1/2 and 1)");
    check_not_negative(check, dynamics.mass_damping_1_s, location + "mass_damping");
    check_not_negative(check, dynamics.stiffness_damping_s, location + "stiffness_damping");
    check.require(dynamics.rows >= 1, location + "rows", "must be at least 1");
    check_dynamic_case(check);
}

}  // namespace

void check_time_function(const Checker& check, const model::TimeFunction& time_function, const std::string& loads,
                         std::size_t load) {
    const std::string location = loads + "/time_function/", table = location + "table/time";
    const auto own = [&](const char* name) { return Checker::item(location + name, load); };
    check_not_negative(check, time_function.time_s, own("rise"));
    if (time_function.kind == model::TimeFunctionKind::sine)
        check.require_positive(time_function.frequency_Hz, own("frequency"));
    else
        check_not_negative(check, time_function.frequency_Hz, own("frequency"));
    const auto& times = time_function.times_s;
    check.require(times.size() == time_function.shares.size(), table, "must have as many entries as table/share");
    check.require(time_function.kind == model::TimeFunctionKind::table || times.empty(), own("kind"),
                  "has table points but is not a table");
    check.require(time_function.kind != model::TimeFunctionKind::table || !times.empty(), own("kind"),
                  "is a table without points");
    for (std::size_t i = 0; i < times.size(); ++i) {
        check_not_negative(check, times[i], table);
        check.require_finite(time_function.shares[i], location + "table/share");
        check.require(i == 0 || times[i] > times[i - 1], table, "must ascend");
    }
}

void check_settings(const Checker& check) {
    check_solver(check);
    check_dynamics(check);
}

}  // namespace soft::io
