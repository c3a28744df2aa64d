/// Quantities that System computes from a state: volume, energy, stretches, fields.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "fem/system.hpp"
#include "linalg/profile.hpp"
#include "material/response.hpp"
#include "math/tensor.hpp"

namespace soft::fem {

void System::add_slope(Vec gradient, std::span<double> by_motion, std::span<const PetscInt> dofs,
                       std::span<const double> slope) const {
    if (gradient != nullptr)
        SOFT_PETSC(VecSetValues(gradient, static_cast<PetscInt>(dofs.size()), dofs.data(), slope.data(), ADD_VALUES));
    for (std::size_t i = 0; i < dofs.size() && !by_motion.empty(); ++i)
        if (const int slot = motion_slot(dofs[i]); slot >= 0)
            by_motion[slot / 3] += slope[i] * input_.motions[slot / 3].displacement_m[slot % 3].value_or(0.0);
}

void System::finish_slope(Vec gradient, std::span<double> by_motion) const {
    if (gradient != nullptr) {
        SOFT_PETSC(VecAssemblyBegin(gradient));
        SOFT_PETSC(VecAssemblyEnd(gradient));
    }
    if (!by_motion.empty())
        MPI_Allreduce(MPI_IN_PLACE, by_motion.data(), static_cast<int>(by_motion.size()), MPI_DOUBLE, MPI_SUM, comm_);
}

double System::enclosed_volume(std::size_t cavity, Vec x, Vec gradient, std::span<double> by_motion) {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    return add_volumes({&cavity, 1}, x, gradient, by_motion);
}

double System::load_volume(std::size_t load, Vec x, Vec gradient, std::span<double> by_motion) {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    return add_volumes(load_cavities_.at(load), x, gradient, by_motion);
}

double System::add_volumes(std::span<const std::size_t> cavities, Vec x, Vec gradient, std::span<double> by_motion) {
    if (gradient != nullptr) SOFT_PETSC(VecZeroEntries(gradient));
    std::ranges::fill(by_motion, 0.0);
    read_state(x);
    double total = 0;
    std::vector<double> position, slope;
    for (const std::size_t cavity : cavities) {
        const EnclosedVolume& volume = volumes_.at(cavity);
        double sum = 0;
        for (const auto& facet : volume.facets) {
            const auto& reference = tables_[facet.reference];
            gather_surface(facet, position);
            slope.assign(reference.dofs(), 0.0);
            sum += fem::swept_volume(reference, input_.kinematics, position, slope);
            for (double& s : slope) s /= volume.model_fraction;
            add_slope(gradient, by_motion, facet.dofs, slope);
        }
        add_rims(volume, gradient, by_motion, sum);
        total += sum / volume.model_fraction;
    }
    MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_DOUBLE, MPI_SUM, comm_);
    finish_slope(gradient, by_motion);
    return total;
}

void System::add_rims(const EnclosedVolume& volume, Vec gradient, std::span<double> by_motion, double& sum) const {
    std::vector<double> y, slope;
    for (const auto& rim : volume.rims) {
        Vector3 apex{};
        std::vector<std::pair<PetscInt, int>> rim_dofs;  // unknown and component; each node once
        std::vector<mesh::Index> seen;
        for (const auto& edge : rim.edges) {
            gather_surface(edge, y);
            const std::size_t n = edge.nodes.size();
            for (std::size_t a = 0; a < n; ++a) {
                if (std::ranges::find(seen, edge.nodes[a]) != seen.end()) continue;
                seen.push_back(edge.nodes[a]);
                for (int i = 0; i < 3; ++i) {
                    if (rim.on_plane[i]) continue;
                    apex[i] += y[i * n + a] / static_cast<double>(rim.nodes.size());
                    rim_dofs.emplace_back(edge.dofs[i * n + a], i);
                }
            }
        }
        Vector3 apex_slope{};
        for (const auto& edge : rim.edges) {
            gather_surface(edge, y);
            slope.assign(y.size(), 0.0);
            sum += fem::cap_volume(tables_[edge.reference], y, apex, slope, apex_slope);
            for (double& s : slope) s /= volume.model_fraction;
            add_slope(gradient, by_motion, edge.dofs, slope);
        }
        const double share = 1.0 / (static_cast<double>(rim.nodes.size()) * volume.model_fraction);
        for (const auto& [dof, component] : rim_dofs) {
            const double part = share * apex_slope[component];
            add_slope(gradient, by_motion, {&dof, 1}, {&part, 1});
        }
    }
}

template <class Visit>
void System::for_each_point(Visit&& visit) const {
    std::vector<fem::PointState> points;
    for (const auto& group : groups_) {
        LocalCell local(*group.reference);
        fem::CellPoints work(*group.reference);
        const auto frame = std::visit([](const auto& rubber) { return rubber.fiber_frame; }, *group.rubber);
        for (std::size_t c = 0; c < group.cells.size(); ++c) {
            gather_cell(group, c, local);
            points.clear();
            fem::sample_cell(*group.reference, input_.kinematics, frame, local.input(map_.pressure_scale_Pa), work,
                             points);
            for (std::size_t q = 0; q < points.size(); ++q)
                visit(points[q], *group.rubber, PointLocation{&group, c, q});
        }
    }
}

