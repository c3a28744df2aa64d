#pragma once
/// Faces of a body's surface by where they are: facets of the file that fulfil a rule. Tested by surface/named_faces_test.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "surface/body_surface.hpp"
#include "surface/remesh.hpp"

namespace soft::surface {

/// Where the surface turns by more than this between two facets, a face ends.
inline constexpr double sharp_rad = 0.6981317007977318;  // 40 degrees

/// The two triangles beside each edge (its points ascending).
[[nodiscard]] std::map<std::array<int, 2>, std::array<std::size_t, 2>> edges_with_sides(const BodySurface& surface);

/// Edges whose facets' normals differ by more than sharp_rad, ascending.
[[nodiscard]] Creases sharp_edges(const BodySurface& surface);

/// What is given holds for every facet of the face.
struct FaceRule {
    struct Plane {
        std::size_t component;  ///< 0, 1, 2: x, y, z
        double at_m;
    };
    struct Box {
        mesh::Point from, to;  ///< [m]
    };
    struct Direction {
        mesh::Point normal;  ///< of any length
        double within_rad;
    };
    /// What hangs together with the place on the surface that is nearest to `point`, up to sharp edges; with `up_to`, across
    /// sharp edges up to these faces.
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
    std::vector<bool> facets;  ///< one a triangle of the surface
};

/// The shells' faces ("outer", "cavity", ...), then those of the rules in their order; `up_to` names faces before its own.
/// A rule that no facet fulfils gives a face without facets. std::logic_error for an unknown name in `up_to`.
[[nodiscard]] std::vector<NamedFace> named_faces(const BodySurface& surface, const std::vector<FaceRule>& rules);

/// Sharp edges and the borders of the faces: what the mesh must keep.
[[nodiscard]] Creases creases_of(const BodySurface& surface, const std::vector<NamedFace>& faces);

}  // namespace soft::surface
