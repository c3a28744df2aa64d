#include "mesh_summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "cli.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "mesh/cell_map.hpp"
#include "model/location.hpp"
#include "surface/triangles.hpp"

namespace soft::cli {
namespace {

std::size_t free_displacements(const model::Case& model) {
    const auto dimension = static_cast<std::size_t>(model.mesh.dimension);
    std::vector<std::array<bool, 3>> fixed(model.mesh.points.size());
    const auto fix = [&](const std::string& name, const std::array<bool, 3>& components) {
        const auto face = model.mesh.facet_sets.find(name);
        if (face == model.mesh.facet_sets.end()) return;
        for (const mesh::Facet& facet : face->second)
            for (const mesh::Index node : mesh::facet_nodes(model.mesh, facet))
                for (std::size_t i = 0; i < dimension; ++i) fixed[static_cast<std::size_t>(node)][i] |= components[i];
    };
    for (const model::Support& support : model.supports) fix(support.face, support.fixed);
    for (const model::Motion& motion : model.motions) {
        const auto& moved = motion.displacement_m;
        fix(motion.face, {moved[0].has_value(), moved[1].has_value(), moved[2].has_value()});
    }
    std::size_t count = 0;
    for (const auto& node : fixed)
        count += dimension - static_cast<std::size_t>(std::count(node.begin(), node.end(), true));
    return count;
}

/// Number of pressure unknowns: linear and discontinuous on quadrilaterals and hexahedra, continuous at the vertices of other cells.
std::size_t pressures(const model::Case& model) {
    if (model.formulation != model::Formulation::mixed) return 0;
    std::size_t count = 0;
    std::set<mesh::Index> corners;
    for (mesh::Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
        const mesh::CellTopology& topology = mesh::topology(model.mesh.cell_type(cell));
        const bool discontinuous =
            topology.shape == mesh::Shape::quadrilateral || topology.shape == mesh::Shape::hexahedron;
        if (discontinuous) count += static_cast<std::size_t>(topology.dimension) + 1;
        const auto nodes = model.mesh.cell_nodes(cell);
        if (!discontinuous) corners.insert(nodes.begin(), nodes.begin() + topology.vertex_count);
    }
    return count + corners.size();
}

std::string cell_type_names(const mesh::Mesh& mesh) {
    std::vector<std::string> names;
    for (const mesh::CellType type : mesh.cell_types) {
        const std::string name{mesh::topology(type).name};
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return core::join(names);
}

meshing::WallStatistics walls_of(const model::Case& model) {
    const surface::Triangles surface = surface::facet_triangles(model.mesh, boundary_facets(model.mesh));
    std::vector<meshing::Wall> walls = meshing::walls(surface.points, surface.triangles);
    return walls.empty() ? meshing::WallStatistics{} : meshing::wall_statistics(std::move(walls));
}

nlohmann::ordered_json walls_json(const meshing::WallStatistics& walls) {
    return {
        {"min_m", walls.thinnest.thickness_m}, {"min_place_m", walls.thinnest.location}, {"median_m", walls.median_m}};
}

std::string volume_text(double volume_m3) { return core::quantity_text(volume_m3, core::Dimension::volume); }

std::string length_text(double length_m) { return core::quantity_text(length_m, core::Dimension::length); }

std::string corners_line(const mesh::ReentrantCorners& corners) {
    const std::string where =
        corners.length_m > 0 ? length_text(corners.length_m) + " of edges" : std::to_string(corners.count);
    return "sharp re-entrant corners: " + where + ", cells of " + length_text(corners.cell_m) +
           " next to them; the largest stretch there grows with refinement, so use stretch_p99; "
           "curves converge slowly, see solve --tolerance";
}

std::string obstacles_line(const std::vector<geometry::ObstacleGap>& obstacles) {
    std::vector<std::string> gaps;
    for (const geometry::ObstacleGap& obstacle : obstacles)
        gaps.push_back(obstacle.name + " " + length_text(std::max(obstacle.gap_m, 0.0)));
    return "obstacles, gap to the actuator: " + core::join(gaps);
}

std::string part_line(const MeshSummary::Part& part, double volume_m3) {
    const meshing::WallStatistics &before = part.file.walls, &after = part.walls;
    return part.file.file + ": " + std::to_string(part.file.facets) + " facets; volume " +
           volume_text(part.file.volume_m3) + ", of the mesh " + volume_text(volume_m3) + " (" +
           core::rounded_text(100 * (volume_m3 / part.file.volume_m3 - 1), 2) + " %); wall thickness at least " +
           length_text(before.thinnest.thickness_m) + ", median " + length_text(before.median_m) + ", of the mesh " +
           length_text(after.thinnest.thickness_m) + " and " + length_text(after.median_m) +
           "; the mesh follows the facets of the file, not a smooth surface";
}

std::optional<double> mass_kg(const model::Case& model) {
    const auto volumes_m3 = mesh::region_measures(model.mesh, geometry::measure_of(model));
    double mass = 0;
    for (std::size_t region = 0; region < volumes_m3.size(); ++region) {
        const auto material =
            std::ranges::find(model.materials, model.mesh.region_names[region], &model::Material::name);
        if (material == model.materials.end() || !material->density_kg_m3) return std::nullopt;
        mass += volumes_m3[region] * *material->density_kg_m3 / model.model_fraction;
    }
    return mass;
}

}  // namespace

MeshSummary inspect(const geometry::Built& built) {
    const model::Case& model = built.model;
    MeshSummary summary;
    summary.name = model.name;
    summary.cell_types = cell_type_names(model.mesh);
    summary.cells = model.mesh.cell_count();
    summary.points = model.mesh.points.size();
    summary.unknowns = free_displacements(model) + pressures(model);
    summary.quality = mesh::quality(model.mesh);
    summary.inner_corners = mesh::find_reentrant_corners(model.mesh);
    summary.rubber_volume_m3 = mesh::measure(model.mesh, geometry::measure_of(model)) / model.model_fraction;
    summary.mass_kg = mass_kg(model);
    summary.notes = built.notes;
    summary.obstacles = built.gaps;
    summary.cavities = surface::check_cavities(model);
    for (const surface::CavityReport& cavity : summary.cavities)
        summary.min_wall_locations.push_back(model::location_text(model.kinematics, cavity.min_wall_location));
    if (built.part) {
        summary.part = MeshSummary::Part{*built.part, walls_of(model)};
        summary.part->file.volume_m3 /= model.model_fraction;  // of the whole actuator, like all volumes of the summary
    }
    return summary;
}

std::string memory_warning(std::size_t unknowns, int dimension) {
    constexpr std::size_t many = 1000000;
    if (unknowns <= many) return {};
    // Measured with the direct solver: solids of 91,281 unknowns 0.88 GB, of 445,471 5.6 GB; a section of 136,000 unknowns 0.29 GB.
    const double n = static_cast<double>(unknowns);
    const double memory_GB = dimension == 3 ? 0.88 * std::pow(n / 91281, 1.17) : 0.29 * std::pow(n / 136000, 1.08);
    return "mesh: " + std::to_string(unknowns) + " unknowns; solve will need about " +
           core::rounded_text(memory_GB, 2) + " GB of memory; " +
           (dimension == 3 ? "use larger cells, a half or quarter model, or solver.preconditioner: multigrid"
                           : "use larger cells (mesh.size, mesh.quality: draft)");
}

std::vector<std::string> summary_lines(const MeshSummary& summary) {
    std::string shape = "rubber " + volume_text(summary.rubber_volume_m3);
    if (summary.mass_kg) shape += ", " + core::quantity_text(*summary.mass_kg, core::Dimension::mass);
    for (std::size_t i = 0; i < summary.cavities.size(); ++i) {
        const surface::CavityReport& cavity = summary.cavities[i];
        shape += ", " + cavity.name + " " + volume_text(cavity.volume_m3);
        if (cavity.min_wall_m)
            shape += ", min. wall " + core::quantity_text(*cavity.min_wall_m, core::Dimension::length) + " at " +
                     summary.min_wall_locations[i];
    }
    shape += ", min. scaled Jacobian " + core::rounded_text(summary.quality.min_scaled_jacobian, 3);
    std::vector<std::string> lines{core::one_line(summary.name) + ": " + core::counted(summary.cells, "cell") + " (" +
                                       summary.cell_types + "), " + std::to_string(summary.points) + " points, " +
                                       std::to_string(summary.unknowns) + " unknowns",
                                   shape};
    if (!summary.obstacles.empty()) lines.push_back(obstacles_line(summary.obstacles));
    if (summary.inner_corners.count > 0) lines.push_back(corners_line(summary.inner_corners));
    lines.insert(lines.end(), summary.notes.begin(), summary.notes.end());
    if (!summary.part) return lines;
    lines.push_back(part_line(*summary.part, summary.rubber_volume_m3));
    if (!summary.part->file.repairs.empty())
        lines.push_back(summary.part->file.file + ": repaired: " + core::join(summary.part->file.repairs));
    return lines;
}

nlohmann::ordered_json summary_json(const MeshSummary& summary, const std::vector<std::string>& warnings) {
    nlohmann::ordered_json cavities = nlohmann::ordered_json::array();
    for (const surface::CavityReport& cavity : summary.cavities) {
        nlohmann::ordered_json one = {
            {"name", cavity.name}, {"volume_m3", cavity.volume_m3}, {"surface_triangles", cavity.triangles}};
        if (cavity.min_wall_m) {
            one["min_wall_m"] = *cavity.min_wall_m;
            one["min_wall_place_m"] = cavity.min_wall_location;
        }
        cavities.push_back(std::move(one));
    }
    nlohmann::ordered_json json = summary_head("mesh-gen");
    json.update({{"name", summary.name},
                 {"cells", summary.cells},
                 {"cell_types", summary.cell_types},
                 {"points", summary.points},
                 {"unknowns", summary.unknowns},
                 {"rubber_volume_m3", summary.rubber_volume_m3},
                 {"cavities", std::move(cavities)},
                 {"min_scaled_jacobian", summary.quality.min_scaled_jacobian},
                 {"mean_scaled_jacobian", summary.quality.mean_scaled_jacobian},
                 {"worst_cell", summary.quality.worst_cell},
                 {"worst_place_m", summary.quality.worst_position_m},
                 {"warnings", warnings}});
    json["inner_corners"] = {{"count", summary.inner_corners.count},
                             {"length_m", summary.inner_corners.length_m},
                             {"cell_m", summary.inner_corners.cell_m}};
    for (const geometry::ObstacleGap& obstacle : summary.obstacles)
        json["obstacles"].push_back({{"name", obstacle.name}, {"gap_m", std::max(obstacle.gap_m, 0.0)}});
    if (!summary.notes.empty()) json["notes"] = summary.notes;
    if (summary.mass_kg) json["mass_kg"] = *summary.mass_kg;
    if (summary.part)
        json["part"] = {{"file", summary.part->file.file},
                        {"facets", summary.part->file.facets},
                        {"volume_m3", summary.part->file.volume_m3},
                        {"repairs", summary.part->file.repairs},
                        {"walls", walls_json(summary.part->file.walls)},
                        {"walls_of_mesh", walls_json(summary.part->walls)}};
    return json;
}

}  // namespace soft::cli
