/// A thick spherical shell about the origin. Every model is cut at x = 0: with this symmetry plane nothing else need be
/// held to keep the shell from drifting along its axis.
#include "geometry/family.hpp"
#include "geometry/keys.hpp"

#include <numbers>

namespace soft::geometry {
namespace {

Body build(const design::Values& values) {
    const double inner_m = values.number("geometry.inner_radius"), outer_m = values.number("geometry.outer_radius");
    if (!(inner_m < outer_m))
        throw values.refuse("geometry.inner_radius", not_smaller(inner_m, "outer_radius", outer_m),
                            smaller_than(outer_m));
    constexpr int least_around = 4;  // per quarter turn, as for mesh.sectors
    const int through = cells_through_wall(values, outer_m - inner_m);
    const int around =
        meshing::divisions(0.25 * std::numbers::pi * (inner_m + outer_m), values.number("mesh.size"), least_around);

    Body body;
    meshing::Section& s = body.section;
    const int centre = add_point(s, {0, 0});
    const int a = add_point(s, {inner_m, 0}), b = add_point(s, {outer_m, 0});
    const int c = add_point(s, {0, outer_m}), d = add_point(s, {0, inner_m});
    add_line(s, {a, b}, through, {meshing::axis_face});
    add_arc(s, {b, c}, centre, around, {"outer"});
    add_line(s, {c, d}, through, {meshing::symmetry_x_face});
    add_arc(s, {d, a}, centre, around, {"cavity"});
    add_block(s, {{{a, b}, {b, c}, {c, d}, {d, a}}});
    body.sweep = Revolution{values.count("mesh.sectors")};
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
    keys.geometry = {
        length_key("inner_radius", "10 mm", "radius of the cavity"),
        length_key("outer_radius", "20 mm", "radius of the outer face; every model holds the half x >= 0")};
    keys.models = {"axisymmetric", "solid", "half", "quarter"};
    keys.faces = {"cavity", "outer"};
    keys.defaults =
        "supports: {}                    # the symmetry planes hold the shell\n"
        "loads:\n"
        "  cavity: {pressure: 100 kPa}\n"
        "outputs: {}                     # the cavity's volume is in every curve\n";
    keys.mesh = {size_key("2.5 mm"), through_wall_key(), sectors_key()};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
