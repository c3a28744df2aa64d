#pragma once
/// Questions about surfaces that CGAL answers (Polygon Mesh Processing, AABB tree, box intersection; exact predicates).
/// Tested by surface/report_test and surface/contact_test.
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "surface/triangles.hpp"

namespace soft::surface {

struct SurfaceChecks {
    bool closed = false;                             ///< every edge has exactly two triangles, run through both ways
    std::optional<mesh::Point> open_place;           ///< model coordinates of the first edge that has not, or near
                                                     ///< a point where two sheets hang together
    bool outward = false;                            ///< of a closed surface: normals point out of what it encloses
    double volume_m3 = 0;                            ///< of a closed surface
    std::optional<std::array<int, 2>> intersecting;  ///< first pair of triangles that meet without being neighbours
};

[[nodiscard]] SurfaceChecks check_surface(const Triangles& surface);

/// Finds the first triangle along a ray.
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
    /// `direction` is a unit vector; triangles of the facet `skip` are passed through.
    [[nodiscard]] std::optional<Hit> first_hit(const mesh::Point& from, const mesh::Point& direction, int skip) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

/// Axis-parallel, both ends included. Sections have z = 0.
struct Box {
    mesh::Point low, high;
};

/// All pairs (i < j) of boxes that have a point in common, in ascending order.
[[nodiscard]] std::vector<std::array<int, 2>> overlapping(std::span<const Box> boxes);

/// A straight piece of a surface: the ends of a segment in the plane z = 0 (two points) or a triangle's corners (three).
using Corners = std::span<const mesh::Point>;

/// Whether two pieces of the same kind have a point in common; exact. A piece without length or area meets nothing.
[[nodiscard]] bool meet(Corners a, Corners b);

/// Whether they come as near to each other as this, to rounding.
[[nodiscard]] bool within(Corners a, Corners b, double distance_m);

}  // namespace soft::surface
