#pragma once
/// A curved facet as a polynomial in its reference coordinates, x(xi, eta) = sum of c_ij xi^i eta^j with i, j <= 2, which is evaluated much
/// faster than by shape functions. A line is extruded along z as in surface/facet_map.hpp. Private to the module.
/// Tested by contact/potential_test.
#include <array>
#include <cmath>
#include <span>

#include "surface/facet_map.hpp"

namespace soft::contact {

struct Patch {
    mesh::CellType type = mesh::CellType::line2;
    std::array<mesh::Point, 9> nodes{};  ///< the first node_count(type)
    std::array<Vector3, 9> c{};          ///< c_ij at 3 i + j
    mesh::Point centre{};
    double radius_m = 0;        ///< of a sphere about the centre that contains the facet
    mesh::Point low{}, high{};  ///< of a box that contains it

    [[nodiscard]] bool is_line() const { return mesh::dimension(type) == 1; }
    [[nodiscard]] surface::FacetMap::Value operator()(const surface::FacetPoint& xi) const;
};

[[nodiscard]] Patch make_patch(const surface::FacetMap& facet);

/// A lower bound of the distance of a point.
[[nodiscard]] inline double at_least(const Patch& patch, const mesh::Point& x) {
    Vector3 beyond{};
    for (std::size_t d = 0; d < 3; ++d) beyond[d] = std::fmax(0, std::fmax(patch.low[d] - x[d], x[d] - patch.high[d]));
    return std::fmax(norm(beyond), norm(difference(x, patch.centre)) - patch.radius_m);
}

}  // namespace soft::contact
