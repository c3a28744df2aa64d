#include "linalg/petsc.hpp"

#include <algorithm>
#include <string>

#include "core/error.hpp"
#include "core/memory.hpp"

namespace soft::linalg {

void check(PetscErrorCode code, const char* call) {
    if (code == 0) [[likely]]
        return;
    const char* text = nullptr;
    PetscErrorMessage(code, &text, nullptr);
    // Some allocations of PETSc 3.18 fail with their line number instead of PETSC_ERR_MEM (seen under ulimit -v).
    if (code == PETSC_ERR_MEM || (text == nullptr && code > PETSC_ERR_MAX_VALUE)) throw core::out_of_memory();
    if (code == PETSC_ERR_ARG_UNKNOWN_TYPE || code == PETSC_ERR_MISSING_FACTOR)  // only PETSc options set types
        throw Error(ExitCode::usage, "PETSc", "does not provide the solver or preconditioner type requested after --",
                    "see `solve CASE -- -help`");
    throw Error(
        ExitCode::internal, "PETSc",
        std::string(call) + " failed: " + (text != nullptr ? std::string(text) : "error " + std::to_string(code)));
}

Vector duplicate(Vec like) {
    Vector copy;
    SOFT_PETSC(VecDuplicate(like, copy.out()));
    SOFT_PETSC(VecZeroEntries(copy));
    return copy;
}

double dot(Vec a, Vec b) {
    PetscScalar value = 0;
    SOFT_PETSC(VecDot(a, b, &value));
    return value;
}

double norm(Vec a) {
    PetscReal value = 0;
    SOFT_PETSC(VecNorm(a, NORM_2, &value));
    return value;
}

void copy(Vec from, Vec to) { SOFT_PETSC(VecCopy(from, to)); }
void add(Vec y, double factor, Vec x) { SOFT_PETSC(VecAXPY(y, factor, x)); }

void add(Mat Y, double factor, Mat X) {
    MatInfo of_Y, of_X;
    SOFT_PETSC(MatGetInfo(Y, MAT_GLOBAL_SUM, &of_Y));
    SOFT_PETSC(MatGetInfo(X, MAT_GLOBAL_SUM, &of_X));
    const bool same = of_Y.nz_used == of_X.nz_used;
    SOFT_PETSC(MatAXPY(Y, factor, X, same ? SAME_NONZERO_PATTERN : SUBSET_NONZERO_PATTERN));
}

void assemble(Vec x) {
    SOFT_PETSC(VecAssemblyBegin(x));
    SOFT_PETSC(VecAssemblyEnd(x));
}

void assemble(Mat K) {
    SOFT_PETSC(MatAssemblyBegin(K, MAT_FINAL_ASSEMBLY));
    SOFT_PETSC(MatAssemblyEnd(K, MAT_FINAL_ASSEMBLY));
}

std::vector<double> gather(Vec distributed) {
    const MPI_Comm ranks = PetscObjectComm(reinterpret_cast<PetscObject>(distributed));
    int rank = 0, count = 0;
    MPI_Comm_rank(ranks, &rank);
    MPI_Comm_size(ranks, &count);
    const PetscInt* begins = nullptr;
    const PetscScalar* values = nullptr;
    SOFT_PETSC(VecGetOwnershipRanges(distributed, &begins));
    std::vector<int> sizes;
    for (int r = 0; r < count; ++r) sizes.push_back(static_cast<int>(begins[r + 1] - begins[r]));
    std::vector<double> gathered(rank == 0 ? static_cast<std::size_t>(begins[count]) : 0);
    SOFT_PETSC(VecGetArrayRead(distributed, &values));
    MPI_Gatherv(values, sizes[static_cast<std::size_t>(rank)], MPI_DOUBLE, gathered.data(), sizes.data(), begins,
                MPI_DOUBLE, 0, ranks);
    SOFT_PETSC(VecRestoreArrayRead(distributed, &values));
    return gathered;
}

void spread(std::span<const double> all, Vec distributed) {
    PetscInt begin = 0, end = 0;
    SOFT_PETSC(VecGetOwnershipRange(distributed, &begin, &end));
    PetscScalar* values = nullptr;
    SOFT_PETSC(VecGetArray(distributed, &values));
    std::copy(all.begin() + begin, all.begin() + end, values);
    SOFT_PETSC(VecRestoreArray(distributed, &values));
}

}  // namespace soft::linalg
