#include "assembly/system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/error.hpp"

namespace soft::assembly {

namespace {

using mesh::Index;

std::vector<element::ReferenceCell> make_references(const model::Case& input) {
    std::vector<mesh::CellType> types = input.mesh.cell_types;
    std::ranges::sort(types);
    const auto repeated = std::ranges::unique(types);
    types.erase(repeated.begin(), repeated.end());
    std::vector<element::ReferenceCell> references;
    for (const auto type : types) references.push_back(element::make_reference_cell(type, input.formulation));
    return references;
}

std::vector<AnyRubber> make_rubbers(const model::Case& input) {
    std::vector<AnyRubber> rubbers;
    for (const auto& region : input.mesh.region_names) {
        const auto material = std::ranges::find(input.materials, region, &model::Material::name);
        if (material == input.materials.end())
            throw Error(ExitCode::bad_input, "materials", "region '" + region + "' has no material");
        if (const std::string reason = model::why_not(*material, input.kinematics); !reason.empty())
            throw Error(ExitCode::bad_input, "materials/" + region, reason);
        rubbers.push_back(make_rubber(*material, input.formulation));
    }
    return rubbers;
}

/// shear modulus / cell size: see assembly/dof_map.hpp. Any value gives the same solution.
double pressure_scale(const model::Case& input, std::span<const AnyRubber> rubbers) {
    double modulus_Pa = 0;
    for (const auto& rubber : rubbers) modulus_Pa = std::max(modulus_Pa, material::initial_shear_modulus_Pa(rubber));
    double extent_m = 0;
    const auto nodes = input.mesh.cell_nodes(0);
    for (int i = 0; i < 3; ++i) {
        double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
        for (const Index node : nodes) {
            low = std::min(low, input.mesh.point(node)[i]);
            high = std::max(high, input.mesh.point(node)[i]);
        }
        extent_m = std::max(extent_m, high - low);
    }
    return modulus_Pa / extent_m;
}

}  // namespace

System::System(const model::Case& input, MPI_Comm comm) : input_(input), comm_(comm) {
    MPI_Comm_rank(comm, &rank_);
    if (input.mesh.cell_types.empty()) throw Error(ExitCode::bad_input, "mesh", "there are no cells");
    references_ = make_references(input);
    rubbers_ = make_rubbers(input);
    map_ = make_dof_map(input, references_, pressure_scale(input, rubbers_), comm);
    if (map_.total == 0) throw Error(ExitCode::bad_input, "supports", "every point is held", "free some face");
    make_groups();
    for (const auto& load : input.loads) {
        loads_.push_back(make_load_surface(input, map_, load, rank_, tables_));
        const auto cavity = std::ranges::find(input.cavities, load.target, &model::Cavity::name);
        if (cavity != input.cavities.end() && !volume_)
            volume_ = make_enclosed_volume(input, map_, *cavity, rank_, tables_);
    }
    make_local_copy();
    make_dead_load();
    for (const auto& output : input.outputs) {
        output_weights_.push_back(make_vector());
        const auto mean = mean_displacement(input, map_, output.face, output.direction);
        for (std::size_t i = 0; i < mean.dofs.size(); ++i)
            if (mean.dofs[i] >= map_.begin && mean.dofs[i] < map_.end)
                SOFT_PETSC(VecSetValue(output_weights_.back(), mean.dofs[i], mean.values[i], ADD_VALUES));
        SOFT_PETSC(VecAssemblyBegin(output_weights_.back()));
        SOFT_PETSC(VecAssemblyEnd(output_weights_.back()));
    }
}

void System::make_dead_load() {
    dead_load_ = make_vector();
    for (const auto& traction : input_.tractions) {
        const auto force = face_force(input_, map_, traction.face, traction.traction_Pa);
        if (rank_ == 0)   // known whole to every rank
            for (std::size_t i = 0; i < force.dofs.size(); ++i)
                SOFT_PETSC(VecSetValue(dead_load_, force.dofs[i], force.values[i], ADD_VALUES));
    }
    SOFT_PETSC(VecAssemblyBegin(dead_load_));
    SOFT_PETSC(VecAssemblyEnd(dead_load_));
}

void System::make_groups() {
    std::map<std::pair<mesh::CellType, std::int32_t>, CellGroup> groups;
    std::vector<PetscInt> dofs;
    for (Index cell = 0; cell < input_.mesh.cell_count(); ++cell) {
        if (map_.cell_rank[cell] != rank_) continue;
        const auto type = input_.mesh.cell_type(cell);
        const auto region = input_.mesh.cell_regions[cell];
        auto& group = groups[{type, region}];
        group.reference = &reference_of(references_, type);
        group.rubber = &rubbers_[region];
        group.cells.push_back(cell);
        map_.cell_dofs(input_.mesh, cell, *group.reference, dofs);
        group.dofs.insert(group.dofs.end(), dofs.begin(), dofs.end());
    }
    for (auto& [key, group] : groups) groups_.push_back(std::move(group));
}

void System::make_local_copy() {
    const auto collect = [this](std::span<const PetscInt> dofs) {
        for (const auto dof : dofs)
            if (dof >= 0) ghosts_.push_back(dof);
    };
    for (const auto& group : groups_) collect(group.dofs);
    if (volume_)
        for (const auto& rim : volume_->rims)
            for (const auto& edge : rim.edges) collect(edge.dofs);
    std::ranges::sort(ghosts_);
    const auto repeated = std::ranges::unique(ghosts_);
    ghosts_.erase(repeated.begin(), repeated.end());
    local_.assign(ghosts_.size() + 1, 0.0);

    for (auto& group : groups_) group.local = local_positions(group.dofs);
    for (auto& load : loads_)
        for (auto& facet : load.facets) facet.local = local_positions(facet.dofs);
    if (volume_) {
        for (auto& facet : volume_->facets) facet.local = local_positions(facet.dofs);
        for (auto& rim : volume_->rims)
            for (auto& edge : rim.edges) edge.local = local_positions(edge.dofs);
    }

    linalg::IndexSet wanted;
    const auto count = static_cast<PetscInt>(ghosts_.size());
    SOFT_PETSC(ISCreateGeneral(PETSC_COMM_SELF, count, ghosts_.data(), PETSC_COPY_VALUES, wanted.out()));
    SOFT_PETSC(VecCreateSeq(PETSC_COMM_SELF, count, ghost_values_.out()));
    SOFT_PETSC(VecScatterCreate(make_vector(), wanted, ghost_values_, nullptr, ghost_scatter_.out()));
}

std::vector<int> System::local_positions(std::span<const PetscInt> dofs) const {
    const int held = static_cast<int>(ghosts_.size());
    std::vector<int> positions;
    for (const auto dof : dofs)
        positions.push_back(dof < 0 ? held
                                    : static_cast<int>(std::ranges::lower_bound(ghosts_, dof) - ghosts_.begin()));
    return positions;
}

linalg::Vector System::make_vector() const {
    linalg::Vector vector;
    SOFT_PETSC(VecCreate(comm_, vector.out()));
    SOFT_PETSC(VecSetSizes(vector, map_.end - map_.begin, map_.total));
    SOFT_PETSC(VecSetFromOptions(vector));
    SOFT_PETSC(VecSetOption(vector, VEC_IGNORE_NEGATIVE_INDICES, PETSC_TRUE));
    SOFT_PETSC(VecZeroEntries(vector));
    return vector;
}

linalg::Matrix System::make_matrix() const {
    const PetscInt own = map_.end - map_.begin;
    linalg::Matrix pattern;
    SOFT_PETSC(MatCreate(comm_, pattern.out()));
    SOFT_PETSC(MatSetType(pattern, MATPREALLOCATOR));
    SOFT_PETSC(MatSetSizes(pattern, own, own, map_.total, map_.total));
    SOFT_PETSC(MatSetUp(pattern));
    std::vector<PetscScalar> zeros;
    for (const auto& group : groups_) {
        const PetscInt n = group.reference->dofs();
        zeros.assign(static_cast<std::size_t>(n) * n, 0.0);
        for (std::size_t c = 0; c < group.cells.size(); ++c) {
            const PetscInt* dofs = &group.dofs[c * n];
            SOFT_PETSC(MatSetValues(pattern, n, dofs, n, dofs, zeros.data(), INSERT_VALUES));
        }
    }
    SOFT_PETSC(MatAssemblyBegin(pattern, MAT_FINAL_ASSEMBLY));
    SOFT_PETSC(MatAssemblyEnd(pattern, MAT_FINAL_ASSEMBLY));
    linalg::Matrix K;
    SOFT_PETSC(MatCreate(comm_, K.out()));
    SOFT_PETSC(MatSetType(K, MATAIJ));
    SOFT_PETSC(MatSetSizes(K, own, own, map_.total, map_.total));
    SOFT_PETSC(MatPreallocatorPreallocate(pattern, PETSC_TRUE, K));
    SOFT_PETSC(MatSetOption(K, MAT_NEW_NONZERO_LOCATION_ERR, PETSC_TRUE));
    return K;
}

void System::read_state(Vec x) {
    SOFT_PETSC(VecScatterBegin(ghost_scatter_, x, ghost_values_, INSERT_VALUES, SCATTER_FORWARD));
    SOFT_PETSC(VecScatterEnd(ghost_scatter_, x, ghost_values_, INSERT_VALUES, SCATTER_FORWARD));
    const PetscScalar* values = nullptr;
    SOFT_PETSC(VecGetArrayRead(ghost_values_, &values));
    std::copy(values, values + ghosts_.size(), local_.begin());
    SOFT_PETSC(VecRestoreArrayRead(ghost_values_, &values));
}

void System::gather_cell(const CellGroup& group, std::size_t index, LocalCell& local) const {
    const auto nodes = input_.mesh.cell_nodes(group.cells[index]);
    const int n = group.reference->nodes, size = group.reference->dofs();
    for (int i = 0; i < map_.dimension; ++i)
        for (int a = 0; a < n; ++a) local.X[i * n + a] = input_.mesh.point(nodes[a])[i];
    for (int k = 0; k < size; ++k) local.unknowns[k] = local_[group.local[index * size + k]];
}

void System::gather_surface(const SurfaceCell& cell, std::vector<double>& x) const {
    const std::size_t n = cell.nodes.size();
    x.resize(cell.local.size());
    for (int i = 0; i < map_.dimension; ++i)
        for (std::size_t a = 0; a < n; ++a)
            x[i * n + a] = input_.mesh.point(cell.nodes[a])[i] + local_[cell.local[i * n + a]];
}

Evaluation System::evaluate(Vec x, double load_factor, Vec R, Vec load, Mat K) {
    read_state(x);
    SOFT_PETSC(VecZeroEntries(R));
    SOFT_PETSC(VecZeroEntries(load));
    if (K != nullptr) SOFT_PETSC(MatZeroEntries(K));
    Evaluation result;
    result.min_jacobian = std::numeric_limits<double>::max();
    for (const auto& group : groups_) add_cells(group, R, K, result);

    // The worst point and its cell, the same on every rank; ties go to the lower rank.
    struct { double value; int rank; } mine{result.min_jacobian, rank_}, worst{};
    MPI_Allreduce(&mine, &worst, 1, MPI_DOUBLE_INT, MPI_MINLOC, comm_);
    result.min_jacobian = worst.value;
    MPI_Bcast(&result.worst_cell, 1, MPI_INT64_T, worst.rank, comm_);
    MPI_Allreduce(MPI_IN_PLACE, &result.force_scale, 1, MPI_DOUBLE, MPI_SUM, comm_);
    result.force_scale = std::sqrt(result.force_scale);

    add_loads(load_factor, load, K);
    for (Vec v : {R, load}) SOFT_PETSC(VecAssemblyBegin(v));
    for (Vec v : {R, load}) SOFT_PETSC(VecAssemblyEnd(v));
    linalg::add(load, 1.0, dead_load_);
    linalg::add(R, -load_factor, load);
    if (K != nullptr) {
        SOFT_PETSC(MatAssemblyBegin(K, MAT_FINAL_ASSEMBLY));
        SOFT_PETSC(MatAssemblyEnd(K, MAT_FINAL_ASSEMBLY));
    }
    return result;
}

void System::add_cells(const CellGroup& group, Vec R, Mat K, Evaluation& result) const {
    const auto& reference = *group.reference;
    const PetscInt size = reference.dofs();
    const auto wanted = K != nullptr ? material::Wanted::stress_and_tangent : material::Wanted::stress;
    LocalCell local(reference);
    element::CellOutput out(reference);
    std::visit(
        [&](const auto& rubber) {
            for (std::size_t c = 0; c < group.cells.size(); ++c) {
                gather_cell(group, c, local);
                element::integrate_cell(reference, input_.kinematics, rubber, local.input(map_.pressure_scale_Pa),
                                        wanted, out);
                if (out.min_jacobian < result.min_jacobian) {
                    result.min_jacobian = out.min_jacobian;
                    result.worst_cell = group.cells[c];
                }
                for (const double r : out.residual) result.force_scale += r * r;
                const PetscInt* dofs = &group.dofs[c * size];
                SOFT_PETSC(VecSetValues(R, size, dofs, out.residual.data(), ADD_VALUES));
                if (K != nullptr)
                    SOFT_PETSC(MatSetValues(K, size, dofs, size, dofs, out.stiffness.data(), ADD_VALUES));
            }
        },
        *group.rubber);
}

void System::add_loads(double load_factor, Vec load, Mat K) {
    std::vector<double> x, force, stiffness;
    for (const auto& surface : loads_) {
        for (const auto& facet : surface.facets) {
            const auto& reference = tables_[facet.reference];
            const PetscInt size = reference.dofs();
            gather_surface(facet, x);
            force.assign(size, 0.0);
            stiffness.assign(K != nullptr ? static_cast<std::size_t>(size) * size : 0, 0.0);
            element::pressure_force(reference, input_.kinematics, x, force, stiffness);
            for (double& f : force) f *= surface.pressure_Pa;
            for (double& k : stiffness) k *= -load_factor * surface.pressure_Pa;
            SOFT_PETSC(VecSetValues(load, size, facet.dofs.data(), force.data(), ADD_VALUES));
            if (K != nullptr)
                SOFT_PETSC(MatSetValues(K, size, facet.dofs.data(), size, facet.dofs.data(), stiffness.data(),
                                        ADD_VALUES));
        }
        if (rank_ != 0) continue;   // the plug's force is known whole to every rank
        for (std::size_t i = 0; i < surface.plug_force.dofs.size(); ++i)
            SOFT_PETSC(VecSetValue(load, surface.plug_force.dofs[i],
                                   surface.pressure_Pa * surface.plug_force.values[i], ADD_VALUES));
    }
}

}  // namespace soft::assembly
