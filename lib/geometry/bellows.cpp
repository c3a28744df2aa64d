/// Bellows: convolutions between two discs; the inlet disc has a bore. The first trough lies at x = -pitch, the last at
/// x = (convolutions - 1) pitch (the ends of their lands, if any). The end disc behind it is fixed; the inlet moves towards -x.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/bellows_shape.hpp"
#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "geometry/keys.hpp"
#include "geometry/strip.hpp"

namespace soft::geometry {
namespace {

using Names = std::vector<std::string>;

struct Counts {
    int through, bend, straight, crest_land, trough_land, below_neck, above_neck, neck, disc, disc_radial, core;
};

bool is_section(const design::Values& values) { return model_of(values) == Model::axisymmetric; }

/// Largest errors of bend, elongation and volume of seven bending bellows (walls of 1.5 to 3 mm, strips of 72 and 120 degrees, with and
/// without lands), up to 4 kPa, relative to finer meshes: normal 0.5 %, draft 5.2 % (6 % with one cell in a bend).
double walls_per_cell(const design::Values& values) { return is_section(values) ? 0.5 : 1.5; }

CellSize cells_of(const BellowsShape& shape, const design::Values& values) {
    return {values, walls_per_cell(values) * shape.wall_m};
}

Counts counts_of(const BellowsShape& shape, const design::Values& values) {
    const CellSize size = cells_of(shape, values);
    constexpr int min_bend = 2;  // a half bend turns by about 84 degrees
    const auto cells = [&](double length_m, int min_cells = 1) { return size.along(length_m, min_cells); };
    // The state varies slowly along the wall between the bends: longer cells cost no accuracy there (measured).
    constexpr double straight_stretch = 1.2;
    // The discs hardly deform; half of a solid's cells were in them. In sections cells cost little.
    const double disc_stretch = is_section(values) ? 1 : 3;
    const bool is_sharp = shape.fillet_m < 0.25 * shape.wall_m;  // two cells are badly shaped in such a sharp bend
    constexpr int min_through = 3;  // with two cells the bends are 0.6 % too soft for any grading (measured)
    return {.through = size.through(shape.wall_m, is_section(values) || is_sharp ? min_through : 2, min_through),
            .bend = std::max(is_section(values) ? 1 : min_bend,
                             cells((shape.fillet_m + 0.5 * shape.wall_m) * shape.bend_rad, min_bend)),
            .straight = cells(shape.straight_m / straight_stretch),
            .crest_land = cells(shape.crest_land_m),
            .trough_land = cells(shape.trough_land_m),
            .below_neck = cells(shape.neck_at_m),
            .above_neck = cells((shape.straight_m - shape.neck_at_m) / straight_stretch),
            .neck = cells(shape.neck_length_m),
            .disc = cells((shape.disc_length_m + shape.disc_corner[0]) / disc_stretch),
            .disc_radial = cells((shape.disc_radius_m - shape.neck_radius_m) / disc_stretch),
            .core = cells(shape.bore_m / disc_stretch)};
}

/// A cut through the wall: the points on its cavity side and on its outer side, connected by a line.
struct Cut {
    int inside, outside;
};

/// Local x to global: origin at a trough, +1 for a wall that rises with x, -1 for one that falls.
struct Frame {
    double origin_m;
    int sign;
    [[nodiscard]] meshing::PlanePoint global(meshing::PlanePoint local) const {
        return {origin_m + sign * local[0], local[1]};
    }
};

class Drawing {
public:
    explicit Drawing(const design::Values& values) : shapes_(shapes_of(values)), values_(values) {}

