#pragma once
/// One distorted cell of each type, for patch and tangent tests.
#include <cmath>
#include <vector>

#include "mesh/cell_type.hpp"

namespace soft::fem {

/// Smooth invertible map of the reference cell; second-order cells become curved.
inline std::vector<double> distorted_nodes(mesh::CellType type) {
    const auto& cell = mesh::topology(type);
    std::vector<double> X(static_cast<std::size_t>(cell.dimension) * cell.node_count);
    for (int a = 0; a < cell.node_count; ++a) {
        const auto& s = cell.nodes[a];
        const double x = 2.0 + s[0] + 0.12 * s[1] * s[1] + 0.05 * s[0] * s[1];
        const double y = 3.0 + s[1] + 0.10 * s[0] + 0.07 * s[0] * s[0] + 0.06 * s[2];
        const double z = 1.0 + s[2] + 0.08 * s[0] * s[1] + 0.05 * s[1];
        const double position[] = {x, y, z};
        for (int i = 0; i < cell.dimension; ++i) X[i * cell.node_count + a] = 0.01 * position[i];
    }
    return X;
}

/// A smooth finite displacement with det F > 0.
inline std::vector<double> smooth_displacement(mesh::CellType type, const std::vector<double>& X, double size) {
    const auto& cell = mesh::topology(type);
    const int n = cell.node_count;
    std::vector<double> u(X.size());
    for (int a = 0; a < n; ++a) {
        const double x = 100 * X[a], y = 100 * X[n + a], z = cell.dimension == 3 ? 100 * X[2 * n + a] : 0;
        const double move[] = {0.2 * x + 0.1 * std::sin(y) + 0.05 * z, -0.1 * y + 0.08 * x * x / 3 + 0.04 * z,
                               0.15 * z + 0.05 * x * y};
        for (int i = 0; i < cell.dimension; ++i) u[i * n + a] = 0.01 * size * move[i];
    }
    return u;
}

}  // namespace soft::fem
