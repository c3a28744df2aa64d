#pragma once
/// Geometric queries on surfaces, implemented with CGAL (Polygon Mesh Processing, AABB tree, box intersection; exact predicates).
/// Tested by surface/report_test and contact/contact_test.
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "surface/triangles.hpp"

namespace soft::surface {

struct SurfaceChecks {
    bool closed = false;                       ///< every edge has exactly two triangles, with opposite directions
    std::optional<mesh::Point> open_location;  ///< model coordinates of the first edge that violates this, or near
                                               ///< a point that is the only connection of two sheets
    bool outward = false;                      ///< closed surface: normals point out of the enclosed volume
    double volume_m3 = 0;                      ///< of a closed surface
    std::optional<std::array<int, 2>> intersecting;  ///< first pair of intersecting triangles that are not neighbours
};

[[nodiscard]] SurfaceChecks check_surface(const Triangles& surface);

/// Search tree that finds the first triangle along a ray.
class RayTree {
public:
    explicit RayTree(const Triangles& surface);
    ~RayTree();
    RayTree(RayTree&&) noexcept;
    RayTree& operator=(RayTree&&) noexcept;

    struct Hit {
        double distance_m;
        int facet;  ///< Triangles::facets of the triangle
    };
    /// `direction` is a unit vector; triangles of the facet `skip` are ignored.
    [[nodiscard]] std::optional<Hit> first_hit(const mesh::Point& from, const mesh::Point& direction, int skip) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

/// Axis-aligned closed box. Sections have z = 0.
struct Box {
    mesh::Point low, high;
};

/// All pairs (i < j) of boxes that share a point, in ascending order.
[[nodiscard]] std::vector<std::array<int, 2>> overlapping_pairs(std::span<const Box> boxes);

/// A flat piece of a surface: the two ends of a segment in the plane z = 0 or the three corners of a triangle.
using Corners = std::span<const mesh::Point>;

/// Whether two pieces of the same kind share a point; exact. A degenerate piece intersects nothing.
[[nodiscard]] bool intersect(Corners a, Corners b);

/// How far a piece reaches beyond the plane (line) of another that is not degenerate, on the side where it reaches less far.
[[nodiscard]] double reach_m(Corners piece, Corners other);

/// Whether the distance of two pieces is at most `distance_m`, to rounding.
[[nodiscard]] bool is_within(Corners a, Corners b, double distance_m);

}  // namespace soft::surface
