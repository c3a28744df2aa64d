#pragma once
/// Questions about triangle surfaces that CGAL answers (Polygon Mesh Processing and AABB tree, exact predicates).
/// The one place of the project that sees CGAL. Held by surface/report_test.
#include <array>
#include <memory>
#include <optional>

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

}  // namespace soft::surface
