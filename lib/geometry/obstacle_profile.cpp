/// A section from a table (profile.hpp), revolved about x in axisymmetric models and extruded along z in the others.
#include <algorithm>

#include "geometry/keys.hpp"
#include "geometry/obstacle.hpp"
#include "geometry/profile.hpp"

namespace soft::geometry {
namespace {

/// Two triangles per segment; the normal of a segment (dx, dy) is (dy, -dx, 0).
model::FacetedSurface extruded(const model::FacetedSurface& section, double far_m) {
    model::FacetedSurface surface;
    const int count = static_cast<int>(section.points.size());
    for (const double z_m : {-far_m, far_m})
        for (const mesh::Point& point : section.points) surface.points.push_back({point[0], point[1], z_m});
    for (const auto& [start, end, none] : section.facets) {
        surface.facets.push_back({start, end, end + count});
        surface.facets.push_back({start, end + count, start + count});
    }
    return surface;
}

ObstacleSurface build(const ObstacleInput& input) {
    const std::string path = input.path + ".profile";
    const bool turned = input.kinematics == model::Kinematics::axisymmetric;
    const meshing::Outline outline =
        outline_of_file(input.values.text(path), input.values.location(path), turned ? Across::r : Across::y, path);
    std::vector<std::array<mesh::Point, 2>> pieces;
    for (const meshing::OutlinePiece& piece : meshing::pieces_of(outline))
        if (!turned || piece.start[1] != 0 || piece.end[1] != 0)  // the axis is not a surface
            pieces.push_back({{{piece.start[0], piece.start[1], 0}, {piece.end[0], piece.end[1], 0}}});
    const model::FacetedSurface section = segments_of(pieces);
    if (input.kinematics != model::Kinematics::solid) return section;
    return extruded(section, input.far_m);
}

}  // namespace

ObstacleShape profile_obstacle() {
    design::Key key =
        value_key("profile", design::Kind::text, {},
                  "section as a table: a file relative to the design file, or (profile: |) its lines; columns "
                  "and rows as in geometry.profile, x and r of an obstacle that is revolved about x in an "
                  "axisymmetric model, x and y of one that extends along z in other models");
    key.max_count = several_lines;
    return {{"profile", {std::move(key)}}, ObstacleStorage::faceted, build};
}

}  // namespace soft::geometry
