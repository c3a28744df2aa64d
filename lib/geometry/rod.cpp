/// A box: x = 0 .. length, y = 0 .. width, z = 0 .. height.
/// In the half model y = 0 is the middle plane, in the quarter model also z = 0.
#include <cmath>

#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "geometry/keys.hpp"

namespace soft::geometry {
namespace {

Body build(const design::Values& values) {
    const double length_m = values.number("geometry.length");
    const Model model = model_of(values);
    const bool cut_y = model != Model::solid, cut_z = model == Model::quarter;
    const double width_m = values.number("geometry.width") / (cut_y ? 2 : 1);
    const double height_m = values.number("geometry.height") / (cut_z ? 2 : 1);
    constexpr int across = 2;  // of the whole width and height
    const CellSize size{values, std::sqrt(values.number("geometry.width") * values.number("geometry.height")) / across};
    const auto min_cells = [&](bool cut) { return size.is_stated() || cut ? 1 : across; };

    Body body;
    body.section = meshing::rectangle({length_m,
                                       height_m,
                                       size.along(length_m),
                                       size.through(height_m, 0, min_cells(cut_z)),
                                       {cut_z ? meshing::symmetry_z_face : "bottom"},
                                       {"end"},
                                       {"top"},
                                       {"fixed"}});
    body.sweep = meshing::Extrusion{
        width_m, size.along(width_m, min_cells(cut_y)), {cut_y ? meshing::symmetry_y_face : "left"}, {"right"}};
    body.symmetry_planes = {false, cut_y, cut_z};
    body.fraction = (cut_y ? 0.5 : 1.0) * (cut_z ? 0.5 : 1.0);
    return body;
}

}  // namespace

Family rod() {
    design::FamilyKeys keys;
    keys.name = "rod";
    keys.summary = "a box fixed at x = 0 and pulled at its end";
    keys.geometry = {
        length_key("length", "100 mm", "length along x, from the fixed face x = 0"),
        length_key("width", "10 mm", "width along y; half and quarter models are the upper half, y = 0 in the middle"),
        length_key("height", "10 mm", "height along z; the quarter model is the upper half, z = 0 in the middle")};
    keys.models = {"solid", "half", "quarter"};
    keys.faces = {"fixed", "end", "bottom", "top", "left", "right"};
    keys.defaults =
        "supports: {fixed: fixed}\n"
        "loads:\n"
        "  end: {pressure: -50 kPa}      # negative: tension; per deformed area\n"
        "outputs:\n"
        "  elongation: {face: end, along: axis}\n";
    keys.mesh = {size_key(), through_wall_key()};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
