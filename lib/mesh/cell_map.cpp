#include "mesh/cell_map.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace soft::mesh {
namespace {

using Xi = std::array<double, 3>;

struct Slope {
    double value, derivative;
};

/// One-dimensional Lagrange polynomial on [-1, 1] that is 1 at `node` (-1, 0 or 1).
Slope lagrange(int order, double node, double xi) {
    if (order == 1) return {0.5 * (1 + node * xi), 0.5 * node};
    if (node == 0.0) return {1 - xi * xi, -2 * xi};
    return {0.5 * xi * (xi + node), xi + 0.5 * node};
}

ShapeValue product(int dimension, int order, const Xi& node, const Xi& xi) {
    ShapeValue shape{1.0, {}};
    std::array<Slope, 3> factor{{{1, 0}, {1, 0}, {1, 0}}};
    for (int d = 0; d < dimension; ++d) factor[d] = lagrange(order, node[d], xi[d]);
    shape.value = factor[0].value * factor[1].value * factor[2].value;
    shape.gradient = {factor[0].derivative * factor[1].value * factor[2].value,
                      factor[0].value * factor[1].derivative * factor[2].value,
                      factor[0].value * factor[1].value * factor[2].derivative};
    return shape;
}

/// Barycentric coordinates of the unit simplex; entry 0 belongs to the corner at the origin.
std::array<double, 4> barycentric(int dimension, const Xi& xi) {
    std::array<double, 4> lambda{1, 0, 0, 0};
    for (int d = 0; d < dimension; ++d) {
        lambda[d + 1] = xi[d];
        lambda[0] -= xi[d];
    }
    return lambda;
}

Xi gradient_of(int dimension, int lambda) {
    Xi gradient{};
    for (int d = 0; d < dimension; ++d) gradient[d] = lambda == 0 ? -1.0 : (lambda == d + 1 ? 1.0 : 0.0);
    return gradient;
}

ShapeValue simplex(int dimension, int order, const Xi& node, const Xi& xi) {
    const auto at_node = barycentric(dimension, node), lambda = barycentric(dimension, xi);
    int i = 0, j = 0;   // the corners the node lies between; equal at a corner
    for (int k = 0; k <= dimension; ++k)
        if (at_node[k] > 0.25) j = k;
    for (int k = dimension; k >= 0; --k)
        if (at_node[k] > 0.25) i = k;
    const Xi gi = gradient_of(dimension, i), gj = gradient_of(dimension, j);
    ShapeValue shape{};
    if (order == 1) return {lambda[i], gi};
    shape.value = i == j ? lambda[i] * (2 * lambda[i] - 1) : 4 * lambda[i] * lambda[j];
    for (int d = 0; d < 3; ++d)
        shape.gradient[d] = i == j ? (4 * lambda[i] - 1) * gi[d] : 4 * (lambda[i] * gj[d] + lambda[j] * gi[d]);
    return shape;
}

ShapeValue wedge(int order, const Xi& node, const Xi& xi) {
    const ShapeValue triangle = simplex(2, order, {node[0], node[1], 0}, {xi[0], xi[1], 0});
    const Slope along = lagrange(order, node[2], xi[2]);
    return {triangle.value * along.value,
            {triangle.gradient[0] * along.value, triangle.gradient[1] * along.value, triangle.value * along.derivative}};
}

/// Position and slopes; the determinant depends on what the nodes span and is left to the caller.
CellMap map_nodes(const Mesh& mesh, std::span<const Index> nodes, const std::vector<ShapeValue>& shapes) {
    CellMap map{};
    for (std::size_t a = 0; a < shapes.size(); ++a) {
        const Point& X = mesh.point(nodes[a]);
        for (std::size_t i = 0; i < 3; ++i) {
            map.position[i] += shapes[a].value * X[i];
            for (std::size_t d = 0; d < 3; ++d) map.dX_dxi[3 * i + d] += shapes[a].gradient[d] * X[i];
        }
    }
    return map;
}

double determinant(int dimension, const std::array<double, 9>& m) {
    if (dimension == 1) return std::hypot(m[0], m[3], m[6]);
    if (dimension == 2) return m[0] * m[4] - m[1] * m[3];
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

/// Gauss-Legendre, four points: roots of P4, Abramowitz and Stegun 25.4.29.
std::array<Slope, 4> gauss() {
    const double spread = 2.0 / 7.0 * std::sqrt(1.2);
    const double inner = std::sqrt(3.0 / 7.0 - spread), outer = std::sqrt(3.0 / 7.0 + spread);
    const double heavy = (18 + std::sqrt(30.0)) / 36, light = (18 - std::sqrt(30.0)) / 36;
    return {{{-outer, light}, {-inner, heavy}, {inner, heavy}, {outer, light}}};
}

/// From the cube [-1, 1]^d onto the cell: nothing to do for tensor cells, the collapse for simplices.
QuadraturePoint placed(Shape shape, const Xi& cube, double weight) {
    const double u = 0.5 * (1 + cube[0]), v = 0.5 * (1 + cube[1]), w = 0.5 * (1 + cube[2]);
    switch (shape) {
        case Shape::line:
        case Shape::quadrilateral:
        case Shape::hexahedron: break;
        case Shape::triangle: return {{u, v * (1 - u), 0}, weight * (1 - u) / 4};
        case Shape::wedge: return {{u, v * (1 - u), cube[2]}, weight * (1 - u) / 4};
        case Shape::tetrahedron:
            return {{u, v * (1 - u), w * (1 - u) * (1 - v)}, weight * (1 - u) * (1 - u) * (1 - v) / 8};
    }
    return {cube, weight};
}

}  // namespace

std::vector<ShapeValue> shape_values(CellType type, const Xi& xi) {
    const CellTopology& t = topology(type);
    std::vector<ShapeValue> shapes;
    shapes.reserve(t.nodes.size());
    for (const Xi& node : t.nodes) {
        if (t.shape == Shape::wedge) shapes.push_back(wedge(t.order, node, xi));
        else if (t.shape == Shape::triangle || t.shape == Shape::tetrahedron)
            shapes.push_back(simplex(t.dimension, t.order, node, xi));
        else shapes.push_back(product(t.dimension, t.order, node, xi));
    }
    return shapes;
}

CellMap map_cell(const Mesh& mesh, Index cell, const std::vector<ShapeValue>& shapes) {
    CellMap map = map_nodes(mesh, mesh.cell_nodes(cell), shapes);
    map.determinant = determinant(dimension(mesh.cell_type(cell)), map.dX_dxi);
    return map;
}

std::array<double, 3> facet_normal(const Mesh& mesh, const Facet& facet, const std::vector<ShapeValue>& shapes) {
    const auto m = map_nodes(mesh, facet_nodes(mesh, facet), shapes).dX_dxi;
    if (mesh.dimension == 2) return {m[3], -m[0], 0};
    return {m[3] * m[7] - m[6] * m[4], m[6] * m[1] - m[0] * m[7], m[0] * m[4] - m[3] * m[1]};
}

std::vector<QuadraturePoint> volume_rule(CellType type) {
    const CellTopology& t = topology(type);
    const auto points = gauss();
    const int second = t.dimension > 1 ? 4 : 1, third = t.dimension > 2 ? 4 : 1;
    std::vector<QuadraturePoint> rule;
    for (int k = 0; k < third; ++k)
        for (int j = 0; j < second; ++j)
            for (const Slope& p : points) {
                const Slope q = second > 1 ? points[j] : Slope{0, 1}, r = third > 1 ? points[k] : Slope{0, 1};
                rule.push_back(placed(t.shape, {p.value, q.value, r.value}, p.derivative * q.derivative * r.derivative));
            }
    return rule;
}

double measure(const Mesh& mesh, Measure kind) {
    struct Sample {
        std::vector<ShapeValue> shapes;
        double weight;
    };
    std::vector<Sample> samples;
    std::optional<CellType> tabulated;
    double sum = 0;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const CellType type = mesh.cell_type(cell);
        if (tabulated != type) {
            samples.clear();
            for (const QuadraturePoint& p : volume_rule(type)) samples.push_back({shape_values(type, p.xi), p.weight});
            tabulated = type;
        }
        for (const Sample& sample : samples) {
            const CellMap map = map_cell(mesh, cell, sample.shapes);
            const double turn = kind == Measure::revolved ? 2 * std::numbers::pi * map.position[1] : 1.0;
            sum += sample.weight * map.determinant * turn;
        }
    }
    return sum;
}

}  // namespace soft::mesh
