#include "geometry/build.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "core/text.hpp"
#include "geometry/case_warnings.hpp"
#include "geometry/keys.hpp"
#include "geometry/loading.hpp"
#include "geometry/strip.hpp"
#include "mesh/raise_order.hpp"
#include "mesh/refine.hpp"
#include "mesh/split.hpp"
#include "meshing/outline_mesher.hpp"
#include "meshing/outline_sizes.hpp"
#include "meshing/regions.hpp"
#include "meshing/section_mesher.hpp"
#include "model/cavity_surface.hpp"
#include "model/formulation.hpp"
#include "model/rubber.hpp"

namespace soft::geometry {
namespace {

const Family& family_named(const std::string& name) {
    for (const Family& family : catalogue())
        if (family.keys.name == name) return family;
    throw Error(ExitCode::bad_input, "family", "no family is called " + core::quoted(name));
}

/// A triangle of the section that meets the axis becomes tetrahedra of the solid; a quadrilateral that meets it in a corner has no
/// counterpart. A solid of revolution that closes on its axis therefore consists of simplices.
meshing::FreeCells free_cells(const Body& body, const design::Values& values, Model model) {
    const bool simplices = values.has("mesh.cells") && values.text("mesh.cells") == "simplices";
    const bool turned = std::holds_alternative<Revolution>(body.sweep) && model != Model::axisymmetric;
    const auto on_axis = [](const meshing::OutlineEdge& edge) { return edge.points.front()[1] == 0; };
    const bool closes = std::ranges::any_of(
        body.outline.loops, [&](const meshing::Loop& loop) { return std::ranges::any_of(loop, on_axis); });
    return simplices || (turned && closes) ? meshing::FreeCells::triangles : meshing::FreeCells::quadrilaterals;
}

void refuse_too_many(const Body& body, const design::Values& values) {
    double cells = cell_count(body.section);
    if (!body.outline.loops.empty()) cells = expected_cells(body.outline);
    const Model model = model_of(values);
    if (const auto* revolution = std::get_if<Revolution>(&body.sweep)) {
        if (model != Model::axisymmetric) cells *= revolution->sectors_per_quarter;
        if (model == Model::half) cells *= 2;
        if (model == Model::solid) cells *= 4;
    } else if (model != Model::plane_strain) {
        cells *= std::get<meshing::Extrusion>(body.sweep).layers;
    }
    refuse_too_many_cells(values, cells);
}

void mark_strip(mesh::Mesh& solid, double angle_rad) {
    const std::vector<std::string> names = solid.region_names;
    for (mesh::Index cell = 0; cell < solid.cell_count(); ++cell) {
        double y = 0, z = 0;
        for (const mesh::Index node : solid.cell_nodes(cell)) {
            y += solid.point(node)[1];
            z += solid.point(node)[2];
        }
        std::int32_t& region = solid.cell_regions[static_cast<std::size_t>(cell)];
        if (std::atan2(std::abs(y), -z) < 0.5 * angle_rad)
            region = meshing::region_number(solid, strip_region(names[static_cast<std::size_t>(region)]));
    }
}

Solid revolved(const mesh::Mesh& section, const Body& body, const Revolution& revolution, Model model) {
    Solid solid{{}, model::Kinematics::solid, body.symmetry_planes, body.fraction};
    switch (model) {
        case Model::axisymmetric:
            solid.mesh = section;
            solid.kinematics = model::Kinematics::axisymmetric;
            break;
        case Model::plane_strain: throw std::logic_error("a body of revolution has no plane strain");
        case Model::solid:
            solid.mesh = meshing::revolve(section, meshing::Turn::full, revolution.sectors_per_quarter);
            break;
        case Model::half:
            solid.mesh = meshing::revolve(section, meshing::Turn::half, revolution.sectors_per_quarter);
            solid.symmetry_planes[1] = true;
            solid.fraction *= 0.5;
            break;
        case Model::quarter:
            solid.mesh = meshing::revolve(section, meshing::Turn::quarter, revolution.sectors_per_quarter);
            solid.symmetry_planes[1] = solid.symmetry_planes[2] = true;
            solid.fraction *= 0.25;
            break;
    }
    if (body.strip_rad > 0) mark_strip(solid.mesh, body.strip_rad);
    return solid;
}

/// Adds the planes y = 0 and z = 0 that are not cuts as inner faces "middle_y", "middle_z".
void add_middle_planes(Solid& solid) {
    constexpr std::array<const char*, 3> names{"", "middle_y", "middle_z"};
    for (int c = 1; c < 3; ++c)
        if (!solid.symmetry_planes[c]) solid.mesh.facet_sets[names[c]] = meshing::facets_on_plane(solid.mesh, c);
}

/// Supports that follow from the shape: symmetry planes, the axis, and the middle planes of an unsupported body.
std::vector<model::Support> own_supports(const Body& body, const Solid& solid) {
    if (std::holds_alternative<ReadyMesh>(body.sweep)) return {};  // the user defines its faces, whatever their names
    struct Named {
        const char* face;
        int component;
    };
    constexpr std::array<Named, 6> candidates{{{meshing::symmetry_x_face, 0},
                                               {meshing::symmetry_y_face, 1},
                                               {meshing::symmetry_z_face, 2},
                                               {meshing::axis_face, 1},
                                               {"middle_y", 1},
                                               {"middle_z", 2}}};
    std::vector<model::Support> supports;
    for (const Named& candidate : candidates) {
        if (!solid.mesh.facet_sets.contains(candidate.face)) continue;
        model::Support support{candidate.face, {}};
        support.fixed[candidate.component] = true;
        supports.push_back(support);
    }
    return supports;
}

bool has_value(const design::Values& values, const char* path, std::string_view word) {
    return values.has(path) && values.text(path) == word;
}

model::Formulation formulation_of(const design::Values& values, const mesh::Mesh& mesh) {
    model::Formulation formulation = model::Formulation::mixed;
    if (has_value(values, "mesh.formulation", "displacement")) formulation = model::Formulation::displacement;
    if (has_value(values, "mesh.formulation", "f-bar")) formulation = model::Formulation::f_bar;
    for (const mesh::CellType type : std::set(mesh.cell_types.begin(), mesh.cell_types.end()))
        if (const std::string reason = model::explain_incompatibility(type, formulation); !reason.empty())
            throw values.refuse("mesh.formulation", reason);
    return formulation;
}

/// The meshed and swept section, or the finished mesh.
Solid swept(const Body& body, const design::Values& values) {
    if (const auto* ready = std::get_if<ReadyMesh>(&body.sweep))
        return {ready->mesh, ready->kinematics, body.symmetry_planes, body.fraction};
    const Model model = model_of(values);
    refuse_too_many(body, values);
    const mesh::Mesh section = body.outline.loops.empty() ? mesh_section(body.section)
                                                          : mesh_outline(body.outline, free_cells(body, values, model));
    if (const auto* revolution = std::get_if<Revolution>(&body.sweep))
        return revolved(section, body, *revolution, model);
    if (model == Model::plane_strain)
        return {section, model::Kinematics::plane_strain, body.symmetry_planes, body.fraction};
    return {meshing::extrude(section, std::get<meshing::Extrusion>(body.sweep)), model::Kinematics::solid,
            body.symmetry_planes, body.fraction};
}

mesh::Mesh refined(const mesh::Mesh& mesh, const design::Values& values) {
    const int times = values.has("mesh.refine") ? values.count("mesh.refine") : 0;
    const double cells = std::ldexp(static_cast<double>(mesh.cell_count()), times * mesh.dimension);
    if (cells > max_cells)
        throw values.refuse("mesh.refine",
                            "the mesh would have " + core::rounded_text(cells, 2) + " cells (limit 5 million)",
                            "use a smaller number");
    return mesh::refine(mesh, times);
}

/// The material of every region: the one that the family assigns, else the one of the region's name, else the main one. Includes
/// the fibres that the family adds to the region.
std::vector<model::Material> region_materials(const design::Design& design, const Body& body, const Solid& solid) {
    std::vector<model::Material> materials;
    for (const std::string& region : solid.mesh.region_names) {
        const auto named = body.region_materials.find(region);
        const auto found = design.materials.find(named == body.region_materials.end() ? region : named->second);
        materials.push_back(found == design.materials.end() ? design.material : found->second);
        materials.back().name = region;
        if (const auto fibers = body.region_fibers.find(region); fibers != body.region_fibers.end()) {
            materials.back().fibers = fibers->second.fibers;
            materials.back().fiber_frame = fibers->second.frame;
        }
    }
    return materials;
}

/// Throws if the law of the rubber cannot be combined with fibres; the keys of the family check the fibres themselves.
void check_fibers(const design::Design& design, const model::Material& material) {
    try {
        static_cast<void>(model::make_rubber(material));
    } catch (const Error& error) {
        throw design.values.refuse(material.source + ".law", error.what());
    }
}

/// A material that no region uses is most likely misspelt. Built-in materials of a family may stay unused.
void check_materials(const design::Design& design, const design::FamilyKeys& keys, const Solid& solid,
                     const std::vector<model::Material>& materials) {
    for (const model::Material& material : materials) {
        if (material.fibers) check_fibers(design, material);
        const std::string reason = model::explain_incompatibility(material, solid.kinematics, solid.symmetry_planes);
        if (!reason.empty())
            throw design.values.refuse(
                (material.fibers ? "geometry.fibers" : material.source) + std::string{".families"}, reason);
    }
    for (const auto& [name, material] : design.materials) {
        const bool used = std::ranges::find(materials, material.source, &model::Material::source) != materials.end();
        if (!used && !keys.materials.contains(name))
            throw design.values.refuse(material.source + ".law", "no region uses this material",
                                       "regions: " + core::join(solid.mesh.region_names));
    }
}

}  // namespace

Solid mesh_body(const Body& body, const design::Values& values) {
    Solid solid = swept(body, values);
    const bool mixed = std::ranges::find(solid.mesh.cell_types, mesh::CellType::tet10) != solid.mesh.cell_types.end() &&
                       !std::holds_alternative<ReadyMesh>(body.sweep);  // some facets are split already
    if (mixed || has_value(values, "mesh.cells", "simplices")) solid.mesh = split_into_simplices(solid.mesh);
    solid.mesh = refined(solid.mesh, values);  // before mid nodes are removed: they define the curved edges
    if (values.has("mesh.order") && values.count("mesh.order") == 1) solid.mesh = mesh::lower_order(solid.mesh);
    if (body.anchoring == Anchoring::middle_planes && solid.kinematics == model::Kinematics::solid)
        add_middle_planes(solid);
    return solid;
}

std::vector<std::string> warnings_of(const design::Design& design, const Built& built) {
    std::vector<std::string> warnings = design.warnings;
    warnings.insert(warnings.end(), built.mesh_warnings.begin(), built.mesh_warnings.end());
    const auto locks = [](mesh::CellType type) {
        return type == mesh::CellType::triangle3 || type == mesh::CellType::tet4;
    };
    const bool is_reported = design.values.has("mesh.cells") && design.values.text("mesh.cells") == "simplices";
    if (!is_reported && std::ranges::any_of(built.model.mesh.cell_types, locks))
        warnings.push_back((design.values.has("geometry.file") ? "geometry.file: " : "mesh.order: ") +
                           design::first_order_simplex_warning());
    for (std::string& warning : case_warnings(design, built.model)) warnings.push_back(std::move(warning));
    return warnings;
}

void check_geometry(const design::Design& design) {
    const Family& family = family_named(design.family);
    if (family.keys.faces_of_file) return;
    const Body body = family.build(design.values);
    if (!std::holds_alternative<ReadyMesh>(body.sweep)) refuse_too_many(body, design.values);
}

model::Case build_case(const design::Design& design) { return build_with_figures(design).model; }

Built build_with_figures(const design::Design& design) {
    const Family& family = family_named(design.family);
    const Body body = family.build(design.values);
    Solid solid = mesh_body(body, design.values);
    for (const model::Support& support : design.supports)
        require_face(solid.mesh, support.face, "supports", family.keys);

    model::Case result;
    result.name = design.name;
    result.kinematics = solid.kinematics;
    result.formulation = formulation_of(design.values, solid.mesh);
    result.model_fraction = solid.fraction;
    result.symmetry_planes = solid.symmetry_planes;
    result.materials = region_materials(design, body, solid);
    check_materials(design, family.keys, solid, result.materials);
    result.supports = design.supports;
    for (model::Support& support : own_supports(body, solid)) result.supports.push_back(std::move(support));
    result.supports.insert(result.supports.end(), body.supports.begin(), body.supports.end());
    result.cavities = body.cavities;
    add_loads(result, design, {family.keys, body, solid});
    add_outputs(result, design, {family.keys, body, solid});
    result.path = design.path;
    result.solver = design.solver;
    result.dynamics = design.dynamics;
    result.mesh = std::move(solid.mesh);
    return {std::move(result), body.part, body.notes, body.warnings};
}

}  // namespace soft::geometry