Vector3 System::position_of(const PointLocation& location) const {
    const auto& reference = *location.group->reference;
    const auto nodes = input_.mesh.cell_nodes(location.group->cells[location.cell]);
    Vector3 X{};
    for (std::size_t a = 0; a < nodes.size(); ++a)
        for (std::size_t i = 0; i < 3; ++i)
            X[i] += reference.N[location.point * nodes.size() + a] * input_.mesh.point(nodes[a])[i];
    return X;
}

double System::stored_energy(Vec x) {
    read_state(x);
    double energy = 0;
    const material::Form form = input_.formulation;
    for_each_point([&](const fem::PointState& point, const AnyRubber& any, const PointLocation&) {
        energy += point.weight_m3 *
                  std::visit([&](const auto& rubber) { return fem::energy_density(form, rubber, point); }, any);
    });
    MPI_Allreduce(MPI_IN_PLACE, &energy, 1, MPI_DOUBLE, MPI_SUM, comm_);
    return energy;
}

StretchSummary System::stretches(Vec x) {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    read_state(x);
    struct Sample {
        double stretch, volume;
    };
    std::vector<Sample> mine;
    StretchSummary summary;
    summary.min_jacobian = 1e300;
    const material::Form form = input_.formulation;
    struct {
        double stretch;
        int rank;
    } own{0, rank_}, most{};
    for_each_point([&](const fem::PointState& point, const AnyRubber& any, const PointLocation& location) {
        const auto eigenvalues = symmetric_eigenvalues(right_cauchy_green(point.F));
        mine.push_back({std::sqrt(std::max(eigenvalues[0], 0.0)), point.weight_m3});
        summary.min_jacobian = std::min(summary.min_jacobian, determinant(point.F));
        const double energy =
            std::visit([&](const auto& rubber) { return fem::energy_density(form, rubber, point); }, any);
        summary.stored_energy_J += point.weight_m3 * energy;
        summary.max_energy_J_m3 = std::max(summary.max_energy_J_m3, energy);
        if (mine.back().stretch <= own.stretch) return;
        own.stretch = mine.back().stretch;
        summary.max_at_m = position_of(location);
    });
    MPI_Allreduce(MPI_IN_PLACE, &summary.min_jacobian, 1, MPI_DOUBLE, MPI_MIN, comm_);
    MPI_Allreduce(MPI_IN_PLACE, &summary.stored_energy_J, 1, MPI_DOUBLE, MPI_SUM, comm_);
    MPI_Allreduce(MPI_IN_PLACE, &summary.max_energy_J_m3, 1, MPI_DOUBLE, MPI_MAX, comm_);
    MPI_Allreduce(&own, &most, 1, MPI_DOUBLE_INT, MPI_MAXLOC, comm_);
    MPI_Bcast(summary.max_at_m.data(), 3, MPI_DOUBLE, most.rank, comm_);

    int size = 1;
    MPI_Comm_size(comm_, &size);
    std::vector<int> counts(size), starts(size, 0);
    const int count = static_cast<int>(2 * mine.size());
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm_);
    std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
    std::vector<Sample> all((starts.back() + counts.back()) / 2);
    MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE, comm_);

    std::ranges::sort(all, [](const Sample& a, const Sample& b) {
        return a.stretch != b.stretch ? a.stretch > b.stretch : a.volume > b.volume;
    });
    double total = 0;
    for (const auto& sample : all) total += sample.volume;
    summary.largest = all.front().stretch;
    summary.p99 = all.front().stretch;
    double above = 0;
    for (const auto& sample : all) {
        above += sample.volume;
        summary.p99 = sample.stretch;
        if (above >= 0.01 * total) break;
    }
    return summary;
}

double System::load_power(Vec x, Vec velocity, const LoadLevels& levels, const LoadLevels& rates) {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    prescribe(levels);
    read_state(x);
    const linalg::Vector force = make_vector();  // of the loads, with the sign of a residual
    for (std::size_t load = 0; load < loads_.size(); ++load) add_pressures(load, levels, force, nullptr, {});
    SOFT_PETSC(VecAssemblyBegin(force));
    SOFT_PETSC(VecAssemblyEnd(force));
    add_dead_loads(levels, force, {});
    double moving = 0;
    for (const auto& group : groups_) {
        if (std::ranges::all_of(rates.motions, [](double rate) { return rate == 0.0; })) break;
        const auto& reference = *group.reference;
        const auto size = static_cast<std::size_t>(reference.dofs());
        LocalCell local(reference);
        fem::CellOutput out(reference);
        for (std::size_t c = 0; c < group.cells.size(); ++c) {
            const std::span<const PetscInt> dofs{&group.dofs[c * size], size};
            if (std::ranges::none_of(dofs, [](PetscInt dof) { return motion_slot(dof) >= 0; })) continue;
            gather_cell(group, c, local);
            std::visit(
                [&](const auto& rubber) {
                    fem::integrate_cell(reference, input_.kinematics, rubber, local.input(map_.pressure_scale_Pa),
                                        material::Wanted::stress, out);
                },
                *group.rubber);
            for (std::size_t k = 0; k < size; ++k) moving += out.residual[k] * moved_by(dofs[k], rates.motions);
        }
    }
    MPI_Allreduce(MPI_IN_PLACE, &moving, 1, MPI_DOUBLE, MPI_SUM, comm_);
    return moving - linalg::dot(force, velocity);
}

