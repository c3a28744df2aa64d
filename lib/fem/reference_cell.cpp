#include "fem/reference_cell.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "math/lanes.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "model/formulation.hpp"

namespace soft::fem {

namespace {

using mesh::Shape;

bool is_tensor_cell(const mesh::CellTopology& cell) {
    return cell.shape == Shape::quadrilateral || cell.shape == Shape::hexahedron;
}

bool is_simplex(const mesh::CellTopology& cell) {
    return cell.shape == Shape::triangle || cell.shape == Shape::tetrahedron;
}

PressureSpace pressure_space(const mesh::CellTopology& cell, Form form) {
    if (form != Form::mixed) return PressureSpace::none;
    return is_tensor_cell(cell) ? PressureSpace::discontinuous_linear : PressureSpace::continuous_vertex;
}

/// See the table in the header.
int quadrature_degree(const mesh::CellTopology& cell, Form form) {
    if (cell.order == 1) return cell.shape == Shape::tetrahedron ? 1 : 2;
    return is_simplex(cell) && form == Form::displacement ? 2 : 5;
}

void add_point(const mesh::QuadraturePoint& point, ReferenceCell& ref) {
    const auto shapes = mesh::shape_values(ref.type, point.xi);
    ref.weight.push_back(point.weight);
    for (const auto& shape : shapes) ref.N.push_back(shape.value);
    for (int d = 0; d < ref.dimension; ++d)
        for (const auto& shape : shapes) ref.dN_dxi.push_back(shape.gradient[d]);
    if (ref.pressure == PressureSpace::continuous_vertex) {
        const auto vertex = mesh::vertex_values(ref.type, point.xi);
        ref.vertex_N.insert(ref.vertex_N.end(), vertex.begin(), vertex.end());
    }
    ++ref.points;
}

void fill_by_node(ReferenceCell& ref) {
    const int n = ref.nodes, dim = ref.dimension, stride = padded(ref.points);
    ref.by_node.reserve(static_cast<std::size_t>(n) * (dim + 1) * stride);
    for (int a = 0; a < n; ++a)
        for (int d = 0; d <= dim; ++d)
            for (int lane = 0; lane < stride; ++lane) {
                const int q = std::min(lane, ref.points - 1);
                ref.by_node.push_back(d < dim ? ref.dN_dxi[(q * dim + d) * n + a] : ref.N[q * n + a]);
            }
}

}  // namespace

ReferenceCell make_reference_cell(mesh::CellType type, Form form) {
    const auto& cell = mesh::topology(type);
    if (const std::string reason = model::explain_incompatibility(type, form); !reason.empty())
        throw Error(ExitCode::bad_input, "mesh", reason);
    ReferenceCell ref;
    ref.type = type;
    ref.form = form;
    ref.dimension = cell.dimension;
    ref.nodes = cell.node_count;
    ref.pressure = pressure_space(cell, form);
    if (ref.pressure == PressureSpace::discontinuous_linear) ref.pressure_dofs = cell.dimension + 1;
    if (ref.pressure == PressureSpace::continuous_vertex) ref.pressure_dofs = cell.vertex_count;
    for (const auto& point : mesh::quadrature(cell.shape, quadrature_degree(cell, form))) add_point(point, ref);
    fill_by_node(ref);
    return ref;
}

}  // namespace soft::fem
