#include "fem/solid_kernel.hpp"

namespace soft::fem {

namespace {

template <bool Axisymmetric>
void sample(const ReferenceCell& cell, material::FiberFrame frame, const CellInput& in, CellPoints& points,
            std::vector<PointState>& states) {
    detail::map_points<Axisymmetric>(cell, in, points);
    detail::find_fiber_axes<Axisymmetric>(cell, frame, points);
    detail::FBarState mean;
    if (cell.form == Form::f_bar) mean = detail::f_bar_state(cell, points);
    for (int q = 0; q < cell.points; ++q) {
        const Tensor F = points.law.gradient(q);
        states.push_back({F, cell.form == Form::f_bar ? mean.law_gradient(q) : F, points.law.axes[q],
                          cell.pressure == PressureSpace::none ? 0.0 : points.law.p[q], points.volume[q]});
    }
}

}  // namespace

void sample_cell(const ReferenceCell& cell, model::Kinematics kinematics, material::FiberFrame frame,
                 const CellInput& in, CellPoints& points, std::vector<PointState>& states) {
    if (kinematics == model::Kinematics::axisymmetric) return sample<true>(cell, frame, in, points, states);
    return sample<false>(cell, frame, in, points, states);
}

std::vector<double> nodal_pressures(const ReferenceCell& cell, std::span<const double> X,
                                    std::span<const double> unknowns, double pressure_scale_Pa) {
    std::vector<double> nodal(cell.nodes, 0.0), basis(cell.pressure_dofs);
    for (int a = 0; a < cell.nodes; ++a) {
        detail::pressure_functions_at(cell, X, a, pressure_scale_Pa, basis);
        for (int s = 0; s < cell.pressure_dofs; ++s) nodal[a] += basis[s] * unknowns[s];
    }
    return nodal;
}

}  // namespace soft::fem
