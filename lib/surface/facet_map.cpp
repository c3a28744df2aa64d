#include "surface/facet_map.hpp"

#include <stdexcept>

namespace soft::surface {
namespace {

struct Function {
    double value, d1, d2;  ///< N, dN/dxi1, dN/dxi2
};

struct LineFunction {
    double value, slope;
};

/// One-dimensional Lagrange function on [-1, 1] that is one at `node` (-1, 0 or 1).
LineFunction line_function(int order, double node, double x) {
    if (order == 1) return {(1 + node * x) / 2, node / 2};
    if (node == 0) return {1 - x * x, -2 * x};
    return {x * (x + node) / 2, x + node / 2};
}

/// By barycentric coordinates l: corners l (2 l - 1) or l, mid-edge nodes 4 l l'.
Function triangle_function(int order, std::size_t node, const FacetPoint& xi) {
    const std::array<double, 3> l{1 - xi[0] - xi[1], xi[0], xi[1]}, d1{-1, 1, 0}, d2{-1, 0, 1};
    if (node >= 3) {
        const std::size_t i = node - 3, j = (i + 1) % 3;
        return {4 * l[i] * l[j], 4 * (d1[i] * l[j] + l[i] * d1[j]), 4 * (d2[i] * l[j] + l[i] * d2[j])};
    }
    if (order == 1) return {l[node], d1[node], d2[node]};
    const double slope = 4 * l[node] - 1;
    return {l[node] * (2 * l[node] - 1), slope * d1[node], slope * d2[node]};
}

Function shape_function(const mesh::CellTopology& cell, std::size_t node, const FacetPoint& xi) {
    if (cell.shape == mesh::Shape::triangle) return triangle_function(cell.order, node, xi);
    const LineFunction u = line_function(cell.order, cell.nodes[node][0], xi[0]);
    if (cell.shape == mesh::Shape::line) return {u.value, u.slope, 0};
    const LineFunction v = line_function(cell.order, cell.nodes[node][1], xi[1]);
    return {u.value * v.value, u.slope * v.value, u.value * v.slope};
}

constexpr double gauss = 0.7745966692414834;  // sqrt(3/5)
constexpr std::array<double, 3> gauss_points{-gauss, 0, gauss}, gauss_weights{5 / 9.0, 8 / 9.0, 5 / 9.0};

constexpr auto line_rule = [] {
    std::array<WeightedPoint, 3> rule{};
    for (std::size_t i = 0; i < 3; ++i) rule[i] = {{gauss_points[i], 0}, gauss_weights[i]};
    return rule;
}();

constexpr auto quadrilateral_rule = [] {
    std::array<WeightedPoint, 9> rule{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            rule[3 * i + j] = {{gauss_points[i], gauss_points[j]}, gauss_weights[i] * gauss_weights[j]};
    return rule;
}();

constexpr auto triangle_rule = [] {
    constexpr double root15 = 3.872983346207417;
    std::array<WeightedPoint, 7> rule{};
    rule[0] = {{1 / 3.0, 1 / 3.0}, 9 / 80.0};
    std::size_t next = 1;
    for (const double sign : {-1.0, 1.0}) {
        const double a = (6 + sign * root15) / 21, weight = (155 + sign * root15) / 2400;
        for (const FacetPoint& xi : {FacetPoint{a, a}, FacetPoint{1 - 2 * a, a}, FacetPoint{a, 1 - 2 * a}})
            rule[next++] = {xi, weight};
    }
    return rule;
}();

}  // namespace

FacetMap::Value FacetMap::operator()(const FacetPoint& xi) const {
    const mesh::CellTopology& cell = mesh::topology(type);
    Value at{};
    for (std::size_t a = 0; a < static_cast<std::size_t>(cell.node_count); ++a) {
        const Function N = shape_function(cell, a, xi);
        for (std::size_t d = 0; d < 3; ++d) {
            at.x[d] += N.value * nodes[a][d];
            at.t1[d] += N.d1 * nodes[a][d];
            at.t2[d] += N.d2 * nodes[a][d];
        }
    }
    if (cell.dimension == 1) {
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

std::span<const WeightedPoint> facet_rule(mesh::Shape shape) {
    switch (shape) {
        case mesh::Shape::line: return line_rule;
        case mesh::Shape::triangle: return triangle_rule;
        case mesh::Shape::quadrilateral: return quadrilateral_rule;
        case mesh::Shape::tetrahedron:
        case mesh::Shape::hexahedron:
        case mesh::Shape::wedge: break;
    }
    throw std::logic_error("a solid cell is no facet");
}

}  // namespace soft::surface
