/// The section of a long thick cylinder about z, drawn in (x, y); it cannot lengthen. Every model is cut at x = 0 and
/// y = 0; the solid is the slice z = 0 .. length, whose ends slide in their own planes.
#include "geometry/family.hpp"
#include "geometry/keys.hpp"

#include <numbers>

namespace soft::geometry {
namespace {

meshing::Section section_of(double inner_m, double outer_m, int through, int around) {
    meshing::Section s;
    const int centre = add_point(s, {0, 0});
    const int a = add_point(s, {inner_m, 0}), b = add_point(s, {outer_m, 0});
    const int c = add_point(s, {0, outer_m}), d = add_point(s, {0, inner_m});
    add_line(s, {a, b}, through, {meshing::symmetry_y_face});
    add_arc(s, {b, c}, centre, around, {"outer"});
    add_line(s, {c, d}, through, {meshing::symmetry_x_face});
    add_arc(s, {d, a}, centre, around, {"cavity"});
    add_block(s, {{{a, b}, {b, c}, {c, d}, {d, a}}});
    return s;
}

Body build(const design::Values& values) {
    const double inner_m = values.number("geometry.inner_radius"), outer_m = values.number("geometry.outer_radius");
    if (!(inner_m < outer_m))
        throw values.refuse("geometry.inner_radius", not_smaller(inner_m, "outer_radius", outer_m),
                            smaller_than(outer_m));
    constexpr int least_around = 4;  // as for a quarter of the sphere's meridian
    const double size_m = values.number("mesh.size");
    const bool solid = model_of(values) == Model::solid;

    Body body;
    body.section = section_of(inner_m, outer_m, cells_through_wall(values, outer_m - inner_m),
                              meshing::divisions(0.25 * std::numbers::pi * (inner_m + outer_m), size_m, least_around));
    body.symmetry_planes = {true, true, false};
    body.fraction = 0.25;
    body.cavities = {{"cavity", "cavity", {}, {}}};
    if (solid) {
        const double length_m = values.number("geometry.length");
        body.sweep = meshing::Extrusion{
            length_m, meshing::divisions(length_m, size_m), {"left"}, {"right"}, meshing::Extrusion::Along::z};
        body.supports = {{"left", {false, false, true}}, {"right", {false, false, true}}};
        // The cavity goes on beyond both ends; the plugs that stand for it push on faces held against them.
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
    keys.geometry = {
        length_key("inner_radius", "10 mm", "radius of the cavity"),
        length_key("outer_radius", "20 mm", "radius of the outer face; every model holds the quarter x, y >= 0"),
        length_key("length", "10 mm", "length along z of the solid slice; in plane strain it is 1 m")};
    keys.models = {"plane-strain", "solid"};
    keys.faces = {"cavity", "outer", "left", "right"};
    keys.defaults =
        "supports: {}                    # the symmetry planes hold the ring\n"
        "loads:\n"
        "  cavity: {pressure: 80 kPa}\n"
        "outputs: {}                     # the cavity's volume is in every curve\n";
    keys.mesh = {size_key("2.5 mm"), through_wall_key()};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
