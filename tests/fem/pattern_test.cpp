#include "fem/pattern.hpp"

#include <gtest/gtest.h>

#include <set>

#include "fem/system.hpp"
#include "mesh/split.hpp"
#include "sample_cases.hpp"

namespace soft::fem {
namespace {

/// Pairs of unknowns that share a cell, cell by cell.
std::set<std::pair<PetscInt, PetscInt>> pairs(const System& system) {
    std::set<std::pair<PetscInt, PetscInt>> found;
    const auto& input = system.input();
    std::vector<PetscInt> dofs;
    for (mesh::Index cell = 0; cell < input.mesh.cell_count(); ++cell) {
        system.dofs().cell_dofs(input.mesh, cell,
                                fem::make_reference_cell(input.mesh.cell_type(cell), input.formulation), dofs);
        for (const PetscInt row : dofs)
            for (const PetscInt column : dofs)
                if (row >= 0 && column >= 0) found.emplace(row, column);
    }
    return found;
}

TEST(Pattern, ContainsExactlyThePairsOfUnknownsThatShareACell) {
    auto input = box_case(2, false);
    auto tetrahedra = input;
    tetrahedra.mesh = mesh::split_into_simplices(input.mesh);
    for (const auto& body : {input, sphere_case(2, 3), tetrahedra}) {
        System system(body, PETSC_COMM_WORLD);
        const auto K = system.make_matrix();
        std::set<std::pair<PetscInt, PetscInt>> found;
        for (PetscInt row = 0; row < system.dofs().total; ++row) {
            PetscInt count = 0;
            const PetscInt* columns = nullptr;
            SOFT_PETSC(MatGetRow(K, row, &count, &columns, nullptr));
            for (PetscInt k = 0; k < count; ++k) found.emplace(row, columns[k]);
            SOFT_PETSC(MatRestoreRow(K, row, &count, &columns, nullptr));
        }
        EXPECT_EQ(found, pairs(system));
        MatInfo info;
        SOFT_PETSC(MatGetInfo(K, MAT_LOCAL, &info));
        EXPECT_EQ(info.nz_allocated, info.nz_used);  // counted exactly
    }
}

}  // namespace
}  // namespace soft::fem
