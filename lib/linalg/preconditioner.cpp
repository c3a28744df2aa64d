#include "linalg/preconditioner.hpp"

#include <omp.h>

#include <string>
#include <string_view>

#include "core/error.hpp"
#include "linalg/mumps.hpp"

namespace soft::linalg {

namespace {

[[noreturn]] void refuse_library(const std::string& key, const std::string& library) {
    throw Error(ExitCode::bad_input, key, "this PETSc was built without " + library,
                "choose another method, or automatic");
}

void set_factorization(PC pc, PCType type, MatSolverType library, const char* name) {
    PetscBool found = PETSC_FALSE;
    const MatFactorType factor = std::string_view(type) == PCLU ? MAT_FACTOR_LU : MAT_FACTOR_CHOLESKY;
    SOFT_PETSC(MatSolverTypeGet(library, MATSEQAIJ, factor, &found, nullptr, nullptr));
    if (!found) refuse_library("solver.linear", name);
    SOFT_PETSC(PCSetType(pc, type));
    SOFT_PETSC(PCFactorSetMatSolverType(pc, library));
}

void set_mumps(PC pc, PCType type) {
    set_factorization(pc, type, MATSOLVERMUMPS, "MUMPS");
    // ICNTL(14): work space beyond the estimate [%]; the default is too small for the pivoting of a saddle-point matrix.
    // ICNTL(13) = 1: the root front is factorised on one rank; otherwise the count of negative pivots is incomplete.
    // ICNTL(33) = 1: the determinant, whose sign is the only information on the inertia that LU gives.
    // ICNTL(12) = 1, ICNTL(6) = 0: the elimination order depends on the pattern of K only, not on the values of the first K.
    // A resumed run is then bitwise equal to an uninterrupted one.
    set_defaults({{"-mat_mumps_icntl_14", "80"},
                  {"-mat_mumps_icntl_13", "1"},
                  {"-mat_mumps_icntl_33", "1"},
                  {"-mat_mumps_icntl_12", "1"},
                  {"-mat_mumps_icntl_6", "0"}});
}

void set_cholmod(PC pc) {
    int ranks = 1;
    MPI_Comm_size(PetscObjectComm(reinterpret_cast<PetscObject>(pc)), &ranks);
    if (ranks > 1)
        throw Error(ExitCode::bad_input, "solver.linear",
                    "cholmod runs on one rank only, not on " + std::to_string(ranks), "use mumps-ldlt, or one rank");
    set_factorization(pc, PCCHOLESKY, MATSOLVERCHOLMOD, "CHOLMOD (SuiteSparse)");
    // CHOLMOD's warnings go to stdout, which is for data. Its simplicial LDL^T for small matrices accepts negative pivots.
    set_defaults({{"-mat_cholmod_print", "0"}, {"-mat_cholmod_factor", "supernodal"}});
}

void set_boomeramg(PC pc) {
    const PetscErrorCode code = PCSetType(pc, PCHYPRE);
    if (code == PETSC_ERR_ARG_UNKNOWN_TYPE) refuse_library("solver.preconditioner", "hypre");
    check(code, "PCSetType(pc, PCHYPRE)");
    SOFT_PETSC(PCHYPRESetType(pc, "boomeramg"));
}

void set_krylov(PC pc, Preconditioner preconditioner) {
    switch (preconditioner) {
        case Preconditioner::lu: return set_mumps(pc, PCLU);
        case Preconditioner::asm_lu:
        case Preconditioner::asm_ilu:
        case Preconditioner::asm_boomeramg: return SOFT_PETSC(PCSetType(pc, PCASM));
        case Preconditioner::boomeramg: return set_boomeramg(pc);
        case Preconditioner::gamg: return SOFT_PETSC(PCSetType(pc, PCGAMG));
        case Preconditioner::multigrid: return SOFT_PETSC(PCSetType(pc, PCSHELL));  // Multigrid::attach does the rest
        case Preconditioner::jacobi: return SOFT_PETSC(PCSetType(pc, PCJACOBI));
        case Preconditioner::none: return SOFT_PETSC(PCSetType(pc, PCNONE));
    }
}

void set_block_lu(PC pc) {
    SOFT_PETSC(PCSetType(pc, PCLU));
    SOFT_PETSC(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
    SOFT_PETSC(PCFactorSetUpMatSolverType(pc));
    Mat factor = nullptr;
    SOFT_PETSC(PCFactorGetMatrix(pc, &factor));
    SOFT_PETSC(MatMumpsSetIcntl(factor, 14, mumps_work_space));
}

}  // namespace

void set_type(PC pc, const LinearSettings& settings, Symmetry symmetry) {
    switch (settings.method) {
        case LinearMethod::automatic: return set_mumps(pc, symmetry == Symmetry::symmetric ? PCCHOLESKY : PCLU);
        case LinearMethod::mumps_ldlt: return set_mumps(pc, PCCHOLESKY);
        case LinearMethod::mumps_lu: return set_mumps(pc, PCLU);
        case LinearMethod::superlu_dist:
            // SuperLU_DIST does not pivot, and incompressibility gives zeros on the diagonal: it replaces them, and the iterations
            // correct the error. With several threads, 8.1.2 gives wrong factors in about one of ten runs of a small incompressible box;
            // loops of this program name their number of threads.
            omp_set_num_threads(1);
            set_defaults({{"-mat_superlu_dist_replacetinypivot", "true"}});
            return set_factorization(pc, PCLU, MATSOLVERSUPERLU_DIST, "SuperLU_DIST");
        case LinearMethod::cholmod: return set_cholmod(pc);
        case LinearMethod::krylov:
        case LinearMethod::jacobian_free: return set_krylov(pc, settings.preconditioner);
    }
}

void set_block_type(PC pc, Preconditioner preconditioner) {
    if (!is_type(pc, PCASM)) return;
    PetscInt blocks = 0;
    KSP* solvers = nullptr;
    SOFT_PETSC(PCASMGetSubKSP(pc, &blocks, nullptr, &solvers));
    for (PetscInt i = 0; i < blocks; ++i) {
        PC block = nullptr;
        SOFT_PETSC(KSPGetPC(solvers[i], &block));
        switch (preconditioner) {
            case Preconditioner::asm_lu: set_block_lu(block); break;
            case Preconditioner::asm_ilu: SOFT_PETSC(PCSetType(block, PCILU)); break;
            case Preconditioner::asm_boomeramg: set_boomeramg(block); break;
            case Preconditioner::lu:
            case Preconditioner::boomeramg:
            case Preconditioner::gamg:
            case Preconditioner::multigrid:
            case Preconditioner::jacobi:
            case Preconditioner::none: break;  // -pc_type asm after --
        }
        SOFT_PETSC(KSPSetFromOptions(solvers[i]));
    }
}

void set_defaults(std::initializer_list<Default> defaults) {
    for (const auto& [option, value] : defaults) {
        PetscBool given = PETSC_FALSE;
        SOFT_PETSC(PetscOptionsHasName(nullptr, nullptr, option, &given));
        if (!given) SOFT_PETSC(PetscOptionsSetValue(nullptr, option, value));
    }
}

bool is_type(PC pc, PCType type) {
    PetscBool same = PETSC_FALSE;
    SOFT_PETSC(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(pc), type, &same));
    return same == PETSC_TRUE;
}

bool is_mumps(PC pc) {
    if (!is_type(pc, PCCHOLESKY) && !is_type(pc, PCLU)) return false;
    MatSolverType type = nullptr;
    SOFT_PETSC(PCFactorGetMatSolverType(pc, &type));
    return type != nullptr && std::string_view(type) == MATSOLVERMUMPS;
}

}  // namespace soft::linalg
