/// A closed tube about x; the length includes the caps. It is fixed at x = 0; the face x = length moves. The cavity has no opening.
#include "geometry/family.hpp"
#include "geometry/keys.hpp"
#include "geometry/tube_section.hpp"

namespace soft::geometry {
namespace {

Body build(const design::Values& values) {
    const TubeShape shape = tube_shape(values);
    const CellSize size = tube_cells(shape, values);
    const WallLayer wall{shape.outer_m, size.through_ring(shape.inner_m, shape.outer_m)};
    Body body;
    body.warnings = tube_warnings(shape, size, wall.through);
    body.section = tube_section(shape, size, {&wall, 1});
    body.sweep = Revolution{sectors(values)};
    body.cavities = {{"cavity", "cavity", {}, {}}};
    return body;
}

}  // namespace

Family tube() {
    design::FamilyKeys keys = tube_keys();
    keys.name = "tube";
    keys.summary = "a closed tube, fixed at one end, inflated";
    return {std::move(keys), build};
}

}  // namespace soft::geometry
