/// A round body about x with two to four closed chambers around its axis. Each chamber has its own pressure, so that the body bends in
/// any direction. Chambers are sectors of a ring, the first centred on the direction z; caps close them at both ends.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/units.hpp"
#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "geometry/fiber_keys.hpp"
#include "geometry/keys.hpp"
#include "geometry/mirror_symmetry.hpp"
#include "meshing/box_grid.hpp"
#include "meshing/capped.hpp"
#include "meshing/cell_counts.hpp"
#include "meshing/section_mesher.hpp"

namespace soft::geometry {
namespace {

constexpr const char *jacket_region = "jacket", *jacket_material = "geometry.jacket.material",
                     *jacket_fibers = "geometry.jacket.fibers";
constexpr int max_chambers = 4;

enum class Extent { whole, half };

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
};

/// Half of a chamber or of a web.
struct Sector {
    double begin_rad, end_rad;  ///< from y toward z
    int chamber;                ///< from 0, or `web`
    bool outgoing;              ///< begins in the middle of the chamber or web
    static constexpr int web = -1;
};

/// The sectors of the whole body, or of the half y >= 0, in the order of their angles from the direction -z.
std::vector<Sector> sectors_of(const Shape& shape, Extent extent) {
    const int n = shape.chambers;  // the middles of chambers (even) and webs (odd) are at equal angles
    const auto middle_rad = [&](int i) { return std::numbers::pi * (0.5 + static_cast<double>(i) / n); };
    const auto width_rad = [&](int i) { return 0.5 * (i % 2 == 0 ? shape.chamber_rad() : shape.web_rad); };
    const auto chamber = [&](int i) { return i % 2 == 0 ? i / 2 % n : Sector::web; };
    std::vector<Sector> sectors;
    for (int i = n; i < (extent == Extent::half ? 2 : 3) * n; ++i) {
        sectors.push_back({middle_rad(i), middle_rad(i) + width_rad(i), chamber(i), true});
        sectors.push_back({middle_rad(i + 1) - width_rad(i + 1), middle_rad(i + 1), chamber(i + 1), false});
    }
    return sectors;
}

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

/// Cell lengths along the parts of the body, as shares of each.
struct Cells {
    std::vector<std::vector<double>> rings;  ///< across each
    std::vector<double> chamber, web;        ///< around half of each, from the middle to the edge between them
    std::vector<double> along;               ///< between the caps
    int cap;
};

/// Lengths of cells, and their growth from one to the next away from the edges where the stress is singular.
struct Lengths {
    double shortest_m, longest_m, growth;
};

std::vector<double> cells_between(double length_m, int min_cells, const Lengths& lengths, meshing::SharpEnds sharp) {
    return meshing::growing_shares(
        length_m, min_cells,
        {lengths.longest_m, {min_cells, min_cells, min_cells}, lengths.longest_m / lengths.shortest_m, lengths.growth},
        sharp);
}

std::vector<double> even_cells(int cells) { return meshing::graded_shares(cells, 1, {}); }

/// The stress is singular at the edges of the chambers: without mesh.size, cells get shorter toward them.
/// Largest errors of the bend and of the change of volume, of six shapes: normal 1.9 and 2.3 %; of the default shape: draft 3.4 and
/// 5.7 %, fine 0.6 % (tests/verification/notes.md).
Cells cells_of(const Shape& shape, const design::Values& values) {
    constexpr int own_through = 2;
    constexpr meshing::SharpEnds both{true, true}, far{false, true};
    // Cells turn by less than 29 degrees: at 30 degrees the area error of their quadratic edges is 1.6e-4.
    const auto turns = [](double angle_rad) {
        return meshing::cell_count(
            [&] { return static_cast<int>(std::ceil(angle_rad / (29 * std::numbers::pi / 180))); });
    };
    const double outer_m = shape.radii_m.back(), quality = quality_factor(values), unit_m = outer_m / quality;
    const CellSize size{values, unit_m / 4};
    const Lengths coarse{unit_m / 4, unit_m / 4, 2}, fine{outer_m / 24, unit_m / 4, 2},
        edges = quality > 1 ? fine : Lengths{unit_m / 8, unit_m / 4, 2};
    const auto divided = [&](double length_m, int min_cells, const Lengths& lengths, meshing::SharpEnds sharp) {
        return size.is_stated() ? even_cells(size.along(length_m, min_cells))
                                : cells_between(length_m, min_cells, lengths, sharp);
    };
    // Fibres keep the section from swelling, so that it changes little along x. Without them the walls swell away from the caps, and
    // the caps bend.
    const bool has_fibers = fibers_of(values, jacket_fibers).k1_Pa > 0;
    const int own_cap = has_fibers ? 1 : 2;
    const Lengths steady{0.6 * unit_m, 4 * unit_m, 6}, swelling{0.15 * unit_m, 0.6 * unit_m, 2};
    const Lengths& blunt = quality > 1 ? fine : coarse;  // at the narrower side of an edge
    const double chamber_rad = 0.5 * shape.chamber_rad(), web_rad = 0.5 * shape.web_rad,
                 middle_m = 0.5 * (shape.radii_m[chamber_ring] + shape.radii_m[chamber_ring + 1]);
    const double wall_m = outer_m - shape.radii_m[chamber_ring + 1];
    const int through = size.through(wall_m, own_through);
    Cells cells{.rings = {},
                .chamber = divided(middle_m * chamber_rad, std::max(2, turns(chamber_rad)), edges, far),
                .web = divided(middle_m * web_rad, turns(web_rad), blunt, far),
                .along = divided(shape.length_m - 2 * shape.cap_m, 1, has_fibers ? steady : swelling, both),
                .cap = size.through(shape.cap_m, own_cap)};
    for (std::size_t ring = 0; ring + 1 < shape.radii_m.size(); ++ring) {
        const double width_m = shape.radii_m[ring + 1] - shape.radii_m[ring];
        if (ring == chamber_ring)
            cells.rings.push_back(divided(width_m, 1, edges, both));
        else if (ring < chamber_ring && !size.is_through_stated())
            cells.rings.push_back(divided(width_m, 1, blunt, far));
        else if (ring < chamber_ring)
            cells.rings.push_back(even_cells(size.through(width_m, own_through)));
        else  // jacket included
            cells.rings.push_back(even_cells(meshing::cell_count(
                [&] { return std::max(1, static_cast<int>(std::lround(through * width_m / wall_m))); })));
    }
    return cells;
}

/// A line of the grid, and the ring or sector beyond it.
struct GridLine {
    double at;  ///< radius [m] or angle from y toward z [rad]
    std::size_t part;
};

/// The lines between `begin` and `end`, without that at `end`.
void add_lines(std::vector<GridLine>& lines, double begin, double end, std::span<const double> shares,
               std::size_t part) {
    double share = 0;
    for (const double next : shares) {
        lines.push_back({std::lerp(begin, end, share), part});
        share += next;
    }
}

std::vector<GridLine> radial_lines(const Shape& shape, const Cells& cells) {
    std::vector<GridLine> lines;
    for (std::size_t i = 0; i < cells.rings.size(); ++i)
        add_lines(lines, shape.radii_m[i], shape.radii_m[i + 1], cells.rings[i], i);
    lines.push_back({shape.radii_m.back(), cells.rings.size()});
    return lines;
}

std::vector<GridLine> angular_lines(const std::vector<Sector>& sectors, const Cells& cells) {
    std::vector<GridLine> lines;
    for (std::size_t i = 0; i < sectors.size(); ++i) {
        std::vector<double> shares = sectors[i].chamber == Sector::web ? cells.web : cells.chamber;
        if (!sectors[i].outgoing) std::ranges::reverse(shares);
        add_lines(lines, sectors[i].begin_rad, sectors[i].end_rad, shares, i);
    }
    lines.push_back({sectors.back().end_rad, sectors.size()});
    return lines;
}

std::string region_of(const Shape& shape, std::size_t ring, int chamber) {
    if (ring == chamber_ring && chamber != Sector::web) return chamber_name(chamber);
    return shape.jacket && ring + 2 == shape.radii_m.size() ? jacket_region : meshing::rubber_region;
}

/// Section in (y, z): a grid of radii and angles; chambers are meshed like the rest.
meshing::Section section_of(const Shape& shape, const Cells& cells, Extent extent) {
    using Names = std::vector<std::string>;
    const std::vector<Sector> sectors = sectors_of(shape, extent);
    const std::vector<GridLine> radii = radial_lines(shape, cells), angles = angular_lines(sectors, cells);
    const bool half = extent == Extent::half;
    const std::size_t around = angles.size() - 1, across = radii.size() - 1;
    meshing::Section s;
    const int centre = add_point(s, {0, 0});
    std::vector<std::vector<int>> points(around + 1);
    for (std::size_t j = 0; j <= around; ++j) {
        if (!half && j == around) {
            points[j] = points.front();
            break;
        }
        const bool on_plane = half && (j == 0 || j == around);
        for (const GridLine& radius : radii)
            points[j].push_back(
                add_point(s, {on_plane ? 0 : radius.at * std::cos(angles[j].at), radius.at * std::sin(angles[j].at)}));
        for (std::size_t i = 0; i < across; ++i)
            add_line(s, {points[j][i], points[j][i + 1]}, 1, on_plane ? Names{meshing::symmetry_y_face} : Names{});
    }
    for (std::size_t j = 0; j < around; ++j) {
        const std::vector<int>&here = points[j], &next = points[j + 1];
        for (std::size_t i = 0; i <= across; ++i)
            add_arc(s, {here[i], next[i]}, centre, 1, i == 0 ? Names{"bore"} : i == across ? Names{"outer"} : Names{});
        for (std::size_t i = 0; i < across; ++i)
            add_block(
                s, {{{here[i], here[i + 1]}, {here[i + 1], next[i + 1]}, {next[i + 1], next[i]}, {next[i], here[i]}}},
                region_of(shape, radii[i].part, sectors[angles[j].part].chamber));
    }
    return s;
}

/// In the half: the wall of the chambers beside the plane y = 0, each of which stands for two. The whole has no such face.
constexpr const char* beside_face = "chambers_beside";

/// The faces of the half y >= 0 that designs may refer to.
std::vector<std::string> faces_of_half(const Shape& shape) {
    std::vector<std::string> faces{"fixed", "end", "outer", "bore", chamber_name(0)};
    if (shape.chambers % 2 == 0) faces.push_back(chamber_name(shape.chambers / 2));
    return faces;
}

Extent extent_of(const Shape& shape, const design::Values& values, std::vector<std::string>& notes) {
    const Model model = model_of(values);
    if (model != Model::automatic) return model == Model::half ? Extent::half : Extent::whole;
    const std::string reason = find_asymmetry(values, faces_of_half(shape));
    notes.push_back(reason.empty()
                        ? "model: half, y >= 0, because shape and loads are symmetric about y = 0"
                        : "model: the whole body, because " + reason + " may break the symmetry about y = 0");
    return reason.empty() ? Extent::half : Extent::whole;
}

Body build(const design::Values& values) {
    const Shape shape = checked_shape(values);
    const Cells cells = cells_of(shape, values);
    Body body;
    const Extent extent = extent_of(shape, values, body.notes);
    const meshing::Section section = section_of(shape, cells, extent);
    const meshing::Capped along{shape.length_m, shape.cap_m, cells.cap, cells.along, "fixed", "end"};
    refuse_too_many_cells(values, cell_count(section) * along.layers());
    std::size_t through = 0;  // jacket included
    for (std::size_t i = chamber_ring + 1; i < cells.rings.size(); ++i) through += cells.rings[i].size();
    body.warnings =
        CellSize{values, shape.radii_m.back()}.too_few(static_cast<int>(through), 2);  // error with one cell: 3 %
    mesh::Mesh mesh = meshing::capped(section, along, chamber_prefix);
    const std::vector<std::string> of_half = faces_of_half(shape);
    for (int k = 0; k < shape.chambers; ++k) {
        const std::string name = chamber_name(k);
        if (extent == Extent::whole || std::ranges::find(of_half, name) != of_half.end())
            body.cavities.push_back({name, name, {}, {}});
        else if (auto wall = mesh.facet_sets.extract(name); !wall.empty())
            std::ranges::copy(wall.mapped(), std::back_inserter(mesh.facet_sets[beside_face]));
    }
    body.sweep = ReadyMesh{std::move(mesh), model::Kinematics::solid};
    if (extent == Extent::half) {
        body.symmetry_planes = {false, true, false};
        body.fraction = 0.5;
        body.supports = {{meshing::symmetry_y_face, {false, true, false}}};
    }
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
    keys.models = {"auto", "half", "solid"};
    keys.faces = {"fixed", "end", "outer", "bore", beside_face};
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
