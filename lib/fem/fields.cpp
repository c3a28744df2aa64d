#include "fem/fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "linalg/profile.hpp"
#include "math/tensor.hpp"
#include "mesh/quality.hpp"

namespace soft::fem {

namespace {

/// Energies per undeformed volume at a point.
struct PointEnergy {
    double stored_J_m3 = 0, dissipated_J_m3 = 0;  // dissipated: in the step
};

/// Calls visit(point, energy, number) for every quadrature point of this rank's cells, as for_each_point.
template <class Visit>
void for_each_energy(const Discretization& fe, LocalState& state, const Visit& visit) {
    const auto& steps = state.inelastic_step().points;
    for_each_point(fe, state, [&](const PointState& point, const PointLocation& at, std::size_t number) {
        const double elastic = std::visit(
            [&](const auto& rubber) { return energy_density(fe.input.formulation, rubber, point); }, *at.group.rubber);
        const material::PointStep step = steps.empty() ? material::PointStep{} : steps[number];
        visit(point, PointEnergy{elastic + step.stored_change_J_m3, step.dissipated_J_m3}, number);
    });
}

/// Of the point with this number.
Vector3 undeformed_position(const Discretization& fe, std::size_t number) {
    auto group = fe.groups.begin();
    const auto points_of_cell = [&] { return static_cast<std::size_t>(group->reference->points); };
    for (; number >= group->cells.size() * points_of_cell(); ++group) number -= group->cells.size() * points_of_cell();
    const mesh::Mesh& mesh = fe.input.mesh;
    const auto nodes = mesh.cell_nodes(group->cells[number / points_of_cell()]);
    const double* N = &group->reference->N[number % points_of_cell() * nodes.size()];
    Vector3 X{};
    for (std::size_t a = 0; a < nodes.size(); ++a)
        for (std::size_t i = 0; i < 3; ++i) X[i] += N[a] * mesh.point(nodes[a])[i];
    return X;
}

struct Sample {
    double stretch, volume;
};

/// The samples of all ranks, the largest stretch first.
std::vector<Sample> sorted_samples(const std::vector<Sample>& mine, MPI_Comm comm) {
    int size = 1;
    MPI_Comm_size(comm, &size);
    std::vector<int> counts(size), starts(size, 0);
    const int count = static_cast<int>(2 * mine.size());
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
    std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
    std::vector<Sample> all((starts.back() + counts.back()) / 2);
    MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE, comm);
    std::ranges::sort(all, [](const Sample& a, const Sample& b) {
        return a.stretch != b.stretch ? a.stretch > b.stretch : a.volume > b.volume;
    });
    return all;
}

/// The stretch that is exceeded in 1 % of the volume.
double percentile_99(const std::vector<Sample>& sorted) {
    double total = 0, above = 0;
    for (const auto& sample : sorted) total += sample.volume;
    for (const auto& sample : sorted) {
        above += sample.volume;
        if (above >= 0.01 * total) return sample.stretch;
    }
    return sorted.back().stretch;
}

/// Adds the pressure of one cell at its nodes.
void add_nodal_pressures(const Discretization& fe, mesh::Index cell, const std::vector<double>& x,
                         std::vector<double>& pressure_Pa, std::vector<int>& shares) {
    const auto& mesh = fe.input.mesh;
    const auto& reference = reference_of(fe.references, mesh.cell_type(cell));
    const auto nodes = mesh.cell_nodes(cell);
    std::vector<PetscInt> dofs;
    fe.dofs.cell_dofs(mesh, cell, reference, dofs);
    std::vector<double> unknowns;
    for (int s = reference.displacement_dofs(); s < reference.dofs(); ++s) unknowns.push_back(x[dofs[s]]);
    const auto nodal = nodal_pressures(reference, mesh::by_component(mesh.points, nodes, mesh.dimension), unknowns,
                                       fe.dofs.pressure_scale_Pa);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        pressure_Pa[nodes[a]] += nodal[a];
        ++shares[nodes[a]];
    }
}

}  // namespace

double Fields::stored_energy(Vec x) {
    state_.read(x);
    std::vector<double> energies_J(point_count(fe_));
    for_each_energy(fe_, state_, [&](const PointState& point, const PointEnergy& energy, std::size_t number) {
        energies_J[number] = point.weight_m3 * (energy.stored_J_m3 + energy.dissipated_J_m3);
    });
    double energy_J = std::accumulate(energies_J.begin(), energies_J.end(), 0.0);
    MPI_Allreduce(MPI_IN_PLACE, &energy_J, 1, MPI_DOUBLE, MPI_SUM, fe_.comm);
    const contact::Summary contact = contact_.measure(x);
    return energy_J + state_.internal().dissipated_J() + contact.energy_J + contact.dissipated_J;
}

