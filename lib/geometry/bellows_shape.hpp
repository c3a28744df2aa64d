#pragma once
/// Dimensions of the meridian of a bellows. A wall of constant thickness runs from trough to crest and back. Its bends are
/// concentric arcs of radii fillet and fillet + wall, joined by straight lines tangent to both. Each half convolution is
/// described in its own frame: trough centre at x = 0, crest centre at x = half_m; the falling half is the mirror image. Crests
/// and troughs may have straight sections along x (lands). With upright walls these give square convolutions. The crest radius
/// may change linearly from the first convolution to the last.
/// Tested by geometry/bellows_test (volumes in closed form).
#include <cmath>
#include <vector>

#include "design/design.hpp"
#include "meshing/section.hpp"

namespace soft::geometry {

struct BellowsShape {
    int convolutions;
    double pitch_m, crest_m, bore_m, wall_m, fillet_m;
    double crest_land_m, trough_land_m;  ///< straight lengths along x
    double disc_length_m, disc_radius_m, neck_length_m, neck_radius_m;

    // Derived; see shape_of.
    double half_m;                           ///< from trough centre to crest centre along x
    double trough_centre_m, crest_centre_m;  ///< radii at which the arc centres lie
    meshing::PlanePoint along;               ///< unit vector of the straight wall, from trough to crest
    meshing::PlanePoint outward;             ///< its unit normal, from the cavity to the outside
    double straight_m;                       ///< length of the straight wall
    double bend_rad;                         ///< angle of a half bend, trough or crest
    double neck_at_m;  ///< distance along the straight wall at which its outer face meets the neck

    /// The point at `offset` from the trough centre along `outward` and at `distance` along the wall.
    [[nodiscard]] meshing::PlanePoint on_wall(double offset, double distance) const {
        return {offset * outward[0] + distance * along[0], trough_centre_m + offset * outward[1] + distance * along[1]};
    }
    [[nodiscard]] double cavity_offset_m() const { return -(fillet_m + wall_m); }
    [[nodiscard]] double outer_offset_m() const { return -fillet_m; }

    /// Ratio of the largest to the smallest cell through a bend: the fourth root of the ratio of the radii. Uniform cells make the
    /// inner bend too soft; cells proportional to the radius make the rest too stiff (mesh study of the paper's bellows).
    [[nodiscard]] double bend_grading() const { return std::sqrt(std::sqrt((fillet_m + wall_m) / fillet_m)); }

    /// Points of an end section, in the frame of its half convolution (x < 0 towards the disc).
    meshing::PlanePoint neck_corner;   ///< where the outer wall meets the neck
    meshing::PlanePoint disc_corner;   ///< where the neck meets the disc
    meshing::PlanePoint fork;          ///< inside the rubber: where the cells of wall, neck and disc meet
    meshing::PlanePoint below_corner;  ///< inside the rubber, beside the fork and below disc_corner
};

/// Shape of one convolution, counted from 0. Throws values.refuse(...) with the key and its admissible range if arcs, walls and
/// ends do not fit together.
[[nodiscard]] BellowsShape shape_of(const design::Values& values, int convolution = 0);

/// Shapes of all convolutions.
[[nodiscard]] std::vector<BellowsShape> shapes_of(const design::Values& values);

}  // namespace soft::geometry
