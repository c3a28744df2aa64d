/// Residual, tangent and load columns of a state: the element loops.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/system.hpp"
#include "linalg/profile.hpp"

namespace soft::fem {

/// Enough to make the overhead of a batch negligible.
constexpr std::size_t cells_per_thread = 16;

Evaluation System::evaluate(Vec x, const LoadLevels& levels, Vec R, Mat K, std::span<const LoadColumn> columns) {
    const linalg::ScopedTimer timed(K != nullptr ? linalg::Phase::tangent : linalg::Phase::residual);
    prescribe(levels);
    read_state(x);
    SOFT_PETSC(VecSetOption(R, VEC_IGNORE_NEGATIVE_INDICES, PETSC_TRUE));  // R may be created by a PETSc solver
    SOFT_PETSC(VecZeroEntries(R));
    for (const auto& column : columns) SOFT_PETSC(VecZeroEntries(column.out));
    if (K != nullptr) SOFT_PETSC(MatZeroEntries(K));
    Evaluation result;
    result.min_jacobian = std::numeric_limits<double>::max();
    std::optional<linalg::BlockAdder> tangent;
    if (K != nullptr) {
        find_block_indices(K);
        tangent.emplace(K);
    }
    auto* adder = tangent ? &*tangent : nullptr;
    for (std::size_t group = 0; group < groups_.size(); ++group) add_cells(group, R, adder, columns, result);

    // The worst point and its cell, the same on every rank; ties go to the lower rank.
    struct {
        double value;
        int rank;
    } mine{result.min_jacobian, rank_}, worst{};
    MPI_Allreduce(&mine, &worst, 1, MPI_DOUBLE_INT, MPI_MINLOC, comm_);
    result.min_jacobian = worst.value;
    MPI_Bcast(&result.worst_cell, 1, MPI_INT64_T, worst.rank, comm_);
    MPI_Allreduce(MPI_IN_PLACE, &result.force_scale, 1, MPI_DOUBLE, MPI_SUM, comm_);
    result.force_scale = std::sqrt(result.force_scale);

    for (std::size_t load = 0; load < loads_.size(); ++load) add_pressures(load, levels, R, adder, columns);
    tangent.reset();
    SOFT_PETSC(VecAssemblyBegin(R));
    SOFT_PETSC(VecAssemblyEnd(R));
    for (const auto& column : columns) {
        SOFT_PETSC(VecAssemblyBegin(column.out));
        SOFT_PETSC(VecAssemblyEnd(column.out));
    }
    add_dead_loads(levels, R, columns);
    if (K != nullptr) {
        SOFT_PETSC(MatAssemblyBegin(K, MAT_FINAL_ASSEMBLY));
        SOFT_PETSC(MatAssemblyEnd(K, MAT_FINAL_ASSEMBLY));
    }
    return result;
}

/// The matrices of a system have the same pattern, so the indices are computed once; another pattern would recompute them.
void System::find_block_indices(Mat K) {
    PetscObjectId id = 0;
    PetscObjectState state = 0;
    SOFT_PETSC(PetscObjectGetId(reinterpret_cast<PetscObject>(K), &id));
    SOFT_PETSC(MatGetNonzeroState(K, &state));
    if (id == block_indices_.matrix && state == block_indices_.state) return;
    const bool is_first = block_indices_.matrix == 0;
    const std::uint64_t pattern = linalg::pattern_hash(K);
    block_indices_.matrix = id;
    block_indices_.state = state;
    if (!is_first && pattern == block_indices_.pattern) return;
    block_indices_.pattern = pattern;
    block_indices_.groups.clear();
    block_indices_.loads.clear();
    std::vector<std::span<const PetscInt>> blocks;
    for (const auto& group : groups_) {
        const auto size = static_cast<std::size_t>(group.reference->dofs());
        blocks.clear();
        for (std::size_t c = 0; c < group.cells.size(); ++c) blocks.emplace_back(&group.dofs[c * size], size);
        block_indices_.groups.emplace_back(K, blocks);
    }
    for (const auto& load : loads_) {
        blocks.clear();
        for (const auto& facet : load.facets) blocks.emplace_back(facet.dofs);
        block_indices_.loads.emplace_back(K, blocks);
    }
}

void System::add_cells(std::size_t index, Vec R, linalg::BlockAdder* K, std::span<const LoadColumn> columns,
                       Evaluation& result) const {
    const CellGroup& group = groups_[index];
    const auto& reference = *group.reference;
    const PetscInt size = reference.dofs();
    const auto wanted = K != nullptr ? material::Wanted::stress_and_tangent : material::Wanted::stress;
    // All threads compute a batch of cells; one thread adds them in order, so that the sums do not depend on the number of threads.
    const int threads = input_.solver.threads;
    const std::size_t batch = threads > 1 ? cells_per_thread * static_cast<std::size_t>(threads) : 1;
    std::vector<LocalCell> local(batch, LocalCell(reference));
    std::vector<fem::CellOutput> out(batch, fem::CellOutput(reference));
    std::visit(
        [&](const auto& rubber) {
            for (std::size_t begin = 0; begin < group.cells.size(); begin += batch) {
                const int count = static_cast<int>(std::min(batch, group.cells.size() - begin));
#pragma omp parallel for num_threads(threads) schedule(static) if (threads > 1)
                for (int i = 0; i < count; ++i) {
                    gather_cell(group, begin + i, local[i]);
                    fem::integrate_cell(reference, input_.kinematics, rubber, local[i].input(map_.pressure_scale_Pa),
                                        wanted, out[i]);
                }
                for (int i = 0; i < count; ++i) {
                    const PetscInt* dofs = &group.dofs[(begin + i) * size];
                    add_residual(group.cells[begin + i], {dofs, static_cast<std::size_t>(size)}, out[i], R, result);
                    if (K == nullptr) continue;
                    K->add(block_indices_.groups[index], begin + i, out[i].stiffness);
                    for (const auto& column : columns)
                        add_moved(column, -1.0, {dofs, static_cast<std::size_t>(size)}, out[i].stiffness);
                }
            }
        },
        *group.rubber);
}

void System::add_residual(mesh::Index cell, std::span<const PetscInt> dofs, const fem::CellOutput& out, Vec R,
                          Evaluation& result) {
    if (out.min_jacobian < result.min_jacobian) {
        result.min_jacobian = out.min_jacobian;
        result.worst_cell = cell;
    }
    for (const double r : out.residual) result.force_scale += r * r;
    const auto size = static_cast<PetscInt>(dofs.size());
    SOFT_PETSC(VecSetValues(R, size, dofs.data(), out.residual.data(), ADD_VALUES));
}

double System::moved_by(PetscInt number, std::span<const double> levels) const {
    const int slot = motion_slot(number);
    return slot < 0 ? 0.0 : levels[slot / 3] * input_.motions[slot / 3].displacement_m[slot % 3].value_or(0.0);
}

void System::add_moved(const LoadColumn& column, double factor, std::span<const PetscInt> dofs,
                       std::span<const double> matrix) const {
    if (input_.motions.empty()) return;
    std::vector<double> force;
    for (std::size_t j = 0; j < dofs.size(); ++j) {
        const double velocity = moved_by(dofs[j], column.direction.motions);
        if (velocity == 0.0) continue;
        force.resize(dofs.size(), 0.0);
        for (std::size_t i = 0; i < dofs.size(); ++i) force[i] += factor * matrix[i * dofs.size() + j] * velocity;
    }
    if (!force.empty())
        SOFT_PETSC(VecSetValues(column.out, static_cast<PetscInt>(dofs.size()), dofs.data(), force.data(), ADD_VALUES));
}

void System::add_pressures(std::size_t load, const LoadLevels& levels, Vec R, linalg::BlockAdder* K,
                           std::span<const LoadColumn> columns) const {
    const LoadSurface& surface = loads_[load];
    const double pressure = levels.pressures_Pa[load];
    const bool follows = input_.loads[load].shape == model::LoadShape::deformed;
    std::vector<double> x, force, scaled, stiffness;
    const auto add = [&](Vec out, double factor, std::span<const PetscInt> dofs, std::span<const double> values) {
        if (factor == 0.0) return;
        scaled.assign(values.begin(), values.end());
        for (double& value : scaled) value *= factor;
        SOFT_PETSC(VecSetValues(out, static_cast<PetscInt>(dofs.size()), dofs.data(), scaled.data(), ADD_VALUES));
    };
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
        const auto& facet = surface.facets[f];
        const auto& reference = tables_[facet.reference];
        const PetscInt size = reference.dofs();
        if (follows)
            gather_surface(facet, x);
        else
            gather_undeformed(facet, x);
        force.assign(size, 0.0);
        stiffness.assign(follows && K != nullptr && pressure != 0.0 ? static_cast<std::size_t>(size) * size : 0, 0.0);
        fem::pressure_force(reference, input_.kinematics, x, force, stiffness);
        add(R, -pressure, facet.dofs, force);
        for (const auto& column : columns) add(column.out, column.direction.pressures_Pa[load], facet.dofs, force);
        if (stiffness.empty()) continue;
        for (double& k : stiffness) k *= -pressure;
        K->add(block_indices_.loads[load], f, stiffness);
        for (const auto& column : columns) add_moved(column, -1.0, facet.dofs, stiffness);
    }
    if (rank_ != 0) return;  // every rank has the whole plug force
    add(R, -pressure, surface.plug_force.dofs, surface.plug_force.values);
    for (const auto& column : columns)
        add(column.out, column.direction.pressures_Pa[load], surface.plug_force.dofs, surface.plug_force.values);
}

void System::add_dead_loads(const LoadLevels& levels, Vec R, std::span<const LoadColumn> columns) const {
    const auto add = [&](std::span<const linalg::Vector> forces, std::vector<double> LoadLevels::*list) {
        for (std::size_t i = 0; i < forces.size(); ++i) {
            linalg::add(R, -(levels.*list)[i], forces[i]);
            for (const auto& column : columns) linalg::add(column.out, (column.direction.*list)[i], forces[i]);
        }
    };
    add(tractions_, &LoadLevels::tractions);
    add(body_forces_, &LoadLevels::body_forces);
}

}  // namespace soft::fem
