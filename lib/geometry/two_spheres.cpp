/// Two separate thick spherical shells on the axis x, each modelled as the half beside its own symmetry plane: left of
/// x = -gap/2 and right of x = gap/2. They share at most their gas.
#include <algorithm>

#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "geometry/keys.hpp"

#include <numbers>

namespace soft::geometry {
namespace {

constexpr Radii usual{10e-3, 11e-3};

constexpr std::array<const char*, 2> plane_faces{"plane_left", "plane_right"};

Body build(const design::Values& values) {
    const auto [inner_m, outer_m] = radii_of(values, usual);
    constexpr int min_around = 4;  // per quarter turn, as for mesh.sectors
    const double right_m = inner_m + (outer_m - inner_m) * values.number("geometry.right_scale");
    const double half_gap_m = 0.5 * values.number("geometry.gap");
    // Both shells have the same cells: a difference between the meshes would act as an imperfection.
    const double thin_m = std::min(outer_m, right_m), thick_m = std::max(outer_m, right_m);
    const CellSize size{values, ring_cell_m(inner_m, thin_m)};
    const Division through = size.through_ring(inner_m, thick_m);
    const int around = size.along(0.25 * std::numbers::pi * (inner_m + outer_m), min_around);

    Body body;
    const meshing::QuarterRing left{
        inner_m,      outer_m,        through.cells, through.grading, around,      meshing::axis_face,
        "outer_left", plane_faces[0], "left",        "left",          -half_gap_m, -1};
    const meshing::QuarterRing right{
        inner_m,       right_m,        through.cells, through.grading, around,     meshing::axis_face,
        "outer_right", plane_faces[1], "right",       "right",         half_gap_m, 1};
    for (const meshing::QuarterRing& half : {left, right}) add_quarter_ring(body.section, half);
    body.warnings = too_few_through_ring(size, inner_m, thick_m, through, max_innermost_sphere);
    body.sweep = Revolution{};
    // Each cavity continues beyond its plane; the plug that represents this acts on a face that supports fix.
    const double hole_m2 = std::numbers::pi * inner_m * inner_m;
    body.cavities = {{"left", "left", {}, {{plane_faces[0], hole_m2, {1, 0, 0}}}},
                     {"right", "right", {}, {{plane_faces[1], hole_m2, {-1, 0, 0}}}}};
    body.fraction = 0.5;
    for (const char* plane : plane_faces) body.supports.push_back({plane, {true, false, false}});
    return body;
}

}  // namespace

Family two_spheres() {
    design::FamilyKeys keys;
    keys.name = "two-spheres";
    keys.summary = "two spherical shells that share one gas";
    design::Key right_scale{.path = "geometry.right_scale",
                            .kind = design::Kind::ratio,
                            .fallback = "1",
                            .meaning = "thickness of the right wall relative to the left one",
                            .min = 0,
                            .max = 10,
                            .min_open = true};
    keys.geometry = radii_keys(usual, "radius of both cavities",
                               "radius of the outer faces; the model is the outward half of each shell");
    keys.geometry.push_back(length_key("gap", "10 mm", "distance between the two symmetry planes"));
    keys.geometry.push_back(std::move(right_scale));
    keys.models = {"axisymmetric"};
    keys.faces = {"left", "right", "outer_left", "outer_right", plane_faces[0], plane_faces[1]};
    keys.cavities = {"left", "right"};
    keys.defaults =
        "supports: {}                    # the symmetry planes support the shells\n"
        "loads:\n"
        "  cavities:\n"
        "    left: {volume_ratio: 10}    # sum of both volumes\n"
        "    right: {shares: left}\n"
        "outputs: {}                     # every curve contains the volumes\n";
    keys.mesh = {size_key(), through_wall_key()};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
