#include "geometry/part.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "core/text.hpp"
#include "geometry/cell_size.hpp"
#include "geometry/keys.hpp"
#include "meshing/body_mesher.hpp"

namespace soft::geometry {
namespace {

constexpr const char* rules_group = "geometry.faces";
constexpr const char* symmetry_key = "geometry.symmetry";

meshing::FaceRule rule_of(const design::Values& values, const std::string& name) {
    constexpr double usual_within_rad = 10 * std::numbers::pi / 180;
    const std::string own = std::string{rules_group} + "." + name + ".";
    meshing::FaceRule rule{name, {}, {}, {}, {}};
    const std::array<const char*, 3> planes{"plane.x", "plane.y", "plane.z"};
    for (std::size_t c = 0; c < 3; ++c) {
        if (!values.has(own + planes[c])) continue;
        if (rule.plane) throw values.refuse(own + planes[c], "only one plane is possible", "use x, y or z alone");
        rule.plane = meshing::FaceRule::Plane{c, values.number(own + planes[c])};
    }
    if (values.has(own + "box.from") != values.has(own + "box.to"))
        throw values.refuse(own + (values.has(own + "box.from") ? "box.from" : "box.to"), "a box needs two corners",
                            "use box: {from: [x, y, z], to: [x, y, z]}");
    if (values.has(own + "box.from"))
        rule.box = meshing::FaceRule::Box{point_of(values, own + "box.from"), point_of(values, own + "box.to")};
    if (values.has(own + "within") && !values.has(own + "normal"))
        throw values.refuse(own + "within", "within needs a normal", "add normal: [x, y, z]");
    if (values.has(own + "normal")) {
        rule.direction =
            meshing::FaceRule::Direction{point_of(values, own + "normal"),
                                         values.has(own + "within") ? values.number(own + "within") : usual_within_rad};
        if (rule.direction->normal == mesh::Point{})
            throw values.refuse(own + "normal", "the normal is zero", "use a direction such as [1, 0, 0]");
    }
    if (values.has(own + "up_to") && !values.has(own + "point"))
        throw values.refuse(own + "up_to", "up_to needs a point", "add point: [x, y, z]");
    if (values.has(own + "point"))
        rule.flood = meshing::FaceRule::Flood{point_of(values, own + "point"), values.has(own + "up_to")
                                                                                   ? listed(values.text(own + "up_to"))
                                                                                   : std::vector<std::string>{}};
    return rule;
}

/// Of the extent of a part: distance from a plane within which a point lies on it.
constexpr double rounding = 1e-6;

/// A part with a symmetry plane must lie on one side of it.
void refuse_crossing(const std::vector<mesh::Point>& points, double extent_m, const std::array<bool, 3>& cut,
                     const design::Values& values) {
    for (std::size_t c = 0; c < 3; ++c) {
        if (!cut[c]) continue;
        const auto [low, high] = std::ranges::minmax(points, {}, [c](const mesh::Point& p) { return p[c]; });
        if (std::min(-low[c], high[c]) > rounding * extent_m)
            throw values.refuse(symmetry_key,
                                std::string{"the part extends from "} + "xyz"[c] + " = " + length_text(low[c]) +
                                    " to " + length_text(high[c]) + " and is not cut at 0",
                                "cut it in the CAD program, or remove this plane");
    }
}

/// Adds the cuts as faces; no flood crosses them.
std::vector<meshing::FaceRule> with_cuts(std::vector<meshing::FaceRule> rules, const std::array<bool, 3>& cut) {
    std::vector<meshing::FaceRule> all;
    for (std::size_t c = 0; c < 3; ++c)
        if (cut[c]) all.push_back({symmetry_faces[c], meshing::FaceRule::Plane{c, 0}, {}, {}, {}});
    for (meshing::FaceRule& rule : rules)
        if (rule.flood && !rule.flood->up_to.empty())
            for (std::size_t c = 0; c < 3; ++c)
                if (cut[c]) rule.flood->up_to.emplace_back(symmetry_faces[c]);
    all.insert(all.end(), rules.begin(), rules.end());
    return all;
}

void put_on_planes(mesh::Mesh& mesh, const std::array<bool, 3>& cut) {
    for (std::size_t c = 0; c < 3; ++c) {
        const auto face = mesh.facet_sets.find(symmetry_faces[c]);
        if (!cut[c] || face == mesh.facet_sets.end()) continue;
        for (const mesh::Facet& facet : face->second)
            for (const mesh::Index node : facet_nodes(mesh, facet)) mesh.points[static_cast<std::size_t>(node)][c] = 0;
    }
}

}  // namespace

double file_unit_m(const std::string& unit) {
    static const std::map<std::string, double> units{{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"in", 0.0254}};
    const auto found = units.find(unit);
    if (found == units.end())
        throw Error(ExitCode::usage, "geometry.unit", core::quoted(unit) + " is not a unit of a file",
                    "use mm, cm, m or in");
    return found->second;
}

std::vector<meshing::FaceRule> face_rules(const design::Values& values) {
    std::vector<meshing::FaceRule> rules, floods;  // floods refer to faces of the other rules
    for (const std::string& name : values.names_below(rules_group)) {
        meshing::FaceRule rule = rule_of(values, name);
        (rule.flood && !rule.flood->up_to.empty() ? floods : rules).push_back(std::move(rule));
    }
    for (const meshing::FaceRule& rule : floods)
        for (const std::string& border : rule.flood->up_to)
            if (std::ranges::find(rules, border, &meshing::FaceRule::name) == rules.end())
                throw values.refuse(std::string{rules_group} + "." + rule.name + ".up_to",
                                    core::quoted(border) + " is not a face of geometry.faces without up_to",
                                    "use faces defined by plane, box, normal or point");
    rules.insert(rules.end(), floods.begin(), floods.end());
    return rules;
}

std::array<bool, 3> cuts(const design::Values& values) {
    const std::string& planes = values.text(symmetry_key);
    std::array<bool, 3> cut{};
    if (planes == "none") return cut;
    for (std::size_t c = 0; c < 3; ++c) cut[c] = planes.find("xyz"[c]) != std::string::npos;
    return cut;
}

void name_cuts(mesh::Mesh& mesh, const design::Values& values) {
    const std::array<bool, 3> cut = cuts(values);
    const double extent_m = mesh::extent_m(mesh);
    refuse_crossing(mesh.points, extent_m, cut, values);
    const std::vector<mesh::Facet> boundary = boundary_facets(mesh);
    for (std::size_t c = 0; c < 3; ++c) {
        if (!cut[c]) continue;
        std::vector<mesh::Facet> facets;
        std::ranges::copy_if(boundary, std::back_inserter(facets), [&](const mesh::Facet& facet) {
            return std::ranges::all_of(facet_nodes(mesh, facet), [&](mesh::Index node) {
                return std::abs(mesh.point(node)[c]) <= rounding * extent_m;
            });
        });
        const std::string plane = std::string{"xyz"[c]} + " = 0";
        if (facets.empty())
            throw values.refuse(symmetry_key, "no facet of the mesh lies in the plane " + plane,
                                "cut the mesh there, or remove this plane");
        const auto own = mesh.facet_sets.find(symmetry_faces[c]);
        if (own != mesh.facet_sets.end() && own->second != facets)
            throw values.refuse("geometry.file",
                                "its face " + core::quoted(symmetry_faces[c]) + " is not all of the plane " + plane,
                                "rename the face");
        mesh.facet_sets[symmetry_faces[c]] = std::move(facets);
    }
    put_on_planes(mesh, cut);
}

MeshedPart mesh_part(const meshing::Part& part, const design::Values& values) {
    MeshedPart result;
    const std::array<bool, 3> cut = cuts(values);
    refuse_crossing(part.surface.points, part.surface.extent_m(), cut, values);
    const std::vector<meshing::Wall> walls = meshing::walls(part.surface.points, part.surface.triangles);
    result.figures = {part.origin.name, part.surface.triangles.size(), part.surface.volume_m3(),
                      walls.empty() ? meshing::WallStatistics{} : meshing::wall_statistics(walls),
                      part.surface.repairs};
    for (std::size_t s = 1; s < part.surface.shells.size(); ++s) result.cavities.push_back(part.surface.shells[s].name);
    const std::vector<meshing::NamedFace> faces = named_faces(part.surface, with_cuts(face_rules(values), cut));
    for (const meshing::NamedFace& face : faces)
        if (std::ranges::find(face.facets, true) == face.facets.end()) {
            std::string first = face.name.starts_with("symmetry_") ? symmetry_key : "";  // a key of the rule
            for (const char* key : {"plane.x", "plane.y", "plane.z", "box.from", "normal", "point"})
                if (const std::string path = std::string{rules_group} + "." + face.name + "." + key;
                    first.empty() && values.has(path))
                    first = path;
            throw values.refuse(first, "no facet of the surface matches this rule",
                                "check the coordinates in the CAD program");
        }
    constexpr int own_along = 20, own_through = 2;
    const double max_m = CellSize{values, part.surface.extent_m() / own_along}.length_m();
    const int through = values.text("mesh.through_wall") == "auto" ? scaled_count(values, own_through)
                                                                   : values.count("mesh.through_wall");
    const meshing::WallSizes sizes(walls, bends(part.surface), {max_m / values.number("mesh.grading"), max_m, through});
    result.mesh = meshing::mesh_inside({part.surface, faces, part.origin}, sizes);
    put_on_planes(result.mesh, cut);
    return result;
}

}  // namespace soft::geometry
