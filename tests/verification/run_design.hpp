#pragma once
/// Runs a design through the libraries, as the tools do, without intermediate files.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/case.hpp"
#include "model/path.hpp"

namespace soft::verification {

/// The converged steps of a path, its end, and the last converged state.
struct Run {
    model::Case model;
    std::vector<model::Step> steps;
    model::PathEnd end;
    std::vector<double> displacement_m;  ///< last step, [point x 3]
    std::vector<double> energy_J;        ///< one per step, whole actuator; empty unless requested
    std::string mesh;                    ///< "32 quadrilateral9, 1234 unknowns"
    double seconds = 0;                  ///< mesh and path, wall clock

    [[nodiscard]] double pressure_kPa() const { return 1e-3 * steps.back().pressure_Pa; }
    [[nodiscard]] double output_mm(std::size_t output = 0) const { return 1e3 * steps.back().outputs.at(output); }

    /// All quantities (SI) at the first crossing of the smooth path with `value` (SI) of the quantity.
    /// Throws std::runtime_error if there is no crossing.
    struct Point {
        double pressure_Pa = 0;
        std::vector<double> outputs;
        std::optional<double> volume_m3;
        std::vector<double> volumes_m3;  ///< of each cavity, if there are several
    };
    [[nodiscard]] Point at(const std::string& quantity, double value) const;
    [[nodiscard]] bool reaches(const std::string& quantity, double value) const;
};

enum class Energy { ignored, recorded };

/// `design`: file in designs/; `sets`: "key.path=value", as after --set. Runs a dynamic analysis if the design is dynamic. Self-contact
/// ends the path, as in `solve`. Throws std::runtime_error if the path diverges.
[[nodiscard]] Run run_design(const std::string& design, const std::vector<std::string>& sets,
                             Energy energy = Energy::ignored);

/// Reads and meshes the case without solving it.
[[nodiscard]] model::Case read_case(const std::string& design, const std::vector<std::string>& sets);

/// The node nearest to a position [m].
[[nodiscard]] std::size_t nearest_node(const Run& run, const std::array<double, 3>& position_m);

}  // namespace soft::verification
