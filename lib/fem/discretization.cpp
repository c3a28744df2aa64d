#include "fem/discretization.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "core/error.hpp"

namespace soft::fem {

namespace {

using mesh::Index;

std::vector<ReferenceCell> make_references(const model::Case& input) {
    if (input.mesh.cell_types.empty()) throw Error(ExitCode::bad_input, "mesh", "the mesh has no cells");
    std::vector<ReferenceCell> references;
    for (const auto type : std::set(input.mesh.cell_types.begin(), input.mesh.cell_types.end()))
        references.push_back(make_reference_cell(type, input.formulation));
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
    double size_m = 0;
    const auto nodes = input.mesh.cell_nodes(0);
    for (std::size_t i = 0; i < 3; ++i) {
        double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
        for (const Index node : nodes) {
            low = std::min(low, input.mesh.point(node)[i]);
            high = std::max(high, input.mesh.point(node)[i]);
        }
        size_m = std::max(size_m, high - low);
    }
    return modulus_Pa / size_m;
}

std::vector<CellGroup> make_groups(const Discretization& fe) {
    std::map<std::pair<mesh::CellType, std::int32_t>, CellGroup> by_key;
    std::vector<PetscInt> dofs;
    for (Index cell = 0; cell < fe.input.mesh.cell_count(); ++cell) {
        if (fe.dofs.cell_rank[cell] != fe.rank) continue;
        const auto type = fe.input.mesh.cell_type(cell);
        const auto region = fe.input.mesh.cell_regions[cell];
        auto& group = by_key[{type, region}];
        group.reference = &reference_of(fe.references, type);
        group.rubber = &fe.rubbers[region];
        group.cells.push_back(cell);
        fe.dofs.cell_dofs(fe.input.mesh, cell, *group.reference, dofs);
        group.dofs.insert(group.dofs.end(), dofs.begin(), dofs.end());
    }
    std::vector<CellGroup> groups;
    for (auto& [key, group] : by_key) groups.push_back(std::move(group));
    return groups;
}

}  // namespace

Discretization::Discretization(const model::Case& model_case, MPI_Comm communicator, std::span<const int> cell_rank)
    : input(model_case), comm(communicator), references(make_references(input)), rubbers(make_rubbers(input)) {
    MPI_Comm_rank(comm, &rank);
    dofs = make_dof_map(input, references, pressure_scale(input, rubbers), comm, cell_rank);
    if (dofs.total == 0) throw Error(ExitCode::bad_input, "supports", "the supports fix every node", "release a face");
    groups = make_groups(*this);
}

linalg::Vector Discretization::make_vector() const {
    linalg::Vector vector;
    SOFT_PETSC(VecCreate(comm, vector.out()));
    SOFT_PETSC(VecSetSizes(vector, dofs.end - dofs.begin, dofs.total));
    SOFT_PETSC(VecSetFromOptions(vector));
    SOFT_PETSC(VecSetOption(vector, VEC_IGNORE_NEGATIVE_INDICES, PETSC_TRUE));
    SOFT_PETSC(VecZeroEntries(vector));
    return vector;
}

linalg::Vector Discretization::make_vector(const SparseVector& entries) const {
    linalg::Vector vector = make_vector();
    for (std::size_t i = 0; i < entries.dofs.size(); ++i)
        if (entries.dofs[i] >= dofs.begin && entries.dofs[i] < dofs.end)
            SOFT_PETSC(VecSetValue(vector, entries.dofs[i], entries.values[i], ADD_VALUES));
    linalg::assemble(vector);
    return vector;
}

double Discretization::moved_by(PetscInt dof) const {
    const int slot = motion_slot(dof);
    return slot < 0 ? 0.0 : input.motions[slot / 3].displacement_m[slot % 3].value_or(0.0);
}

AnyRubber make_rubber(const model::Material& material, model::Formulation formulation) {
    const std::string location = "materials/" + material.name;
    const auto make = [&] {
        try {
            return model::make_rubber(material);
        } catch (const Error& error) {
            throw Error(error.code(), "", location + "/" + error.what());  // the law names only the constant
        }
    };
    AnyRubber rubber = make();
    if (const std::string reason = material::explain_incompatibility(rubber, formulation); !reason.empty())
        throw Error(ExitCode::bad_input, location, reason);
    return rubber;
}

std::vector<double> densities_kg_m3(const model::Case& input) {
    std::vector<double> density;
    for (const auto& region : input.mesh.region_names) {
        const auto material = std::ranges::find(input.materials, region, &model::Material::name);
        if (material == input.materials.end() || !material->density_kg_m3)
            throw Error(ExitCode::bad_input, "materials/" + region, "gravity and dynamics need the density",
                        "add material.density, for example 1080 kg/m^3");
        density.push_back(*material->density_kg_m3);
    }
    return density;
}

}  // namespace soft::fem
