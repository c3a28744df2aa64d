/// Section of a long thick cylinder about z in (x, y); its length is fixed. Every model is cut at x = 0 and y = 0. The solid is
/// the slice z = 0 .. length; its ends slide in their planes.
#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "geometry/keys.hpp"

#include <numbers>

namespace soft::geometry {
namespace {

constexpr Radii usual{10e-3, 20e-3};

Body build(const design::Values& values) {
    const auto [inner_m, outer_m] = radii_of(values, usual);
    constexpr int min_around = 4;  // as for a quarter of the sphere's meridian
    const CellSize size{values, ring_cell_m(inner_m, outer_m)};
    const Division through = size.through_ring(inner_m, outer_m);
    const bool solid = model_of(values) == Model::solid;

    Body body;
    add_quarter_ring(body.section, {inner_m, outer_m, through.cells, through.grading,
                                    size.along(0.25 * std::numbers::pi * (inner_m + outer_m), min_around),
                                    meshing::symmetry_y_face, "outer", meshing::symmetry_x_face, "cavity"});
    body.warnings = too_few_through_ring(size, inner_m, outer_m, through, max_innermost_cylinder);
    body.symmetry_planes = {true, true, false};
    body.fraction = 0.25;
    body.cavities = {{"cavity", "cavity", {}, {}}};
    if (solid) {
        const double length_m = values.number("geometry.length");
        body.sweep =
            meshing::Extrusion{length_m, size.along(length_m), {"left"}, {"right"}, meshing::Extrusion::Along::z};
        body.supports = {{"left", {false, false, true}}, {"right", {false, false, true}}};
        // The cavity continues beyond both ends; the plugs that represent this act on faces that supports fix.
        const double hole_m2 = std::numbers::pi * inner_m * inner_m;
        body.cavities.front().openings = {{"left", hole_m2, {0, 0, -1}}, {"right", hole_m2, {0, 0, 1}}};
    } else {
        body.sweep = meshing::Extrusion{};
    }
    return body;
}

}  // namespace

Family ring() {
    design::FamilyKeys keys;
    keys.name = "ring";
    keys.summary = "the section of a long thick cylinder, inflated";
    keys.geometry =
        radii_keys(usual, "radius of the cavity", "radius of the outer face; every model is the quarter x, y >= 0");
    keys.geometry.push_back(
        length_key("length", "10 mm", "length along z of the solid slice; in plane strain it is 1 m"));
    keys.models = {"plane-strain", "solid"};
    keys.faces = {"cavity", "outer", "left", "right"};
    keys.defaults =
        "supports: {}                    # the symmetry planes support the ring\n"
        "loads:\n"
        "  cavity: {pressure: 80 kPa}\n"
        "outputs: {}                     # every curve contains the cavity volume\n";
    keys.mesh = {size_key(), through_wall_key()};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
