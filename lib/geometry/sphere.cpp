/// A thick spherical shell about the origin. Every model is cut at x = 0: this symmetry plane prevents rigid motion along the axis
/// without further supports.
#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "geometry/keys.hpp"

#include <numbers>

namespace soft::geometry {
namespace {

constexpr Radii usual{10e-3, 20e-3};

Body build(const design::Values& values) {
    const auto [inner_m, outer_m] = radii_of(values, usual);
    constexpr int min_around = 4;  // per quarter turn
    const CellSize size{values, ring_cell_m(inner_m, outer_m)};
    const Division through = size.through_ring(inner_m, outer_m);
    const int around = size.along(0.25 * std::numbers::pi * (inner_m + outer_m), min_around);

    Body body;
    add_quarter_ring(body.section, {inner_m, outer_m, through.cells, through.grading, around, meshing::axis_face,
                                    "outer", meshing::symmetry_x_face, "cavity"});
    body.warnings = too_few_through_ring(size, inner_m, outer_m, through, max_innermost_sphere);
    body.sweep = Revolution{sectors(values)};
    body.cavities = {{"cavity", "cavity", {}, {}}};
    body.symmetry_planes = {true, false, false};
    body.fraction = 0.5;
    body.anchoring = Anchoring::middle_planes;
    return body;
}

}  // namespace

Family sphere() {
    design::FamilyKeys keys;
    keys.name = "sphere";
    keys.summary = "a thick spherical shell, inflated";
    keys.geometry =
        radii_keys(usual, "radius of the cavity", "radius of the outer face; every model is the half x >= 0");
    keys.models = {"axisymmetric", "solid", "half", "quarter"};
    keys.faces = {"cavity", "outer"};
    keys.defaults =
        "supports: {}                    # the symmetry planes support the shell\n"
        "loads:\n"
        "  cavity: {pressure: 100 kPa}\n"
        "outputs: {}                     # every curve contains the cavity volume\n";
    keys.mesh = {size_key(), through_wall_key(), sectors_key()};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
