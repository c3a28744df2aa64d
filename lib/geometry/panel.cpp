/// A plane panel with straight sides in (x, y): corners (0, 0), (length, rise), (length, rise + end_height),
/// (0, height). In plane strain it is 1 m deep; the solid spans z = 0 .. thickness.
#include "core/units.hpp"
#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "geometry/keys.hpp"

namespace soft::geometry {
namespace {

struct Shape {
    double length_m, height_m, end_height_m, rise_m, patch_m;

    [[nodiscard]] meshing::PlanePoint bottom(double x) const { return {x, rise_m * x / length_m}; }
    [[nodiscard]] meshing::PlanePoint top(double x) const {
        return {x, height_m + (rise_m + end_height_m - height_m) * x / length_m};
    }
};

Shape checked_shape(const design::Values& values) {
    Shape shape{values.number("geometry.length"), values.number("geometry.height"),
                values.number("geometry.end_height"), values.number("geometry.rise"),
                values.number("geometry.loaded_top")};
    if (values.text("geometry.end_height") == "height") shape.end_height_m = shape.height_m;
    if (shape.patch_m > shape.length_m)
        throw values.refuse("geometry.loaded_top",
                            core::quantity_text(shape.patch_m, core::Dimension::length) + " is longer than the panel",
                            "use at most its length, " + core::quantity_text(shape.length_m, core::Dimension::length));
    return shape;
}

/// Columns from x = 0 to the end; the first one carries the patch, if any.
meshing::Section section_of(const Shape& shape, int across, const CellSize& size) {
    std::vector<double> cuts{0};
    if (shape.patch_m > 0 && shape.patch_m < shape.length_m) cuts.push_back(shape.patch_m);
    cuts.push_back(shape.length_m);
    using Names = std::vector<std::string>;
    meshing::Section s;
    int low = add_point(s, shape.bottom(0)), high = add_point(s, shape.top(0));
    add_line(s, {high, low}, across, {"fixed"});
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        const bool last = i + 1 == cuts.size(), patch = i == 1 && shape.patch_m > 0;
        const int along = size.along(cuts[i] - cuts[i - 1]);
        const int next_low = add_point(s, shape.bottom(cuts[i])), next_high = add_point(s, shape.top(cuts[i]));
        add_line(s, {low, next_low}, along, {"bottom"});
        add_line(s, {next_low, next_high}, across, last ? Names{"end"} : Names{});
        add_line(s, {next_high, high}, along, patch ? Names{"top", "patch"} : Names{"top"});
        add_block(s, {{{low, next_low}, {next_low, next_high}, {next_high, high}, {high, low}}});
        low = next_low;
        high = next_high;
    }
    return s;
}

Body build(const design::Values& values) {
    const Shape shape = checked_shape(values);
    const double thickness_m = values.number("geometry.thickness"),
                 height_m = std::max(shape.height_m, shape.end_height_m);
    constexpr double along = 11.5;
    const CellSize size{values, std::sqrt(shape.length_m * height_m) / along};
    Body body;
    body.section = section_of(shape, size.through(height_m, 0, size.is_stated() ? 1 : 4), size);
    body.sweep =
        meshing::Extrusion{thickness_m, size.along(thickness_m), {"left"}, {"right"}, meshing::Extrusion::Along::z};
    return body;
}

}  // namespace

Family panel() {
    design::FamilyKeys keys;
    keys.name = "panel";
    keys.summary = "a plane panel, straight or tapered, fixed at x = 0";
    design::Key end_height =
        length_key("end_height", "height", "height of the face x = length; height = same as at x = 0");
    end_height.choices = {"height"};
    design::Key rise{.path = "geometry.rise",
                     .kind = design::Kind::length,
                     .fallback = "0 mm",
                     .meaning = "y of the lower corner at x = length"};
    design::Key loaded_top =
        length_key("loaded_top", "0 mm", "length of the face patch, which is the top from x = 0; 0 = none");
    loaded_top.min_open = false;
    keys.geometry = {length_key("length", "48 mm", "length along x, from the fixed face x = 0"),
                     length_key("height", "44 mm", "height of the face x = 0, along y from y = 0"),
                     std::move(end_height),
                     std::move(rise),
                     length_key("thickness", "10 mm", "thickness of the solid, along z; in plane strain it is 1 m"),
                     std::move(loaded_top)};
    keys.models = {"plane-strain", "solid"};
    keys.faces = {"fixed", "end", "bottom", "top", "patch", "left", "right"};
    keys.defaults =
        "supports: {fixed: fixed}\n"
        "loads:\n"
        "  end: {traction: 20 kPa, along: y}     # dead shear traction per undeformed area\n"
        "outputs:\n"
        "  deflection: {face: end, along: y}\n";
    design::Key across = through_wall_key();
    across.meaning = "cells between bottom and top; 0 = from mesh.size";
    keys.mesh = {size_key(), std::move(across)};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
