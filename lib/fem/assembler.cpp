#include "fem/assembler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linalg/profile.hpp"
#include "math/threads.hpp"

namespace soft::fem {

namespace {

/// Enough to make the overhead of a batch negligible.
constexpr std::size_t cells_per_thread = 16;

void add_scaled(Vec out, double factor, std::span<const PetscInt> dofs, std::vector<double> values) {
    if (factor == 0.0) return;
    for (double& value : values) value *= factor;
    SOFT_PETSC(VecSetValues(out, static_cast<PetscInt>(dofs.size()), dofs.data(), values.data(), ADD_VALUES));
}

/// Reduces to the worst point and its cell, the same on every rank; ties go to the lower rank.
void reduce(Evaluation& result, const Discretization& fe) {
    struct {
        double value;
        int rank;
    } mine{result.min_jacobian, fe.rank}, worst{};
    MPI_Allreduce(&mine, &worst, 1, MPI_DOUBLE_INT, MPI_MINLOC, fe.comm);
    result.min_jacobian = worst.value;
    MPI_Bcast(&result.worst_cell, 1, MPI_INT64_T, worst.rank, fe.comm);
    MPI_Allreduce(MPI_IN_PLACE, &result.force_scale, 1, MPI_DOUBLE, MPI_SUM, fe.comm);
    result.force_scale = std::sqrt(result.force_scale);
}

}  // namespace

Evaluation Assembler::evaluate(Vec x, const LoadLevels& levels, Vec R, Mat K, std::span<const LoadColumn> columns,
                               NewEntries entries) {
    std::optional<linalg::ScopedTimer> timed(K != nullptr ? linalg::Phase::tangent : linalg::Phase::residual);
    state_.prescribe(levels);
    state_.read(x);
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
    const Targets to{R, tangent ? &*tangent : nullptr, columns};
    for (std::size_t group = 0; group < fe_.groups.size(); ++group) add_cells(group, to, result);
    reduce(result, fe_);
    for (std::size_t load = 0; load < loads_.pressures.size(); ++load) add_pressures(load, to);
    tangent.reset();
    timed.reset();
    const bool is_beyond = result.admissible() && add_contact(to, K, entries);
    timed.emplace(K != nullptr ? linalg::Phase::tangent : linalg::Phase::residual);
    linalg::assemble(R);
    for (const auto& column : columns) linalg::assemble(column.out);
    add_dead_loads(to);
    if (K == nullptr) return result;
    PetscObjectState before = indices_.state, after = before;
    linalg::assemble(K);
    SOFT_PETSC(MatGetNonzeroState(K, &after));
    result.pattern_grew = is_beyond || after != before;
    return result;
}

/// The matrices of a system have the same pattern, so the indices are computed once; another pattern would recompute them.
void Assembler::find_block_indices(Mat K) {
    PetscObjectId id = 0;
    PetscObjectState state = 0;
    SOFT_PETSC(PetscObjectGetId(reinterpret_cast<PetscObject>(K), &id));
    SOFT_PETSC(MatGetNonzeroState(K, &state));
    if (id == indices_.matrix && state == indices_.state) return;
    const bool is_first = indices_.matrix == 0;
    const std::uint64_t pattern = linalg::pattern_hash(K);
    indices_.matrix = id;
    indices_.state = state;
    if (!is_first && pattern == indices_.pattern) return;
    indices_.pattern = pattern;
    indices_.groups.clear();
    indices_.pressures.clear();
    std::vector<std::span<const PetscInt>> blocks;
    for (const auto& group : fe_.groups) {
        blocks.clear();
        for (std::size_t c = 0; c < group.cells.size(); ++c) blocks.push_back(group.dofs_of(c));
        indices_.groups.emplace_back(K, blocks, threads_for(fe_, group));
    }
    for (const auto& load : loads_.pressures) {
        blocks.clear();
        for (const auto& facet : load.facets) blocks.emplace_back(facet.dofs);
        indices_.pressures.emplace_back(K, blocks);
    }
}

void Assembler::add_cells(std::size_t index, const Targets& to, Evaluation& result) const {
    const CellGroup& group = fe_.groups[index];
    const auto wanted = to.K != nullptr ? material::Wanted::stress_and_tangent : material::Wanted::stress;
    // All threads compute a batch of cells; one thread adds them in order, so that the sums do not depend on the number of threads.
    const int threads = threads_for(fe_, group);
    const std::size_t batch = threads > 1 ? cells_per_thread * static_cast<std::size_t>(threads) : 1;
    std::vector<LocalCell> cells(batch, LocalCell(*group.reference));
    for (std::size_t begin = 0; begin < group.cells.size(); begin += batch) {
        const int count = static_cast<int>(std::min(batch, group.cells.size() - begin));
#pragma omp parallel for num_threads(threads) schedule(static) if (threads > 1)
        for (int i = 0; i < count; ++i) integrate(fe_, state_, group, begin + i, wanted, cells[i]);
        if (to.K != nullptr) add_stiffness(index, begin, std::span(cells).first(count), threads, *to.K);
        for (int i = 0; i < count; ++i) {
            const CellOutput& out = cells[i].out;
            const auto dofs = group.dofs_of(begin + i);
            if (out.min_jacobian < result.min_jacobian) {
                result.min_jacobian = out.min_jacobian;
                result.worst_cell = group.cells[begin + i];
            }
            for (const double r : out.residual) result.force_scale += r * r;
            SOFT_PETSC(
                VecSetValues(to.R, static_cast<PetscInt>(dofs.size()), dofs.data(), out.residual.data(), ADD_VALUES));
            if (to.K == nullptr) continue;
            for (const auto& column : to.columns) subtract_moved(column, dofs, out.stiffness);
        }
    }
}

/// Each thread adds some of the rows of all cells, in the order of the cells.
void Assembler::add_stiffness(std::size_t group, std::size_t first, std::span<const LocalCell> cells, int threads,
                              linalg::BlockAdder& K) const {
    const linalg::BlockIndices& indices = indices_.groups[group];
    const auto add = [&](linalg::RowShare share) {
        for (std::size_t i = 0; i < cells.size(); ++i) K.add(indices, first + i, cells[i].out.stiffness, share);
    };
    if (threads == 1 || !K.is_shareable(indices)) return add({});
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int t = 0; t < threads; ++t) add({t, threads});
}

