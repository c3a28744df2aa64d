#include "mesh/shape.hpp"

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
    int i = 0, j = 0;  // the ends of the node's edge; equal at a corner
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
    return {
        triangle.value * along.value,
        {triangle.gradient[0] * along.value, triangle.gradient[1] * along.value, triangle.value * along.derivative}};
}

ShapeValue shape_value(const CellTopology& t, int order, const Xi& node, const Xi& xi) {
    switch (t.shape) {
        case Shape::wedge: return wedge(order, node, xi);
        case Shape::triangle:
        case Shape::tetrahedron: return simplex(t.dimension, order, node, xi);
        case Shape::line:
        case Shape::quadrilateral:
        case Shape::hexahedron: break;
    }
    return product(t.dimension, order, node, xi);
}

}  // namespace

void shape_values(CellType type, const Xi& xi, std::span<ShapeValue> out) {
    const CellTopology& t = topology(type);
    for (std::size_t a = 0; a < t.nodes.size(); ++a) out[a] = shape_value(t, t.order, t.nodes[a], xi);
}

std::vector<ShapeValue> shape_values(CellType type, const Xi& xi) {
    std::vector<ShapeValue> shapes(topology(type).nodes.size());
    shape_values(type, xi, shapes);
    return shapes;
}

std::vector<double> vertex_values(CellType type, const Xi& xi) {
    const CellTopology& t = topology(type);
    std::vector<double> values;
    for (int v = 0; v < t.vertex_count; ++v) values.push_back(shape_value(t, 1, t.nodes[v], xi).value);
    return values;
}

}  // namespace soft::mesh
