#include "geometry/tube_section.hpp"

#include "geometry/keys.hpp"

namespace soft::geometry {

design::FamilyKeys tube_keys() {
    design::FamilyKeys keys;
    keys.geometry = {length_key("length", "100 mm", "outer length along x, caps included"),
                     length_key("outer_radius", "10 mm", "radius of the outer face"),
                     length_key("inner_radius", "7 mm", "radius of the cavity"),
                     length_key("cap", "5 mm", "thickness of each cap")};
    keys.models = {"axisymmetric", "solid", "half", "quarter"};
    keys.faces = {"fixed", "inlet", "cavity", "outer"};
    keys.defaults =
        "supports: {fixed: fixed}\n"
        "loads:\n"
        "  cavity: {pressure: 30 kPa}\n"
        "outputs:\n"
        "  elongation: {face: inlet, along: axis}\n";
    keys.mesh = {size_key("1.5 mm"), through_wall_key(), sectors_key()};
    return keys;
}

TubeShape tube_shape(const design::Values& values) {
    const TubeShape shape{values.number("geometry.length"), values.number("geometry.outer_radius"),
                          values.number("geometry.inner_radius"), values.number("geometry.cap")};
    if (!(shape.inner_m < shape.outer_m))
        throw values.refuse("geometry.inner_radius", not_smaller(shape.inner_m, "outer_radius", shape.outer_m),
                            smaller_than(shape.outer_m));
    if (!(2 * shape.cap_m < shape.length_m))
        throw values.refuse("geometry.cap", not_smaller(shape.cap_m, "half the length", 0.5 * shape.length_m),
                            smaller_than(0.5 * shape.length_m));
    return shape;
}

/// Rectangles: of the two caps those below the inner radius, and of every layer three, within the caps and between them.
meshing::Section tube_section(const TubeShape& shape, double size_m, std::span<const WallLayer> layers) {
    meshing::Section s;
    const std::array<double, 4> x{0, shape.cap_m, shape.length_m - shape.cap_m, shape.length_m};
    std::vector<double> r{0, shape.inner_m};
    for (const WallLayer& layer : layers) r.push_back(layer.outer_m);
    const std::size_t last = r.size() - 1;
    std::array<std::vector<int>, 4> p;
    for (std::size_t i = 0; i < 4; ++i)
        for (const double radius : r) p[i].push_back(add_point(s, {x[i], radius}));
    using Names = std::vector<std::string>;
    const std::array<Names, 4> ends{Names{"fixed"}, Names{"cavity"}, Names{"cavity"}, Names{"inlet"}};
    for (std::size_t i = 0; i < 4; ++i) {
        const bool inner = i == 1 || i == 2;
        add_line(s, {p[i][0], p[i][1]}, meshing::divisions(shape.inner_m, size_m), ends[i]);
        for (std::size_t j = 1; j < last; ++j)
            add_line(s, {p[i][j], p[i][j + 1]}, layers[j - 1].cells, inner ? Names{} : ends[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const bool cap = i != 1;
        const int cells = meshing::divisions(cap ? shape.cap_m : shape.length_m - 2 * shape.cap_m, size_m);
        for (std::size_t j = cap ? 0 : 1; j <= last; ++j)
            add_line(s, {p[i][j], p[i + 1][j]}, cells,
                     j == 0             ? Names{meshing::axis_face}
                     : j == last        ? Names{"outer"}
                     : j == 1 && i == 1 ? Names{"cavity"}
                                        : Names{});
        for (std::size_t j = cap ? 0 : 1; j < last; ++j)
            add_block(s,
                      {{{p[i][j], p[i + 1][j]},
                        {p[i + 1][j], p[i + 1][j + 1]},
                        {p[i + 1][j + 1], p[i][j + 1]},
                        {p[i][j + 1], p[i][j]}}},
                      j == 0 ? "rubber"
                      : cap  ? layers[j - 1].cap_region
                             : layers[j - 1].region);
    }
    return s;
}

}  // namespace soft::geometry