double Assembler::velocity_of(PetscInt dof, const LoadLevels& rates) const {
    const int slot = motion_slot(dof);
    return slot < 0 ? 0.0 : rates.motions[slot / 3] * fe_.moved_by(dof);
}

void Assembler::subtract_moved(const LoadColumn& column, std::span<const PetscInt> dofs,
                               std::span<const double> matrix) const {
    if (fe_.input.motions.empty()) return;
    std::vector<double> force;
    for (std::size_t j = 0; j < dofs.size(); ++j) {
        const double velocity = velocity_of(dofs[j], column.direction);
        if (velocity == 0.0) continue;
        force.resize(dofs.size(), 0.0);
        for (std::size_t i = 0; i < dofs.size(); ++i) force[i] -= matrix[i * dofs.size() + j] * velocity;
    }
    if (!force.empty())
        SOFT_PETSC(VecSetValues(column.out, static_cast<PetscInt>(dofs.size()), dofs.data(), force.data(), ADD_VALUES));
}

void Assembler::add_pressures(std::size_t load, const Targets& to) const {
    const PressureSurface& surface = loads_.pressures[load];
    const double pressure = state_.levels().pressures_Pa[load];
    std::vector<double> x, force, stiffness;
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
        const SurfaceCell& facet = surface.facets[f];
        state_.positions(facet, x);
        stiffness.resize(surface.follows && to.K != nullptr && pressure != 0.0 ? x.size() * x.size() : 0);
        pressure_force(fe_, surface, facet, x, force, stiffness);
        add_scaled(to.R, -pressure, facet.dofs, force);
        for (const auto& column : to.columns)
            add_scaled(column.out, column.direction.pressures_Pa[load], facet.dofs, force);
        if (stiffness.empty()) continue;
        for (double& k : stiffness) k *= -pressure;
        to.K->add(indices_.pressures[load], f, stiffness);
        for (const auto& column : to.columns) subtract_moved(column, facet.dofs, stiffness);
    }
    if (fe_.rank != 0) return;  // every rank has the whole plug force
    const auto& [dofs, values] = surface.plug_force;
    add_scaled(to.R, -pressure, dofs, values);
    for (const auto& column : to.columns) add_scaled(column.out, column.direction.pressures_Pa[load], dofs, values);
}

void Assembler::add_dead_loads(const Targets& to) const {
    for (std::size_t i = 0; i < loads_.dead_loads.size(); ++i) {
        const auto& force = loads_.dead_loads[i];
        linalg::add(to.R, -state_.levels().dead_loads[i], force);
        for (const auto& column : to.columns) linalg::add(column.out, column.direction.dead_loads[i], force);
    }
}

