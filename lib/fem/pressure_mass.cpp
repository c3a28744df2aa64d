#include "fem/pressure_mass.hpp"

namespace soft::fem {

std::vector<double> pressure_mass(const ReferenceCell& cell, model::Kinematics kinematics, std::span<const double> X,
                                  double pressure_scale_Pa) {
    const auto size = static_cast<std::size_t>(cell.pressure_dofs);
    std::vector<double> mass(size * size, 0.0);
    if (size == 0) return mass;
    const std::vector<double> rest(X.size(), 0.0), none(size, 0.0);
    CellPoints points(cell);
    if (kinematics == model::Kinematics::axisymmetric)
        detail::map_points<true>(cell, {X, rest, none, pressure_scale_Pa}, points);
    else
        detail::map_points<false>(cell, {X, rest, none, pressure_scale_Pa}, points);
    const auto stride = static_cast<std::size_t>(points.law.stride);
    for (std::size_t s = 0; s < size; ++s)
        for (std::size_t t = 0; t < size; ++t)
            for (std::size_t q = 0; q < static_cast<std::size_t>(cell.points); ++q)
                mass[s * size + t] += points.volume[q] * points.basis[s * stride + q] * points.basis[t * stride + q];
    return mass;
}

}  // namespace soft::fem
