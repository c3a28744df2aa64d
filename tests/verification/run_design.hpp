#pragma once
/// Runs a design through the libraries, as the tools do, without files in between.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/case.hpp"
#include "solution/path.hpp"

namespace soft::verification {

/// How a path ended, and what the last converged state looks like.
struct Run {
    model::Case model;
    std::vector<solution::Step> steps;
    solution::PathEnd end;
    std::vector<double> displacement_m;  ///< last step, [point x 3]
    std::vector<double> energy_J;        ///< one a step, whole actuator; empty unless wanted
    std::string mesh;                    ///< "32 quadrilateral9, 1234 unknowns"
    double seconds = 0;                  ///< mesh and path, wall clock

    [[nodiscard]] double pressure_kPa() const { return 1e-3 * steps.back().pressure_Pa; }
    [[nodiscard]] double output_mm(std::size_t output = 0) const { return 1e3 * steps.back().outputs.at(output); }

    /// Where the path, smooth between its rows, first has `value` (SI) of the quantity; all quantities there, SI.
    /// Throws std::runtime_error if it never does.
    struct Point {
        double pressure_Pa = 0;
        std::vector<double> outputs;
        std::optional<double> volume_m3;
        std::vector<double> volumes_m3;  ///< of each cavity, where there are several
    };
    [[nodiscard]] Point at(const std::string& quantity, double value) const;
    [[nodiscard]] bool reaches(const std::string& quantity, double value) const;
};

enum class Energy { ignored, recorded };

/// `design`: file in designs/; `sets`: "key.path=value", as after --set. A motion in time if the design is one. Walls that touch end the path, as in `solve`. Throws
/// std::runtime_error where the path ends as diverged: no problem may.
[[nodiscard]] Run run_design(const std::string& design, const std::vector<std::string>& sets,
                             Energy energy = Energy::ignored);

/// The case alone, not solved.
[[nodiscard]] model::Case read_case(const std::string& design, const std::vector<std::string>& sets);

/// The node nearest to a place [m].
[[nodiscard]] std::size_t nearest_node(const Run& run, const std::array<double, 3>& place_m);

}  // namespace soft::verification
