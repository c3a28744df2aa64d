#include "element/reference_cell.hpp"

#include <string>

#include "core/error.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace soft::element {

namespace {

using mesh::Shape;

PressureSpace stable_space(const mesh::CellTopology& cell) {
    const bool tensor = cell.shape == Shape::quadrilateral || cell.shape == Shape::hexahedron;
    if (cell.order == 2) return tensor ? PressureSpace::discontinuous_linear : PressureSpace::continuous_vertex;
    throw Error(ExitCode::bad_input, "mesh", "first-order cells (" + std::string(cell.name) + ") have no stable pressure",
                "use mesh.order 2");
}

/// Degree that integrates stiffness of the undeformed, undistorted cell exactly and keeps full rank.
int quadrature_degree(const mesh::CellTopology& cell) {
    return cell.order == 1 ? 2 : 5;
}

}  // namespace

ReferenceCell make_reference_cell(mesh::CellType type, PressureChoice choice) {
    const auto& cell = mesh::topology(type);
    if (cell.dimension < 2)
        throw Error(ExitCode::bad_input, "mesh", std::string(cell.name) + " is no solid cell");
    ReferenceCell ref;
    ref.type = type;
    ref.dimension = cell.dimension;
    ref.nodes = cell.node_count;
    if (choice == PressureChoice::mixed) ref.pressure = stable_space(cell);
    if (ref.pressure == PressureSpace::discontinuous_linear) ref.pressure_dofs = cell.dimension + 1;
    if (ref.pressure == PressureSpace::continuous_vertex) ref.pressure_dofs = cell.vertex_count;

    for (const auto& point : mesh::quadrature(cell.shape, quadrature_degree(cell))) {
        const auto shapes = mesh::shape_values(type, point.xi);
        ref.weight.push_back(point.weight);
        for (const auto& shape : shapes) ref.N.push_back(shape.value);
        for (int d = 0; d < cell.dimension; ++d)
            for (const auto& shape : shapes) ref.dN_dxi.push_back(shape.gradient[d]);
        if (ref.pressure == PressureSpace::continuous_vertex) {
            const auto vertex = mesh::vertex_values(type, point.xi);
            ref.vertex_N.insert(ref.vertex_N.end(), vertex.begin(), vertex.end());
        }
        ++ref.points;
    }
    return ref;
}

}  // namespace soft::element
