#pragma once
/// Summary that mesh-gen prints of a case: size, volumes, smallest wall thickness, mesh quality. Also the content of --json.
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/build.hpp"
#include "mesh/quality.hpp"
#include "mesh/reentrant_corners.hpp"
#include "model/case.hpp"
#include "surface/report.hpp"

namespace soft::cli {

struct MeshSummary {
    std::string name;
    std::string cell_types;  ///< "hex27, wedge18"
    mesh::Index cells = 0;
    std::size_t points = 0;
    std::size_t unknowns = 0;       ///< free displacements and pressures
    double rubber_volume_m3 = 0;    ///< whole actuator
    std::optional<double> mass_kg;  ///< whole actuator; set if all materials have a density
    mesh::Quality quality;
    mesh::ReentrantCorners inner_corners;
    std::vector<surface::CavityReport> cavities;
    /// For a part imported as a surface: figures of the file, and the wall thickness of the mesh for comparison.
    struct Part {
        geometry::PartFigures file;
        meshing::WallStatistics walls;
    };
    std::optional<Part> part;
    std::vector<std::string> notes;  ///< how a drawn outline was interpreted
    std::vector<std::string>
        min_wall_locations;  ///< "x = 12.3 mm, r = 4.5 mm": location of the smallest wall of each cavity
    std::vector<geometry::ObstacleGap> obstacles;
};

/// Throws Error(bad_input) for a case that cannot be solved: inverted cells, or a cavity surface that is open or intersects itself.
[[nodiscard]] MeshSummary inspect(const geometry::Built& built);

/// Warning about the memory that solve will need, for more than a million unknowns; otherwise empty.
[[nodiscard]] std::string memory_warning(std::size_t unknowns, int dimension);

/// Two lines; one more for obstacles, one for sharp re-entrant corners, up to two more for an imported part.
[[nodiscard]] std::vector<std::string> summary_lines(const MeshSummary& summary);
/// SI values; the key names contain the units.
[[nodiscard]] nlohmann::ordered_json summary_json(const MeshSummary& summary, const std::vector<std::string>& warnings);

}  // namespace soft::cli
