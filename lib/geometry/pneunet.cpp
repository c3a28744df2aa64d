/// A bending finger: a row of chambers with slots between them, connected by a channel, on a base that stretches less. All
/// corners are sharp. x starts at the fixed end, z points up from the lower face, y = 0 is the middle; the half model is y >= 0.
#include <algorithm>
#include <cmath>

#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "geometry/keys.hpp"
#include "meshing/box_grid.hpp"
#include "meshing/cell_counts.hpp"
#include "meshing/section_mesher.hpp"

namespace soft::geometry {
namespace {

constexpr const char *layer_region = "layer", *cavity_face = "cavity", *layer_material = "geometry.layer.material";

struct Shape {
    int chambers;
    double chamber_m, gap_m, half_width_m, height_m, wall_m, side_m, roof_m;
    double base_m, bridge_m, channel_half_width_m, channel_height_m, root_m, tip_m, layer_m;

    [[nodiscard]] double chamber_at(int i) const { return root_m + i * (chamber_m + gap_m); }
    [[nodiscard]] double chambers_end() const { return chamber_at(chambers - 1) + chamber_m; }
    [[nodiscard]] double length() const { return chambers_end() + tip_m; }
};

/// Upper bound of a length, and its name in messages.
struct Bound {
    double value_m;
    const char* what;
};
void require_below(const design::Values& values, const char* key, double value_m, Bound bound) {
    if (!(value_m < bound.value_m))
        throw values.refuse(key, not_smaller(value_m, bound.what, bound.value_m), smaller_than(bound.value_m));
}
void require_within(const design::Values& values, const char* key, double value_m, Bound bound) {
    constexpr double rounding = 1 + 1e-9;  // the bound is a difference of keys
    if (value_m > rounding * bound.value_m)
        throw values.refuse(key,
                            length_text(value_m) + " exceeds " + bound.what + " (" + length_text(bound.value_m) + ")",
                            "use at most " + length_text(bound.value_m));
}

void check(const Shape& s, const design::Values& values) {
    require_below(values, "geometry.wall", s.wall_m, {0.5 * s.chamber_m, "half the chamber_length"});
    require_below(values, "geometry.side", s.side_m, {s.half_width_m, "half the width"});
    require_below(values, "geometry.roof", s.roof_m, {s.height_m, "the height"});
    require_below(values, "geometry.bridge", s.bridge_m, {s.height_m, "the height of the chambers"});
    require_below(values, "geometry.channel.height", s.channel_height_m, {s.bridge_m, "the bridge that covers it"});
    require_within(values, "geometry.channel.height", s.channel_height_m,
                   {s.height_m - s.roof_m, "the height of the cavities"});
    require_within(values, "geometry.channel.width", 2 * s.channel_half_width_m,
                   {2 * (s.half_width_m - s.side_m), "the width of the cavities"});
    require_below(values, "geometry.layer.thickness", s.layer_m, {s.base_m, "the base"});
}

Shape checked_shape(const design::Values& values) {
    const auto length = [&](const char* key) { return values.number(std::string{"geometry."} + key); };
    const double height_m = length("height"), width_m = length("width"),
                 bridge_m = length_or(values, "bridge", 0.25 * height_m);
    const double channel_width_m =
        length_or(values, "channel.width", std::min(0.25 * width_m, width_m - 2 * length("side")));
    const double channel_height_m =
        length_or(values, "channel.height", std::min(0.5 * bridge_m, height_m - length("roof")));
    const Shape shape{.chambers = values.count("geometry.chambers"),
                      .chamber_m = length("chamber_length"),
                      .gap_m = length("gap"),
                      .half_width_m = 0.5 * width_m,
                      .height_m = height_m,
                      .wall_m = length("wall"),
                      .side_m = length("side"),
                      .roof_m = length("roof"),
                      .base_m = length("base"),
                      .bridge_m = bridge_m,
                      .channel_half_width_m = 0.5 * channel_width_m,
                      .channel_height_m = channel_height_m,
                      .root_m = length("root"),
                      .tip_m = length("tip"),
                      .layer_m = length("layer.thickness")};
    check(shape, values);
    return shape;
}

std::vector<meshing::Box> boxes_of(const Shape& s) {
    const double w = s.half_width_m;
    std::vector<meshing::Box> boxes{
        {{0, 0, 0}, {s.length(), w, s.base_m + s.bridge_m}, meshing::Fill::solid, meshing::rubber_region}};
    for (int i = 0; i < s.chambers; ++i) {
        const double x = s.chamber_at(i), end = x + s.chamber_m;
        boxes.push_back(
            {{x, 0, s.base_m}, {end, w, s.base_m + s.height_m}, meshing::Fill::solid, meshing::rubber_region});
        boxes.push_back({{x + s.wall_m, 0, s.base_m},
                         {end - s.wall_m, w - s.side_m, s.base_m + s.height_m - s.roof_m},
                         meshing::Fill::hollow,
                         cavity_face});
    }
    if (s.chambers > 1)  // from the first chamber's cavity to the last one's
        boxes.push_back({{s.chamber_at(0) + s.wall_m, 0, s.base_m},
                         {s.chambers_end() - s.wall_m, s.channel_half_width_m, s.base_m + s.channel_height_m},
                         meshing::Fill::hollow,
                         cavity_face});
    if (s.layer_m > 0) boxes.push_back({{0, 0, 0}, {s.length(), w, s.layer_m}, meshing::Fill::solid, layer_region});
    return boxes;
}

CellSize size_of(const Shape& shape, const design::Values& values) {
    constexpr double share = 0.3;
    return {values, share * std::cbrt(shape.chamber_m * 2 * shape.half_width_m * shape.height_m)};
}

constexpr int min_through = 2;

/// The stress is singular at the edges of cavities and slots. Largest differences of the bend and of the change of volume at a bend of 5 degrees a
/// chamber, of twelve shapes (walls of 1 to 2.5 mm, chambers 8 to 20 mm long, 12 to 25 mm high, 14 to 30 mm wide): normal 0.6 and 0.7 %, draft
/// 2.4 and 3.4 %, from a mesh with 119,507 to 143,331 unknowns.
/// One cell through a wall has the bend within 1 % too, but the wall bulges 2 to 3 % too far, so that chambers touch too early; sides and
/// roofs with a short span hardly bulge.
meshing::Spacing spacing_of(const Shape& shape, const CellSize& size, const design::Values& values) {
    constexpr double growth = 2.5, fine_edges = 3, short_span = 3, stretch = 1.5, one_sided_stretch = 2;
    const double quality = quality_factor(values), thinnest_m = std::min({shape.wall_m, shape.side_m, shape.roof_m});
    const double edge_m = std::min(size.length_m(), thinnest_m / (quality > 1 ? fine_edges : quality));
    const double stated_grading = values.number("mesh.grading");
    const double span_m = shape.chamber_m - 2 * shape.wall_m;
    const auto cells_through = [&](double thickness_m) {
        return meshing::cell_count(
            [&] { return quality < 1 || (quality == 1 && span_m < short_span * thickness_m) ? 1 : min_through; });
    };
    meshing::Spacing spacing{size.length_m(),
                             {min_through, cells_through(shape.side_m), cells_through(shape.roof_m)},
                             size.length_m() / edge_m,
                             growth,
                             quality == 1 ? stretch : 1,
                             quality == 1 ? one_sided_stretch : 1};
    if (stated_grading > 0) spacing.grading = stated_grading;
    if (const int through = values.count("mesh.through_wall"); through > 0)
        spacing.min_cells = {through, through, std::max(1, through - 1)};
    return spacing;
}

Body build(const design::Values& values) {
    const Shape shape = checked_shape(values);
    const bool half = model_of(values) == Model::half;
    meshing::BoxBody boxes{.boxes = boxes_of(shape),
                           .extent = half ? meshing::Extent::as_drawn : meshing::Extent::mirrored_in_y};
    boxes.borders[0] = {{{"fixed", true}, {"tip"}}};
    if (half) boxes.borders[1][0] = {meshing::symmetry_y_face};
    boxes.borders[2][0] = {"bottom"};
    const CellSize size = size_of(shape, values);
    const meshing::Spacing spacing = spacing_of(shape, size, values);
    refuse_too_many_cells(values, cells_of_boxes(boxes, spacing));

    Body body;
    const int stated = values.count("mesh.through_wall");
    body.warnings = size.too_few(stated > 0 ? stated : scaled_count(values, min_through), min_through);
    body.sweep = ReadyMesh{mesh_of_boxes(boxes, spacing), model::Kinematics::solid};
    body.cavities = {{cavity_face, cavity_face, {}, {}}};  // closed, because the supply line is not modelled
    body.symmetry_planes = {false, half, false};
    body.fraction = half ? 0.5 : 1.0;
    if (half) body.supports = {{meshing::symmetry_y_face, {false, true, false}}};
    body.region_materials = {{layer_region, values.text(layer_material)}};
    return body;
}

std::vector<design::Key> geometry_keys() {
    design::Key chambers{.path = "geometry.chambers",
                         .kind = design::Kind::count,
                         .fallback = "4",
                         .meaning = "number of chambers in the row",
                         .min = 1,
                         .max = 100};
    design::Key layer = length_key("layer.thickness", "0 mm",
                                   "thickness of a layer of another material, the lowest part of the base; 0 = none");
    layer.min_open = false;
    design::Key material{
        .path = layer_material,
        .kind = design::Kind::text,
        .fallback = "paper",
        .meaning =
            "material of the layer: a name below `materials`, paper (copy paper of 6.5 GPa; measure yours), or rubber"};
    return {
        std::move(chambers),
        length_key("chamber_length", "8 mm", "outer length of a chamber along x"),
        length_key("gap", "1 mm", "width of the free slots between chambers, along x"),
        length_key("width", "16 mm", "outer width along y; half models are the half y >= 0"),
        length_key("height", "16 mm", "outer height of the chambers above the base"),
        length_key("wall", "1.5 mm", "thickness of the chamber walls at the slots, along x"),
        length_key("side", "2 mm", "thickness of the chamber sides, along y"),
        length_key("roof", "2 mm", "thickness of the chamber roofs"),
        length_key("base", "3 mm", "solid thickness below the cavities, from z = 0"),
        derived_key("bridge", "height above the base of root, tip and the blocks across the slots; auto: height / 4"),
        derived_key(
            "channel.width",
            "width along y of the channel on the base that connects the cavities; auto: width / 4, at most the width of "
            "the cavities"),
        derived_key(
            "channel.height",
            "height of the channel, below that of the bridge that covers it; auto: bridge / 2, at most the height of the "
            "cavities"),
        length_key("root", "8 mm", "solid length before the first chamber, from the fixed face x = 0"),
        length_key("tip", "3 mm", "solid length after the last chamber"),
        std::move(layer),
        std::move(material)};
}

}  // namespace

Family pneunet() {
    design::FamilyKeys keys;
    keys.name = "pneunet";
    keys.summary = "a bending finger: a row of chambers with slots between them on a stiffer base";
    keys.geometry = geometry_keys();
    keys.models = {"half", "solid"};
    keys.faces = {"fixed", "tip", "cavity", "bottom", "outer"};
    keys.defaults =
        "supports: {fixed: fixed}\n"
        "loads:\n"
        "  cavity: {pressure: 3.5 kPa}\n"
        "outputs:\n"
        "  bend: {face: tip, measure: bend, reference: fixed, along: y}   # positive toward the base\n"
        "  forward: {face: tip, along: x}\n"
        "  up: {face: tip, along: z}\n";
    // Copy paper: Young's modulus 6.5 GPa, Poisson's ratio 0.2, as in the Soft Robotics Toolkit's model of this actuator.
    keys.materials = {{"paper", "{law: neo-hookean, mu: 2.708 GPa, kappa: 3.611 GPa, density: 750 kg/m^3}"}};
    design::Key min_cells = through_wall_key();
    min_cells.meaning =
        "minimum number of cells between neighbouring planes of the body, through walls and across slots; one fewer along z; "
        "auto: 2, and 1 along y and z for draft and where sides and roofs span less than three times their thickness";
    min_cells.min = 1;
    design::Key grading = grading_key("auto");
    grading.choices = {"auto"};
    grading.meaning += "; auto: the shortest are as long as the thinnest wall (draft twice, fine a third)";
    keys.mesh = {size_key(), std::move(min_cells), std::move(grading)};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
