#pragma once
/// Named faces of a body's surface: the facets of the file that satisfy a geometric rule. Tested by meshing/named_faces_test.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meshing/body_surface.hpp"
#include "meshing/remesh.hpp"

namespace soft::meshing {

/// A face ends at an edge if the angle between the normals of its two facets exceeds this.
inline constexpr double sharp_rad = 0.6981317007977318;  // 40 degrees

/// The two triangles of each edge (points of the edge ascending).
[[nodiscard]] std::map<std::array<int, 2>, std::array<std::size_t, 2>> edges_with_sides(const BodySurface& surface);

/// A facet belongs to the face if it satisfies every condition that is given.
struct FaceRule {
    struct Plane {
        std::size_t component;  ///< 0, 1, 2: x, y, z
        double at_m;
    };
    struct Box {
        mesh::Point from, to;  ///< [m]
    };
    struct Direction {
        mesh::Point normal;  ///< need not be a unit vector
        double within_rad;
    };
    /// The facets connected to the surface point nearest to `point`, bounded by sharp edges; if `up_to` is given, bounded by those
    /// faces instead.
    struct Flood {
        mesh::Point point;  ///< [m]
        std::vector<std::string> up_to;
    };
    std::string name;
    std::optional<Plane> plane;
    std::optional<Box> box;
    std::optional<Direction> direction;
    std::optional<Flood> flood;
};

struct NamedFace {
    std::string name;
    std::vector<bool> facets;  ///< one entry per triangle of the surface
};

/// The faces of the shells ("outer", "cavity", ...), then those of the rules in their order; `up_to` names earlier faces.
/// A rule that no facet satisfies gives a face without facets. std::logic_error for an unknown name in `up_to`.
[[nodiscard]] std::vector<NamedFace> named_faces(const BodySurface& surface, const std::vector<FaceRule>& rules);

/// Sharp edges and boundaries of the faces: the edges that the mesh must preserve.
[[nodiscard]] Creases creases_of(const BodySurface& surface, const std::vector<NamedFace>& faces);

}  // namespace soft::meshing
