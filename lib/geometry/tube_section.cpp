#include "geometry/tube_section.hpp"

#include <algorithm>

#include "geometry/family.hpp"
#include "geometry/keys.hpp"

namespace soft::geometry {

namespace {
constexpr Radii usual{7e-3, 10e-3};
}

design::FamilyKeys tube_keys() {
    design::FamilyKeys keys;
    keys.geometry = radii_keys(usual, "radius of the cavity", "radius of the outer face");
    keys.geometry.insert(keys.geometry.begin(), length_key("length", "100 mm", "outer length along x, caps included"));
    keys.geometry.push_back(
        derived_key("cap", "thickness of each cap; auto: 5/3 of the wall, at most a tenth of the length"));
    keys.models = {"axisymmetric", "solid", "half", "quarter"};
    keys.faces = {"fixed", "inlet", "cavity", "outer"};
    keys.defaults =
        "supports: {fixed: fixed}\n"
        "loads:\n"
        "  cavity: {pressure: 30 kPa}\n"
        "outputs:\n"
        "  elongation: {face: inlet, along: axis}\n";
    keys.mesh = {size_key(), through_wall_key(), sectors_key()};
    return keys;
}

TubeShape tube_shape(const design::Values& values) {
    const double length_m = values.number("geometry.length");
    const auto [inner_m, outer_m] = radii_of(values, usual);
    const double cap_m = length_or(values, "cap", std::min(5.0 / 3 * (outer_m - inner_m), 0.1 * length_m));
    const TubeShape shape{length_m, outer_m, inner_m, cap_m};
    if (!(2 * shape.cap_m < shape.length_m))
        throw values.refuse("geometry.cap", not_smaller(shape.cap_m, "half the length", 0.5 * shape.length_m),
                            smaller_than(0.5 * shape.length_m));
    return shape;
}

CellSize tube_cells(const TubeShape& shape, const design::Values& values) {
    constexpr double section_share = 0.297, solid_share = 0.6;  // of the bending length
    return {values, (model_of(values) == Model::axisymmetric ? section_share : solid_share) *
                        bending_length(0.5 * (shape.inner_m + shape.outer_m), shape.wall_m())};
}

std::vector<std::string> tube_warnings(const TubeShape& shape, const CellSize& size, const Division& through) {
    // Longer cells do not resolve bending at the caps: error 0.7 % of the elongation at four times the normal length, 8 % at nine.
    constexpr double max_length = 4.2;
    std::vector<std::string> warnings = size.too_long(max_length);
    for (std::string& few : too_few_through_ring(size, shape.inner_m, shape.outer_m, through, max_innermost_cylinder))
        warnings.push_back(std::move(few));
    return warnings;
}

/// Rectangles: one below the inner radius for each cap, and three for every layer (within both caps and between them).
meshing::Section tube_section(const TubeShape& shape, const CellSize& size, std::span<const WallLayer> layers) {
    meshing::Section s;
    // A thin cap bends like a plate, near its edge within about its thickness.
    const double core_m = size.is_stated() ? size.length_m() : std::min(size.length_m(), 0.6 * shape.cap_m);
    const int core_cells = meshing::divisions(shape.inner_m, core_m);
    const int cap_cells = size.along(shape.cap_m, size.is_stated() ? 1 : 2);
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
        add_line(s, {p[i][0], p[i][1]}, core_cells, ends[i]);
        for (std::size_t j = 1; j < last; ++j)
            add_graded_line(s, {p[i][j], p[i][j + 1]}, layers[j - 1].through.cells, layers[j - 1].through.grading,
                            inner ? Names{} : ends[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const bool cap = i != 1;
        const int cells = cap ? cap_cells : size.along(shape.length_m - 2 * shape.cap_m);
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
