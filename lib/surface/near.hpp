#pragma once
/// The nearest place of a set of triangles, or of segments (CGAL AABB tree). Tested by surface/remesh_test.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::surface {

/// Elements of two (segments) or three (triangles) of `points`; at least one, none without length or area.
template <std::size_t corners>
class NearestOn {
public:
    NearestOn(const std::vector<mesh::Point>& points, const std::vector<std::array<int, corners>>& elements);
    ~NearestOn();
    NearestOn(NearestOn&&) noexcept;
    NearestOn& operator=(NearestOn&&) noexcept;

    struct Place {
        mesh::Point point;
        int element;
        double distance_m;
    };
    [[nodiscard]] Place operator()(const mesh::Point& from) const;
    /// The same where it is no further away; much faster than to look everywhere.
    [[nodiscard]] std::optional<Place> within(const mesh::Point& from, double distance_m) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

using NearestOnTriangles = NearestOn<3>;
using NearestOnSegments = NearestOn<2>;

}  // namespace soft::surface
