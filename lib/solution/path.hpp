#pragma once
/// The equilibrium path as plain data: shared by solver, io and post. SI units.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soft::solution {

enum class StopReason { done, limit_point, diverged, inverted_element, self_contact, step_limit };

[[nodiscard]] constexpr std::string_view name(StopReason reason) noexcept {
    switch (reason) {
        case StopReason::done: return "done";
        case StopReason::limit_point: return "limit_point";
        case StopReason::diverged: return "diverged";
        case StopReason::inverted_element: return "inverted_element";
        case StopReason::self_contact: return "self_contact";
        case StopReason::step_limit: return "step_limit";
    }
    return "diverged";
}

/// One converged state. The tangent_* values are the derivatives along the path (any positive scale, direction of
/// travel), all by the same path parameter, so that d(pressure)/d(volume) is their quotient.
struct Step {
    int stage = 0;                     ///< index into model::PathSettings::stages
    double load_factor = 0;            ///< how much of the stage's change of loads is done
    double pressure_Pa = 0;            ///< the leading load (model::leading_load)
    std::optional<double> volume_m3;   ///< enclosed by the cavities of the first load, whole actuator; empty without
    std::vector<double> pressures_Pa;  ///< of each pressure load, where there are several; else empty
    std::vector<double> volumes_m3;    ///< of each of model::measured_cavities, where there are several; else empty
    std::vector<double> outputs;       ///< in the order of Case::outputs, SI (model::unit_of)
    double tangent_load_factor = 0;
    double tangent_pressure = 0;
    double tangent_volume = 0;
    std::vector<double> tangent_pressures, tangent_volumes, tangent_outputs;
    int newton_iterations = 0;
    int factorizations = 0;
    bool stable =
        true;  ///< under the loads as the case states them: at that pressure, volume or gas; see solver/path.hpp
    /// Under the control that finds the state (a pressure that is stated may be found at a prescribed volume). Absent of a dynamic
    /// path and in older files.
    std::optional<bool> stable_under_control = {};
    double stretch_p99 = 1;  ///< largest principal stretch exceeded in 1 % of the rubber's volume
    double max_stretch = 1;
    double min_jacobian = 1;  ///< least det F over the integration points
    /// Where the rubber is stretched most, and its energy; absent in older files.
    struct Extremes {
        std::array<double, 3> stretch_at_m{};  ///< undeformed place of max_stretch; a section's x, r, 0
        double energy_J_m3 = 0;                ///< largest strain energy per undeformed volume, at an integration point
    };
    std::optional<Extremes> extremes;
    /// Of a static path (a dynamic one has its own), whole actuator; absent in older files and for laws without an energy.
    struct Energies {
        double stored_J = 0, load_work_J = 0;  ///< held by the rubber; done by the loads since the path began
        /// Power of the loads along the path: the derivative of both, as the body is in equilibrium. Absent in older files.
        std::optional<double> tangent_J;
    };
    std::optional<Energies> energies;
    /// Of a dynamic path; its load_factor is the time over the duration, its tangents are derivatives by time.
    struct Motion {
        double time_s = 0;
        double kinetic_energy_J = 0, stored_energy_J = 0;  ///< of the whole actuator
        double load_work_J = 0, damping_work_J = 0;        ///< done by the loads, taken by damping, since time 0
    };
    std::optional<Motion> motion;
    /// Half widths of the discretisation's error, where it was asked for (solver/accuracy.hpp): of pressure_Pa at an equal
    /// value of the first output (of the volume without outputs), of each output at equal pressure_Pa.
    std::optional<double> pressure_error_Pa;
    std::vector<double> output_errors;
};

/// Where the leading load has an extremum along the path.
struct LimitPoint {
    int step = 0;  ///< row of the path that holds it
    double pressure_Pa = 0;
    std::optional<double> volume_m3;
    std::vector<double> outputs;
};

/// Where another branch of equilibria leaves the path.
struct Bifurcation {
    LimitPoint at;
    int modes = 1;             ///< eigenvalues of the tangent that change sign there
    std::vector<double> mode;  ///< [point x 3], largest displacement 1; empty where it was not found
};

struct PathEnd {
    StopReason reason = StopReason::done;
    std::string detail;  ///< one sentence for the user, with the place where there is one
    std::vector<LimitPoint> limit_points;
    std::vector<Bifurcation> bifurcations;
    int newton_iterations = 0;
    int factorizations = 0;
};

}  // namespace soft::solution
