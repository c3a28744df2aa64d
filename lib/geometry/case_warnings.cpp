#include "geometry/case_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.hpp"
#include "core/units.hpp"
#include "math/vector.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/quality.hpp"
#include "model/cavity_surface.hpp"
#include "model/location.hpp"
#include "surface/volume.hpp"

namespace soft::geometry {
namespace {

/// From a valve in a chip to an arm; outside this range a unit is most likely wrong.
constexpr double min_m = 2e-3, max_m = 3;
/// Ambient pressures from a vacuum chamber to a depth of a kilometre of water.
constexpr double min_ambient_Pa = 1e3, max_ambient_Pa = 10e6;
/// Densities of gases at room temperature relative to air: hydrogen 0.07, sulphur hexafluoride 5.1.
constexpr double min_density_ratio = 0.05, max_density_ratio = 6.0;
/// A balloon grows a thousandfold; a supply line contains at most a thousand times the volume of its actuator.
constexpr double max_gas_ratio = 1e3;
/// Of the extent of a rim: its distance from a plane, as of a bore in the side of a cylinder.
constexpr double flat_rim = 0.05;
/// Relative component of a direction; smaller values are rounding.
constexpr double across = 1e-9;

using Warnings = std::vector<std::string>;

void check_size(const design::Design& design, const model::Case& built, Warnings& warnings) {
    const double extent_m = mesh::extent_m(built.mesh);
    if (extent_m >= min_m && extent_m <= max_m) return;
    const std::string text = core::quantity_text(extent_m, core::Dimension::length);
    if (design.values.has("geometry.unit"))
        warnings.push_back("geometry.unit: the part is " + text + " long; are the file's lengths in " +
                           design.values.text("geometry.unit") + "?" +
                           (extent_m < min_m ? " For inches use `unit: in`" : ""));
    else
        warnings.push_back("geometry: the body is " + text +
                           " long; soft actuators measure 2 mm to 3 m, check the units");
}

/// Checks dead loads; add_loads rejects forces, gravity and motions across a plane.
void check_symmetry(const model::Case& built, Warnings& warnings) {
    static constexpr std::array planes{"x = 0", "y = 0", "z = 0"};
    for (const model::DeadLoad& load : built.dead_loads) {
        const auto& vector = load.vector_SI;
        const double size = std::hypot(vector[0], vector[1], vector[2]);
        for (std::size_t d = 0; d < 3; ++d)
            if (built.symmetry_planes[d] && std::abs(vector[d]) > across * size)
                warnings.push_back("loads." + load.name + ": acts across the symmetry plane " + planes[d] +
                                   ", so the mirror image is loaded in the opposite direction; use the whole body "
                                   "(model: solid)");
    }
}

/// Whether all nodes of a face belong to faces that supports fix in a direction.
bool is_fixed_face(const model::Case& built, const std::string& face, const std::array<double, 3>& direction) {
    std::vector<std::array<bool, 3>> fixed(built.mesh.points.size());
    const auto nodes_of = [&](const std::string& name, const auto& visit) {
        const auto set = built.mesh.facet_sets.find(name);
        if (set == built.mesh.facet_sets.end()) return;
        for (const mesh::Facet& facet : set->second)
            for (const mesh::Index node : mesh::facet_nodes(built.mesh, facet)) visit(static_cast<std::size_t>(node));
    };
    for (const model::Support& support : built.supports)
        nodes_of(support.face, [&](std::size_t node) {
            for (std::size_t d = 0; d < 3; ++d) fixed[node][d] = fixed[node][d] || support.fixed[d];
        });
    bool all = true, any = false;
    nodes_of(face, [&](std::size_t node) {
        any = true;
        for (std::size_t d = 0; d < 3; ++d) all = all && (std::abs(direction[d]) <= across || fixed[node][d]);
    });
    return any && all;
}

void check_outputs(const model::Case& built, Warnings& warnings) {
    for (const model::Output& output : built.outputs)
        if (output.measure == model::Measure::displacement && !output.obstacle.empty()) {
            if (std::ranges::find(built.motions, output.obstacle, &model::Motion::face) == built.motions.end())
                warnings.push_back("outputs." + output.name + ": no load moves the obstacle " + output.obstacle +
                                   ", so its displacement stays 0; write loads." + output.obstacle +
                                   ": {displacement: ...}");
        } else if (output.measure == model::Measure::displacement &&
                   is_fixed_face(built, output.face, output.direction))
            warnings.push_back(
                "outputs." + output.name + ": supports fix the face " + output.face +
                " in this direction, so its displacement stays 0; measure a free face, or the reaction (measure: force)");
}

void check_outside(const model::Case& built, Warnings& warnings) {
    if (built.cavities.size() != 1 || built.loads.size() != 1 || model::first_traction(built) || !built.motions.empty())
        return;
    const std::string& target = built.loads.front().targets.front();
    if (target == built.cavities.front().name || target == built.cavities.front().wall) return;
    warnings.push_back("loads." + built.loads.front().name + ": acts on the face " + target +
                       " while the cavity is not loaded; use loads." + built.cavities.front().name + " to inflate it");
}

double gas_volume_m3(const model::Case& built, const model::PressureLoad& load) {
    double volume_m3 = 0;
    for (const model::Cavity& cavity : built.cavities)
        if (std::ranges::find(load.targets, cavity.name) != load.targets.end())
            volume_m3 += surface::enclosed_volume_m3(built, model::cavity_facets(built, cavity), built.mesh.points);
    return volume_m3;
}

/// The largest gas mass of the path's stages.
double max_mass_kg(const model::Case& built, std::size_t load) {
    double mass_kg = 0;
    for (const model::Stage& stage : built.path.stages)
        if (load < stage.supplies.size() && stage.supplies[load].what == model::Prescription::mass)
            mass_kg = std::max(mass_kg, stage.supplies[load].value);
    return mass_kg;
}

void check_gas(const model::Case& built, Warnings& warnings) {
    for (std::size_t i = 0; i < built.loads.size(); ++i) {
        const model::PressureLoad& load = built.loads[i];
        const std::string path = "loads." + load.name + ".";
        const auto text = core::quantity_text;
        const model::Gas &gas = load.gas, air;
        const double air_density = air.ambient_density_kg_m3 * gas.ambient_Pa / air.ambient_Pa;
        const double density_ratio = gas.ambient_density_kg_m3 / air_density;
        if (gas.ambient_Pa < min_ambient_Pa || gas.ambient_Pa > max_ambient_Pa)
            warnings.push_back(path + "gas.ambient: " + text(gas.ambient_Pa, core::Dimension::pressure) +
                               " is an unusual ambient pressure (usual: 1 kPa to 10 MPa, absolute); check the unit "
                               "(standard: 101.325 kPa)");
        else if (density_ratio < min_density_ratio || density_ratio > max_density_ratio)
            warnings.push_back(path + "gas.density: no gas has a density of " +
                               text(gas.ambient_density_kg_m3, core::Dimension::density) + " at " +
                               text(gas.ambient_Pa, core::Dimension::pressure) + " and room temperature; air has " +
                               text(air_density, core::Dimension::density));
        const double cavity_m3 = built.kinematics == model::Kinematics::plane_strain ? 0.0 : gas_volume_m3(built, load);
        if (!(cavity_m3 > 0)) continue;
        if (gas.dead_volume_m3 > max_gas_ratio * cavity_m3)
            warnings.push_back(path + "gas.dead_volume: " + text(gas.dead_volume_m3, core::Dimension::volume) +
                               " is more than a thousand times the cavity volume, " +
                               text(cavity_m3, core::Dimension::volume) + "; check the unit");
        const double mass_kg = max_mass_kg(built, i),
                     content_kg = gas.ambient_density_kg_m3 * (cavity_m3 + gas.dead_volume_m3);
        if (mass_kg > max_gas_ratio * content_kg)
            warnings.push_back(path + "mass: " + text(mass_kg, core::Dimension::mass) +
                               " is more than a thousand times the gas at ambient pressure, " +
                               text(content_kg, core::Dimension::mass) + "; check the unit");
    }
}

/// Of a rim: its largest distance from a plane through its mean, and its extent [m].
struct RimShape {
    double off_plane = 0, extent = 0;
};
RimShape shape_of(const mesh::Mesh& mesh, const std::vector<model::RimEdge>& rim) {
    Vector3 mean{}, area{};
    for (const model::RimEdge& edge : rim)
        mean = along(mean, 1.0 / static_cast<double>(rim.size()), mesh.point(edge[0]));
    for (const model::RimEdge& edge : rim)
        area = along(area, 1.0, cross(difference(mesh.point(edge[0]), mean), difference(mesh.point(edge[1]), mean)));
    RimShape shape;
    for (const model::RimEdge& edge : rim) {
        const Vector3 from_mean = difference(mesh.point(edge[0]), mean);
        shape.extent = std::max(shape.extent, 2 * norm(from_mean));
        if (norm(area) > 0) shape.off_plane = std::max(shape.off_plane, std::abs(dot(from_mean, area)) / norm(area));
    }
    return shape;
}

/// The volume of a cavity is that up to a cone over each rim (surface/volume.hpp).
void check_rims(const model::Case& built, Warnings& warnings) {
    if (built.kinematics != model::Kinematics::solid) return;
    for (const model::Cavity& cavity : built.cavities)
        for (const auto& rim : model::rims(built, model::cavity_facets(built, cavity)))
            if (const RimShape shape = shape_of(built.mesh, rim); shape.off_plane > flat_rim * shape.extent)
                warnings.push_back(
                    "geometry: the rim of " + cavity.name + " is up to " +
                    core::quantity_text(shape.off_plane, core::Dimension::length) +
                    " off a plane; the volume of the cavity is that up to a cone over the rim. If the file "
                    "contains a part of the body that is cut at planes, set geometry.symmetry");
}

/// Checks drawn or imported shapes, whose faces the user names.
void check_openings(const design::Design& design, const model::Case& built, Warnings& warnings) {
    const auto is_loaded_and = [&](const model::Cavity& cavity, bool sealed) {
        return std::ranges::any_of(built.loads, [&](const model::PressureLoad& load) {
            return load.sealed == sealed && std::ranges::find(load.targets, cavity.name) != load.targets.end();
        });
    };
    constexpr const char* sealed_key = "loads.cavity.sealed";
    for (const char* key : {"geometry.profile", "geometry.file"}) {
        if (!design.values.has(key)) continue;
        for (const model::Cavity& cavity : built.cavities) {
            const std::size_t count = cavity.openings.size();
            if (count > 1)
                warnings.push_back(std::string{key} + ": " + cavity.name + " has " + std::to_string(count) +
                                   " openings, " +
                                   (is_loaded_and(cavity, true) ? "which a sealed load plugs"
                                                                : "on whose plugs no pressure acts (sealed: false)") +
                                   "; if an opening is not an inlet, name the face there " + cavity.wall);
            const bool is_default =
                cavity.name == "cavity" && design.values.has(sealed_key) && !design.values.given(sealed_key);
            if (count == 1 && is_loaded_and(cavity, false) && is_default)
                warnings.push_back(std::string{sealed_key} +
                                   ": false, the default of a file: no pressure acts on the plug of the opening; state "
                                   "sealed: true or false");
        }
    }
}

/// Number of parts whose cells are connected by nodes.
std::size_t parts_of(const mesh::Mesh& mesh) {
    mesh::DisjointSets groups(mesh.points.size());
    const auto corner = [&](mesh::Index c, std::size_t k) { return static_cast<std::size_t>(mesh.cell_nodes(c)[k]); };
    for (mesh::Index c = 0; c < mesh.cell_count(); ++c)
        for (std::size_t k = 1; k < mesh.cell_nodes(c).size(); ++k) groups.unite(corner(c, k), corner(c, 0));
    std::set<std::size_t> found;
    for (mesh::Index c = 0; c < mesh.cell_count(); ++c) found.insert(groups.first(corner(c, 0)));
    return found.size();
}

/// Stresses in a cell whose Jacobian varies more than tenfold are unreliable.
void check_quality(const model::Case& built, Warnings& warnings) {
    constexpr double poor = 0.1;
    const mesh::Quality quality = mesh::quality(built.mesh);
    if (quality.min_scaled_jacobian >= poor) return;
    warnings.push_back(
        "mesh: worst scaled Jacobian " + core::rounded_text(quality.min_scaled_jacobian, 2) + " at " +
        model::location_text(built.kinematics, quality.worst_position_m) +
        ", below 0.1 stresses in the cell are unreliable and steps may fail; use a smaller mesh.size or a "
        "smoother shape there");
}

}  // namespace

std::vector<std::string> case_warnings(const design::Design& design, const model::Case& built) {
    Warnings warnings;
    check_size(design, built, warnings);
    check_symmetry(built, warnings);
    check_outputs(built, warnings);
    check_outside(built, warnings);
    check_openings(design, built, warnings);
    check_rims(built, warnings);
    check_quality(built, warnings);
    check_gas(built, warnings);
    if (design.values.has("geometry.file"))
        if (const std::size_t parts = parts_of(built.mesh); parts > 1)
            warnings.push_back(
                "geometry.file: the mesh has " + std::to_string(parts) +
                " parts that share no nodes and are not bonded; mesh them together (coherence) or merge the nodes where they meet");
    return warnings;
}

}  // namespace soft::geometry
