/// A closed tube about x, caps within the length: held at x = 0, x = length moves. The cavity has no opening.
#include "geometry/family.hpp"
#include "geometry/keys.hpp"

namespace soft::geometry {
namespace {

struct Shape {
    double length_m, outer_m, inner_m, cap_m;
};

Shape checked_shape(const design::Values& values) {
    const Shape shape{values.number("geometry.length"), values.number("geometry.outer_radius"),
                      values.number("geometry.inner_radius"), values.number("geometry.cap")};
    if (!(shape.inner_m < shape.outer_m))
        throw values.refuse("geometry.inner_radius", not_smaller(shape.inner_m, "outer_radius", shape.outer_m),
                            smaller_than(shape.outer_m));
    if (!(2 * shape.cap_m < shape.length_m))
        throw values.refuse("geometry.cap", not_smaller(shape.cap_m, "half the length", 0.5 * shape.length_m),
                            smaller_than(0.5 * shape.length_m));
    return shape;
}

struct Counts {
    int cap, along, inside, through;
};

/// Five rectangles: the two caps, each below and above the inner radius, and the wall between them.
Section section_of(const Shape& shape, const Counts& n) {
    Section s;
    const std::array<double, 4> x{0, shape.cap_m, shape.length_m - shape.cap_m, shape.length_m};
    const std::array<double, 3> r{0, shape.inner_m, shape.outer_m};
    std::array<std::array<int, 3>, 4> p{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 3; ++j) p[i][j] = add_point(s, {x[i], r[j]});
    using Names = std::vector<std::string>;
    const std::array<Names, 4> ends{Names{"fixed"}, Names{"cavity"}, Names{"cavity"}, Names{"inlet"}};
    for (std::size_t i = 0; i < 4; ++i) {
        const bool inner = i == 1 || i == 2;
        add_line(s, {p[i][0], p[i][1]}, n.inside, ends[i]);
        add_line(s, {p[i][1], p[i][2]}, n.through, inner ? Names{} : ends[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const bool cap = i != 1;
        const int cells = cap ? n.cap : n.along;
        if (cap) add_line(s, {p[i][0], p[i + 1][0]}, cells, {axis_face});
        add_line(s, {p[i][1], p[i + 1][1]}, cells, cap ? Names{} : Names{"cavity"});
        add_line(s, {p[i][2], p[i + 1][2]}, cells, {"outer"});
        for (std::size_t j = cap ? 0 : 1; j < 2; ++j)
            add_block(s, {{{p[i][j], p[i + 1][j]}, {p[i + 1][j], p[i + 1][j + 1]}, {p[i + 1][j + 1], p[i][j + 1]},
                           {p[i][j + 1], p[i][j]}}});
    }
    return s;
}

Body build(const design::Values& values) {
    const Shape shape = checked_shape(values);
    const double size_m = values.number("mesh.size");
    Body body;
    body.section = section_of(shape, {divisions(shape.cap_m, size_m), divisions(shape.length_m - 2 * shape.cap_m, size_m),
                                      divisions(shape.inner_m, size_m),
                                      cells_through_wall(values, shape.outer_m - shape.inner_m)});
    body.sweep = Revolution{values.count("mesh.sectors")};
    body.cavities = {{"cavity", "cavity", {}, {}}};
    return body;
}

}  // namespace

Family tube() {
    design::FamilyKeys keys;
    keys.name = "tube";
    keys.summary = "a closed tube, held at one end, inflated";
    keys.geometry = {length_key("length", "100 mm", "outer length along x, caps included"),
                     length_key("outer_radius", "10 mm", "radius of the outer face"),
                     length_key("inner_radius", "7 mm", "radius of the cavity"),
                     length_key("cap", "5 mm", "thickness of each cap")};
    keys.models = {"axisymmetric", "solid", "half", "quarter"};
    keys.faces = {"fixed", "inlet", "cavity", "outer"};
    keys.defaults = "supports: {fixed: fixed}\n"
                    "loads:\n"
                    "  cavity: {pressure: 30 kPa}\n"
                    "outputs:\n"
                    "  elongation: {face: inlet, along: axis}\n";
    keys.mesh = {size_key("1.5 mm"), through_wall_key(), sectors_key()};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
