#include "fem/mass.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/error.hpp"
#include "math/tensor.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"

namespace soft::fem {

namespace {

using mesh::Index;

/// N_a N_b is of degree 4 in second-order cells, times r in a body of revolution.
constexpr int mass_degree = 5;

struct PointTable {
    std::vector<double> weight;
    std::vector<std::vector<mesh::ShapeValue>> shapes;  // [point][node]
};

PointTable point_table(mesh::CellType type) {
    PointTable table;
    for (const auto& point : mesh::quadrature(mesh::topology(type).shape, mass_degree)) {
        table.weight.push_back(point.weight);
        table.shapes.push_back(mesh::shape_values(type, point.xi));
    }
    return table;
}

/// Undeformed volume of one quadrature point (axisymmetric: 2 pi R dA).
double point_volume(const model::Case& input, std::span<const Index> nodes, const std::vector<mesh::ShapeValue>& shapes,
                    double weight) {
    Tensor dX{};
    double radius = 0;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        const auto& X = input.mesh.point(nodes[a]);
        radius += shapes[a].value * X[1];
        for (int i = 0; i < input.mesh.dimension; ++i)
            for (int d = 0; d < input.mesh.dimension; ++d) dX[3 * i + d] += X[i] * shapes[a].gradient[d];
    }
    if (input.mesh.dimension == 2) dX[8] = 1.0;
    const double volume = determinant(dX) * weight;
    return input.kinematics == model::Kinematics::axisymmetric ? 2.0 * std::numbers::pi * radius * volume : volume;
}

/// Calls visit(unknowns by component, mass matrix of one component [node x node]) for every cell of this rank.
template <class Visit>
void for_each_cell_mass(const System& system, Visit&& visit) {
    const model::Case& input = system.input();
    const auto density = densities_kg_m3(input);
    std::map<mesh::CellType, PointTable> tables;
    std::vector<PetscInt> dofs;
    for (Index cell = 0; cell < input.mesh.cell_count(); ++cell) {
        if (system.dofs().cell_rank[cell] != system.discretization().rank) continue;
        const auto type = input.mesh.cell_type(cell);
        auto found = tables.find(type);
        if (found == tables.end()) found = tables.emplace(type, point_table(type)).first;
        const auto& table = found->second;
        const auto nodes = input.mesh.cell_nodes(cell);
        const std::size_t n = nodes.size();
        std::vector<double> mass(n * n, 0.0);
        for (std::size_t q = 0; q < table.weight.size(); ++q) {
            const auto& shapes = table.shapes[q];
            const double dm =
                density[input.mesh.cell_regions[cell]] * point_volume(input, nodes, shapes, table.weight[q]);
            for (std::size_t a = 0; a < n; ++a)
                for (std::size_t b = 0; b < n; ++b) mass[a * n + b] += dm * shapes[a].value * shapes[b].value;
        }
        system.dofs().node_dofs(nodes, dofs);
        visit(std::span<const PetscInt>(dofs), std::span<const double>(mass));
    }
}

}  // namespace

linalg::Matrix consistent_mass(const System& system) {
    linalg::Matrix M = system.make_matrix();
    for_each_cell_mass(system, [&](std::span<const PetscInt> dofs, std::span<const double> mass) {
        const auto n = static_cast<PetscInt>(std::lround(std::sqrt(static_cast<double>(mass.size()))));
        for (int i = 0; i < system.dofs().dimension; ++i) {
            const PetscInt* rows = dofs.data() + static_cast<std::size_t>(i) * static_cast<std::size_t>(n);
            SOFT_PETSC(MatSetValues(M, n, rows, n, rows, mass.data(), ADD_VALUES));
        }
    });
    linalg::assemble(M);
    return M;
}

linalg::Vector lumped_mass(const System& system) {
    linalg::Vector lumped = system.make_vector();
    for_each_cell_mass(system, [&](std::span<const PetscInt> dofs, std::span<const double> mass) {
        const auto n = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(mass.size()))));
        std::vector<double> share(n);
        double total = 0, diagonal = 0;
        for (std::size_t a = 0; a < n; ++a) {
            diagonal += share[a] = mass[a * n + a];
            for (std::size_t b = 0; b < n; ++b) total += mass[a * n + b];
        }
        for (double& m : share) m *= total / diagonal;
        for (int i = 0; i < system.dofs().dimension; ++i)
            SOFT_PETSC(VecSetValues(lumped, static_cast<PetscInt>(n), dofs.data() + static_cast<std::size_t>(i) * n,
                                    share.data(), ADD_VALUES));
    });
    linalg::assemble(lumped);
    return lumped;
}

linalg::Vector displacement_mask(const System& system) {
    linalg::Vector mask = system.make_vector();
    SOFT_PETSC(VecSet(mask, 1.0));
    const DofMap& map = system.dofs();
    const auto clear = [&](PetscInt dof) {
        if (dof >= map.begin && dof < map.end) SOFT_PETSC(VecSetValue(mask, dof, 0.0, INSERT_VALUES));
    };
    for (const auto dof : map.vertex_pressure) clear(dof);
    for (Index cell = 0; cell < system.input().mesh.cell_count(); ++cell)
        if (map.cell_pressure[cell] >= 0)
            for (int s = 0; s <= map.dimension; ++s) clear(map.cell_pressure[cell] + s);  // {1, X - Xc, ...}
    linalg::assemble(mask);
    return mask;
}

}  // namespace soft::fem
