/// A box from the origin: x = 0 .. length, y = 0 .. width, z = 0 .. height.
/// Half: y = 0 is the middle plane; quarter: z = 0 too.
#include "geometry/family.hpp"
#include "geometry/keys.hpp"

namespace soft::geometry {
namespace {

Body build(const design::Values& values) {
    const double length_m = values.number("geometry.length"), size_m = values.number("mesh.size");
    const Model model = model_of(values);
    const bool cut_y = model != Model::solid, cut_z = model == Model::quarter;
    const double width_m = values.number("geometry.width") / (cut_y ? 2 : 1);
    const double height_m = values.number("geometry.height") / (cut_z ? 2 : 1);

    Body body;
    body.section = meshing::rectangle({length_m,
                                       height_m,
                                       meshing::divisions(length_m, size_m),
                                       cells_through_wall(values, height_m),
                                       {cut_z ? meshing::symmetry_z_face : "bottom"},
                                       {"end"},
                                       {"top"},
                                       {"fixed"}});
    body.sweep = meshing::Extrusion{
        width_m, meshing::divisions(width_m, size_m), {cut_y ? meshing::symmetry_y_face : "left"}, {"right"}};
    body.symmetry_planes = {false, cut_y, cut_z};
    body.fraction = (cut_y ? 0.5 : 1.0) * (cut_z ? 0.5 : 1.0);
    return body;
}

}  // namespace

Family rod() {
    design::FamilyKeys keys;
    keys.name = "rod";
    keys.summary = "a box held at x = 0 and pulled at its end";
    keys.geometry = {
        length_key("length", "100 mm", "length along x, from the held face x = 0"),
        length_key("width", "10 mm", "width along y; half and quarter models hold the upper half, y = 0 in the middle"),
        length_key("height", "10 mm", "height along z; the quarter model holds the upper half, z = 0 in the middle")};
    keys.models = {"solid", "half", "quarter"};
    keys.faces = {"fixed", "end", "bottom", "top", "left", "right"};
    keys.defaults =
        "supports: {fixed: fixed}\n"
        "loads:\n"
        "  end: {pressure: -50 kPa}      # negative pulls; per deformed area\n"
        "outputs:\n"
        "  elongation: {face: end, along: axis}\n";
    keys.mesh = {size_key("5 mm"), through_wall_key()};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
