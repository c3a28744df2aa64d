#pragma once
/// A curved facet as a polynomial in its reference coordinates, x(xi, eta) = sum of c_ij xi^i eta^j with i, j <= 2, which is evaluated much
/// faster than by shape functions. A line is extruded along z as in surface/facet_map.hpp. Private to the module.
/// Tested by contact/potential_test.
#include <array>
#include <cmath>
#include <span>

#include "surface/facet_map.hpp"

namespace soft::contact {

/// Largest motion of a point of a second-order facet over that of its nodes: the sum of the absolute shape functions (25/16 in a
/// quadrilateral, 5/3 in a triangle).
inline constexpr double of_nodal_motion = 5.0 / 3;

struct Patch {
    mesh::CellType type = mesh::CellType::line2;
    std::array<mesh::Point, 9> nodes{};  ///< the first node_count(type)
    std::array<Vector3, 9> c{};          ///< c_ij at 3 i + j
    mesh::Point centre{};
    double radius_m = 0;            ///< of a sphere about the centre that contains the facet
    mesh::Point low{}, high{};      ///< of a box that contains it
    std::array<Vector3, 3> axes{};  ///< of another such box, along the tangents and normal in the middle: unit vectors
    mesh::Point oriented_low{}, oriented_high{};  ///< along these axes
    mesh::Point cell_centre{};                    ///< mean of the corners of its cell

    [[nodiscard]] bool is_line() const { return mesh::dimension(type) == 1; }
    [[nodiscard]] surface::FacetMap::Value operator()(const surface::FacetPoint& xi) const;
};

[[nodiscard]] Patch make_patch(const surface::FacetMap& facet);

[[nodiscard]] inline Vector3 unit_normal(const Patch& patch, const surface::FacetPoint& xi) {
    const auto at = patch(xi);
    const Vector3 n = cross(at.t1, at.t2);
    return along({}, 1 / norm(n), n);
}

/// A lower bound of the distance of a point.
[[nodiscard]] inline double at_least(const Patch& patch, const mesh::Point& x) {
    Vector3 beyond{};
    for (std::size_t d = 0; d < 3; ++d) {
        const double at = dot(patch.axes[d], x);
        beyond[d] = std::fmax(0, std::fmax(patch.oriented_low[d] - at, at - patch.oriented_high[d]));
    }
    return norm(beyond);
}
/// The same of two facets.
[[nodiscard]] inline double at_least(const Patch& a, const Patch& b) {
    Vector3 beyond{};
    for (std::size_t d = 0; d < 3; ++d) beyond[d] = std::fmax(0, std::fmax(a.low[d] - b.high[d], b.low[d] - a.high[d]));
    return norm(beyond);
}
/// Height above the box along the normal in the middle; where it is positive, the point is in front of the facet.
[[nodiscard]] inline double height_above(const Patch& patch, const mesh::Point& x) {
    return dot(patch.axes[2], x) - patch.oriented_high[2];
}

}  // namespace soft::contact
