#pragma once
/// What mesh-gen tells about a case: size, volumes, thinnest wall, quality. The numbers of --json.
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/build.hpp"
#include "mesh/inner_corners.hpp"
#include "mesh/quality.hpp"
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
    std::optional<double> mass_kg;  ///< whole actuator; of materials that all have a density
    mesh::Quality quality;
    mesh::InnerCorners inner_corners;
    std::vector<surface::CavityReport> cavities;
    /// Of a part that came as a surface: the file's figures, and the mesh's walls to compare.
    struct Part {
        geometry::PartFigures file;
        surface::WallFigures walls;
    };
    std::optional<Part> part;
    std::vector<std::string> notes;        ///< how a drawn shape was read
    std::vector<std::string> wall_places;  ///< "x = 12.3 mm, r = 4.5 mm" of each cavity's smallest wall
};

/// Refuses a case that cannot be solved: inverted cells, a cavity that is open or meets itself (Error(bad_input)).
[[nodiscard]] MeshSummary inspect(const geometry::Built& built);

/// Two lines for a person; one more where there are sharp inner corners, two more where a part was meshed.
/// A warning where the solve will need much memory: above a million unknowns; empty below.
[[nodiscard]] std::string memory_warning(std::size_t unknowns, int dimension);

[[nodiscard]] std::vector<std::string> summary_lines(const MeshSummary& summary);
/// SI, units in the names.
[[nodiscard]] nlohmann::ordered_json summary_json(const MeshSummary& summary, const std::vector<std::string>& warnings);

}  // namespace soft::cli
