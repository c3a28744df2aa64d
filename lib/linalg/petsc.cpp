#include "linalg/petsc.hpp"

#include <string>

#include "core/error.hpp"

namespace soft::linalg {

void check(PetscErrorCode code, const char* call) {
    if (code == 0) [[likely]]
        return;
    const char* text = nullptr;
    PetscErrorMessage(code, &text, nullptr);
    if (code == PETSC_ERR_MEM)
        throw Error(ExitCode::io_error, "solve", "out of memory", "use a coarser mesh or more memory");
    if (code == PETSC_ERR_ARG_UNKNOWN_TYPE || code == PETSC_ERR_MISSING_FACTOR)   // types come from PETSc's options only
        throw Error(ExitCode::usage, "PETSc", "has no solver or preconditioner of the type asked for behind --",
                    "see `solve CASE -- -help`");
    throw Error(ExitCode::internal, "PETSc", std::string(call) + " failed: " + (text != nullptr ? text : "unknown"));
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

}  // namespace soft::linalg
