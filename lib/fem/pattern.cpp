#include "fem/pattern.hpp"

#include <algorithm>

namespace soft::fem {

namespace {

using mesh::Index;

/// Groups of unknowns that share entries: the cells of the mesh, then the couplings.
struct Groups {
    const mesh::Mesh& mesh;
    const DofMap& map;
    std::span<const ReferenceCell> references;
    std::span<const std::vector<PetscInt>> couplings;

    [[nodiscard]] Index count() const { return mesh.cell_count() + static_cast<Index>(couplings.size()); }
    void read(Index group, std::vector<PetscInt>& dofs) const {
        if (const Index cells = mesh.cell_count(); group >= cells)
            dofs = couplings[static_cast<std::size_t>(group - cells)];
        else
            map.cell_dofs(mesh, group, reference_of(references, mesh.cell_type(group)), dofs);
    }
};

/// The groups of each of this rank's unknowns.
struct GroupsOfRows {
    std::vector<std::size_t> begin;  // of each row, and one past the last
    std::vector<Index> groups;
};

GroupsOfRows groups_of_rows(const Groups& all) {
    const DofMap& map = all.map;
    GroupsOfRows rows;
    rows.begin.assign(static_cast<std::size_t>(map.end - map.begin) + 2, 0);
    std::vector<PetscInt> dofs;
    const auto for_each_own = [&](auto&& visit) {
        for (Index group = 0; group < all.count(); ++group) {
            all.read(group, dofs);
            for (const PetscInt dof : dofs)
                if (dof >= map.begin && dof < map.end) visit(static_cast<std::size_t>(dof - map.begin), group);
        }
    };
    for_each_own([&](std::size_t row, Index) { ++rows.begin[row + 2]; });
    for (std::size_t r = 2; r < rows.begin.size(); ++r) rows.begin[r] += rows.begin[r - 1];
    rows.groups.resize(rows.begin.back());
    for_each_own([&](std::size_t row, Index group) { rows.groups[rows.begin[row + 1]++] = group; });
    rows.begin.pop_back();
    return rows;
}

/// The columns of this rank's rows, ascending. Neighbouring rows mostly have the same groups (the components of a node): their
/// columns are computed and stored once.
struct Columns {
    std::vector<std::size_t> set_of;    // [row]
    std::vector<std::size_t> begin{0};  // [set], and one past the last
    std::vector<PetscInt> columns;

    [[nodiscard]] std::span<const PetscInt> of(std::size_t row) const {
        return {columns.data() + begin[set_of[row]], columns.data() + begin[set_of[row] + 1]};
    }
};

Columns columns_of(const Groups& all) {
    const GroupsOfRows rows = groups_of_rows(all);
    Columns found;
    std::vector<PetscInt> dofs;
    std::vector<char> met(static_cast<std::size_t>(all.map.total), 0);
    std::span<const Index> before;
    for (std::size_t row = 0; row + 1 < rows.begin.size(); ++row) {
        const std::span<const Index> groups(&rows.groups[rows.begin[row]], rows.begin[row + 1] - rows.begin[row]);
        if (row == 0 || !std::ranges::equal(groups, before)) {
            for (const Index group : groups) {
                all.read(group, dofs);
                for (const PetscInt dof : dofs)
                    if (dof >= 0 && met[static_cast<std::size_t>(dof)] == 0) {
                        met[static_cast<std::size_t>(dof)] = 1;
                        found.columns.push_back(dof);
                    }
            }
            const auto own = found.columns.begin() + static_cast<std::ptrdiff_t>(found.begin.back());
            for (auto dof = own; dof != found.columns.end(); ++dof) met[static_cast<std::size_t>(*dof)] = 0;
            std::sort(own, found.columns.end());
            found.begin.push_back(found.columns.size());
            before = groups;
        }
        found.set_of.push_back(found.begin.size() - 2);
    }
    return found;
}

}  // namespace

linalg::Matrix make_zero_matrix(const mesh::Mesh& mesh, const DofMap& map,
                                std::span<const fem::ReferenceCell> references,
                                std::span<const std::vector<PetscInt>> couplings, MPI_Comm comm) {
    const Columns found = columns_of({mesh, map, references, couplings});
    const PetscInt own = map.end - map.begin;
    std::vector<PetscInt> here(static_cast<std::size_t>(own)), elsewhere(here.size());
    for (std::size_t row = 0; row < here.size(); ++row) {
        const auto columns = found.of(row);
        const auto first = std::ranges::lower_bound(columns, map.begin),
                   last = std::ranges::lower_bound(columns, map.end);
        here[row] = static_cast<PetscInt>(last - first);
        elsewhere[row] = static_cast<PetscInt>(columns.size()) - here[row];
    }
    linalg::Matrix K;
    SOFT_PETSC(MatCreate(comm, K.out()));
    SOFT_PETSC(MatSetType(K, MATAIJ));
    SOFT_PETSC(MatSetSizes(K, own, own, map.total, map.total));
    SOFT_PETSC(MatSeqAIJSetPreallocation(K, 0, here.data()));
    SOFT_PETSC(MatMPIAIJSetPreallocation(K, 0, here.data(), 0, elsewhere.data()));
    SOFT_PETSC(MatSetOption(K, MAT_SORTED_FULL, PETSC_TRUE));  // whole rows: no search within a row on one rank
    std::vector<PetscScalar> zeros;
    for (std::size_t row = 0; row < here.size(); ++row) {
        const auto columns = found.of(row);
        zeros.resize(std::max(zeros.size(), columns.size()), 0.0);
        const PetscInt number = map.begin + static_cast<PetscInt>(row);
        SOFT_PETSC(MatSetValues(K, 1, &number, static_cast<PetscInt>(columns.size()), columns.data(), zeros.data(),
                                INSERT_VALUES));
    }
    linalg::assemble(K);
    SOFT_PETSC(MatSetOption(K, MAT_SORTED_FULL, PETSC_FALSE));
    SOFT_PETSC(MatSetOption(K, MAT_NEW_NONZERO_LOCATION_ERR, PETSC_TRUE));
    return K;
}

}  // namespace soft::fem
