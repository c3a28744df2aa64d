#include "fem/local_state.hpp"

#include <algorithm>
#include <numeric>

namespace soft::fem {

namespace {

/// Entries of all element matrices from which on threads are faster.
constexpr double entries_of_threads = 2e6;

/// The unknowns that this rank reads, ascending. Rims and the outputs of whole faces, which rank 0 evaluates, reach beyond its cells.
std::vector<PetscInt> unknowns_read(const Discretization& fe, std::span<const mesh::Index> nodes) {
    std::vector<char> wanted(static_cast<std::size_t>(fe.dofs.total), 0);
    const auto mark = [&](std::span<const PetscInt> dofs) {
        for (const PetscInt dof : dofs)
            if (dof >= 0) wanted[static_cast<std::size_t>(dof)] = 1;
    };
    for (const auto& group : fe.groups) mark(group.dofs);
    std::vector<PetscInt> dofs;
    fe.dofs.node_dofs(nodes, dofs);
    mark(dofs);
    if (fe.rank == 0)
        for (const auto& [name, facets] : fe.input.mesh.facet_sets)
            for (const auto& facet : facets) {
                fe.dofs.node_dofs(mesh::facet_nodes(fe.input.mesh, facet), dofs);
                mark(dofs);
            }
    dofs.clear();
    for (std::size_t dof = 0; dof < wanted.size(); ++dof)
        if (wanted[dof] != 0) dofs.push_back(static_cast<PetscInt>(dof));
    return dofs;
}

}  // namespace

LocalState::LocalState(const Discretization& fe, std::span<const mesh::Index> nodes)
    : fe_(fe),
      levels_(no_loads(fe.input)),
      first_(1 + 3 * static_cast<PetscInt>(fe.input.motions.size())),
      values_(static_cast<std::size_t>(first_ + fe.dofs.total), 0.0),
      internal_(fe) {
    const auto dofs = unknowns_read(fe, nodes);
    linalg::IndexSet wanted;
    SOFT_PETSC(ISCreateGeneral(PETSC_COMM_SELF, static_cast<PetscInt>(dofs.size()), dofs.data(), PETSC_COPY_VALUES,
                               wanted.out()));
    SOFT_PETSC(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, fe.dofs.total, values_.data() + first_, unknowns_.out()));
    SOFT_PETSC(VecScatterCreate(fe.make_vector(), wanted, unknowns_, wanted, scatter_.out()));
}

void LocalState::prescribe(const LoadLevels& levels) {
    levels_ = levels;
    internal_.set_time(levels.time_s);
    for (PetscInt slot = 0; slot < first_ - 1; ++slot) {
        const PetscInt dof = -2 - slot;
        values_[static_cast<std::size_t>(first_ + dof)] =
            levels.motions[static_cast<std::size_t>(slot / 3)] * fe_.moved_by(dof);
    }
}

void LocalState::read(Vec x) {
    SOFT_PETSC(VecScatterBegin(scatter_, x, unknowns_, INSERT_VALUES, SCATTER_FORWARD));
    SOFT_PETSC(VecScatterEnd(scatter_, x, unknowns_, INSERT_VALUES, SCATTER_FORWARD));
}

/// A row asks for it several times.
const InelasticStep& LocalState::inelastic_step() {
    const bool is_known = step_values_ == values_ && step_time_s_ == levels_.time_s;
    if (internal_.is_empty() || (is_known && step_number_ == internal_.accepted_steps())) return step_;
    step_ = {};
    step_.points.resize(point_count(fe_));
    std::vector<double> weights_m3(step_.points.size());
    for_each_point(fe_, *this, [&](const PointState& point, const PointLocation& at, std::size_t number) {
        step_.points[number] = internal_.step_at(at, point);
        weights_m3[number] = point.weight_m3;
    });
    for (std::size_t i = 0; i < weights_m3.size(); ++i) {
        step_.dissipated_J += weights_m3[i] * step_.points[i].dissipated_J_m3;
        step_.error2 += weights_m3[i] * step_.points[i].error2;
        step_.stress2 += weights_m3[i] * step_.points[i].stress2;
    }
    step_values_ = values_;
    step_time_s_ = levels_.time_s;
    step_number_ = internal_.accepted_steps();
    return step_;
}

void LocalState::positions(const SurfaceCell& cell, std::vector<double>& x) const {
    x = cell.X;
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += (*this)[cell.dofs[k]];
}

int threads_for(const Discretization& fe, const CellGroup& group) {
    const auto dofs_of_all = static_cast<double>(group.dofs.size());
    const bool is_large = dofs_of_all * dofs_of_all > entries_of_threads * static_cast<double>(group.cells.size());
    return is_large ? thread_count(fe.input.solver.threads) : 1;
}

std::size_t point_count(const Discretization& fe) {
    std::size_t count = 0;
    for (const auto& group : fe.groups) count += group.cells.size() * static_cast<std::size_t>(group.reference->points);
    return count;
}

void gather(const Discretization& fe, const LocalState& state, const CellGroup& group, std::size_t index,
            LocalCell& cell) {
    const auto nodes = fe.input.mesh.cell_nodes(group.cells[index]);
    const std::size_t n = nodes.size();
    for (std::size_t i = 0; i * n < cell.X.size(); ++i)
        for (std::size_t a = 0; a < n; ++a) cell.X[i * n + a] = fe.input.mesh.point(nodes[a])[i];
    const auto dofs = group.dofs_of(index);
    for (std::size_t k = 0; k < dofs.size(); ++k) cell.unknowns[k] = state[dofs[k]];
    cell.is_elastic = !state.internal().read(group, index, cell.memory);
}

void integrate(const Discretization& fe, const LocalState& state, const CellGroup& group, std::size_t index,
               material::Wanted wanted, LocalCell& cell) {
    gather(fe, state, group, index, cell);
    std::visit(
        [&](const auto& rubber) {
            integrate_cell(*group.reference, fe.input.kinematics, rubber, cell.input(fe.dofs.pressure_scale_Pa), wanted,
                           cell.out);
        },
        *group.rubber);
}

Slopes::Slopes(const Discretization& fe, Vec by_x, std::span<double> by_motion)
    : fe_(fe), by_x_(by_x), by_motion_(by_motion) {
    if (by_x != nullptr) SOFT_PETSC(VecZeroEntries(by_x));
    std::ranges::fill(by_motion, 0.0);
}

void Slopes::add(std::span<const PetscInt> dofs, std::span<const double> slope) {
    if (by_x_ != nullptr)
        SOFT_PETSC(VecSetValues(by_x_, static_cast<PetscInt>(dofs.size()), dofs.data(), slope.data(), ADD_VALUES));
    for (std::size_t i = 0; i < dofs.size() && !by_motion_.empty(); ++i)
        if (const int slot = motion_slot(dofs[i]); slot >= 0)
            by_motion_[static_cast<std::size_t>(slot / 3)] += slope[i] * fe_.moved_by(dofs[i]);
}

void Slopes::finish() {
    if (by_x_ != nullptr) linalg::assemble(by_x_);
    if (!by_motion_.empty())
        MPI_Allreduce(MPI_IN_PLACE, by_motion_.data(), static_cast<int>(by_motion_.size()), MPI_DOUBLE, MPI_SUM,
                      fe_.comm);
}

}  // namespace soft::fem