StretchSummary Fields::stretches(Vec x) {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    state_.read(x);
    std::vector<Sample> mine(point_count(fe_));
    std::vector<PointEnergy> energies(mine.size());
    std::vector<double> jacobians(mine.size());
    for_each_energy(fe_, state_, [&](const PointState& point, const PointEnergy& energy, std::size_t number) {
        const auto eigenvalues = symmetric_eigenvalues(right_cauchy_green(point.F));
        mine[number] = {std::sqrt(std::max(eigenvalues[0], 0.0)), point.weight_m3};
        energies[number] = energy;
        jacobians[number] = determinant(point.F);
    });
    StretchSummary summary;
    summary.min_jacobian = 1e300;
    struct {
        double stretch;
        int rank;
    } own{0, fe_.rank}, most{};
    std::size_t largest = 0;
    for (std::size_t i = 0; i < mine.size(); ++i) {
        summary.min_jacobian = std::min(summary.min_jacobian, jacobians[i]);
        summary.stored_energy_J += mine[i].volume * energies[i].stored_J_m3;
        summary.dissipated_J += mine[i].volume * energies[i].dissipated_J_m3;
        summary.max_energy_J_m3 = std::max(summary.max_energy_J_m3, energies[i].stored_J_m3);
        if (mine[i].stretch > mine[largest].stretch) largest = i;
    }
    if (!mine.empty()) {
        own.stretch = mine[largest].stretch;
        summary.max_at_m = undeformed_position(fe_, largest);
    }
    MPI_Allreduce(MPI_IN_PLACE, &summary.min_jacobian, 1, MPI_DOUBLE, MPI_MIN, fe_.comm);
    for (double* sum : {&summary.stored_energy_J, &summary.dissipated_J})
        MPI_Allreduce(MPI_IN_PLACE, sum, 1, MPI_DOUBLE, MPI_SUM, fe_.comm);
    summary.dissipated_J += state_.internal().dissipated_J();
    const contact::Summary contact = contact_.measure(x);
    summary.stored_energy_J += contact.energy_J;
    summary.friction_J = contact.dissipated_J;
    MPI_Allreduce(MPI_IN_PLACE, &summary.max_energy_J_m3, 1, MPI_DOUBLE, MPI_MAX, fe_.comm);
    MPI_Allreduce(&own, &most, 1, MPI_DOUBLE_INT, MPI_MAXLOC, fe_.comm);
    MPI_Bcast(summary.max_at_m.data(), 3, MPI_DOUBLE, most.rank, fe_.comm);
    const auto samples = sorted_samples(mine, fe_.comm);
    summary.largest = samples.front().stretch;
    summary.p99 = percentile_99(samples);
    return summary;
}

std::optional<double> Fields::error_in_time(Vec x) {
    state_.read(x);
    const InelasticStep& step = state_.inelastic_step();
    std::array sums{step.error2, step.stress2};
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), 2, MPI_DOUBLE, MPI_SUM, fe_.comm);
    return state_.internal().relative_error(sums[0], sums[1]);
}

mesh::Index Fields::inverted_at_a_node(Vec x, double below) const {
    const auto displacement_m = gather_displacements(x);
    mesh::Index found = -1;
    if (fe_.rank == 0) {
        mesh::Mesh mesh = fe_.input.mesh;
        for (std::size_t i = 0; i < displacement_m.size(); ++i) mesh.points[i / 3][i % 3] += displacement_m[i];
        double worst = below;
        for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell) {
            const double value = mesh::scaled_jacobian(mesh, cell, mesh::node_shapes(mesh.cell_type(cell))).value;
            if (value >= worst) continue;
            worst = value;
            found = cell;
        }
    }
    MPI_Bcast(&found, 1, MPI_INT64_T, 0, fe_.comm);
    return found;
}

std::vector<double> Fields::displacements_m(std::span<const double> all) const {
    const std::size_t points = fe_.input.mesh.points.size(), dimension = static_cast<std::size_t>(fe_.dofs.dimension);
    std::vector<double> values(3 * points, 0.0);
    for (std::size_t node = 0; node < points; ++node)
        for (std::size_t i = 0; i < dimension; ++i) {
            const auto dof = fe_.dofs.displacement[node * dimension + i];
            values[3 * node + i] = dof >= 0 ? all[static_cast<std::size_t>(dof)] : state_[dof];
        }
    return values;
}

std::vector<double> Fields::gather_displacements(Vec x) const {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    const std::vector<double> all = linalg::gather(x);
    return fe_.rank == 0 ? displacements_m(all) : std::vector<double>{};
}

NodalFields Fields::gather(Vec x) const {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    const std::vector<double> all = linalg::gather(x);
    NodalFields fields;
    if (fe_.rank != 0) return fields;
    const mesh::Mesh& mesh = fe_.input.mesh;
    const DofMap& map = fe_.dofs;
    const std::size_t points = mesh.points.size();
    fields.displacement_m = displacements_m(all);
    if (map.pressures == 0) return fields;
    fields.pressure_Pa.assign(points, 0.0);
    std::vector<int> shares(points, 0);
    for (mesh::Index cell = 0; cell < mesh.cell_count(); ++cell)
        add_nodal_pressures(fe_, cell, all, fields.pressure_Pa, shares);
    for (std::size_t node = 0; node < points; ++node)
        if (shares[node] > 0) fields.pressure_Pa[node] /= shares[node];
    return fields;
}

void Fields::spread(std::span<const double> displacement_m, Vec x) const {
    const std::size_t points = fe_.input.mesh.points.size(), dimension = static_cast<std::size_t>(fe_.dofs.dimension);
    std::vector<double> all(3 * points);
    if (fe_.rank == 0) std::ranges::copy(displacement_m.first(all.size()), all.begin());
    MPI_Bcast(all.data(), static_cast<int>(all.size()), MPI_DOUBLE, 0, fe_.comm);
    PetscScalar* value = nullptr;
    SOFT_PETSC(VecGetArray(x, &value));
    for (std::size_t node = 0; node < points; ++node)
        for (std::size_t i = 0; i < dimension; ++i) {
            const auto dof = fe_.dofs.displacement[node * dimension + i];
            if (dof >= fe_.dofs.begin && dof < fe_.dofs.end) value[dof - fe_.dofs.begin] = all[3 * node + i];
        }
    SOFT_PETSC(VecRestoreArray(x, &value));
}

}  // namespace soft::fem
