#pragma once
/// The equilibrium path as plain data: shared by solver, io and post. SI units.
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soft::model {

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

/// In place of the derivatives of a row that has none: a bifurcation, where they are not unique.
inline constexpr double no_derivative = std::numeric_limits<double>::max();

/// One converged state. The tangent_* values are the derivatives by a common path parameter (of arbitrary positive scale, in the
/// direction of the path), so d(pressure)/d(volume) is a quotient of two of them.
struct Step {
    int stage = 0;           ///< index into model::PathSettings::stages
    double load_factor = 0;  ///< fraction of the stage's load increment that is applied
    std::optional<double> time_s =
        {};                  ///< since the start, on a static path in time (Motion has that of a dynamic path)
    double pressure_Pa = 0;  ///< the leading load (model::leading_load)
    /// Enclosed by the cavities of the first load, whole actuator; empty without cavities.
    std::optional<double> volume_m3;
    std::vector<double> pressures_Pa;  ///< of each pressure load if there are several; else empty
    std::vector<double> volumes_m3;    ///< of each of model::measured_cavities if there are several; else empty
    std::vector<double> outputs;       ///< in the order of Case::outputs, SI (model::unit_of)
    double tangent_load_factor = 0;
    double tangent_pressure = 0;
    double tangent_volume = 0;
    std::vector<double> tangent_pressures, tangent_volumes, tangent_outputs;
    int newton_iterations = 0;
    int factorizations = 0;
    /// Stable under the loads of the case (prescribed pressure, volume or gas mass); see solver/path.hpp.
    bool stable = true;
    /// Stable under the control that found the state (a prescribed pressure may be found under volume control). Absent for dynamic
    /// paths and in older files.
    std::optional<bool> stable_under_control = {};
    double stretch_p99 = 1;  ///< principal stretch that is exceeded in 1 % of the material's volume
    double max_stretch = 1;
    double min_jacobian = 1;  ///< smallest det F at the quadrature points
    /// Position of the maximum stretch, and the maximum energy density. Absent in older files.
    struct Extremes {
        std::array<double, 3> stretch_at_m{};  ///< undeformed position of max_stretch; x, r, 0 in a section
        double energy_J_m3 = 0;                ///< largest strain energy per undeformed volume at a quadrature point
    };
    std::optional<Extremes> extremes;
    /// Energies of a static path (dynamic paths: Motion), whole actuator. Absent in older files and for laws without an energy.
    struct Energies {
        double stored_J = 0, load_work_J = 0;  ///< strain energy; work of the loads since the start of the path
        /// Derivative of load_work_J along the path, in equilibrium also of stored_J. Absent in older files.
        std::optional<double> tangent_J = {};
        /// Set free by snaps (solver/snap.hpp), and by inelastic materials, since the start of the path; absent where there is neither,
        /// and in older files.
        std::optional<double> dissipated_J = {};
    };
    std::optional<Energies> energies;
    /// Dynamic path: load_factor is time / duration, and the tangents are time derivatives.
    struct Motion {
        double time_s = 0;
        double kinetic_energy_J = 0, stored_energy_J = 0;  ///< of the whole actuator
        double load_work_J = 0, damping_work_J = 0;  ///< work of the loads and work dissipated by damping since time 0
    };
    std::optional<Motion> motion;
    /// Dissipated by friction since the start of the path, whole actuator; absent without friction.
    std::optional<double> friction_J = {};
    /// Half widths of the error bars of the discretisation error, if requested (solver/accuracy.hpp): of pressure_Pa at an equal
    /// value of the first output (of the volume if there are no outputs), and of each output at equal pressure_Pa.
    std::optional<double> pressure_error_Pa;
    std::vector<double> output_errors;
    /// model::PathSettings::frequencies values, ascending; negative: unstable (solver/natural_frequencies.hpp).
    std::vector<double> frequencies_Hz = {};
    /// Derivatives by Case::parameters at a fixed position along the path (solver/sensitivities.hpp), SI: for each parameter of
    /// pressure_Pa, then of each output; all no_derivative where they do not exist.
    std::vector<double> derivatives = {};
};

/// Whether the leading load is constant along the path there, as where an obstacle moves or another pressure grows at a held pressure.
[[nodiscard]] inline bool holds_load(const Step& step) {
    return step.tangent_pressure == 0.0 && step.tangent_load_factor != 0.0;
}

/// Extremum of the leading load along the path.
struct LimitPoint {
    int step = 0;  ///< row of the path
    double pressure_Pa = 0;
    std::optional<double> volume_m3;
    std::vector<double> outputs;
};

/// Point at which another branch of equilibria intersects the path.
struct Bifurcation {
    LimitPoint at;
    int modes = 1;             ///< number of eigenvalues of the tangent that change sign there
    std::vector<double> mode;  ///< [point x 3], scaled to a largest displacement of 1; empty if it was not found
};

/// Point at which the actuator touches itself or an obstacle after it has touched nothing.
struct FirstContact {
    LimitPoint at;
    int obstacle = -1;                   ///< index in Case::obstacles; -1: itself
    std::array<double, 3> location_m{};  ///< undeformed
};

struct PathEnd {
    StopReason reason = StopReason::done;
    std::string detail;  ///< one sentence for the user, with the location if there is one
    std::vector<LimitPoint> limit_points;
    std::vector<Bifurcation> bifurcations;
    std::vector<FirstContact> first_contacts;
    int newton_iterations = 0;
    int factorizations = 0;
};

}  // namespace soft::model
