#include "element/solid_kernel.hpp"

#include <algorithm>
#include <array>

#include "mesh/shape.hpp"

namespace soft::element {

namespace detail {

/// {1, 2 (X - centre) / extent} at a place given by the values N of the shape functions.
static void linear_basis(const ReferenceCell& cell, std::span<const double> X, const double* N, double scale_Pa,
                         std::span<double> basis) {
    const int n = cell.nodes, dim = cell.dimension;
    const int vertices = mesh::topology(cell.type).vertex_count;
    std::array<double, 3> centre{}, here{};
    double extent = 0;
    for (int i = 0; i < dim; ++i) {
        const auto [low, high] = std::minmax_element(&X[i * n], &X[i * n] + vertices);
        centre[i] = 0.5 * (*low + *high);
        extent = std::max(extent, *high - *low);
        for (int a = 0; a < n; ++a) here[i] += N[a] * X[i * n + a];
    }
    basis[0] = scale_Pa;
    for (int i = 0; i < dim; ++i) basis[i + 1] = scale_Pa * 2.0 * (here[i] - centre[i]) / extent;
}

void pressure_basis(const ReferenceCell& cell, const CellInput& in, int q, std::span<double> basis) {
    if (cell.pressure == PressureSpace::continuous_vertex) {
        for (int v = 0; v < cell.pressure_dofs; ++v)
            basis[v] = in.pressure_scale_Pa * cell.vertex_N[static_cast<std::size_t>(q) * cell.pressure_dofs + v];
        return;
    }
    linear_basis(cell, in.X, &cell.N[static_cast<std::size_t>(q) * cell.nodes], in.pressure_scale_Pa, basis);
}

namespace {

template <bool Axisymmetric>
void sample(const ReferenceCell& cell, material::FiberFrame frame, const CellInput& in,
            std::vector<PointState>& states) {
    std::vector<double> gradient(static_cast<std::size_t>(cell.dimension + 1) * cell.nodes);
    std::vector<double> basis(cell.pressure_dofs);
    FBarState mean;
    if (cell.form == Form::f_bar) mean = f_bar_state<Axisymmetric>(cell, in, gradient);
    for (int q = 0; q < cell.points; ++q) {
        PointState state;
        state.weight_m3 = map_point<Axisymmetric>(cell, in, q, gradient);
        state.F = deformation_gradient<Axisymmetric>(cell, in, gradient);
        state.F_law = cell.form == Form::f_bar ? mean.law_gradient(q) : state.F;
        state.axes = fiber_axes<Axisymmetric>(cell, frame, in, q);
        state.p_Pa = 0;
        if (cell.pressure != PressureSpace::none) {
            pressure_basis(cell, in, q, basis);
            for (int s = 0; s < cell.pressure_dofs; ++s) state.p_Pa += basis[s] * in.p[s];
        }
        states.push_back(state);
    }
}

}  // namespace
}  // namespace detail

void sample_cell(const ReferenceCell& cell, model::Kinematics kinematics, material::FiberFrame frame,
                 const CellInput& in, std::vector<PointState>& states) {
    if (kinematics == model::Kinematics::axisymmetric) return detail::sample<true>(cell, frame, in, states);
    return detail::sample<false>(cell, frame, in, states);
}

std::vector<double> nodal_pressures(const ReferenceCell& cell, std::span<const double> X,
                                    std::span<const double> unknowns, double pressure_scale_Pa) {
    std::vector<double> nodal(cell.nodes, 0.0), basis(cell.pressure_dofs);
    for (int a = 0; a < cell.nodes; ++a) {
        const auto& xi = mesh::topology(cell.type).nodes[a];
        if (cell.pressure == PressureSpace::continuous_vertex) {
            basis = mesh::vertex_values(cell.type, xi);
            for (double& b : basis) b *= pressure_scale_Pa;
        } else {
            std::vector<double> N;
            for (const auto& shape : mesh::shape_values(cell.type, xi)) N.push_back(shape.value);
            detail::linear_basis(cell, X, N.data(), pressure_scale_Pa, basis);
        }
        for (int s = 0; s < cell.pressure_dofs; ++s) nodal[a] += basis[s] * unknowns[s];
    }
    return nodal;
}

}  // namespace soft::element
