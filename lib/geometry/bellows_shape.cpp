#include "geometry/bellows_shape.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"
#include "geometry/keys.hpp"

namespace soft::geometry {
namespace {

BellowsShape read(const design::Values& values) {
    const auto length = [&](std::string_view key) { return values.number("geometry." + std::string{key}); };
    BellowsShape s{};
    s.convolutions = values.count("geometry.convolutions");
    s.pitch_m = length("pitch");
    s.crest_m = length("crest_radius");
    s.bore_m = length("bore_radius");
    s.wall_m = length("wall");
    s.fillet_m = length_or(values, "fillet", s.wall_m / 12);
    s.crest_land_m = length("crest_land");
    s.trough_land_m = length("trough_land");
    return s;
}

/// The straight wall is an inner common tangent of the trough arc and the crest arc: along its normal the two centres are
/// 2 fillet + wall apart.
void derive_wall(BellowsShape& s, const design::Values& values, const char* crest_key) {
    const double bend_m = s.fillet_m + s.wall_m, apart_m = 2 * s.fillet_m + s.wall_m,
                 lands_m = s.crest_land_m + s.trough_land_m;
    const double half_m = 0.5 * (s.pitch_m - lands_m);
    s.half_m = half_m;
    if (!(half_m > bend_m))
        throw values.refuse("geometry.pitch", length_text(s.pitch_m) + " lets neighbouring convolutions overlap",
                            larger_than(2 * bend_m + lands_m) + " = 2 (fillet + wall)" +
                                (lands_m > 0 ? " + crest_land + trough_land" : ""));
    const double min_rise_m = std::sqrt(std::max(0.0, apart_m * apart_m - half_m * half_m));
    const double min_crest_m = s.bore_m + 2 * bend_m + min_rise_m;
    if (!(s.crest_m > min_crest_m))
        throw values.refuse(crest_key, length_text(s.crest_m) + " leaves no straight wall between trough and crest",
                            larger_than(min_crest_m));
    s.trough_centre_m = s.bore_m + bend_m;
    s.crest_centre_m = s.crest_m - bend_m;
    const double rise_m = s.crest_centre_m - s.trough_centre_m;
    const double square_m2 = half_m * half_m + rise_m * rise_m;
    s.straight_m = std::sqrt(square_m2 - apart_m * apart_m);
    s.along = {(s.straight_m * half_m - apart_m * rise_m) / square_m2,
               (s.straight_m * rise_m + apart_m * half_m) / square_m2};
    s.outward = {-s.along[1], s.along[0]};
    s.bend_rad = std::atan2(s.along[1], s.along[0]);
}

void derive_neck(BellowsShape& s, const design::Values& values) {
    const double lowest_m = s.on_wall(s.outer_offset_m(), 0)[1],
                 highest_m = s.on_wall(s.outer_offset_m(), s.straight_m)[1];
    constexpr double inside = 0.1;  // distance from the ends of the straight part, relative to its length
    const double margin_m = inside * (highest_m - lowest_m);
    s.neck_radius_m = length_or(values, "neck.radius",
                                std::clamp(s.bore_m + 1.5 * s.wall_m, lowest_m + margin_m, highest_m - margin_m));
    s.disc_radius_m =
        length_or(values, "end_disc.radius", std::max(s.crest_m - 1.5 * s.wall_m, s.neck_radius_m + s.wall_m));
    if (!(s.neck_radius_m > lowest_m && s.neck_radius_m < highest_m))
        throw values.refuse("geometry.neck.radius",
                            length_text(s.neck_radius_m) + " does not meet the straight part of the outer wall",
                            "use a value between " + length_text(lowest_m) + " and " + length_text(highest_m));
    if (!(s.disc_radius_m > s.neck_radius_m))
        throw values.refuse(
            "geometry.end_disc.radius",
            length_text(s.disc_radius_m) + " is not larger than neck.radius (" + length_text(s.neck_radius_m) + ")",
            larger_than(s.neck_radius_m));
    s.neck_at_m = (s.neck_radius_m - lowest_m) / s.along[1];
    s.neck_corner = s.on_wall(s.outer_offset_m(), s.neck_at_m);
    s.neck_corner[1] = s.neck_radius_m;
    // The wall may overhang the neck: the disc must stay clear of the first crest.
    const double crest_edge_m = s.half_m - s.fillet_m - s.wall_m;
    s.neck_length_m =
        length_or(values, "neck.length", std::max(s.wall_m / 3, s.neck_corner[0] - crest_edge_m + s.wall_m / 6));
    s.disc_corner = {s.neck_corner[0] - s.neck_length_m, s.neck_radius_m};
    if (!(s.disc_corner[0] < crest_edge_m))
        throw values.refuse("geometry.neck.length",
                            length_text(s.neck_length_m) + " lets the first crest touch the disc",
                            larger_than(s.neck_corner[0] - crest_edge_m));
}

/// The cells of wall, neck and disc meet inside the rubber. This point is chosen so that no corner angle of the blocks exceeds
/// about 130 degrees for the paper's proportions.
void derive_fork(BellowsShape& s, const design::Values& values) {
    const double height_m = s.neck_radius_m - s.bore_m;
    constexpr double margin = 1.5;  // times the length that the neck and the cells behind it need
    s.disc_length_m =
        length_or(values, "end_disc.length", std::max(2 * s.wall_m, margin * (0.22 * height_m - s.disc_corner[0])));
    const double back_m = std::min(0.22 * height_m, 0.2 * s.disc_length_m), down_m = 0.27 * height_m;
    s.fork = {s.neck_corner[0] - back_m, s.neck_radius_m - down_m};
    s.below_corner = {s.disc_corner[0] - 0.6 * back_m, s.fork[1]};
    // The disc must extend beyond both, or its cells have no space.
    const double min_m = -s.disc_corner[0] + back_m;
    if (!(s.disc_length_m > min_m))
        throw values.refuse(
            "geometry.end_disc.length",
            length_text(s.disc_length_m) + " is too short for a neck of " + length_text(s.neck_length_m),
            larger_than(min_m));
}

}  // namespace

BellowsShape shape_of(const design::Values& values, int convolution) {
    constexpr const char* last_key = "geometry.last_crest_radius";
    BellowsShape s = read(values);
    const double last_m = values.number(last_key);
    const bool tapers = last_m > 0 && s.convolutions > 1;  // 0 means "same"
    if (tapers) s.crest_m += (last_m - s.crest_m) * convolution / (s.convolutions - 1);
    derive_wall(s, values, tapers && convolution > 0 ? last_key : "geometry.crest_radius");
    derive_neck(s, values);
    derive_fork(s, values);
    return s;
}

std::vector<BellowsShape> shapes_of(const design::Values& values) {
    const int last = values.count("geometry.convolutions") - 1;
    // Report an unsuitable taper by its end value, not by a crest in between.
    for (const int end : {0, last}) static_cast<void>(shape_of(values, end));
    std::vector<BellowsShape> shapes;
    for (int i = 0; i <= last; ++i) shapes.push_back(shape_of(values, i));
    return shapes;
}

}  // namespace soft::geometry
