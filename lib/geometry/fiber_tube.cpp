/// A closed tube (tube.cpp) with fibres in a layer of its wall, from end to end: two families at plus and minus the angle (a
/// braid: McKibben's muscle), or one, which twists the tube. The rubber between the fibres is that of the region "fibers"
/// below `materials`, else the main one; their energy stands in material/fibers.hpp.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/text.hpp"
#include "geometry/family.hpp"
#include "geometry/keys.hpp"
#include "geometry/tube_section.hpp"

namespace soft::geometry {
namespace {

constexpr const char* fiber_region = "fibers";

/// A layer thinner than this part of the wall would need cells of its own thickness to be more than a line.
constexpr double least_share = 0.01;

struct Layer {
    double begin, end;   ///< fractions of the wall, from inside
};

Layer checked_layer(const design::Values& values) {
    constexpr const char* path = "geometry.fibers.layer";
    const std::vector<double>& bounds = values.numbers(path);
    const auto text = [](double number) { return core::number_text(number); };
    if (bounds.size() != 2)
        throw values.refuse(path, std::to_string(bounds.size()) + " value where two are needed", "[inner, outer], such as [0, 1]");
    const Layer layer{bounds[0], bounds[1]};
    if (!(layer.begin < layer.end))
        throw values.refuse(path, "the layer from " + text(layer.begin) + " to " + text(layer.end) + " is empty or runs inwards",
                            "[inner, outer], inner smaller than outer");
    for (const double share : {layer.begin, layer.end - layer.begin, 1 - layer.end})
        if (share > 0 && share < least_share)
            throw values.refuse(path, "a part of the wall is " + text(share) + " of it thick",
                                "0, or at least " + text(least_share));
    return layer;
}

/// Rubber, fibres, rubber; at its bounds the layer has lines of the mesh.
std::vector<WallLayer> wall_layers(const TubeShape& shape, const Layer& layer, int cells) {
    std::vector<WallLayer> layers;
    const auto add = [&](double begin, double end, const char* region) {
        if (!(begin < end)) return;
        const double outer_m = end < 1 ? shape.inner_m + end * shape.wall_m() : shape.outer_m;
        layers.push_back({outer_m, std::max(1, static_cast<int>(std::lround((end - begin) * cells))), region});
    };
    add(0, layer.begin, "rubber");
    add(layer.begin, layer.end, fiber_region);
    add(layer.end, 1, "rubber");
    return layers;
}

Body build(const design::Values& values) {
    const TubeShape shape = tube_shape(values);
    const Layer layer = checked_layer(values);
    Body body;
    body.section = tube_section(shape, values.number("mesh.size"),
                                wall_layers(shape, layer, cells_through_wall(values, shape.wall_m())));
    body.sweep = Revolution{values.count("mesh.sectors")};
    body.cavities = {{"cavity", "cavity", {}, {}}};
    body.region_fibers[fiber_region] = {values.number("geometry.fibers.angle"), values.number("geometry.fibers.k1"),
                                        values.number("geometry.fibers.k2"), values.count("geometry.fibers.families")};
    return body;
}

std::vector<design::Key> fiber_keys() {
    return {{.path = "geometry.fibers.angle",
             .kind = design::Kind::angle,
             .fallback = "30 deg",
             .meaning = "of the fibres from the axis x; below 54.74 deg a thin braided tube shortens, above it lengthens",
             .min = 0,
             .max = 0.5 * std::numbers::pi},
            {.path = "geometry.fibers.families",
             .kind = design::Kind::count,
             .fallback = "2",
             .meaning = "2: fibres at plus and minus the angle, as in a braid; 1: a single helix, which twists (model: solid)",
             .min = 1,
             .max = 2},
            {.path = "geometry.fibers.k1",
             .kind = design::Kind::pressure,
             .fallback = "0.5 MPa",
             .meaning = "stiffness of each family at small stretch, k1/(2 k2) [exp(k2 (I4 - 1)^2) - 1] per volume of the layer",
             .min = 0,
             .min_open = true},
            {.path = "geometry.fibers.k2",
             .kind = design::Kind::ratio,
             .fallback = "1",
             .meaning = "how fast the fibres stiffen",
             .min = 0,
             .min_open = true},
            {.path = "geometry.fibers.layer",
             .kind = design::Kind::ratio,
             .fallback = "[0, 1]",
             .meaning = "where in the wall they lie, from end to end of the tube: [inner, outer] as fractions of its thickness",
             .min = 0,
             .max = 1,
             .most = 2}};
}

}  // namespace

Family fiber_tube() {
    design::FamilyKeys keys = tube_keys();
    keys.name = "fiber-tube";
    keys.summary = "a closed tube with fibres wound into its wall: shortens, lengthens or twists by their angle";
    for (design::Key& key : fiber_keys()) keys.geometry.push_back(std::move(key));
    return {std::move(keys), build};
}

}  // namespace soft::geometry