bool System::has_initial_stress() const {
    return std::ranges::any_of(rubbers_,
                               [](const auto& rubber) { return material::reference_stress_Pa(rubber) > 0.0; });
}

bool System::has_fibers() const {
    return std::ranges::any_of(rubbers_, [](const auto& rubber) { return material::fibers_of(rubber).has_value(); });
}
bool System::has_symmetric_tangent() const { return std::ranges::all_of(rubbers_, material::has_symmetric_tangent); }

System::Fields System::gather_fields(Vec x) {
    const linalg::ScopedTimer timed(linalg::Phase::measures);
    linalg::Scatter to_zero;
    linalg::Vector all;
    SOFT_PETSC(VecScatterCreateToZero(x, to_zero.out(), all.out()));
    SOFT_PETSC(VecScatterBegin(to_zero, x, all, INSERT_VALUES, SCATTER_FORWARD));
    SOFT_PETSC(VecScatterEnd(to_zero, x, all, INSERT_VALUES, SCATTER_FORWARD));
    Fields fields;
    if (rank_ != 0) return fields;
    const PetscScalar* value = nullptr;
    SOFT_PETSC(VecGetArrayRead(all, &value));
    const std::size_t points = input_.mesh.points.size();
    fields.displacement_m.assign(3 * points, 0.0);
    for (std::size_t node = 0; node < points; ++node)
        for (int i = 0; i < map_.dimension; ++i) {
            const auto number = map_.displacement[node * map_.dimension + i];
            fields.displacement_m[3 * node + i] = number >= 0 ? value[number] : moved_by(number, levels_.motions);
        }
    if (map_.pressures > 0) {
        fields.pressure_Pa.assign(points, 0.0);
        std::vector<int> shares(points, 0);
        for (mesh::Index cell = 0; cell < input_.mesh.cell_count(); ++cell)
            add_nodal_pressures(cell, value, fields.pressure_Pa, shares);
        for (std::size_t node = 0; node < points; ++node)
            if (shares[node] > 0) fields.pressure_Pa[node] /= shares[node];
    }
    SOFT_PETSC(VecRestoreArrayRead(all, &value));
    return fields;
}

void System::spread_displacements(std::span<const double> nodal, Vec x) const {
    std::vector<double> all(3 * input_.mesh.points.size());
    if (rank_ == 0) std::ranges::copy(nodal.first(all.size()), all.begin());
    MPI_Bcast(all.data(), static_cast<int>(all.size()), MPI_DOUBLE, 0, comm_);
    PetscScalar* value = nullptr;
    SOFT_PETSC(VecGetArray(x, &value));
    for (std::size_t node = 0; node < input_.mesh.points.size(); ++node)
        for (int i = 0; i < map_.dimension; ++i) {
            const auto number = map_.displacement[node * map_.dimension + i];
            if (number >= map_.begin && number < map_.end) value[number - map_.begin] = all[3 * node + i];
        }
    SOFT_PETSC(VecRestoreArray(x, &value));
}

void System::add_nodal_pressures(mesh::Index cell, const double* value, std::vector<double>& pressure_Pa,
                                 std::vector<int>& shares) const {
    const auto& reference = reference_of(references_, input_.mesh.cell_type(cell));
    const auto nodes = input_.mesh.cell_nodes(cell);
    std::vector<PetscInt> dofs;
    map_.cell_dofs(input_.mesh, cell, reference, dofs);
    std::vector<double> X(reference.displacement_dofs()), unknowns;
    for (int i = 0; i < map_.dimension; ++i)
        for (int a = 0; a < reference.nodes; ++a) X[i * reference.nodes + a] = input_.mesh.point(nodes[a])[i];
    for (int s = reference.displacement_dofs(); s < reference.dofs(); ++s) unknowns.push_back(value[dofs[s]]);
    const auto nodal = fem::nodal_pressures(reference, X, unknowns, map_.pressure_scale_Pa);
    for (int a = 0; a < reference.nodes; ++a) {
        pressure_Pa[nodes[a]] += nodal[a];
        ++shares[nodes[a]];
    }
}

}  // namespace soft::fem
