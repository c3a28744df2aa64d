#include "io/case_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/text.hpp"

namespace soft::io {
namespace {

/// Points on the axis in gmsh meshes may be off it by rounding errors. Relative to the largest radius.
constexpr double axis_tolerance = 1e-8;

/// The checked data, the name of their file, and error reporting.
struct Checker {
    const mesh::Mesh& mesh;
    const model::Shape& shape;
    std::string_view source;
    ExitCode code;

    [[noreturn]] void refuse(const std::string& location, const std::string& problem) const {
        throw Error(code, std::string{source} + ":" + location, problem, "rebuild the case with mesh-gen");
    }
    void require(bool condition, const std::string& location, const std::string& problem) const {
        if (!condition) refuse(location, problem);
    }
    static std::string item(const std::string& list, std::size_t i) { return list + "[" + std::to_string(i) + "]"; }

    void require_positive(double value, const std::string& location) const {
        require(std::isfinite(value) && value > 0, location, "must be positive");
    }
    void require_name(const std::string& text, const std::string& location) const {
        require(is_name(text), location, core::quoted(text) + " is not a valid name (letters, digits, '_', '-', '.')");
    }
    void require_face(const std::string& face, const std::string& location) const {
        const auto found = mesh.facet_sets.find(face);
        require(found != mesh.facet_sets.end(), location, "there is no face named " + core::quoted(face));
        require(!found->second.empty(), location, "the face " + core::quoted(face) + " is empty");
    }
    void require_unit(const std::array<double, 3>& direction, const std::string& location) const {
        // mesh-gen writes directions with 16 digits. An error of 1e-6 in the length has no noticeable effect on forces.
        constexpr double unit_length_tolerance = 1e-6;
        const double length = std::hypot(direction[0], direction[1], direction[2]);
        require(std::abs(length - 1) <= unit_length_tolerance, location, "is not a unit vector");
    }
    template <class List, class NameOf>
    void require_unique(const List& list, const std::string& location, NameOf name_of_item) const {
        std::set<std::string> seen;
        for (const auto& entry : list) {
            const std::string& text = name_of_item(entry);
            require_name(text, item(location, seen.size()));
            if (!seen.insert(text).second) refuse(item(location, seen.size()), core::quoted(text) + " occurs twice");
        }
    }
};

void check_points(const Checker& check) {
    const auto& points = check.mesh.points;
    check.require(!points.empty(), "/VTKHDF/Points", "there are no points");
    double max_radius = 0;
    double min_radius = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::all_of(points[i].begin(), points[i].end(), [](double x) { return std::isfinite(x); }))
            check.refuse(Checker::item("/VTKHDF/Points", i), "is not a finite number");
        max_radius = std::max(max_radius, points[i][1]);
        min_radius = std::min(min_radius, points[i][1]);
    }
    if (check.shape.kinematics == model::Kinematics::axisymmetric)
        check.require(min_radius >= -axis_tolerance * max_radius, "/VTKHDF/Points",
                      "a section has points at a negative radius");
}

void require_point(const Checker& check, mesh::Index point, const std::string& list, std::size_t i) {
    if (point < 0 || point >= static_cast<mesh::Index>(check.mesh.points.size()))
        check.refuse(Checker::item(list, i), "point " + std::to_string(point) + " does not exist");
}

// The loops over the mesh format messages only on failure: formatting texts for a million nodes would take a second.
void check_cells(const Checker& check) {
    const mesh::Mesh& mesh = check.mesh;
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
    const mesh::Mesh& mesh = check.mesh;
    const std::string cell = "cell " + std::to_string(facet.cell);
    if (facet.cell < 0 || facet.cell >= mesh.cell_count())
        check.refuse(Checker::item(list, i), cell + " does not exist");
    const auto count = static_cast<int>(mesh::topology(mesh.cell_type(facet.cell)).facets.size());
    if (facet.local < 0 || facet.local >= count)
        check.refuse(Checker::item(list, i), cell + " has no facet " + std::to_string(facet.local));
}

