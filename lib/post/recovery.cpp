#include "post/recovery.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "fem/solid_kernel.hpp"
#include "math/tensor.hpp"

namespace soft::post {

namespace {

/// Least squares for up to three unknowns: matrix and right-hand side, accumulated row by row.
struct NormalEquations {
    Tensor matrix{};
    Vector3 right{};

    void add(const Vector3& row, double value) {
        for (std::size_t i = 0; i < 3; ++i) {
            right[i] += row[i] * value;
            for (std::size_t j = 0; j < 3; ++j) matrix[3 * i + j] += row[i] * row[j];
        }
    }
    /// Minimum-norm solution: a relative damping of 1e-9 selects it and changes the solution by the same order.
    [[nodiscard]] Vector3 solve() const {
        constexpr double damping = 1e-9;
        const double size = trace(matrix);
        if (!(size > 0.0)) return {};
        Tensor damped = matrix;
        for (std::size_t i = 0; i < 3; ++i) damped[4 * i] += damping * size;
        const Tensor inverse_transpose = cofactor(damped);  // symmetric, times the determinant
        const double det = determinant(damped);
        Vector3 x{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) x[i] += inverse_transpose[3 * i + j] * right[j] / det;
        return x;
    }
};

/// Values of the pressure functions at the nodes, [node][unknown].
std::vector<double> nodal_functions(const fem::ReferenceCell& cell, std::span<const double> X) {
    const auto dofs = static_cast<std::size_t>(cell.pressure_dofs), n = static_cast<std::size_t>(cell.nodes);
    std::vector<double> functions(n * dofs), unit(dofs, 0.0);
    for (std::size_t s = 0; s < dofs; ++s) {
        unit[s] = 1.0;
        const auto values = fem::nodal_pressures(cell, X, unit, 1.0);
        for (std::size_t a = 0; a < n; ++a) functions[a * dofs + s] = values[a];
        unit[s] = 0.0;
    }
    return functions;
}

/// A continuous pressure is linear between the vertices. At a vertex that is shared with another region the nodal mean is replaced by the
/// value that follows from the middles of edges to vertices that are not.
std::vector<double> vertex_pressure(const fem::ReferenceCell& cell, const NodalPressures& nodal) {
    const auto dofs = static_cast<std::size_t>(cell.pressure_dofs), n = static_cast<std::size_t>(cell.nodes);
    std::vector<double> unknowns(nodal.pressure_Pa.begin(), nodal.pressure_Pa.begin() + cell.pressure_dofs);
    if (std::none_of(nodal.shared.begin(), nodal.shared.begin() + cell.pressure_dofs, std::identity{})) return unknowns;
    const auto functions = nodal_functions(cell, nodal.X);
    double mean = 0;  // of the nodes between the vertices that are not shared
    int unshared = 0;
    for (std::size_t a = dofs; a < n; ++a)
        if (!nodal.shared[a]) mean += (nodal.pressure_Pa[a] - mean) / ++unshared;
    const auto is_edge_to = [&](std::size_t v, std::size_t w, std::size_t middle) {
        return w != v && !nodal.shared[w] && !nodal.shared[middle] && functions[middle * dofs + v] == 0.5 &&
               functions[middle * dofs + w] == 0.5;
    };
    for (std::size_t v = 0; v < dofs; ++v) {
        if (!nodal.shared[v]) continue;
        double sum = 0;
        int edges = 0;
        for (std::size_t a = dofs; a < n; ++a)
            for (std::size_t w = 0; w < dofs; ++w)
                if (is_edge_to(v, w, a)) {
                    sum += 2 * nodal.pressure_Pa[a] - nodal.pressure_Pa[w];
                    ++edges;
                }
        if (edges > 0)
            unknowns[v] = sum / edges;
        else if (unshared > 0)
            unknowns[v] = mean;
    }
    return unknowns;
}

}  // namespace

std::vector<double> extrapolation(const fem::ReferenceCell& cell, std::span<const double> X) {
    const auto points = static_cast<std::size_t>(cell.points), nodes = static_cast<std::size_t>(cell.nodes);
    // 1 and the coordinates, orthogonalized over the points (Gram-Schmidt).
    struct Function {
        std::vector<double> point, node;
        double square = 0;
    };
    std::vector<Function> functions;
    const std::size_t count = points == 1 ? 1 : static_cast<std::size_t>(cell.dimension) + 1;
    for (std::size_t k = 0; k < count; ++k) {
        Function f{std::vector<double>(points, 1.0), std::vector<double>(nodes, 1.0)};
        if (k > 0) {
            for (std::size_t a = 0; a < nodes; ++a) f.node[a] = X[(k - 1) * nodes + a];
            for (std::size_t q = 0; q < points; ++q)
                f.point[q] = std::inner_product(f.node.begin(), f.node.end(),
                                                cell.N.begin() + static_cast<std::ptrdiff_t>(q * nodes), 0.0);
        }
        for (const Function& g : functions) {
            double share = 0;
            for (std::size_t q = 0; q < points; ++q) share += cell.weight[q] * f.point[q] * g.point[q] / g.square;
            for (std::size_t q = 0; q < points; ++q) f.point[q] -= share * g.point[q];
            for (std::size_t a = 0; a < nodes; ++a) f.node[a] -= share * g.node[a];
        }
        for (std::size_t q = 0; q < points; ++q) f.square += cell.weight[q] * f.point[q] * f.point[q];
        functions.push_back(std::move(f));
    }
    std::vector<double> matrix(nodes * points, 0.0);
    for (const Function& f : functions)
        for (std::size_t a = 0; a < nodes; ++a)
            for (std::size_t q = 0; q < points; ++q)
                matrix[a * points + q] += f.node[a] * f.point[q] * cell.weight[q] / f.square;
    return matrix;
}

std::vector<double> cell_pressure(const fem::ReferenceCell& cell, const NodalPressures& nodal) {
    const auto dofs = static_cast<std::size_t>(cell.pressure_dofs);
    if (cell.pressure == fem::PressureSpace::continuous_vertex) return vertex_pressure(cell, nodal);
    const auto functions = nodal_functions(cell, nodal.X);
    const std::size_t centre = static_cast<std::size_t>(cell.nodes) - 1;  // the last node in VTK's order
    NormalEquations equations;
    for (std::size_t a = 0; a < centre; ++a) {
        if (nodal.shared[a]) continue;
        Vector3 row{};
        for (std::size_t s = 1; s < dofs; ++s) row[s - 1] = functions[a * dofs + s] - functions[centre * dofs + s];
        equations.add(row, nodal.pressure_Pa[a] - nodal.pressure_Pa[centre]);
    }
    const Vector3 slope = equations.solve();
    std::vector<double> unknowns(dofs, nodal.pressure_Pa[centre]);
    for (std::size_t s = 1; s < dofs; ++s) {
        unknowns[s] = slope[s - 1];
        unknowns[0] -= slope[s - 1] * functions[centre * dofs + s];
    }
    return unknowns;
}

}  // namespace soft::post
