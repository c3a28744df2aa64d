/// A mesh from a Gmsh file with the faces of the file, or a mesh generated inside the surface of a part.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/text.hpp"
#include "geometry/family.hpp"
#include "geometry/keys.hpp"
#include "geometry/openings.hpp"
#include "geometry/part.hpp"
#include "mesh/mesh.hpp"
#include "mesh/raise_order.hpp"
#include "meshing/import.hpp"
#include "meshing/pieces.hpp"

namespace soft::geometry {
namespace {

using mesh::Index;
using model::Kinematics;

constexpr const char* cavity_face = "cavity";
constexpr const char* outer_face = "outer";
constexpr const char* file_key = "geometry.file";

/// The mesh of the file. Faces of several pieces also appear piece by piece.
mesh::Mesh read(const std::string& file, std::string_view location, double file_unit_m) {
    mesh::Mesh mesh = meshing::import_mesh(design::file_from(location, file), file_unit_m);
    meshing::name_pieces(mesh);
    return mesh;
}

/// Whether the design contains the lines of an OBJ file instead of a file name.
bool is_inline(const std::string& file) { return file.find('\n') != std::string::npos; }

bool is_part(const std::string& file) { return is_inline(file) || meshing::is_part_file(file); }

struct FileUnit {
    std::string name;
    double length_m = 1;
};
meshing::Part part_of(const std::string& file, std::string_view location, const FileUnit& unit) {
    return is_inline(file) ? meshing::read_obj(file, unit.name, unit.length_m)
                           : meshing::read_part(design::file_from(location, file), unit.name, unit.length_m);
}

design::FileFaces faces_of_part(const meshing::Part& part) {
    design::FileFaces names;
    for (const meshing::Shell& shell : part.surface.shells) {
        names.faces.push_back(shell.name);
        if (shell.name != cavity_face && names.faces.size() > 1) names.cavities.push_back(shell.name);
    }
    return names;
}

design::FileFaces faces_of_file(const std::string& file, std::string_view location) {
    try {
        if (is_part(file)) return faces_of_part(part_of(file, location, {}));
        const mesh::Mesh mesh = read(file, location, 1.0);
        std::vector<std::string> faces;
        for (const auto& [name, facets] : mesh.facet_sets) faces.push_back(name);
        return {faces};
    } catch (const Error& error) {  // add the location in the design that names the file
        throw Error(error.code(), std::string{location} + ": " + file_key, error.what());
    }
}

Kinematics kinematics_of(const design::Values& values, const mesh::Mesh& mesh) {
    const std::string& model = values.text("model");
    if (mesh.dimension == 3 && model != "solid")
        throw values.refuse("model", core::quoted(model) + " needs a plane mesh, but the file contains a solid",
                            "use model: solid");
    if (mesh.dimension == 2 && model == "solid")
        throw values.refuse("model", "the file contains a plane mesh", "use axisymmetric or plane-strain");
    return model == "solid"          ? Kinematics::solid
           : model == "axisymmetric" ? Kinematics::axisymmetric
                                     : Kinematics::plane_strain;
}

/// Moves nodes within rounding of the axis onto it, and adds the facets on the axis as a face.
void add_axis(mesh::Mesh& mesh, const design::Values& values) {
    const double tolerance_m = mesh::plane_tolerance * mesh::extent_m(mesh);
    for (mesh::Point& p : mesh.points) {
        if (p[1] < -tolerance_m)
            throw values.refuse(file_key,
                                "a point lies at y = " + core::rounded_text(1e3 * p[1], 6) + " mm, below the axis",
                                "draw the section at y >= 0; the axis of revolution is x");
        if (std::abs(p[1]) <= tolerance_m) p[1] = 0;
    }
    std::vector<mesh::Facet> on_axis;
    for (const mesh::Facet& facet : boundary_facets(mesh)) {
        const auto nodes = facet_nodes(mesh, facet);
        if (std::all_of(nodes.begin(), nodes.end(), [&](Index node) { return mesh.point(node)[1] == 0; }))
            on_axis.push_back(facet);
    }
    const auto own = mesh.facet_sets.find(meshing::axis_face);
    if (own != mesh.facet_sets.end() && own->second != on_axis)
        throw values.refuse(file_key, "its face 'axis' is not the set of facets on the axis of revolution y = 0",
                            "rename the face");
    if (!on_axis.empty()) mesh.facet_sets[meshing::axis_face] = std::move(on_axis);
}

/// The key that states whether the load of a cavity is sealed; a cavity that shares gas uses the key of the other one.
std::string sealed_key(const design::Values& values, const std::string& cavity) {
    const std::string named = "loads.cavities." + cavity;
    if (values.has(named + ".shares")) return sealed_key(values, values.text(named + ".shares"));
    return values.has(named + ".sealed") ? named + ".sealed" : "loads.cavity.sealed";
}

/// The plugs that a sealed load needs. A plug without a single named face around it is attached to the facets next to it.
std::vector<model::Opening> plugs(mesh::Mesh& mesh, const design::Values& values, const std::string& cavity,
                                  Kinematics kinematics, const std::array<bool, 3>& cut) {
    const std::string sealed = sealed_key(values, cavity);
    const bool wanted = values.has(sealed) && values.text(sealed) == "true";
    std::vector<model::Opening> openings;
    for (FoundOpening& found : openings_of(mesh, mesh.facet_sets.at(cavity), kinematics, cut)) {
        if (found.opening.face.empty()) {
            if (wanted)
                throw values.refuse(
                    sealed, "no single named face surrounds an opening of the cavity, so its plug cannot be attached",
                    "use sealed: false, or name the face around the hole in the mesh");
            found.opening.face = cavity + "_rim_" + std::to_string(openings.size() + 1);
            mesh.facet_sets[found.opening.face] = std::move(found.around);
        }
        openings.push_back(std::move(found.opening));
    }
    return openings;
}

/// Combines the listed faces to the wall of the cavity, a face of its name. A face of the file may already have that name.
void add_wall(mesh::Mesh& mesh, const design::Values& values, const std::string& key, const std::string& cavity) {
    const std::string& text = values.text(key);
    const bool named = mesh.facet_sets.contains(cavity);
    if (text == "none" || text == cavity) {
        if (!named)
            throw values.refuse(key, "the file has no face " + core::quoted(cavity),
                                "list the faces of the cavity wall");
        return;
    }
    if (named)
        throw values.refuse(key, "the file already has a face called " + core::quoted(cavity),
                            "rename it, or use " + cavity + ": " + cavity);
    std::set<mesh::Facet> all;
    for (const std::string& name : listed(text)) {
        const auto face = mesh.facet_sets.find(name);
        if (face == mesh.facet_sets.end())
            throw values.refuse(key, "the file has no face " + core::quoted(name), "remove it from the list");
        all.insert(face->second.begin(), face->second.end());
    }
    mesh.facet_sets[cavity].assign(all.begin(), all.end());
}

/// Pressure on a facet of two cavities would act twice.
void refuse_common_walls(const mesh::Mesh& mesh, const design::Values& values,
                         const std::vector<model::Cavity>& cavities) {
    std::map<mesh::Facet, std::string> owners;
    for (const model::Cavity& cavity : cavities)
        for (const mesh::Facet& facet : mesh.facet_sets.at(cavity.wall))
            if (const auto [owner, fresh] = owners.try_emplace(facet, cavity.name); !fresh)
                throw values.refuse("geometry.cavities." + cavity.name,
                                    "its wall shares facets with that of " + core::quoted(owner->second),
                                    "assign each face to one cavity");
}

/// Cavities that the design names, and the closed cavities of a part.
std::vector<model::Cavity> add_cavities(mesh::Mesh& mesh, const design::Values& values, Kinematics kinematics,
                                        const std::vector<std::string>& closed = {},
                                        const std::array<bool, 3>& cut = {}) {
    constexpr const char *key = "geometry.cavity", *group = "geometry.cavities";
    std::vector<std::string> names = values.names_below(group);
    for (const std::string& name : names) add_wall(mesh, values, std::string{group} + "." + name, name);
    const bool own = std::ranges::find(names, cavity_face) == names.end();
    if (own && (values.text(key) != "none" || mesh.facet_sets.contains(cavity_face))) {
        add_wall(mesh, values, key, cavity_face);
        names.insert(names.begin(), cavity_face);
    }
    for (const std::string& name : closed)
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    std::vector<model::Cavity> cavities;
    for (const std::string& name : names) cavities.push_back({name, name, {}, {}});
    refuse_common_walls(mesh, values, cavities);
    for (model::Cavity& cavity : cavities) cavity.openings = plugs(mesh, values, cavity.name, kinematics, cut);
    return cavities;
}

mesh::Mesh with_requested_order(mesh::Mesh mesh, const design::Values& values) {
    const bool first = mesh::topology(mesh.cell_types.front()).order == 1;
    if (!first || values.text("mesh.order") != "2") return mesh;
    if (values.text("mesh.raise_order") == "false")
        throw values.refuse("mesh.raise_order", "the file contains first-order cells", "use true, or order: 1");
    return raise_order(mesh);
}

std::vector<design::Key> surface_mesh_keys() {
    design::Key size = size_key(), through_wall = through_wall_key(), grading = grading_key("4");
    size.meaning = "for surfaces: longest edge of a cell; auto: a twentieth of the part, scaled by mesh.quality";
    through_wall.meaning =
        "for surfaces: cells through walls thinner than mesh.size; 0 = from mesh.size; auto: 2 (draft 1, fine 3)";
    grading.meaning =
        "for surfaces: ratio of longest to shortest cell; cells get shorter at tight bends and thin walls; 1 = uniform";
    return {size, through_wall, grading};
}

/// The body is a part of the whole, held at the planes at which it is cut; their faces.
std::vector<std::string> hold_cuts(Body& body, const design::Values& values) {
    body.symmetry_planes = cuts(values);
    std::vector<std::string> faces;
    for (std::size_t c = 0; c < 3; ++c) {
        if (!body.symmetry_planes[c]) continue;
        body.fraction /= 2;
        faces.emplace_back(symmetry_faces[c]);
        model::Support& support = body.supports.emplace_back(model::Support{symmetry_faces[c], {}});
        support.fixed[c] = true;
    }
    return faces;
}

/// Generates the cells of a part. Closed cavities are detected automatically; the wall of a cavity is not part of `outer`.
Body build_part(const design::Values& values) {
    const std::string &file = values.text(file_key), &unit = values.text("geometry.unit");
    if (!is_inline(file) && meshing::is_cad_file(file) && unit != "mm")
        throw values.refuse("geometry.unit", "a STEP file defines its own unit", "remove this key");
    MeshedPart part = mesh_part(part_of(file, values.location(file_key), {unit, file_unit_m(unit)}), values);
    ReadyMesh ready{std::move(part.mesh), Kinematics::solid};
    ready.kinematics = kinematics_of(values, ready.mesh);
    meshing::name_pieces(ready.mesh);
    Body body;
    std::vector<std::string> not_outer = hold_cuts(body, values);
    body.cavities = add_cavities(ready.mesh, values, ready.kinematics, part.cavities, body.symmetry_planes);
    for (const model::Cavity& cavity : body.cavities) not_outer.push_back(cavity.wall);
    for (const std::string& name : not_outer) {
        const auto& facets = ready.mesh.facet_sets.at(name);
        const std::set<mesh::Facet> own(facets.begin(), facets.end());
        std::erase_if(ready.mesh.facet_sets.at(outer_face),
                      [&](const mesh::Facet& facet) { return own.contains(facet); });
    }
    body.sweep = std::move(ready);
    body.part = std::move(part.figures);
    return body;
}

void refuse_part_keys(const design::Values& values) {
    static const std::map<std::string, std::string> defaults = [] {  // templates state these keys
        std::map<std::string, std::string> all{{"mesh.quality", "normal"}};
        for (const design::Key& key : surface_mesh_keys()) all[key.path] = key.fallback;
        return all;
    }();
    for (const auto& [key, fallback] : defaults)
        if (values.given(key) && values.text(key) != fallback)
            throw values.refuse(
                key, "a mesh file already contains cells, and this key applies to surfaces (.stl, .obj, .step)",
                "use mesh.refine: 1 to halve the cells");
    if (const auto rules = face_rules(values); !rules.empty())
        throw values.refuse(
            "geometry.file",
            "a mesh file defines its faces by physical groups, and geometry.faces applies to surfaces (.stl, .obj, .step)",
            "remove geometry.faces");
}

Body build(const design::Values& values) {
    if (is_part(values.text(file_key))) return build_part(values);
    refuse_part_keys(values);
    ReadyMesh ready{read(values.text(file_key), values.location(file_key), file_unit_m(values.text("geometry.unit"))),
                    Kinematics::solid};
    ready.kinematics = kinematics_of(values, ready.mesh);
    if (ready.kinematics == Kinematics::axisymmetric) add_axis(ready.mesh, values);
    Body body;
    if (ready.kinematics == Kinematics::axisymmetric && ready.mesh.facet_sets.contains(meshing::axis_face))
        body.supports = {{meshing::axis_face, {false, true, false}}};
    if (values.text("geometry.symmetry") != "none" && ready.kinematics != Kinematics::solid)
        throw values.refuse("geometry.symmetry", "applies to solids, and the file contains a plane mesh",
                            "support the plane, as {x: face}");
    name_cuts(ready.mesh, values);
    hold_cuts(body, values);
    body.cavities = add_cavities(ready.mesh, values, ready.kinematics, {}, body.symmetry_planes);
    ready.mesh = with_requested_order(std::move(ready.mesh), values);
    body.sweep = std::move(ready);
    return body;
}

std::vector<design::Key> geometry_keys() {
    using design::Kind;
    return {
        {.path = file_key,
         .kind = Kind::text,
         .meaning =
             "mesh (Gmsh .msh 2.2 or 4.1) or surface (.stl, .obj, .step) of the part, relative to the design file; or (file: |) "
             "the lines of an OBJ file",
         .max_count = several_lines},
        file_unit_key("geometry.unit"),
        {.path = "geometry.cavity",
         .kind = Kind::faces,
         .fallback = "none",
         .meaning = "faces that form the wall of the cavity of loads.cavity; cavities: {name: faces, ...} for several",
         .choices = {"none"}},
        {.path = "geometry.symmetry",
         .kind = Kind::choice,
         .fallback = "none",
         .meaning =
             "the planes x, y, z = 0 at which the solid in the file is cut; faces of a surface are named by the key faces: {name: "
             "{plane: {x: 0 mm} | box: {from: [x, y, z], to: ..} | normal: [x, y, z] | point: [x, y, z], up_to: faces}}",
         .choices = {"none", "x", "y", "z", "xy", "xz", "yz", "xyz"}}};
}

std::vector<design::Key> mesh_keys() {
    using design::Kind;
    std::vector<design::Key> keys = surface_mesh_keys();
    const std::vector<design::Key> more{
        {.path = "mesh.order",
         .kind = Kind::count,
         .fallback = "file",
         .meaning = "polynomial order of the cells; mixed needs 2",
         .min = 1,
         .max = 2,
         .choices = {"file"}},
        {.path = "mesh.raise_order",
         .kind = Kind::flag,
         .fallback = "true",
         .meaning = "order: 2 may add straight mid nodes to first-order cells of the file"},
        {.path = "mesh.cells",
         .kind = Kind::choice,
         .fallback = "auto",
         .meaning = "auto: as in the file; simplices: each split into triangles or tetrahedra",
         .choices = {"auto", "simplices"}}};
    keys.insert(keys.end(), more.begin(), more.end());
    return keys;
}

}  // namespace

/// A box of 40 x 12 x 12 mm with a closed cavity of 34 x 6 x 3 mm below its middle; it bends when inflated. Lengths in mm.
constexpr const char* imported_obj = R"(v 0 -6 -6
v 40 -6 -6
v 40 6 -6
v 0 6 -6
v 0 -6 6
v 40 -6 6
v 40 6 6
v 0 6 6
v 3 -3 -4
v 37 -3 -4
v 37 3 -4
v 3 3 -4
v 3 -3 -1
v 37 -3 -1
v 37 3 -1
v 3 3 -1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
f 9 10 11 12
f 16 15 14 13
f 13 14 10 9
f 14 15 11 10
f 15 16 12 11
f 16 13 9 12
)";

Family imported() {
    design::FamilyKeys keys;
    keys.name = "imported";
    keys.summary = "a mesh (.msh) or the surface of a part (.stl, .obj, .step) from a file";
    keys.geometry = geometry_keys();
    keys.models = {"solid", "axisymmetric", "plane-strain"};
    keys.faces = {"outer", "cavity"};  // of the template's surface
    keys.defaults = std::string{"geometry:\n"} + block("file", imported_obj) +
                    "  faces:\n"
                    "    fixed: {plane: {x: 0 mm}}\n"
                    "    tip: {plane: {x: 40 mm}}\n"
                    "mesh: {size: 4 mm}\n"
                    "supports: {fixed: fixed}\n"
                    "loads:\n"
                    "  cavity: {pressure: 30 kPa, sealed: false}\n"
                    "outputs:\n"
                    "  deflection: {face: tip, along: z}\n";
    keys.mesh = mesh_keys();
    keys.faces_of_file = faces_of_file;
    keys.has_face_rules = true;
    return {std::move(keys), build};
}

}  // namespace soft::geometry
