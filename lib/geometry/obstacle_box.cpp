/// A box with sides parallel to x, y and z; in plane strain its section.
#include "geometry/keys.hpp"
#include "geometry/obstacle.hpp"

namespace soft::geometry {
namespace {

/// Corner i has the high x, y, z where bits 0, 1, 2 of i are set. Two triangles per side, normals out of the box.
model::FacetedSurface box(const mesh::Point& low, const mesh::Point& high) {
    model::FacetedSurface surface;
    for (std::size_t i = 0; i < 8; ++i)
        surface.points.push_back(
            {(i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1], (i & 4) != 0 ? high[2] : low[2]});
    surface.facets = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return surface;
}

ObstacleSurface build(const ObstacleInput& input) {
    const std::string from = input.path + ".box.from", to = input.path + ".box.to";
    if (input.kinematics == model::Kinematics::axisymmetric)
        throw input.values.refuse(from, "a box is not a body of revolution about x",
                                  "use plane, cylinder, sphere or profile, or model: solid");
    const mesh::Point low = point_of(input.values, from), high = point_of(input.values, to);
    const bool solid = input.kinematics == model::Kinematics::solid;
    for (std::size_t i = 0; i < (solid ? 3U : 2U); ++i)
        if (!(low[i] < high[i]))
            throw input.values.refuse(to, std::string{"its "} + "xyz"[i] + " is not greater than that of from",
                                      "from is the lowest corner, to the highest");
    if (solid) return box(low, high);
    const std::array<mesh::Point, 4> corners{
        {{low[0], low[1], 0}, {high[0], low[1], 0}, {high[0], high[1], 0}, {low[0], high[1], 0}}};
    return segments_of(
        {{corners[0], corners[1]}, {corners[1], corners[2]}, {corners[2], corners[3]}, {corners[3], corners[0]}});
}

}  // namespace

ObstacleShape box_obstacle() {
    using design::Kind;
    return {{"box",
             {vector_key("box.from", Kind::length, "lowest corner: [x, y, z]; plane strain does not use z"),
              vector_key("box.to", Kind::length, "highest corner: [x, y, z]")}},
            ObstacleStorage::faceted,
            build};
}

}  // namespace soft::geometry
