/// A flat plate. Rectangular: x = 0 .. length, y = 0 .. width, z = 0 .. thickness; half: y = 0 is the middle plane;
/// quarter: x = 0 too (a plate that bends has no symmetry plane across its thickness). Round: the axis x runs through
/// the thickness, x = 0 is the bottom.
#include "geometry/family.hpp"
#include "geometry/keys.hpp"

namespace soft::geometry {
namespace {

Body round_plate(const design::Values& values) {
    const double radius_m = values.number("geometry.radius"), thickness_m = values.number("geometry.thickness");
    Body body;
    body.section = meshing::rectangle({thickness_m,
                                       radius_m,
                                       cells_through_wall(values, thickness_m),
                                       meshing::divisions(radius_m, values.number("mesh.size")),
                                       {meshing::axis_face},
                                       {"top"},
                                       {"rim", "edges"},
                                       {"bottom"}});
    body.sweep = Revolution{values.count("mesh.sectors")};
    return body;
}

Body rectangular_plate(const design::Values& values) {
    const Model model = model_of(values);
    if (model == Model::axisymmetric)
        throw values.refuse("model", "a rectangular plate has no axis of revolution",
                            "solid, half or quarter, or a round plate by geometry.radius");
    const bool cut_y = model != Model::solid, cut_x = model == Model::quarter;
    const double size_m = values.number("mesh.size"), thickness_m = values.number("geometry.thickness");
    const double length_m = values.number("geometry.length") / (cut_x ? 2 : 1);
    const double width_m = values.number("geometry.width") / (cut_y ? 2 : 1);
    using Names = std::vector<std::string>;

    Body body;
    body.section = meshing::rectangle({length_m,
                                       thickness_m,
                                       meshing::divisions(length_m, size_m),
                                       cells_through_wall(values, thickness_m),
                                       {"bottom"},
                                       {"edge_x1", "edges"},
                                       {"top"},
                                       cut_x ? Names{meshing::symmetry_x_face} : Names{"edge_x0", "edges"}});
    body.sweep = meshing::Extrusion{width_m,
                                    meshing::divisions(width_m, size_m),
                                    cut_y ? Names{meshing::symmetry_y_face} : Names{"edge_y0", "edges"},
                                    {"edge_y1", "edges"}};
    body.symmetry_planes = {cut_x, cut_y, false};
    body.fraction = (cut_x ? 0.5 : 1.0) * (cut_y ? 0.5 : 1.0);
    return body;
}

Body build(const design::Values& values) {
    return values.number("geometry.radius") > 0 ? round_plate(values) : rectangular_plate(values);
}

}  // namespace

Family plate() {
    design::FamilyKeys keys;
    keys.name = "plate";
    keys.summary = "a flat plate, rectangular or round, held at its edges";
    design::Key radius = length_key(
        "radius", "0 mm", "radius of a round plate, axis x; 0 = rectangular, else length and width are not used");
    radius.min_open = false;
    keys.geometry = {length_key("length", "100 mm", "length along x; the quarter model has x = 0 in the middle"),
                     length_key("width", "100 mm", "width along y; half and quarter models have y = 0 in the middle"),
                     std::move(radius),
                     length_key("thickness", "2 mm", "thickness, along z (rectangular) or x (round)")};
    keys.models = {"solid", "half", "quarter", "axisymmetric"};
    keys.faces = {"edges", "edge_x0", "edge_x1", "edge_y0", "edge_y1", "rim", "top", "bottom"};
    keys.defaults =
        "supports: {fixed: edges}\n"
        "loads:\n"
        "  bottom: {pressure: 5 kPa}     # pushes the plate up\n"
        "outputs:\n"
        "  deflection: {face: top, along: normal}\n";
    keys.mesh = {size_key("10 mm"), through_wall_key(), sectors_key()};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
