/// A flat plate. Rectangular: x = 0 .. length, y = 0 .. width, z = 0 .. thickness. In the half model y = 0 is the middle plane,
/// in the quarter model also x = 0 (bending has no symmetry plane across the thickness). Round: the axis x runs through the
/// thickness, x = 0 is the bottom.
#include <algorithm>

#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "geometry/keys.hpp"
#include "meshing/box_grid.hpp"
#include "meshing/section_mesher.hpp"

namespace soft::geometry {
namespace {

/// Cell length relative to the quality normal; at twice this length the error of the curve is 1 %.
constexpr double max_length = 2.2;

/// Shorter cells toward the edges; with still shorter ones, those in the middle of a thin round plate are too long, and its edge creases earlier.
double grading_of(const design::Values& values, double automatic) {
    const double stated = values.number("mesh.grading");
    return stated > 0 ? stated : automatic;
}

Body round_plate(const design::Values& values) {
    const double radius_m = values.number("geometry.radius"), thickness_m = values.number("geometry.thickness");
    constexpr int along = 20;
    constexpr double thick = 0.125;
    const CellSize size{values, radius_m / along};
    Body body;
    body.section = meshing::rectangle({thickness_m,
                                       radius_m,
                                       size.through(thickness_m, thickness_m > thick * radius_m ? 4 : 2),
                                       size.along(radius_m),
                                       {meshing::axis_face},
                                       {"top"},
                                       {"rim", "edges"},
                                       {"bottom"}});
    body.warnings = size.too_long(max_length);
    const double grading = grading_of(values, 8);
    for (meshing::Curve& curve : body.section.curves)  // shorter toward the rim, as in the rectangular plate
        if (curve.faces == std::vector<std::string>{"top"})
            curve.grading = 1 / grading;
        else if (curve.faces == std::vector<std::string>{"bottom"})
            curve.grading = grading;
    body.sweep = Revolution{sectors(values)};
    return body;
}

/// Cells get shorter toward the edges, where a clamped plate bends within about its thickness: for 2 mm thickness, uniform cells of
/// 10 mm are 5.5 % too stiff, cells of 2.5 mm 2 % too soft (tests/verification/notes.md).
Body rectangular_plate(const design::Values& values) {
    const Model model = model_of(values);
    if (model == Model::axisymmetric)
        throw values.refuse("model", "a rectangular plate has no axis of revolution",
                            "use solid, half or quarter, or a round plate (geometry.radius)");
    const bool cut_y = model != Model::solid, cut_x = model == Model::quarter;
    const double thickness_m = values.number("geometry.thickness");
    const double length_m = values.number("geometry.length") / (cut_x ? 2 : 1);
    const double width_m = values.number("geometry.width") / (cut_y ? 2 : 1);
    meshing::BoxBody plate{
        .boxes = {{{0, 0, 0}, {length_m, width_m, thickness_m}, meshing::Fill::solid, meshing::rubber_region}}};
    const meshing::Border plane_x{meshing::symmetry_x_face}, plane_y{meshing::symmetry_y_face};
    plate.borders = {{{cut_x ? plane_x : meshing::Border{"edge_x0", true}, {"edge_x1", true}},
                      {cut_y ? plane_y : meshing::Border{"edge_y0", true}, {"edge_y1", true}},
                      {{{"bottom"}, {"top"}}}}};
    constexpr int along = 20;
    constexpr double thin = 0.05;
    const double extent_m = std::max(values.number("geometry.length"), values.number("geometry.width"));
    const CellSize size{values, extent_m / along};
    const meshing::Spacing spacing{size.length_m(),
                                   {1, 1, size.through(thickness_m, thickness_m < thin * extent_m ? 1 : 2)},
                                   grading_of(values, 16)};
    refuse_too_many_cells(values, cells_of_boxes(plate, spacing));

    Body body;
    ReadyMesh ready{mesh_of_boxes(plate, spacing), model::Kinematics::solid};
    std::vector<mesh::Facet>& edges = ready.mesh.facet_sets["edges"];
    for (const char* name : {"edge_x0", "edge_x1", "edge_y0", "edge_y1"})
        if (const auto one = ready.mesh.facet_sets.find(name); one != ready.mesh.facet_sets.end())
            edges.insert(edges.end(), one->second.begin(), one->second.end());
    body.warnings = size.too_long(max_length);
    body.sweep = std::move(ready);
    body.symmetry_planes = {cut_x, cut_y, false};
    body.fraction = (cut_x ? 0.5 : 1.0) * (cut_y ? 0.5 : 1.0);
    if (cut_x) body.supports.push_back({meshing::symmetry_x_face, {true, false, false}});
    if (cut_y) body.supports.push_back({meshing::symmetry_y_face, {false, true, false}});
    return body;
}

Body build(const design::Values& values) {
    return values.number("geometry.radius") > 0 ? round_plate(values) : rectangular_plate(values);
}

}  // namespace

Family plate() {
    design::FamilyKeys keys;
    keys.name = "plate";
    keys.summary = "a flat plate, rectangular or round, clamped at its edges";
    design::Key radius =
        length_key("radius", "0 mm",
                   "radius of a round plate, axis x; 0 = rectangular; length and width are unused if it is above 0");
    radius.min_open = false;
    keys.geometry = {length_key("length", "100 mm", "length along x; in the quarter model x = 0 is the middle"),
                     length_key("width", "100 mm", "width along y; in half and quarter models y = 0 is the middle"),
                     std::move(radius),
                     length_key("thickness", "2 mm", "thickness, along z (rectangular) or x (round)")};
    keys.models = {"solid", "half", "quarter", "axisymmetric"};
    keys.revolution_key = "radius";
    keys.faces = {"edges", "edge_x0", "edge_x1", "edge_y0", "edge_y1", "rim", "top", "bottom"};
    keys.defaults =
        "supports: {fixed: edges}\n"
        "loads:\n"
        "  bottom: {pressure: 5 kPa}     # acts upwards\n"
        "outputs:\n"
        "  deflection: {face: top, along: normal}\n";
    design::Key grading = grading_key("auto");
    grading.choices = {"auto"};
    grading.meaning += "; auto: 16, round 8";
    keys.mesh = {size_key(), through_wall_key(), sectors_key(), std::move(grading)};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
