#pragma once
/// Closest point on a set of triangles or of segments (CGAL AABB tree). Tested by meshing/remesh_test.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::surface {

/// Elements connect two (segments) or three (triangles) of `points`; at least one element, none degenerate.
template <std::size_t corners>
class NearestOn {
public:
    NearestOn(const std::vector<mesh::Point>& points, const std::vector<std::array<int, corners>>& elements);
    ~NearestOn();
    NearestOn(NearestOn&&) noexcept;
    NearestOn& operator=(NearestOn&&) noexcept;

    struct ClosestPoint {
        mesh::Point point;
        int element;
        double distance_m;
    };
    [[nodiscard]] ClosestPoint operator()(const mesh::Point& from) const;
    /// The closest point if it is within `distance_m`, else nullopt; much faster than the unbounded search.
    [[nodiscard]] std::optional<ClosestPoint> within(const mesh::Point& from, double distance_m) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

using NearestOnTriangles = NearestOn<3>;
using NearestOnSegments = NearestOn<2>;

}  // namespace soft::surface