    meshing::Section draw() {
        Cut trough{};
        const int convolutions = static_cast<int>(shapes_.size());
        for (int i = 0; i < convolutions; ++i) {
            shape_ = shapes_[static_cast<std::size_t>(i)];
            n_ = counts_of(shape_, values_);
            const double half_land_m = 0.5 * shape_.trough_land_m;
            const Frame rising{(i - 1) * shape_.pitch_m + half_land_m, 1},
                falling{i * shape_.pitch_m - half_land_m, -1};
            Cut crest = crest_middle(rising);
            if (i == 0)
                wall(rising, add_end(rising, "inlet", {"cavity"}), n_.above_neck, crest);
            else
                convolution_half(rising, half_land_m > 0 ? land(trough, trough_middle(rising), n_.trough_land) : trough,
                                 crest);
            if (shape_.crest_land_m > 0) crest = land(crest, crest_middle(falling), n_.crest_land);
            if (i == convolutions - 1) {
                wall(falling, add_end(falling, "fixed", {}), n_.above_neck, crest);
                add_core(falling);
            } else {
                trough = trough_middle(falling);
                convolution_half(falling, trough, crest);
            }
        }
        return std::move(section_);
    }

private:
    int point(const Frame& frame, meshing::PlanePoint local) { return add_point(section_, frame.global(local)); }

    /// Cells through a bend are graded towards its small radius, where the strain varies fastest: the cavity side at a crest
    /// (height 1 along the wall), the outer side at a trough (height 0). They are uniform half way between.
    Cut add_cut(const Frame& frame, meshing::PlanePoint inside, meshing::PlanePoint outside, double height) {
        const Cut cut{point(frame, inside), point(frame, outside)};
        add_graded_line(section_, {cut.inside, cut.outside}, n_.through,
                        std::pow(shape_.bend_grading(), 2 * height - 1));
        return cut;
    }
    Cut wall_cut(const Frame& frame, double distance_m) {
        return add_cut(frame, shape_.on_wall(shape_.cavity_offset_m(), distance_m),
                       shape_.on_wall(shape_.outer_offset_m(), distance_m), distance_m / shape_.straight_m);
    }
    Cut trough_middle(const Frame& frame) {
        return add_cut(frame, {0, shape_.bore_m}, {0, shape_.bore_m + shape_.wall_m}, 0);
    }
    Cut crest_middle(const Frame& frame) {
        const double half_m = shape_.half_m;
        return add_cut(frame, {half_m, shape_.crest_m - shape_.wall_m}, {half_m, shape_.crest_m}, 1);
    }

    /// The block between two cuts; its sides are straight or arcs about a centre.
    void strip(Cut from, Cut to, int centre, int cells) {
        add_arc(section_, {from.inside, to.inside}, centre, cells, {"cavity"});
        add_arc(section_, {from.outside, to.outside}, centre, cells, {"outer"});
        add_block(section_, {{{from.inside, to.inside},
                              {to.inside, to.outside},
                              {to.outside, from.outside},
                              {from.outside, from.inside}}});
    }

    Cut land(Cut from, Cut to, int cells) {
        strip(from, to, meshing::Curve::straight, cells);
        return to;
    }

    void convolution_half(const Frame& frame, Cut trough, Cut crest) {
        const Cut foot = wall_cut(frame, 0);
        strip(trough, foot, point(frame, {0, shape_.trough_centre_m}), n_.bend);
        wall(frame, foot, n_.straight, crest);
    }

    /// The straight wall from a cut to the crest, and the half bend at the crest.
    void wall(const Frame& frame, Cut start, int cells, Cut crest) {
        const Cut top = wall_cut(frame, shape_.straight_m);
        strip(start, top, meshing::Curve::straight, cells);
        strip(top, crest, point(frame, {shape_.half_m, shape_.crest_centre_m}), n_.bend);
    }

    Cut add_end(const Frame& frame, const std::string& end_face, const Names& bore_faces);
    void add_core(const Frame& frame);