void check_sets(const Checker& check) {
    for (const auto& [name, facets] : check.mesh.facet_sets) {
        const std::string location = "/mesh/facets/" + name;
        check.require_name(name, location);
        for (std::size_t i = 0; i < facets.size(); ++i) check_facet(check, facets[i], location, i);
    }
    for (const auto& [name, points] : check.mesh.point_sets) {
        const std::string location = "/mesh/points/" + name;
        check.require_name(name, location);
        for (std::size_t i = 0; i < points.size(); ++i) require_point(check, points[i], location, i);
    }
}

void check_regions(const Checker& check) {
    check.require_unique(check.mesh.region_names, "/mesh/region_names", [](const std::string& name) { return name; });
    for (const auto& [region, winding] : check.shape.region_fibers) {
        const std::string location = "/shape/fibers";
        const material::Fibers& fibers = winding.fibers;
        check.require(std::isfinite(fibers.angle_rad), location + "/angle", "is not a finite number");
        check.require_positive(fibers.k1_Pa, location + "/k1");
        check.require_positive(fibers.k2, location + "/k2");
        check.require(fibers.families == 1 || fibers.families == 2, location + "/families", "must be 1 or 2");
    }
}

void check_cavity(const Checker& check, const model::Cavity& cavity, std::size_t i) {
    const std::string location = "/shape/cavities/";
    check.require_face(cavity.wall, Checker::item(location + "wall", i));
    for (const std::string& face : cavity.inner_faces) check.require_face(face, location + "inner_faces/face");
    for (const model::Opening& opening : cavity.openings) {
        check.require_face(opening.face, location + "openings/face");
        check.require_positive(opening.area_m2, location + "openings/area");
        check.require_unit(opening.direction, location + "openings/direction");
    }
}

/// Every facet must have a normal, on a segment in the plane of the section.
void check_obstacle(const Checker& check, const std::string& name, const model::FacetedSurface& surface) {
    const std::string location = "/shape/obstacles/" + name;
    const bool section = check.mesh.dimension == 2;
    check.require_name(name, location);
    check.require(!surface.facets.empty(), location + "/facets", "there are no facets");
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const mesh::Point& point = surface.points[i];
        if (!std::ranges::all_of(point, [](double x) { return std::isfinite(x); }) || (section && point[2] != 0))
            check.refuse(Checker::item(location + "/points", i), "is not a point of the model");
    }
    for (std::size_t i = 0; i < surface.facets.size(); ++i) {
        const auto& facet = surface.facets[i];
        const std::size_t corners = section ? 2 : 3;
        const auto exists = [&](int point) {
            return point >= 0 && static_cast<std::size_t>(point) < surface.points.size();
        };
        if (!std::all_of(facet.begin(), facet.begin() + corners, exists) || (section && facet[2] != -1))
            check.refuse(Checker::item(location + "/facets", i), "names a point that does not exist");
        const auto normal = model::facet_normal(surface, facet);
        if (!(std::hypot(normal[0], normal[1], normal[2]) > 0))
            check.refuse(Checker::item(location + "/facets", i), "is degenerate");
    }
}

void check_shape(const Checker& check) {
    const model::Shape& shape = check.shape;
    check.require(shape.model_fraction > 0 && shape.model_fraction <= 1, "/shape/model_fraction",
                  "must be greater than 0 and at most 1");
    check.require(check.mesh.dimension == model::dimension_of(shape.kinematics), "/shape/kinematics",
                  "is not that of the cells");
    check.require_unit(shape.axis, "/shape/axis");
    for (std::size_t i = 0; i < shape.supports.size(); ++i) {
        const model::Support& support = shape.supports[i];
        check.require_face(support.face, Checker::item("/shape/supports/face", i));
        check.require(support.fixed[0] || support.fixed[1] || support.fixed[2],
                      Checker::item("/shape/supports/fixed", i), "fixes no component");
    }
    check.require_unique(shape.cavities, "/shape/cavities/name",
                         [](const model::Cavity& cavity) { return cavity.name; });
    for (std::size_t i = 0; i < shape.cavities.size(); ++i) check_cavity(check, shape.cavities[i], i);
    for (const auto& [name, surface] : shape.obstacles) check_obstacle(check, name, surface);
}

}  // namespace

void check_case(const mesh::Mesh& mesh, const model::Shape& shape, std::string_view source, ExitCode code) {
    const Checker check{mesh, shape, source, code};
    check_points(check);
    check_cells(check);
    check_sets(check);
    check_regions(check);
    check_shape(check);
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
