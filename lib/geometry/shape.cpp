#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/text.hpp"
#include "geometry/build.hpp"
#include "geometry/keys.hpp"
#include "geometry/loading.hpp"
#include "geometry/obstacle.hpp"
#include "geometry/strip.hpp"
#include "mesh/raise_order.hpp"
#include "mesh/refine.hpp"
#include "mesh/split.hpp"
#include "meshing/outline_mesher.hpp"
#include "meshing/outline_sizes.hpp"
#include "meshing/section_mesher.hpp"

namespace soft::geometry {
namespace {

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

meshing::Turn turn_of(Model model) {
    switch (model) {
        case Model::solid: return meshing::Turn::full;
        case Model::half: return meshing::Turn::half;
        case Model::quarter: return meshing::Turn::quarter;
        default: throw std::logic_error("a body of revolution has no such model");
    }
}

void refuse_too_many(const Body& body, const design::Values& values) {
    double cells = cell_count(body.section);
    if (!body.outline.loops.empty()) cells = expected_cells(body.outline);
    const Model model = model_of(values);
    if (const auto* revolution = std::get_if<Revolution>(&body.sweep)) {
        if (model != Model::axisymmetric) cells *= revolution->sectors.cells(turn_of(model));
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
            region = mesh::region_number(solid, strip_region(names[static_cast<std::size_t>(region)]));
    }
}

Solid revolved(const mesh::Mesh& section, const Body& body, const Revolution& revolution, Model model) {
    Solid solid{{}, model::Kinematics::solid, body.symmetry_planes, body.fraction};
    if (model == Model::axisymmetric) {
        solid.mesh = section;
        solid.kinematics = model::Kinematics::axisymmetric;
        return solid;
    }
    const meshing::Turn turn = turn_of(model);
    solid.mesh = meshing::revolve(section, turn, revolution.sectors);
    if (turn != meshing::Turn::full) {
        solid.symmetry_planes[1] = true;
        if (turn == meshing::Turn::quarter) solid.symmetry_planes[2] = true;
        solid.fraction *= turn == meshing::Turn::half ? 0.5 : 0.25;
    }
    if (body.strip_rad > 0) mark_strip(solid.mesh, body.strip_rad);
    return solid;
}

/// Adds the planes y = 0 and z = 0 that are not cuts as inner faces.
void add_middle_planes(Solid& solid) {
    for (int c = 1; c < 3; ++c)
        if (!solid.symmetry_planes[c]) solid.mesh.facet_sets[middle_faces[c]] = meshing::facets_on_plane(solid.mesh, c);
}

/// Supports that follow from the shape: symmetry planes, the axis, and the middle planes of an unsupported body.
std::vector<model::Support> own_supports(const Body& body, const Solid& solid) {
    if (std::holds_alternative<ReadyMesh>(body.sweep))
        return body.supports;  // the user defines its faces, whatever their names
    struct Named {
        const char* face;
        int component;
    };
    constexpr std::array<Named, 6> candidates{{{meshing::symmetry_x_face, 0},
                                               {meshing::symmetry_y_face, 1},
                                               {meshing::symmetry_z_face, 2},
                                               {meshing::axis_face, 1},
                                               {middle_faces[1], 1},
                                               {middle_faces[2], 2}}};
    std::vector<model::Support> supports;
    for (const Named& candidate : candidates) {
        if (!solid.mesh.facet_sets.contains(candidate.face)) continue;
        model::Support support{candidate.face, {}};
        support.fixed[candidate.component] = true;
        supports.push_back(support);
    }
    supports.insert(supports.end(), body.supports.begin(), body.supports.end());
    return supports;
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

}  // namespace

Solid mesh_body(const Body& body, const design::Values& values) {
    Solid solid = swept(body, values);
    const bool mixed = std::ranges::find(solid.mesh.cell_types, mesh::CellType::tet10) != solid.mesh.cell_types.end() &&
                       !std::holds_alternative<ReadyMesh>(body.sweep);  // some facets are split already
    if (mixed || (values.has("mesh.cells") && values.text("mesh.cells") == "simplices"))
        solid.mesh = split_into_simplices(solid.mesh);
    solid.mesh = refined(solid.mesh, values);  // before mid nodes are removed: they define the curved edges
    if (values.has("mesh.order") && values.count("mesh.order") == 1) solid.mesh = mesh::lower_order(solid.mesh);
    if (body.anchoring == Anchoring::middle_planes && solid.kinematics == model::Kinematics::solid)
        add_middle_planes(solid);
    return solid;
}

void check_geometry(const design::Design& design) {
    const Family& family = family_of(design.family);
    if (family.keys.faces_of_file) return;
    const Body body = family.build(design.values);
    if (!std::holds_alternative<ReadyMesh>(body.sweep)) refuse_too_many(body, design.values);
}

MeshedShape make_shape(const design::Design& design) {
    const Body body = family_of(design.family).build(design.values);
    Solid solid = mesh_body(body, design.values);
    model::Shape shape{solid.kinematics,
                       solid.fraction,
                       solid.symmetry_planes,
                       body.axis,
                       own_supports(body, solid),
                       body.cavities,
                       body.region_materials,
                       body.region_fibers,
                       faceted_obstacles(design, solid.kinematics, solid.mesh)};
    return {std::move(solid.mesh), std::move(shape), body.part, body.notes, body.warnings};
}

}  // namespace soft::geometry
