#pragma once
/// How thick a body is, seen from its surface, and how long the cells of its mesh may be.
/// Tested by surface/body_walls_test.
#include <memory>
#include <vector>

#include "surface/body_surface.hpp"
#include "surface/remesh.hpp"
#include "surface/triangles.hpp"

namespace soft::surface {

/// From places spread evenly over the surface along the inward normal to where the body ends, where that is at a surface that
/// looks the other way (within 60 degrees): not at one that meets the place's own in a corner.
struct Wall {
    mesh::Point place;
    double thickness_m;
};
[[nodiscard]] std::vector<Wall> walls(const std::vector<mesh::Point>& points,
                                      const std::vector<std::array<int, 3>>& triangles);

/// Where the surface is bent, at edges that are not sharp: the radius, (areas of the two facets) / (length of the edge x angle), at
/// places along the edge no further apart than it.
struct Bend {
    mesh::Point place;
    double radius_m;
};
[[nodiscard]] std::vector<Bend> bends(const BodySurface& surface);

struct WallFigures {
    Wall least{};
    double median_m = 0;  ///< half of the surface has thinner walls behind it
};
/// Of at least one wall.
[[nodiscard]] WallFigures figures(std::vector<Wall> walls);

/// min over the walls and bends of (thickness / cells through it, or radius; no less than min_m, no more than max_m) +
/// growth x distance. Those of about the same size (10 %) are one.
struct SizeBounds {
    double min_m, max_m;
    int through_wall;  ///< 0: the walls do not matter
};
class WallSizes {
public:
    WallSizes(const std::vector<Wall>& walls, const std::vector<Bend>& bends, const SizeBounds& bounds);
    [[nodiscard]] double operator()(const mesh::Point& place) const;

private:
    struct Classes;
    std::shared_ptr<const Classes> classes_;
};

}  // namespace soft::surface
