#pragma once
/// Wall thickness of a body, measured from its surface, and the mesh size that follows from it.
/// Tested by meshing/body_walls_test.
#include <memory>
#include <vector>

#include "meshing/body_surface.hpp"
#include "meshing/remesh.hpp"
#include "surface/triangles.hpp"

namespace soft::meshing {

/// Thickness at one sample point: distance along the inward normal to the opposite surface.
struct Wall {
    mesh::Point location;  ///< sample point on the surface
    double thickness_m;
};
/// Thicknesses at sample points spread evenly over the surface. A sample counts only if its ray ends on a surface that faces the
/// opposite way (within 60 degrees); a surface that joins the sample's own surface in a corner does not count.
[[nodiscard]] std::vector<Wall> walls(const std::vector<mesh::Point>& points,
                                      const std::vector<std::array<int, 3>>& triangles);

/// Radius of curvature at an edge that is not sharp: (areas of the two facets) / (length of the edge x angle between their normals).
/// The sample points along an edge are no further apart than the radius (at most 200 per edge).
struct Bend {
    mesh::Point location;
    double radius_m;
};
[[nodiscard]] std::vector<Bend> bends(const BodySurface& surface);

struct WallStatistics {
    Wall thinnest{};
    double median_m = 0;  ///< half of the surface area has thinner walls
};
/// `walls` has at least one entry.
[[nodiscard]] WallStatistics wall_statistics(std::vector<Wall> walls);

/// Requested mesh size at a point: the minimum over all walls and bends of size + growth x distance, where size is thickness / number of
/// cells through the wall, or the radius, clamped to [min_m, max_m]. Sizes that differ by less than about 10 % are treated as equal.
struct SizeBounds {
    double min_m, max_m;
    int through_wall;  ///< cells through the wall; 0: wall thickness does not limit the size
};
class WallSizes {
public:
    WallSizes(const std::vector<Wall>& walls, const std::vector<Bend>& bends, const SizeBounds& bounds);
    [[nodiscard]] double operator()(const mesh::Point& location) const;

private:
    struct Classes;
    std::shared_ptr<const Classes> classes_;
};

}  // namespace soft::meshing
