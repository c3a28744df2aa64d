/// A round body about x with two to four closed chambers around its axis. Each chamber has its own pressure, so that the body bends in
/// any direction. Chambers are sectors of a ring, the first centred on the direction z; caps close them at both ends.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/units.hpp"
#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "geometry/fiber_keys.hpp"
#include "geometry/keys.hpp"
#include "meshing/capped.hpp"
#include "meshing/section_mesher.hpp"

namespace soft::geometry {
namespace {

constexpr const char *jacket_region = "jacket", *jacket_material = "geometry.jacket.material",
                     *jacket_fibers = "geometry.jacket.fibers";
constexpr int max_chambers = 4;

constexpr const char* chamber_prefix = "chamber_";
std::string chamber_name(int k) { return chamber_prefix + std::to_string(k + 1); }

/// Rings of the section from the bore outward; the chambers lie in the second one.
constexpr std::size_t chamber_ring = 1;

struct Shape {
    int chambers;
    double length_m, cap_m, web_rad;
    std::vector<double> radii_m;  ///< of the bore, both sides of the chambers, [inside of the jacket,] outside
    bool jacket;

    [[nodiscard]] double chamber_rad() const { return 2 * std::numbers::pi / chambers - web_rad; }
    /// Angle at which chamber k begins, from y toward z.
    [[nodiscard]] double begin_rad(int k) const {
        return 0.5 * std::numbers::pi + 2 * std::numbers::pi * k / chambers - 0.5 * chamber_rad();
    }
};

Shape checked_shape(const design::Values& values) {
    const auto number = [&](const char* key) { return values.number(std::string{"geometry."} + key); };
    const double outer_m = number("outer_radius"), length_m = number("length");
    const double bore_m = length_or(values, "bore_radius", outer_m / 4),
                 core_m = length_or(values, "core", outer_m / 6), wall_m = length_or(values, "wall", outer_m / 6),
                 cap_m = length_or(values, "cap", 0.25 * std::min(outer_m, length_m));
    const double jacket_m = number("jacket.thickness");
    Shape shape{values.count("geometry.chambers"), length_m, cap_m, number("web"), {}, jacket_m > 0};
    const double inside_m = bore_m + core_m, outside_m = outer_m - wall_m;
    if (!(inside_m < outside_m))
        throw values.refuse("geometry.wall", length_text(wall_m) + " leaves no chamber between core and wall",
                            outer_m > inside_m
                                ? smaller_than(outer_m - inside_m) + " = outer_radius - bore_radius - core"
                                : "use outer_radius above " + length_text(inside_m));
    if (!(jacket_m < wall_m))
        throw values.refuse("geometry.jacket.thickness", not_smaller(jacket_m, "wall", wall_m), smaller_than(wall_m));
    if (!(2 * shape.cap_m < shape.length_m))
        throw values.refuse("geometry.cap", not_smaller(shape.cap_m, "half the length", 0.5 * shape.length_m),
                            smaller_than(0.5 * shape.length_m));
    if (!(shape.chamber_rad() > 0))
        throw values.refuse(
            "geometry.web", "it leaves no angle for the chambers",
            "use a value below " + core::quantity_text(2 * std::numbers::pi / shape.chambers, core::Dimension::angle));
    shape.radii_m = {bore_m, inside_m, outside_m};
    if (shape.jacket) shape.radii_m.push_back(outer_m - jacket_m);
    shape.radii_m.push_back(outer_m);
    return shape;
}

struct Counts {
    std::vector<int> rings;  ///< across each
    int chamber, web;        ///< around
    int cap, along;
};

Counts counts_of(const Shape& shape, const design::Values& values) {
    // Cells turn by less than 29 degrees: at 30 degrees the area error of their quadratic edges is 1.6e-4.
    const auto turns = [](double angle_rad) {
        return static_cast<int>(std::ceil(angle_rad / (29 * std::numbers::pi / 180)));
    };
    constexpr int own_through = 2, min_along = 6;
    constexpr double share = 0.85;  // of the radius
    const double middle_m = 0.5 * (shape.radii_m[1] + shape.radii_m[2]), outer_m = shape.radii_m.back();
    const double between_m = shape.length_m - 2 * shape.cap_m;
    const CellSize size{values, std::min(share * outer_m, between_m / min_along)};
    Counts n{{},
             size.along(middle_m * shape.chamber_rad(), size.is_stated() ? 3 : std::max(3, turns(shape.chamber_rad()))),
             size.through(middle_m * shape.web_rad, std::max(own_through, turns(shape.web_rad))),
             size.through(shape.cap_m, own_through),
             size.along(between_m)};
    const double wall_m = outer_m - shape.radii_m[chamber_ring + 1];
    const int through = size.through(wall_m, own_through);
    for (std::size_t ring = 0; ring + 1 < shape.radii_m.size(); ++ring) {
        const double width_m = shape.radii_m[ring + 1] - shape.radii_m[ring];
        n.rings.push_back(
            ring == chamber_ring ? size.along(width_m)
            : ring < chamber_ring
                ? size.through(width_m, own_through)
                : std::max(1, static_cast<int>(std::lround(through * width_m / wall_m))));  // jacket included
    }
    return n;
}

std::string region_of(const Shape& shape, std::size_t ring, int piece) {
    if (ring == chamber_ring && piece % 2 == 0) return chamber_name(piece / 2);
    return shape.jacket && ring + 2 == shape.radii_m.size() ? jacket_region : meshing::rubber_region;
}

/// Section in (y, z): rings divided into alternating chambers and webs; chambers are meshed like the rest.
meshing::Section section_of(const Shape& shape, const Counts& n) {
    meshing::Section s;
    const int centre = add_point(s, {0, 0}), pieces = 2 * shape.chambers;
    const std::size_t rings = n.rings.size();
    std::vector<std::vector<int>> points(rings + 1);
    for (std::size_t i = 0; i <= rings; ++i)
        for (int j = 0; j < pieces; ++j) {
            const double angle = shape.begin_rad(j / 2) + (j % 2 == 0 ? 0 : shape.chamber_rad());
            points[i].push_back(add_point(s, {shape.radii_m[i] * std::cos(angle), shape.radii_m[i] * std::sin(angle)}));
        }
    const auto at = [&](std::size_t i, int j) { return points[i][static_cast<std::size_t>(j % pieces)]; };
    using Names = std::vector<std::string>;
    for (int j = 0; j < pieces; ++j) {
        for (std::size_t i = 0; i <= rings; ++i)
            add_arc(s, {at(i, j), at(i, j + 1)}, centre, j % 2 == 0 ? n.chamber : n.web,
                    i == 0       ? Names{"bore"}
                    : i == rings ? Names{"outer"}
                                 : Names{});
        for (std::size_t i = 0; i < rings; ++i) add_line(s, {at(i, j), at(i + 1, j)}, n.rings[i]);
    }
    for (int j = 0; j < pieces; ++j)
        for (std::size_t i = 0; i < rings; ++i)
            add_block(s,
                      {{{at(i, j), at(i + 1, j)},
                        {at(i + 1, j), at(i + 1, j + 1)},
                        {at(i + 1, j + 1), at(i, j + 1)},
                        {at(i, j + 1), at(i, j)}}},
                      region_of(shape, i, j));
    return s;
}

double cells_of(const Shape& shape, const Counts& n) {
    double across = 0;
    for (const int cells : n.rings) across += cells;
    return across * shape.chambers * (static_cast<double>(n.chamber) + n.web) * (2.0 * n.cap + n.along);
}

Body build(const design::Values& values) {
    const Shape shape = checked_shape(values);
    const Counts n = counts_of(shape, values);
    refuse_too_many_cells(values, cells_of(shape, n));
    Body body;
    const int through = std::accumulate(n.rings.begin() + chamber_ring + 1, n.rings.end(), 0);  // jacket included
    body.warnings = CellSize{values, shape.radii_m.back()}.too_few(through, 2);  // error with one cell: 3 %
    body.sweep =
        ReadyMesh{meshing::capped(section_of(shape, n), {shape.length_m, shape.cap_m, n.cap, n.along, "fixed", "end"},
                                  chamber_prefix),
                  model::Kinematics::solid};
    for (int k = 0; k < shape.chambers; ++k) body.cavities.push_back({chamber_name(k), chamber_name(k), {}, {}});
    body.region_materials = {{jacket_region, values.text(jacket_material)}};
    if (const model::Fibers fibers = fibers_of(values, jacket_fibers); fibers.k1_Pa > 0) {
        if (!shape.jacket)
            throw values.refuse(std::string{jacket_fibers} + ".k1", "the fibres need a jacket",
                                "use jacket.thickness above 0");
        body.region_fibers[jacket_region] = {fibers};
    }
    return body;
}

std::vector<design::Key> geometry_keys() {
    design::Key chambers{
        .path = "geometry.chambers",
        .kind = design::Kind::count,
        .fallback = "3",
        .meaning =
            "chambers around the axis, called chamber_1, ...; the first lies in direction z, the second toward -y",
        .min = 2,
        .max = max_chambers};
    design::Key web{.path = "geometry.web",
                    .kind = design::Kind::angle,
                    .fallback = "30 deg",
                    .meaning = "angle between neighbouring chambers",
                    .min = 0,
                    .max = std::numbers::pi,
                    .min_open = true};
    design::Key jacket =
        length_key("jacket.thickness", "0 mm",
                   "thickness of the outermost part of the wall, which may have another material; 0 = none");
    jacket.min_open = false;
    design::Key material{.path = jacket_material,
                         .kind = design::Kind::text,
                         .fallback = meshing::rubber_region,
                         .meaning = "material of the jacket: a name below `materials`, or rubber"};
    std::vector<design::Key> keys{
        std::move(chambers),
        length_key("length", "40 mm", "length along x, from the fixed face x = 0; caps included"),
        length_key("outer_radius", "12 mm", "outer radius of the body"),
        derived_key("bore_radius", "radius of the open bore along the axis; auto: outer_radius / 4"),
        derived_key("core", "thickness between bore and chambers; auto: outer_radius / 6"),
        derived_key("wall", "thickness between chambers and outer face, jacket included; auto: outer_radius / 6"),
        std::move(web),
        derived_key("cap",
                    "thickness of each cap; auto: a quarter of outer_radius or of the length, whichever is smaller"),
        std::move(jacket),
        std::move(material)};
    const FiberDefaults defaults{
        "85 deg", "; steep fibres keep the body from swelling, so that it lengthens and bends instead", "0 MPa"};
    for (design::Key& key : fiber_keys(jacket_fibers, defaults)) keys.push_back(std::move(key));
    return keys;
}

}  // namespace

Family segment() {
    design::FamilyKeys keys;
    keys.name = "segment";
    keys.summary = "a round body with 2 to 4 chambers around its axis, each with its own pressure";
    keys.geometry = geometry_keys();
    keys.models = {"solid"};
    keys.faces = {"fixed", "end", "outer", "bore"};
    keys.cavities.clear();
    for (int k = 0; k < max_chambers; ++k) {
        keys.faces.push_back(chamber_name(k));
        keys.cavities.push_back(chamber_name(k));
    }
    keys.defaults =
        "supports: {fixed: fixed}\n"
        "loads:\n"
        "  cavities:\n"
        "    chamber_1: {pressure: 20 kPa}\n"
        "outputs:\n"
        "  bend: {face: end, measure: bend, reference: fixed, along: y}      # away from chamber_1\n"
        "  sideways: {face: end, measure: bend, reference: fixed, along: z}\n"
        "  elongation: {face: end, along: axis}\n";
    keys.mesh = {size_key(), through_wall_key()};
    return {std::move(keys), build};
}

}  // namespace soft::geometry
