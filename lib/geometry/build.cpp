#include "geometry/build.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "core/text.hpp"
#include "element/reference_cell.hpp"
#include "geometry/section_mesher.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/raise_order.hpp"
#include "mesh/refine.hpp"
#include "mesh/split.hpp"
#include "model/rubber.hpp"

namespace soft::geometry {
namespace {

const Family& family_named(const std::string& name) {
    for (const Family& family : catalogue())
        if (family.keys.name == name) return family;
    throw Error(ExitCode::bad_input, "family", "no family is called " + core::quoted(name));
}

constexpr double most_cells = 5e6;

/// A slip in mesh.size must not fill the memory before anybody can say so.
void refuse_too_many(const Body& body, const design::Values& values) {
    const auto cells_along = [&](const std::vector<int>& side) {
        double cells = 0;
        for (std::size_t i = 0; i + 1 < side.size(); ++i)
            cells += body.section.curves[static_cast<std::size_t>(curve_between(body.section, {side[i], side[i + 1]}))].cells;
        return cells;
    };
    double cells = 0;
    for (const Block& block : body.section.blocks) cells += cells_along(block.sides[0]) * cells_along(block.sides[1]);
    const Model model = model_of(values);
    if (const auto* revolution = std::get_if<Revolution>(&body.sweep)) {
        if (model != Model::axisymmetric) cells *= revolution->sectors_per_quarter;
        if (model == Model::half) cells *= 2;
        if (model == Model::solid) cells *= 4;
    } else if (model != Model::plane_strain) {
        cells *= std::get<Extrusion>(body.sweep).layers;
    }
    if (cells > most_cells)
        throw values.refuse("mesh.size", "it would take " + core::rounded_text(cells, 2) + " cells", "a larger size");
}

Solid revolved(const mesh::Mesh& section, const Body& body, const Revolution& revolution, Model model) {
    Solid solid{{}, model::Kinematics::solid, body.symmetry_planes, body.fraction};
    switch (model) {
        case Model::axisymmetric:
            solid.mesh = section;
            solid.kinematics = model::Kinematics::axisymmetric;
            break;
        case Model::plane_strain: throw std::logic_error("a body of revolution has no plane strain");
        case Model::solid: solid.mesh = revolve(section, Turn::full, revolution.sectors_per_quarter); break;
        case Model::half:
            solid.mesh = revolve(section, Turn::half, revolution.sectors_per_quarter);
            solid.symmetry_planes[1] = true;
            solid.fraction *= 0.5;
            break;
        case Model::quarter:
            solid.mesh = revolve(section, Turn::quarter, revolution.sectors_per_quarter);
            solid.symmetry_planes[1] = solid.symmetry_planes[2] = true;
            solid.fraction *= 0.25;
            break;
    }
    return solid;
}

/// The planes y = 0 and z = 0 that are no cuts, as inner faces "middle_y", "middle_z".
void add_middle_planes(Solid& solid) {
    constexpr std::array<const char*, 3> names{"", "middle_y", "middle_z"};
    for (int c = 1; c < 3; ++c)
        if (!solid.symmetry_planes[c]) solid.mesh.facet_sets[names[c]] = facets_on_plane(solid.mesh, c);
}

bool holds(const mesh::Mesh& mesh, const std::string& face) { return mesh.facet_sets.contains(face); }

void require_face(const mesh::Mesh& mesh, const std::string& face, const std::string& place, const Family& family) {
    if (holds(mesh, face)) return;
    std::vector<std::string> present;
    for (const std::string& name : family.keys.faces)
        if (holds(mesh, name)) present.push_back(name);
    throw Error(ExitCode::bad_input, place, "face " + core::quoted(face) + " is not part of this model",
                "faces it has: " + core::join(present));
}

/// What follows from the shape: symmetry planes, the axis, and the middle planes of a body nobody holds.
std::vector<model::Support> own_supports(const Body& body, const Solid& solid) {
    if (std::holds_alternative<ReadyMesh>(body.sweep)) return {};   // its faces are the user's, whatever they are called
    struct Named {
        const char* face;
        int component;
    };
    constexpr std::array<Named, 6> candidates{{{symmetry_x_face, 0}, {symmetry_y_face, 1}, {symmetry_z_face, 2},
                                               {axis_face, 1}, {"middle_y", 1}, {"middle_z", 2}}};
    std::vector<model::Support> supports;
    for (const Named& candidate : candidates) {
        if (!holds(solid.mesh, candidate.face)) continue;
        model::Support support{candidate.face, {}};
        support.fixed[candidate.component] = true;
        supports.push_back(support);
    }
    return supports;
}

/// Area mean of the outward unit normal of a face; shorter than 1 where the face is not flat.
std::array<double, 3> mean_normal(const Solid& solid, const std::string& face) {
    std::array<double, 3> sum{};
    double area = 0;
    for (const mesh::Facet& facet : solid.mesh.facet_sets.at(face)) {
        const mesh::CellType type = facet_type(solid.mesh, facet);
        for (const mesh::QuadraturePoint& point : mesh::volume_rule(type)) {
            const auto n = mesh::facet_normal(solid.mesh, facet, mesh::shape_values(type, point.xi));
            for (std::size_t i = 0; i < 3; ++i) sum[i] += point.weight * n[i];
            area += point.weight * std::hypot(n[0], n[1], n[2]);
        }
    }
    for (double& component : sum) component /= area;
    return sum;
}

bool says(const design::Values& values, const char* path, std::string_view word) {
    return values.has(path) && values.text(path) == word;
}

model::Formulation formulation_of(const design::Values& values, const mesh::Mesh& mesh) {
    model::Formulation formulation = model::Formulation::mixed;
    if (says(values, "mesh.formulation", "displacement")) formulation = model::Formulation::displacement;
    if (says(values, "mesh.formulation", "f-bar")) formulation = model::Formulation::f_bar;
    for (const mesh::CellType type : std::set(mesh.cell_types.begin(), mesh.cell_types.end()))
        if (const std::string reason = element::why_not(type, formulation); !reason.empty())
            throw values.refuse("mesh.formulation", reason);
    return formulation;
}

/// Loads of the whole actuator on its faces, with `along` turned into a vector.
std::vector<model::TractionLoad> tractions_of(const design::Design& design, const Body& body, const Solid& solid,
                                              const Family& family) {
    std::vector<model::TractionLoad> tractions;
    for (const auto& request : design.tractions) {
        const std::string place = "loads." + request.face;
        require_face(solid.mesh, request.face, place, family);
        auto traction = direction_of({place + ".along", request.face, request.along}, body, solid);
        for (double& component : traction) component *= request.traction_Pa;
        tractions.push_back({request.face, traction});
    }
    return tractions;
}

/// The section meshed and swept, or the mesh that is there.
Solid swept(const Body& body, const design::Values& values) {
    if (const auto* ready = std::get_if<ReadyMesh>(&body.sweep))
        return {ready->mesh, ready->kinematics, body.symmetry_planes, body.fraction};
    const Model model = model_of(values);
    refuse_too_many(body, values);
    const mesh::Mesh section = mesh_section(body.section);
    if (const auto* revolution = std::get_if<Revolution>(&body.sweep))
        return revolved(section, body, *revolution, model);
    if (model == Model::plane_strain)
        return {section, model::Kinematics::plane_strain, body.symmetry_planes, body.fraction};
    return {extrude(section, std::get<Extrusion>(body.sweep)), model::Kinematics::solid, body.symmetry_planes, body.fraction};
}

mesh::Mesh refined(const mesh::Mesh& mesh, const design::Values& values) {
    const int times = values.has("mesh.refine") ? values.count("mesh.refine") : 0;
    const double cells = std::ldexp(static_cast<double>(mesh.cell_count()), times * mesh.dimension);
    if (cells > most_cells)
        throw values.refuse("mesh.refine", "it would take " + core::rounded_text(cells, 2) + " cells", "a smaller number");
    return mesh::refine(mesh, times);
}

}  // namespace

Solid mesh_body(const Body& body, const design::Values& values) {
    Solid solid = swept(body, values);
    if (says(values, "mesh.cells", "simplices")) solid.mesh = split_into_simplices(solid.mesh);
    solid.mesh = refined(solid.mesh, values);   // before mid nodes go: they know the curved edges
    if (values.has("mesh.order") && values.count("mesh.order") == 1) solid.mesh = mesh::lower_order(solid.mesh);
    if (body.anchoring == Anchoring::middle_planes && solid.kinematics == model::Kinematics::solid)
        add_middle_planes(solid);
    return solid;
}

std::array<double, 3> direction_of(const Heading& heading, const Body& body, const Solid& solid) {
    const std::string &place = heading.place, &along = heading.along;
    if (along == "axis") return body.axis;
    if (along == "x") return {1, 0, 0};
    if (along == "normal") {
        constexpr double flat = 1 - 1e-9;   // rounding of the sums; a curved face falls far below
        const auto n = mean_normal(solid, heading.face);
        if (std::hypot(n[0], n[1], n[2]) < flat)
            throw Error(ExitCode::bad_input, place, "face " + core::quoted(heading.face) + " is not flat", "axis, x, y or z");
        return n;
    }
    // The mean of y or z over a whole turn says nothing of a section, and r is no fixed direction of a solid.
    const bool revolved = solid.kinematics == model::Kinematics::axisymmetric;
    const bool plane = solid.kinematics == model::Kinematics::plane_strain;
    if (along == "r" && revolved) return {0, 1, 0};
    if (along == "y" && !revolved) return {0, 1, 0};
    if (along == "z" && !revolved && !plane) return {0, 0, 1};
    throw Error(ExitCode::bad_input, place, core::quoted(along) + " is no direction of this model",
                revolved ? "axis, x, r or normal" : plane ? "axis, x, y or normal" : "axis, x, y, z or normal");
}

std::vector<std::string> warnings_of(const design::Design& design, const model::Case& built) {
    std::vector<std::string> warnings = design.warnings;
    const auto locks = [](mesh::CellType type) { return type == mesh::CellType::triangle3 || type == mesh::CellType::tet4; };
    const bool told = design.values.has("mesh.cells") && design.values.text("mesh.cells") == "simplices";
    if (!told && std::ranges::any_of(built.mesh.cell_types, locks))
        warnings.push_back("geometry.file: " + design::first_order_simplices_lock());
    return warnings;
}

model::Case build_case(const design::Design& design) {
    const Family& family = family_named(design.family);
    const Body body = family.build(design.values);
    Solid solid = mesh_body(body, design.values);
    for (const model::Support& support : design.supports) require_face(solid.mesh, support.face, "supports", family);
    for (const model::PressureLoad& load : design.loads) {
        const auto named = [&](const model::Cavity& cavity) { return cavity.name == load.target; };
        if (std::none_of(body.cavities.begin(), body.cavities.end(), named))
            require_face(solid.mesh, load.target, "loads." + load.target, family);
    }

    if (const std::string reason = model::why_not(design.material, solid.kinematics); !reason.empty())
        throw design.values.refuse("material.families", reason);

    model::Case result;
    result.name = design.name;
    result.kinematics = solid.kinematics;
    result.formulation = formulation_of(design.values, solid.mesh);
    result.model_fraction = solid.fraction;
    result.symmetry_planes = solid.symmetry_planes;
    for (const std::string& region : solid.mesh.region_names) {   // one rubber for all regions
        result.materials.push_back(design.material);
        result.materials.back().name = region;
    }
    result.supports = design.supports;
    for (model::Support& support : own_supports(body, solid)) result.supports.push_back(std::move(support));
    result.supports.insert(result.supports.end(), body.supports.begin(), body.supports.end());
    result.cavities = body.cavities;
    result.loads = design.loads;
    result.tractions = tractions_of(design, body, solid, family);
    for (const auto& request : design.outputs) {
        require_face(solid.mesh, request.face, "outputs." + request.name + ".face", family);
        result.outputs.push_back({request.name, request.face,
                                  direction_of({"outputs." + request.name + ".along", request.face, request.along}, body, solid)});
    }
    result.path = design.path;
    result.solver = design.solver;
    result.mesh = std::move(solid.mesh);
    return result;
}

}  // namespace soft::geometry
