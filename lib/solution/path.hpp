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
    double load_factor = 0;
    double pressure_Pa = 0;                      ///< of the first load; its traction where the case has no pressure
    std::optional<double> volume_m3;             ///< enclosed by the first loaded cavity, whole actuator; empty without one
    std::vector<double> outputs_m;               ///< in the order of Case::outputs
    double tangent_load_factor = 0;
    double tangent_pressure = 0;
    double tangent_volume = 0;
    std::vector<double> tangent_outputs;
    int newton_iterations = 0;
    int factorizations = 0;
    bool stable = true;                          ///< for the controlled variable
    double stretch_p99 = 1;                      ///< largest principal stretch exceeded in 1 % of the rubber's volume
    double max_stretch = 1;
    double min_jacobian = 1;                     ///< least det F over the integration points
};

struct LimitPoint {
    int step = 0;                                ///< row of the path that holds it, or the row before it
    double pressure_Pa = 0;
    std::optional<double> volume_m3;
    std::vector<double> outputs_m;
};

struct PathEnd {
    StopReason reason = StopReason::done;
    std::string detail;                          ///< one sentence for the user, with the place where there is one
    std::vector<LimitPoint> limit_points;
    int newton_iterations = 0;
    int factorizations = 0;
};

}  // namespace soft::solution
