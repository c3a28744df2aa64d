#include "mesh/reentrant_corners.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "math/tensor.hpp"
#include "mesh/shape.hpp"

namespace soft::mesh {
namespace {

constexpr double sharp_cosine = 0.77;  // 40 degrees between the normals

/// One boundary facet at a corner.
struct Side {
    Point corner, normal, middle;  ///< midpoint of the corner; outward unit normal there; centre of the facet
    double corner_length_m, height_m;
};

/// Vertices that define a corner: one vertex in a section, given twice; the two ends of an edge in a solid.
using Ridge = std::pair<Index, Index>;

Side side_at(const Mesh& mesh, const std::vector<Index>& nodes, CellType type, std::size_t first, std::size_t second) {
    const CellTopology& facet = topology(type);
    const auto at = [&](const std::array<double, 3>& xi, Point& normal) {
        Point position{}, along{}, across{};
        const auto values = shape_values(type, xi);
        for (std::size_t a = 0; a < values.size(); ++a)
            for (std::size_t i = 0; i < 3; ++i) {
                const double x = mesh.point(nodes[a])[i];
                position[i] += values[a].value * x;
                along[i] += values[a].gradient[0] * x;
                across[i] += values[a].gradient[1] * x;
            }
        normal = facet.dimension == 1 ? Point{along[1], -along[0], 0} : cross(along, across);
        return position;
    };
    std::array<double, 3> corner{}, centre{};
    const auto vertices = static_cast<std::size_t>(facet.vertex_count);
    for (std::size_t i = 0; i < 3; ++i) {
        corner[i] = 0.5 * (facet.nodes[first][i] + facet.nodes[second][i]);
        for (std::size_t a = 0; a < vertices; ++a) centre[i] += facet.nodes[a][i] / static_cast<double>(vertices);
    }
    Side side{};
    Point unused;
    side.corner = at(corner, side.normal);
    side.middle = at(centre, unused);
    const double length = norm(side.normal);
    for (double& component : side.normal) component /= length;
    side.corner_length_m = norm(difference(mesh.point(nodes[first]), mesh.point(nodes[second])));
    side.height_m = norm(difference(side.middle, side.corner)) * (facet.shape == Shape::triangle ? 3 : 2);
    return side;
}

bool is_sharp_reentrant(const Side& one, const Side& other) {
    return dot(one.normal, other.normal) < sharp_cosine && dot(difference(other.middle, one.corner), one.normal) > 0;
}

}  // namespace

ReentrantCorners find_reentrant_corners(const Mesh& mesh) {
    std::map<Ridge, std::vector<Side>> sides;
    for (const Facet& facet : boundary_facets(mesh)) {
        const std::vector<Index> nodes = facet_nodes(mesh, facet);
        const CellType type = facet_type(mesh, facet);
        const auto vertices = static_cast<std::size_t>(topology(type).vertex_count);
        for (std::size_t a = 0; a < vertices; ++a) {
            const std::size_t b = mesh.dimension == 2 ? a : (a + 1) % vertices;
            sides[std::minmax(nodes[a], nodes[b])].push_back(side_at(mesh, nodes, type, a, b));
        }
    }
    ReentrantCorners found;
    std::vector<double> heights_m;
    for (const auto& [ridge, both] : sides) {
        if (both.size() != 2 || !is_sharp_reentrant(both[0], both[1])) continue;
        ++found.count;
        found.length_m += both[0].corner_length_m;
        for (const Side& side : both) heights_m.push_back(side.height_m);
    }
    if (heights_m.empty()) return found;
    const auto middle = heights_m.begin() + static_cast<std::ptrdiff_t>(heights_m.size() / 2);
    std::ranges::nth_element(heights_m, middle);
    found.cell_m = *middle;
    return found;
}

}  // namespace soft::mesh
