#include "fem/system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "fem/pattern.hpp"

namespace soft::fem {

namespace {

using mesh::Index;

std::vector<fem::ReferenceCell> make_references(const model::Case& input) {
    std::vector<mesh::CellType> types = input.mesh.cell_types;
    std::ranges::sort(types);
    const auto repeated = std::ranges::unique(types);
    types.erase(repeated.begin(), repeated.end());
    std::vector<fem::ReferenceCell> references;
    for (const auto type : types) references.push_back(fem::make_reference_cell(type, input.formulation));
    return references;
}

std::vector<AnyRubber> make_rubbers(const model::Case& input) {
    std::vector<AnyRubber> rubbers;
    for (const auto& region : input.mesh.region_names) {
        const auto material = std::ranges::find(input.materials, region, &model::Material::name);
        if (material == input.materials.end())
            throw Error(ExitCode::bad_input, "materials", "region '" + region + "' has no material");
        if (const std::string reason =
                model::explain_incompatibility(*material, input.kinematics, input.symmetry_planes);
            !reason.empty())
            throw Error(ExitCode::bad_input, "materials/" + region, reason);
        rubbers.push_back(make_rubber(*material, input.formulation));
    }
    return rubbers;
}

/// shear modulus / cell size: see fem/dof_map.hpp. Any value gives the same solution.
double pressure_scale(const model::Case& input, std::span<const AnyRubber> rubbers) {
    if (!input.solver.scaling) return 1.0;
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
    if (input.mesh.cell_types.empty()) throw Error(ExitCode::bad_input, "mesh", "the mesh has no cells");
    references_ = make_references(input);
    rubbers_ = make_rubbers(input);
    map_ = make_dof_map(input, references_, pressure_scale(input, rubbers_), comm);
    if (map_.total == 0) throw Error(ExitCode::bad_input, "supports", "the supports fix every node", "release a face");
    make_groups();
    make_loads();
    make_outputs();
    make_local_copy();
    for (std::size_t i = 0; i < outputs_.size(); ++i)
        if (auto* rotation = std::get_if<Rotation>(&outputs_[i])) {
            const double undeformed = output(i, make_vector(), nullptr);
            rotation->undeformed = undeformed;
        }
}

/// Assembles a vector that every rank has completely.
linalg::Vector System::assembled(const SparseVector& sparse) const {
    linalg::Vector vector = make_vector();
    for (std::size_t i = 0; i < sparse.dofs.size(); ++i)
        if (sparse.dofs[i] >= map_.begin && sparse.dofs[i] < map_.end)
            SOFT_PETSC(VecSetValue(vector, sparse.dofs[i], sparse.values[i], ADD_VALUES));
    SOFT_PETSC(VecAssemblyBegin(vector));
    SOFT_PETSC(VecAssemblyEnd(vector));
    return vector;
}

void System::make_loads() {
    for (const auto& load : input_.loads) {
        loads_.push_back(make_load_surface(input_, map_, load, rank_, tables_));
        auto& cavities = load_cavities_.emplace_back();
        for (const auto& target : load.targets)  // the order of model::measured_cavities
            if (const auto cavity = std::ranges::find(input_.cavities, target, &model::Cavity::name);
                cavity != input_.cavities.end()) {
                cavities.push_back(volumes_.size());
                volumes_.push_back(make_enclosed_volume(input_, map_, *cavity, rank_, tables_));
            }
    }
    for (const auto& traction : input_.tractions)
        tractions_.push_back(assembled(on_unknowns(face_force(input_, traction.face, traction.traction_Pa), map_)));
    for (const auto& force : input_.body_forces)
        body_forces_.push_back(assembled(on_unknowns(body_force(input_, references_, force), map_)));
    levels_ = no_loads(input_);
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

template <class Visit>
void System::for_each_surface_cell(Visit&& visit) {
    for (auto& load : loads_)
        for (auto& facet : load.facets) visit(facet);
    for (auto& volume : volumes_) {
        for (auto& facet : volume.facets) visit(facet);
        for (auto& rim : volume.rims)
            for (auto& edge : rim.edges) visit(edge);
    }
    for (auto& output : outputs_) {
        if (auto* rotation = std::get_if<Rotation>(&output))
            for (RotationFace* face : {&rotation->face, &rotation->reference})
                for (auto& facet : face->facets) visit(facet);
        if (auto* shape = std::get_if<ShapeOutput>(&output)) visit(shape->at_nodes);
        if (auto* reaction = std::get_if<Reaction>(&output)) visit(reaction->at_nodes);
    }
}

void System::make_local_copy() {
    const auto collect = [this](std::span<const PetscInt> dofs) {
        for (const auto dof : dofs)
            if (dof >= 0) ghosts_.push_back(dof);
    };
    for (const auto& group : groups_) collect(group.dofs);
    for_each_surface_cell([&](const SurfaceCell& cell) { collect(cell.dofs); });  // rims reach beyond this rank's cells
    std::ranges::sort(ghosts_);
    const auto repeated = std::ranges::unique(ghosts_);
    ghosts_.erase(repeated.begin(), repeated.end());
    local_.assign(ghosts_.size() + 1 + 3 * input_.motions.size(), 0.0);
    for (auto& group : groups_) group.local = local_positions(group.dofs);
    for_each_surface_cell([&](SurfaceCell& cell) { cell.local = local_positions(cell.dofs); });

    linalg::IndexSet wanted;
    const auto count = static_cast<PetscInt>(ghosts_.size());
    SOFT_PETSC(ISCreateGeneral(PETSC_COMM_SELF, count, ghosts_.data(), PETSC_COPY_VALUES, wanted.out()));
    SOFT_PETSC(VecCreateSeq(PETSC_COMM_SELF, count, ghost_values_.out()));
    SOFT_PETSC(VecScatterCreate(make_vector(), wanted, ghost_values_, nullptr, ghost_scatter_.out()));
}

std::vector<int> System::local_positions(std::span<const PetscInt> dofs) const {
    const int fixed = static_cast<int>(ghosts_.size());
    std::vector<int> positions;
    for (const auto dof : dofs)
        positions.push_back(dof < 0 ? fixed + 1 + motion_slot(dof)
                                    : static_cast<int>(std::ranges::lower_bound(ghosts_, dof) - ghosts_.begin()));
    return positions;
}

void System::prescribe(const LoadLevels& levels) {
    levels_ = levels;
    double* value = local_.data() + ghosts_.size() + 1;
    for (std::size_t m = 0; m < input_.motions.size(); ++m)
        for (int i = 0; i < 3; ++i) *value++ = levels.motions[m] * input_.motions[m].displacement_m[i].value_or(0.0);
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

linalg::Matrix System::make_matrix() const { return make_zero_matrix(input_.mesh, map_, references_, comm_); }

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

void System::gather_undeformed(const SurfaceCell& cell, std::vector<double>& X) const {
    const std::size_t n = cell.nodes.size();
    X.resize(cell.local.size());
    for (int i = 0; i < map_.dimension; ++i)
        for (std::size_t a = 0; a < n; ++a) X[i * n + a] = input_.mesh.point(cell.nodes[a])[i];
}

void System::gather_surface(const SurfaceCell& cell, std::vector<double>& x) const {
    gather_undeformed(cell, x);
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += local_[cell.local[k]];
}

}  // namespace soft::fem