bool Assembler::add_contact(const Targets& to, Mat K, NewEntries entries) const {
    const linalg::ScopedTimer timed(linalg::Phase::contact);
    const auto wanted = K != nullptr ? contact::Wanted::hessian : contact::Wanted::gradient;
    if (K != nullptr) SOFT_PETSC(MatSetOption(K, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_FALSE));
    int is_beyond = 0;
    // All components of two nodes are coupled, or none: the first of each that is not fixed.
    std::vector<PetscInt> first_free;
    const auto of_nodes = [&first_free](std::span<const PetscInt> dofs,
                                        std::size_t points) -> std::span<const PetscInt> {
        first_free.assign(dofs.begin(), dofs.begin() + static_cast<std::ptrdiff_t>(points));
        for (std::size_t k = points; k < dofs.size(); ++k)
            if (first_free[k % points] < 0) first_free[k % points] = dofs[k];
        return first_free;
    };
    const auto add = [&](std::span<const PetscInt> dofs, const contact::Block& block) {
        const auto size = static_cast<PetscInt>(dofs.size());
        SOFT_PETSC(VecSetValues(to.R, size, dofs.data(), block.gradient.data(), ADD_VALUES));
        if (K == nullptr) return;
        if (entries == NewEntries::omit && !linalg::contains_block(K, of_nodes(dofs, block.points()))) {
            is_beyond = 1;
            return;
        }
        SOFT_PETSC(MatSetValues(K, size, dofs.data(), size, dofs.data(), block.hessian.data(), ADD_VALUES));
        for (const auto& column : to.columns) subtract_moved(column, dofs, block.hessian);
    };
    contact_.evaluate(wanted, add);
    if (K != nullptr) MPI_Allreduce(MPI_IN_PLACE, &is_beyond, 1, MPI_INT, MPI_MAX, fe_.comm);
    return is_beyond == 1;
}

void Assembler::load_forces(Vec x, const LoadLevels& levels, Vec R, Mat K) {
    state_.prescribe(levels);
    state_.read(x);
    SOFT_PETSC(VecZeroEntries(R));
    std::optional<linalg::BlockAdder> stiffness;
    if (K != nullptr) {
        SOFT_PETSC(MatZeroEntries(K));
        find_block_indices(K);
        stiffness.emplace(K);
    }
    const Targets to{R, stiffness ? &*stiffness : nullptr, {}};
    for (std::size_t load = 0; load < loads_.pressures.size(); ++load) add_pressures(load, to);
    stiffness.reset();
    linalg::assemble(R);
    add_dead_loads(to);
    if (K != nullptr) linalg::assemble(K);
}

double Assembler::load_power(Vec x, Vec velocity, const LoadLevels& levels, const LoadLevels& rates) {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    const linalg::Vector force = fe_.make_vector();
    load_forces(x, levels, force);
    return motion_power(rates) - linalg::dot(force, velocity);
}

double Assembler::power_of(std::span<const PetscInt> dofs, std::span<const double> force,
                           const LoadLevels& rates) const {
    double power = 0;
    for (std::size_t k = 0; k < dofs.size(); ++k) power += force[k] * velocity_of(dofs[k], rates);
    return power;
}

double Assembler::motion_power(const LoadLevels& rates) const {
    double power = 0;
    const bool moving = std::ranges::any_of(rates.motions, [](double rate) { return rate != 0.0; });
    for (std::size_t g = 0; g < fe_.groups.size() && moving; ++g) {
        const CellGroup& group = fe_.groups[g];
        LocalCell cell(*group.reference);
        for (std::size_t c = 0; c < group.cells.size(); ++c) {
            const auto dofs = group.dofs_of(c);
            if (std::ranges::none_of(dofs, [](PetscInt dof) { return motion_slot(dof) >= 0; })) continue;
            integrate(fe_, state_, group, c, material::Wanted::stress, cell);
            power += power_of(dofs, cell.out.residual, rates);
        }
    }
    if (moving)
        contact_.evaluate(contact::Wanted::gradient, [&](std::span<const PetscInt> dofs, const contact::Block& block) {
            power += power_of(dofs, block.gradient, rates);
        });
    MPI_Allreduce(MPI_IN_PLACE, &power, 1, MPI_DOUBLE, MPI_SUM, fe_.comm);
    return power;
}

}  // namespace soft::fem
