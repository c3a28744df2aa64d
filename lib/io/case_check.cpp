#include "io/case_check.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "io/checker.hpp"

namespace soft::io {
namespace {

/// Points on the axis in gmsh meshes may be off it by rounding errors. Relative to the largest radius.
constexpr double axis_tolerance = 1e-8;

void check_header(const Checker& check) {
    const model::Case& input = check.model();
    check.require(input.model_fraction > 0 && input.model_fraction <= 1, "/mesh/model_fraction",
                  "must be greater than 0 and at most 1");
    const int expected = input.kinematics == model::Kinematics::solid ? 3 : 2;
    check.require(input.mesh.dimension == expected, "/mesh/dimension",
                  "must be " + std::to_string(expected) + " for these kinematics");
}

void check_points(const Checker& check) {
    const model::Case& input = check.model();
    const auto& points = input.mesh.points;
    check.require(!points.empty(), "/VTKHDF/Points", "there are no points");
    double max_radius = 0;
    double min_radius = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::all_of(points[i].begin(), points[i].end(), [](double x) { return std::isfinite(x); }))
            check.refuse(Checker::item("/VTKHDF/Points", i), "is not a finite number");
        max_radius = std::max(max_radius, points[i][1]);
        min_radius = std::min(min_radius, points[i][1]);
    }
    if (input.kinematics == model::Kinematics::axisymmetric)
        check.require(min_radius >= -axis_tolerance * max_radius, "/VTKHDF/Points",
                      "a section has points at a negative radius");
}

void require_point(const Checker& check, mesh::Index point, const std::string& list, std::size_t i) {
    if (point < 0 || point >= static_cast<mesh::Index>(check.model().mesh.points.size()))
        check.refuse(Checker::item(list, i), "point " + std::to_string(point) + " does not exist");
}

// The loops over the mesh format messages only on failure: formatting texts for a million nodes would take a second.
void check_cells(const Checker& check) {
    const model::Case& input = check.model();
    const mesh::Mesh& mesh = input.mesh;
    const std::size_t cells = mesh.cell_types.size();
    check.require(cells > 0, "/VTKHDF/Types", "there are no cells");
    check.require(mesh.offsets.size() == cells + 1 && mesh.offsets[0] == 0, "/VTKHDF/Offsets",
                  "must start at 0 and have one entry more than there are cells");
    check.require(mesh.cell_regions.size() == cells, "/mesh/cell_regions", "must have one entry per cell");
    const auto nodes = static_cast<mesh::Index>(mesh.connectivity.size());
    for (std::size_t c = 0; c < cells; ++c) {
        const auto& topology = mesh::topology(mesh.cell_types[c]);
        if (topology.dimension != mesh.dimension)
            check.refuse(Checker::item("/VTKHDF/Types", c),
                         std::string{topology.name} + " does not have the dimension of the mesh");
        if (mesh.offsets[c] > nodes || mesh.offsets[c + 1] != mesh.offsets[c] + topology.node_count)
            check.refuse(Checker::item("/VTKHDF/Offsets", c + 1),
                         "does not match the number of nodes of a " + std::string{topology.name});
        const auto region = mesh.cell_regions[c];
        if (region < 0 || static_cast<std::size_t>(region) >= mesh.region_names.size())
            check.refuse(Checker::item("/mesh/cell_regions", c),
                         "region " + std::to_string(region) + " does not exist");
    }
    check.require(mesh.offsets.back() == nodes, "/VTKHDF/Connectivity", "its length does not match the offsets");
    for (std::size_t i = 0; i < mesh.connectivity.size(); ++i)
        require_point(check, mesh.connectivity[i], "/VTKHDF/Connectivity", i);
}

void check_facet(const Checker& check, const mesh::Facet& facet, const std::string& list, std::size_t i) {
    const mesh::Mesh& mesh = check.model().mesh;
    const std::string cell = "cell " + std::to_string(facet.cell);
    if (facet.cell < 0 || facet.cell >= mesh.cell_count())
        check.refuse(Checker::item(list, i), cell + " does not exist");
    const auto count = static_cast<int>(mesh::topology(mesh.cell_type(facet.cell)).facets.size());
    if (facet.local < 0 || facet.local >= count)
        check.refuse(Checker::item(list, i), cell + " has no facet " + std::to_string(facet.local));
}

void check_sets(const Checker& check) {
    const model::Case& input = check.model();
    for (const auto& [name, facets] : input.mesh.facet_sets) {
        const std::string location = "/mesh/facets/" + name;
        check.require_name(name, location);
        for (std::size_t i = 0; i < facets.size(); ++i) check_facet(check, facets[i], location, i);
    }
    for (const auto& [name, points] : input.mesh.point_sets) {
        const std::string location = "/mesh/points/" + name;
        check.require_name(name, location);
        for (std::size_t i = 0; i < points.size(); ++i) require_point(check, points[i], location, i);
    }
}

void check_materials(const Checker& check) {
    const model::Case& input = check.model();
    const auto& regions = input.mesh.region_names;
    check.require_unique(regions, "/mesh/region_names", [](const std::string& name) { return name; });
    check.require_unique(input.materials, "/materials", [](const model::Material& material) { return material.name; });
    for (const model::Material& material : input.materials) {
        const std::string location = "/materials/" + material.name;
        check.require(std::find(regions.begin(), regions.end(), material.name) != regions.end(), location,
                      "there is no region of that name");
        check.require_name(material.law, location + "/law");
        for (const auto& [key, values] : material.constants) {
            check.require_name(key, location + "/constants");
            for (const double value : values) check.require_finite(value, location + "/constants/" + key);
        }
        if (material.fibers) {
            check.require_finite(material.fibers->angle_rad, location + "/fibers/angle");
            check.require_positive(material.fibers->k1_Pa, location + "/fibers/k1");
            check.require_positive(material.fibers->k2, location + "/fibers/k2");
            check.require(material.fibers->families == 1 || material.fibers->families == 2,
                          location + "/fibers/families", "must be 1 or 2");
        }
        const double kappa = material.bulk_modulus_Pa.value_or(1);
        check.require_positive(kappa, location + "/bulk_modulus");
        check.require_positive(material.density_kg_m3.value_or(1), location + "/density");
        check.require(input.body_forces.empty() || material.density_kg_m3, location + "/density",
                      "is missing, but a body force requires it");
    }
    check.require(regions.size() == input.materials.size(), "/materials", "a region has no material");
}

void check_supports(const Checker& check) {
    const model::Case& input = check.model();
    for (std::size_t i = 0; i < input.supports.size(); ++i) {
        const model::Support& support = input.supports[i];
        check.require_face(support.face, Checker::item("/supports/face", i));
        check.require(support.fixed[0] || support.fixed[1] || support.fixed[2], Checker::item("/supports/fixed", i),
                      "fixes no component");
    }
}

}  // namespace

void check_case(const model::Case& model, std::string_view source, ExitCode code) {
    const Checker check{model, source, code};
    check_header(check);
    check_points(check);
    check_cells(check);
    check_sets(check);
    check_materials(check);
    check_supports(check);
    check_loads(check);
    check_path(check);
}

bool is_name(std::string_view text) noexcept {
    constexpr std::size_t max_length = 100;
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
               c == '.';
    };
    return !text.empty() && text.size() <= max_length && text[0] != '.' &&
           std::all_of(text.begin(), text.end(), allowed);
}

}  // namespace soft::io
