#include "element/shape.hpp"

#include <cmath>

namespace soft::element {

namespace {

using mesh::Shape;

struct Value {
    double f = 0;
    double df = 0;
};

/// One-dimensional Lagrange function on [-1, 1] that is one at `node` (-1, 0 or 1).
Value line_function(int order, double node, double x) {
    if (order == 1) return {0.5 * (1.0 + node * x), 0.5 * node};
    if (node == 0.0) return {1.0 - x * x, -2.0 * x};
    return {0.5 * x * (x + node), x + 0.5 * node};
}

struct SimplexValue {
    double f = 0;
    std::array<double, 4> df{};   // by barycentric coordinate
};

/// Function of a simplex node with barycentric coordinates `node` (entries 0, 1/2 or 1).
SimplexValue simplex_function(int order, int vertices, const std::array<double, 4>& node,
                              const std::array<double, 4>& lambda) {
    SimplexValue value;
    int first = -1, second = -1;
    for (int v = 0; v < vertices; ++v)
        if (node[v] > 0.25) (first < 0 ? first : second) = v;
    if (second >= 0) {
        value.f = 4.0 * lambda[first] * lambda[second];
        value.df[first] = 4.0 * lambda[second];
        value.df[second] = 4.0 * lambda[first];
    } else if (order == 2) {
        value.f = lambda[first] * (2.0 * lambda[first] - 1.0);
        value.df[first] = 4.0 * lambda[first] - 1.0;
    } else {
        value.f = lambda[first];
        value.df[first] = 1.0;
    }
    return value;
}

/// Barycentric coordinates of the unit simplex: (1 - sum xi, xi...).
std::array<double, 4> barycentric(int dimension, const ReferencePoint& xi) {
    std::array<double, 4> lambda{1.0, 0, 0, 0};
    for (int d = 0; d < dimension; ++d) {
        lambda[0] -= xi[d];
        lambda[d + 1] = xi[d];
    }
    return lambda;
}

void tensor_product(const mesh::CellTopology& cell, int order, const ReferencePoint& xi, int a, ShapeValues& out) {
    std::array<Value, 3> line;
    for (int d = 0; d < cell.dimension; ++d) line[d] = line_function(order, cell.nodes[a][d], xi[d]);
    out.N[a] = 1.0;
    for (int d = 0; d < cell.dimension; ++d) out.N[a] *= line[d].f;
    for (int d = 0; d < cell.dimension; ++d) {
        double slope = 1.0;
        for (int e = 0; e < cell.dimension; ++e) slope *= (e == d ? line[e].df : line[e].f);
        out.dN_dxi[a][d] = slope;
    }
}

void simplex(const mesh::CellTopology& cell, int order, const ReferencePoint& xi, int a, ShapeValues& out) {
    const auto value = simplex_function(order, cell.dimension + 1, barycentric(cell.dimension, cell.nodes[a]),
                                        barycentric(cell.dimension, xi));
    out.N[a] = value.f;
    for (int d = 0; d < cell.dimension; ++d) out.dN_dxi[a][d] = value.df[d + 1] - value.df[0];
}

void wedge(const mesh::CellTopology& cell, int order, const ReferencePoint& xi, int a, ShapeValues& out) {
    const auto triangle = simplex_function(order, 3, barycentric(2, cell.nodes[a]), barycentric(2, xi));
    const Value line = line_function(order, cell.nodes[a][2], xi[2]);
    out.N[a] = triangle.f * line.f;
    for (int d = 0; d < 2; ++d) out.dN_dxi[a][d] = (triangle.df[d + 1] - triangle.df[0]) * line.f;
    out.dN_dxi[a][2] = triangle.f * line.df;
}

void evaluate(const mesh::CellTopology& cell, int order, const ReferencePoint& xi, int a, ShapeValues& out) {
    switch (cell.shape) {
        case Shape::line:
        case Shape::quadrilateral:
        case Shape::hexahedron: return tensor_product(cell, order, xi, a, out);
        case Shape::triangle:
        case Shape::tetrahedron: return simplex(cell, order, xi, a, out);
        case Shape::wedge: return wedge(cell, order, xi, a, out);
    }
}

}  // namespace

ShapeValues shape_functions(mesh::CellType type, const ReferencePoint& xi) {
    const auto& cell = mesh::topology(type);
    ShapeValues out{std::vector<double>(cell.node_count), std::vector<std::array<double, 3>>(cell.node_count)};
    for (int a = 0; a < cell.node_count; ++a) evaluate(cell, cell.order, xi, a, out);
    return out;
}

std::vector<double> vertex_functions(mesh::CellType type, const ReferencePoint& xi) {
    const auto& cell = mesh::topology(type);
    ShapeValues out{std::vector<double>(cell.vertex_count), std::vector<std::array<double, 3>>(cell.vertex_count)};
    for (int a = 0; a < cell.vertex_count; ++a) evaluate(cell, 1, xi, a, out);
    return out.N;
}

}  // namespace soft::element
