#pragma once
/// Dimensions of the bellows' meridian. A wall of constant thickness runs from trough to crest and back; its bends are
/// concentric arcs of radii fillet and fillet + wall, joined by straight lines tangent to both. Each half convolution is
/// described in its own frame: trough centre at x = 0, crest centre at x = half_m, mirrored for the way down. Crests and
/// troughs may go on straight along x before they turn (lands); walls that stand upright then make square convolutions. The
/// crests' radius may change evenly from the first convolution to the last.
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
    double half_m;                           ///< from the trough's centre to the crest's along x
    double trough_centre_m, crest_centre_m;  ///< radii of the arcs' centres
    meshing::PlanePoint along;               ///< unit vector of the straight wall, from trough to crest
    meshing::PlanePoint outward;             ///< its unit normal, from the cavity to the outside
    double straight_m;                       ///< length of the straight wall
    double bend_rad;                         ///< angle of a half bend, trough or crest
    double neck_at_m;                        ///< along the straight wall, where its outer face meets the neck

    /// The point at `offset` from the trough's centre along `outward` and `distance` along the wall.
    [[nodiscard]] meshing::PlanePoint on_wall(double offset, double distance) const {
        return {offset * outward[0] + distance * along[0], trough_centre_m + offset * outward[1] + distance * along[1]};
    }
    [[nodiscard]] double cavity_offset_m() const { return -(fillet_m + wall_m); }
    [[nodiscard]] double outer_offset_m() const { return -fillet_m; }

    /// Largest cell over smallest through a bend. The fourth root of the radii's ratio: even cells leave the inner bend
    /// too soft, cells in proportion to the radius the rest too stiff (mesh study of the paper's bellows).
    [[nodiscard]] double bend_grading() const { return std::sqrt(std::sqrt((fillet_m + wall_m) / fillet_m)); }

    /// Points of an end, in the frame of its half convolution (x < 0 towards the disc).
    meshing::PlanePoint neck_corner;   ///< where the outer wall meets the neck
    meshing::PlanePoint disc_corner;   ///< where the neck meets the disc
    meshing::PlanePoint fork;          ///< inside the rubber: where the wall's cells, the neck's and the disc's meet
    meshing::PlanePoint below_corner;  ///< inside the rubber, beside the fork and below the disc's corner
};

/// Of a convolution, from 0. Throws values.refuse(...) with the key and its admissible range where the arcs, walls and ends do
/// not fit together.
[[nodiscard]] BellowsShape shape_of(const design::Values& values, int convolution = 0);

/// Of all convolutions.
[[nodiscard]] std::vector<BellowsShape> shapes_of(const design::Values& values);

}  // namespace soft::geometry
