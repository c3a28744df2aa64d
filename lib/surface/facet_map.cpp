#include "surface/facet_map.hpp"

#include <algorithm>

#include "mesh/shape.hpp"

namespace soft::surface {

bool is_inside(mesh::Shape shape, const FacetPoint& xi, double margin) {
    if (shape == mesh::Shape::line) return std::abs(xi[0]) <= 1 - margin && xi[1] == 0;
    if (shape == mesh::Shape::triangle) return xi[0] >= margin && xi[1] >= margin && xi[0] + xi[1] <= 1 - margin;
    return std::max(std::abs(xi[0]), std::abs(xi[1])) <= 1 - margin;
}

FacetMap::Value FacetMap::operator()(const FacetPoint& xi) const {
    const auto count = static_cast<std::size_t>(mesh::node_count(type));
    std::array<mesh::ShapeValue, 9> shapes;
    mesh::shape_values(type, {xi[0], xi[1], 0}, std::span{shapes}.first(count));
    Value at{};
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t d = 0; d < 3; ++d) {
            at.x[d] += shapes[a].value * nodes[a][d];
            at.t1[d] += shapes[a].gradient[0] * nodes[a][d];
            at.t2[d] += shapes[a].gradient[1] * nodes[a][d];
        }
    if (mesh::dimension(type) == 1) {
        at.x[2] += xi[1];
        at.t2 = {0, 0, 1};
    }
    return at;
}

FacetMap facet_map(const mesh::Mesh& mesh, const mesh::Facet& facet, std::span<const mesh::Point> positions) {
    FacetMap map{facet_type(mesh, facet), {}};
    std::size_t a = 0;
    for (const mesh::Index node : facet_nodes(mesh, facet)) map.nodes[a++] = positions[static_cast<std::size_t>(node)];
    return map;
}

}  // namespace soft::surface
