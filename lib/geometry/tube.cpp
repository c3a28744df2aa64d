/// A closed tube about x, caps within the length: held at x = 0, x = length moves. The cavity has no opening.
#include "geometry/family.hpp"
#include "geometry/keys.hpp"
#include "geometry/tube_section.hpp"

namespace soft::geometry {
namespace {

Body build(const design::Values& values) {
    const TubeShape shape = tube_shape(values);
    const WallLayer wall{shape.outer_m, cells_through_wall(values, shape.wall_m())};
    Body body;
    body.section = tube_section(shape, values.number("mesh.size"), {&wall, 1});
    body.sweep = Revolution{values.count("mesh.sectors")};
    body.cavities = {{"cavity", "cavity", {}, {}}};
    return body;
}

}  // namespace

Family tube() {
    design::FamilyKeys keys = tube_keys();
    keys.name = "tube";
    keys.summary = "a closed tube, held at one end, inflated";
    return {std::move(keys), build};
}

}  // namespace soft::geometry
