#pragma once
/// Rigid obstacles that the actuator touches. Plain data, SI units, coordinates of the mesh: (x, y, z), in a section of revolution
/// (x, r, 0), in plane strain (x, y, 0).
#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "math/vector.hpp"
#include "mesh/mesh.hpp"

namespace soft::model {

/// The actuator is on the side to which the unit normal points.
struct Plane {
    mesh::Point point{};
    Vector3 normal{};
};

enum class Side { outside, inside };  ///< of the obstacle, where the actuator is

struct Cylinder {
    mesh::Point point{};  ///< on the axis
    Vector3 axis{};       ///< unit vector
    double radius_m = 0;
    Side side = Side::outside;
};

struct Sphere {
    mesh::Point center{};
    double radius_m = 0;
    Side side = Side::outside;
};

/// With sides parallel to the coordinate directions and rounded edges. A section ignores z.
struct Box {
    mesh::Point low{}, high{};
    double radius_m = 0;  ///< of the edges
};

/// Triangles, or in a section line segments. Their normals point to the actuator: t1 x t2 of a triangle, of a segment from a to b in the
/// plane (x, y) the direction of a -> b turned clockwise.
struct FacetedSurface {
    std::vector<mesh::Point> points;
    std::vector<std::array<int, 3>> facets;  ///< the third index of a segment is -1
};

/// Normal of a facet to the actuator, with the length of a segment or twice the area of a triangle.
[[nodiscard]] inline Vector3 facet_normal(const FacetedSurface& surface, const std::array<int, 3>& facet) {
    const auto at = [&](std::size_t i) -> const mesh::Point& {
        return surface.points[static_cast<std::size_t>(facet[i])];
    };
    const Vector3 edge = difference(at(1), at(0));
    return facet[2] < 0 ? Vector3{edge[1], -edge[0], 0} : cross(edge, difference(at(2), at(0)));
}

struct Obstacle {
    std::string name;
    std::variant<Plane, Cylinder, Sphere, Box, FacetedSurface> shape;
    double friction = 0;  ///< coefficient of Coulomb friction
};

struct ContactSettings {
    bool self = true;        ///< contact of the actuator with itself
    double friction = 0;     ///< coefficient of Coulomb friction of the actuator with itself
    double distance = 0.02;  ///< at which surfaces begin to act on each other, over the size of their facets
};

}  // namespace soft::model