    std::vector<BellowsShape> shapes_;
    const design::Values& values_;
    BellowsShape shape_{};  ///< of the current convolution
    Counts n_{};
    meshing::Section section_;
    int bore_inner_ = 0, bore_outer_ = 0;  ///< of the last end: the line between disc and bore (or core)
};

/// Adds disc, neck and the wall up to the point where its outer face leaves the neck; returns the cut there.
/// Blocks: root (the cells of the wall continue below the neck), neck, and three of the disc (below, beside, above the neck).
Cut Drawing::add_end(const Frame& frame, const std::string& end_face, const Names& bore_faces) {
    const double end_m = -shape_.disc_length_m;
    const int root_cells = n_.bend + n_.below_neck;
    const Cut cut = wall_cut(frame, shape_.neck_at_m);
    const int foot = point(frame, shape_.on_wall(shape_.cavity_offset_m(), 0));
    const int bore = point(frame, {0, shape_.bore_m}), bore_end = point(frame, {end_m, shape_.bore_m});
    const int fork = point(frame, shape_.fork), below = point(frame, shape_.below_corner);
    const int side = point(frame, {end_m, shape_.below_corner[1]}),
              neck_end = point(frame, {end_m, shape_.neck_radius_m});
    const int corner = point(frame, shape_.disc_corner);
    const int rim = point(frame, {shape_.disc_corner[0], shape_.disc_radius_m});
    const int rim_end = point(frame, {end_m, shape_.disc_radius_m});

    meshing::Section& s = section_;
    add_arc(s, {bore, foot}, point(frame, {0, shape_.trough_centre_m}), n_.bend, {"cavity"});
    add_line(s, {foot, cut.inside}, n_.below_neck, {"cavity"});
    add_line(s, {cut.outside, fork}, root_cells);
    add_line(s, {fork, bore}, n_.through);
    add_block(s, {{{bore, foot, cut.inside}, {cut.inside, cut.outside}, {cut.outside, fork}, {fork, bore}}});

    add_line(s, {below, fork}, n_.neck);
    add_line(s, {cut.outside, corner}, n_.neck, {"outer"});
    add_line(s, {corner, below}, root_cells);
    add_block(s, {{{below, fork}, {fork, cut.outside}, {cut.outside, corner}, {corner, below}}});

    add_line(s, {bore_end, bore}, n_.disc + n_.neck, bore_faces);
    add_line(s, {side, below}, n_.disc);
    add_line(s, {bore_end, side}, n_.through, {end_face});
    add_block(s, {{{bore_end, bore}, {bore, fork}, {fork, below, side}, {side, bore_end}}});

    add_line(s, {neck_end, corner}, n_.disc);
    add_line(s, {side, neck_end}, root_cells, {end_face});
    add_block(s, {{{side, below}, {below, corner}, {corner, neck_end}, {neck_end, side}}});

    add_line(s, {corner, rim}, n_.disc_radial, {"outer"});
    add_line(s, {rim, rim_end}, n_.disc, {"outer"});
    add_line(s, {rim_end, neck_end}, n_.disc_radial, {end_face});
    add_block(s, {{{neck_end, corner}, {corner, rim}, {rim, rim_end}, {rim_end, neck_end}}});
    bore_inner_ = bore;
    bore_outer_ = bore_end;
    return cut;
}

/// The fixed disc has no bore: its core closes the cavity.
void Drawing::add_core(const Frame& frame) {
    const int inner = point(frame, {0, 0}), outer = point(frame, {-shape_.disc_length_m, 0});
    meshing::Section& s = section_;
    add_line(s, {inner, outer}, n_.disc + n_.neck, {meshing::axis_face});
    add_line(s, {outer, bore_outer_}, n_.core, {"fixed"});
    add_line(s, {bore_inner_, inner}, n_.core, {"cavity_end"});
    add_block(s, {{{inner, outer}, {outer, bore_outer_}, {bore_outer_, bore_inner_}, {bore_inner_, inner}}});
}

design::Key land_key(std::string_view name, std::string_view meaning) {
    design::Key key = length_key(name, "0 mm", meaning);
    key.min_open = false;
    return key;
}

/// Errors for the paper's bellows: 0.6 % with cells of 1.5 walls, 3.7 % with cells of two walls; 4.4 % with one cell through the
/// wall, 0.1 % with two.
std::vector<std::string> coarse_mesh(const design::Values& values) {
    constexpr double max_walls = 1.65;
    constexpr int min_through = 2;
    const BellowsShape shape = shape_of(values);
    const CellSize size = cells_of(shape, values);
    std::vector<std::string> warnings = size.too_long(max_walls / walls_per_cell(values));
    for (std::string& few : size.too_few(counts_of(shape, values).through, min_through))
        warnings.push_back(std::move(few));
    return warnings;
}

Body build(const design::Values& values) {
    const double bore_m = values.number("geometry.bore_radius");
    Body body;
    body.section = Drawing{values}.draw();
    add_strip_sector(body, values);
    body.warnings = coarse_mesh(values);
    body.sweep = Revolution{sectors(values)};
    body.axis = {-1, 0, 0};  // the inlet lies at the lower x
    const model::Opening bore{"inlet", std::numbers::pi * bore_m * bore_m, {-1, 0, 0}};
    body.cavities = {{"cavity", "cavity", {"cavity_end"}, {bore}}};
    return body;
}

}  // namespace

Family bellows() {
    design::FamilyKeys keys;
    keys.name = "bellows";
    keys.summary = "the paper's bellows: convolutions between an inlet disc and a fixed end disc";
    design::Key convolutions;
    convolutions.path = "geometry.convolutions";
    convolutions.kind = design::Kind::count;
    convolutions.fallback = "10";
    convolutions.meaning = "number of crests";
    convolutions.min = 1;
    convolutions.max = 1000;
    design::Key last_crest =
        length_key("last_crest_radius", "same", "crest_radius of the convolution at the fixed end; linear in between");
    last_crest.choices = {"same"};
    keys.geometry = {
        std::move(convolutions),
        length_key("pitch", "9.25 mm", "length of a convolution, trough to trough"),
        length_key("crest_radius", "19 mm", "outermost radius of the rubber"),
        length_key("bore_radius", "2.5 mm", "innermost radius of the rubber: radius of the bore and of the troughs"),
        length_key("wall", "3 mm", "thickness of the wall"),
        derived_key("fillet", "inner radius of every bend; its outer radius is fillet + wall; auto: wall / 12"),
        land_key("crest_land", "straight length of every crest along x, in addition to its bends"),
        land_key("trough_land",
                 "straight length of every trough between two convolutions; if both lands are half the "
                 "pitch minus wall and two fillets, the walls are upright: square convolutions"),
        std::move(last_crest),
        derived_key(
            "end_disc.length",
            "length from the plane of the last trough to the outer face, at both ends; auto: two walls, or what the neck needs"),
        derived_key("end_disc.radius",
                    "radius of both discs; auto: crest_radius minus 1.5 walls, at least a wall more than the neck"),
        derived_key(
            "neck.length",
            "length between disc and outer wall; auto: wall / 3, or what keeps the disc clear of the first crest"),
        derived_key(
            "neck.radius",
            "radius of the neck; must meet the straight part of the outer wall; auto: bore_radius plus 1.5 walls, moved "
            "onto that part"),
        strip_angle_key(),
        strip_material_key()};
    keys.models = {"axisymmetric", "solid", "half", "quarter"};
    keys.faces = {"fixed", "inlet", "cavity", "cavity_end", "outer"};
    keys.aliases = {{"end_disc", "fixed"}};
    keys.defaults =
        "supports: {fixed: end_disc}\n"
        "loads:\n"
        "  cavity: {pressure: 30 kPa, sealed: true}   # sealed: also on the plug of the bore and the end disc\n"
        "outputs:\n"
        "  elongation: {face: inlet, along: axis}     # area mean of the displacement\n";
    keys.mesh = {size_key(), through_wall_key(), sectors_key()};
    describe_strip_sectors(keys.mesh);
    return {std::move(keys), build};
}

}  // namespace soft::geometry
