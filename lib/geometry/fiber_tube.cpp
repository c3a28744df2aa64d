/// A closed tube (tube.cpp), round or half-round, with fibres in a layer of its wall along the whole length or between the caps: two
/// families at plus and minus the angle (a braid: McKibben muscle), or one, which twists the tube. A strip of another material makes
/// the tube bend. The rubber between the fibres is materials.fibers if stated, else the main material. material/fibers.hpp defines
/// the energy of the fibres.
#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "geometry/family.hpp"
#include "geometry/fiber_keys.hpp"
#include "geometry/half_round.hpp"
#include "geometry/keys.hpp"
#include "geometry/strip.hpp"
#include "geometry/tube_section.hpp"
#include "meshing/box_grid.hpp"
#include "meshing/capped.hpp"
#include "meshing/cell_counts.hpp"

namespace soft::geometry {
namespace {

constexpr const char *fiber_region = "fibers", *flat_fiber_region = "fibers_flat";
constexpr const char *flat_key = "geometry.flat", *strip_thickness_key = "geometry.strip.thickness",
                     *fibers_prefix = "geometry.fibers", *layer_key = "geometry.fibers.layer",
                     *caps_key = "geometry.fibers.caps";

/// Smallest share of the wall; a thinner layer would need extremely thin cells.
constexpr double min_share = 0.01;

struct Layer {
    double begin, end;  ///< fractions of the wall, from inside
};

Layer checked_layer(const design::Values& values) {
    const char* path = layer_key;
    const std::vector<double>& bounds = values.numbers(path);
    const auto text = [](double number) { return core::number_text(number); };
    if (bounds.size() != 2)
        throw values.refuse(path, std::to_string(bounds.size()) + " value, but two are needed",
                            "use [inner, outer], such as [0, 1]");
    const Layer layer{bounds[0], bounds[1]};
    if (!(layer.begin < layer.end))
        throw values.refuse(
            path, "the layer from " + text(layer.begin) + " to " + text(layer.end) + " is empty or runs inwards",
            "use [inner, outer] with inner below outer");
    for (const double share : {layer.begin, layer.end - layer.begin, 1 - layer.end})
        if (share > 0 && share < min_share)
            throw values.refuse(path, "a part of the wall has " + text(share) + " of its thickness",
                                "use 0, or at least " + text(min_share));
    return layer;
}

enum class Reach { whole_length, between_caps };  ///< of the fibres

Reach reach_of(const design::Values& values) {
    return values.text(caps_key) == "true" ? Reach::whole_length : Reach::between_caps;
}

/// Rubber, fibres, rubber. Mesh lines follow the bounds of the fibre layer.
std::vector<WallLayer> wall_layers(const TubeShape& shape, const Layer& layer, Division wall, Reach reach) {
    std::vector<WallLayer> layers;
    double inner_m = shape.inner_m;
    const auto add = [&](double begin, double end, const char* region) {
        if (!(begin < end)) return;
        const double outer_m = end < 1 ? shape.inner_m + end * shape.wall_m() : shape.outer_m;
        // The share of cells that grow with the radius follows from the logarithm of the radii.
        const double share =
            wall.grading == 1 ? end - begin : std::log(outer_m / inner_m) / std::log(shape.outer_m / shape.inner_m);
        const int cells =
            meshing::cell_count([&] { return std::max(1, static_cast<int>(std::lround(share * wall.cells))); });
        layers.push_back({outer_m,
                          {cells, wall.grading == 1 ? 1 : std::pow(outer_m / inner_m, 1 - 1.0 / cells)},
                          region,
                          reach == Reach::whole_length ? region : "rubber"});
        inner_m = outer_m;
    };
    add(0, layer.begin, "rubber");
    add(layer.begin, layer.end, fiber_region);
    add(layer.end, 1, "rubber");
    return layers;
}

void lay_fibers(Body& body, const design::Values& values) {
    body.region_fibers[fiber_region] = {fibers_of(values, fibers_prefix)};
}

Body round_tube(const design::Values& values, const TubeShape& shape, const std::vector<WallLayer>& layers) {
    if (values.number(strip_thickness_key) > 0)
        throw values.refuse(strip_thickness_key, "a round tube has no flat wall",
                            "use geometry.strip.angle, or geometry.flat above 0");
    Body body;
    const CellSize size = tube_cells(shape, values);
    body.section = tube_section(shape, size, layers);
    body.warnings = tube_warnings(shape, size, size.through_ring(shape.inner_m, shape.outer_m));
    body.sweep = Revolution{sectors(values)};
    body.cavities = {{"cavity", "cavity", {}, {}}};
    lay_fibers(body, values);
    add_strip_sector(body, values);
    return body;
}

/// The fibres cross the flat wall in straight lines. Below the ring, along its sides, they keep the direction of the ring.
Body half_tube(const design::Values& values, const TubeShape& shape, const std::vector<WallLayer>& layers) {
    const Model model = model_of(values);
    if (model != Model::solid && model != Model::half)
        throw values.refuse(
            flat_key, "model " + core::quoted(values.text("model")) + " assumes a symmetry that a flat wall breaks",
            "use model: solid or half");
    if (values.number("geometry.strip.angle") > 0)
        throw values.refuse("geometry.strip.angle", "the strip of a half-round tube lies in its flat wall",
                            "use geometry.strip.thickness");
    const double flat_m = values.number(flat_key), strip_m = values.number(strip_thickness_key);
    if (!(strip_m < flat_m))
        throw values.refuse(strip_thickness_key, not_smaller(strip_m, "flat", flat_m), smaller_than(flat_m));
    constexpr int own_through = 2;
    const CellSize size = tube_cells(shape, values);
    const HalfRoundCells cells{(sectors(values).upper.front().cells + 1) / 2, size.through(flat_m, own_through),
                               size.length_m()};
    const meshing::Capped along{shape.length_m,
                                shape.cap_m,
                                size.through(shape.cap_m, own_through),
                                meshing::graded_shares(size.along(shape.length_m - 2 * shape.cap_m), 1, {}),
                                "fixed",
                                "inlet",
                                reach_of(values) == Reach::whole_length
                                    ? std::vector<std::string>{}
                                    : std::vector<std::string>{fiber_region, flat_fiber_region}};
    const meshing::Section section = half_round_section({shape.inner_m, shape.outer_m, flat_m, strip_m}, layers, cells,
                                                        model == Model::half ? Cut::half : Cut::whole);
    refuse_too_many_cells(values, cell_count(section) * along.layers());
    Body body;
    body.sweep = ReadyMesh{meshing::capped(section, along, "cavity"), model::Kinematics::solid};
    body.cavities = {{"cavity", "cavity", {}, {}}};
    if (model == Model::half) {
        body.symmetry_planes = {false, true, false};
        body.fraction = 0.5;
        body.supports = {{meshing::symmetry_y_face, {false, true, false}}};
    }
    lay_fibers(body, values);
    body.region_fibers[flat_fiber_region] = {body.region_fibers.at(fiber_region).fibers, model::FiberFrame::cartesian};
    body.region_materials[flat_fiber_region] = fiber_region;
    if (strip_m > 0) add_strip_materials(body, values);
    return body;
}

Body build(const design::Values& values) {
    const TubeShape shape = tube_shape(values);
    const std::vector<WallLayer> layers =
        wall_layers(shape, checked_layer(values), tube_cells(shape, values).through_ring(shape.inner_m, shape.outer_m),
                    reach_of(values));
    return values.number(flat_key) > 0 ? half_tube(values, shape, layers) : round_tube(values, shape, layers);
}

std::vector<design::Key> own_keys() {
    design::Key flat =
        length_key("flat", "0 mm",
                   "thickness of the flat wall, below z = 0, of a half-round tube (model: half or solid); 0 = round");
    flat.min_open = false;
    std::vector<design::Key> keys{std::move(flat)};
    const FiberDefaults defaults{"30 deg", "; below 54.74 deg a thin braided tube shortens, above it lengthens",
                                 "0.5 MPa"};
    for (design::Key& key : fiber_keys(fibers_prefix, defaults)) keys.push_back(std::move(key));
    keys.push_back({.path = layer_key,
                    .kind = design::Kind::ratio,
                    .fallback = "[0, 1]",
                    .meaning = "position of the fibres in the wall: [inner, outer] as fractions of its thickness",
                    .min = 0,
                    .max = 1,
                    .max_count = 2});
    keys.push_back(
        {.path = caps_key,
         .kind = design::Kind::flag,
         .fallback = "true",
         .meaning = "true: fibres along the whole tube; false: only between the caps, which are plain rubber"});
    design::Key strip = length_key(
        "strip.thickness", "0 mm",
        "thickness of the lowest part of the flat wall, made of the strip material, so that the tube bends; 0 = none");
    strip.min_open = false;
    keys.insert(keys.end(), {strip_angle_key(), std::move(strip), strip_material_key()});
    return keys;
}

}  // namespace

Family fiber_tube() {
    design::FamilyKeys keys = tube_keys();
    describe_strip_sectors(keys.mesh);
    keys.name = "fiber-tube";
    keys.summary =
        "a closed tube with fibres in its wall: shortens, lengthens or twists depending on their angle, or bends";
    keys.faces.emplace_back("bottom");  // of a half-round tube
    for (design::Key& key : own_keys()) keys.geometry.push_back(std::move(key));
    return {std::move(keys), build};
}

}  // namespace soft::geometry
