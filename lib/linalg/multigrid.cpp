#include "linalg/multigrid.hpp"

#include "core/error.hpp"
#include "linalg/block_entries.hpp"
#include "linalg/preconditioner.hpp"
#include "linalg/small_matrix.hpp"

namespace soft::linalg {

namespace {

using OwnedPC = Owned<PC, PCDestroy>;
using Kind = PressureBlock::Kind;

/// gamma: ratio of bulk to shear modulus of the solid that replaces the nearly incompressible one. Measured on bellows with 115k
/// unknowns: 44 iterations with 1 and 2, 50 with 4, 61 with 8, because the vertex level locks more; with 2 and A_g solved exactly: 18.
constexpr double bulk_over_shear = 2.0;

/// Values of the rows of one block, all with the same columns.
struct BlockRows {
    std::size_t columns = 0;
    std::vector<double> values;  // [row][column]
    void read(Mat B, PetscInt first, int size) {
        values.clear();
        for (PetscInt row = first; row < first + size; ++row) {
            PetscInt count = 0;
            const PetscScalar* entries = nullptr;
            SOFT_PETSC(MatGetRow(B, row, &count, nullptr, &entries));
            columns = static_cast<std::size_t>(count);
            values.insert(values.end(), entries, entries + count);
            SOFT_PETSC(MatRestoreRow(B, row, &count, nullptr, &entries));
        }
    }
};

/// to = B^T W B for the size x size matrix W.
void project(const BlockRows& B, const double* W, std::size_t size, std::vector<double>& to) {
    const std::size_t n = B.columns;
    std::vector<double> WB(size * n, 0.0);
    for (std::size_t s = 0; s < size; ++s)
        for (std::size_t t = 0; t < size; ++t)
            for (std::size_t j = 0; j < n; ++j) WB[s * n + j] += W[s * size + t] * B.values[t * n + j];
    to.assign(n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t s = 0; s < size; ++s)
            for (std::size_t j = 0; j < n; ++j) to[i * n + j] += B.values[s * n + i] * WB[s * n + j];
}

/// Appends A^-1, row by row.
void append_inverse(const SmallMatrix& A, std::vector<double>& to) {
    const auto size = static_cast<std::size_t>(A.size), begin = to.size();
    to.resize(begin + size * size);
    for (std::size_t j = 0; j < size; ++j) {
        std::vector<double> unit(size, 0.0);
        unit[j] = 1.0;
        const auto column = solve(A, unit);
        if (!column) throw Error(ExitCode::internal, "multigrid", "the pressure block of a cell is singular");
        for (std::size_t i = 0; i < size; ++i) to[begin + i * size + j] = (*column)[i];
    }
}

void scatter(VecScatter context, Vec from, Vec to, ScatterMode mode) {
    SOFT_PETSC(VecScatterBegin(context, from, to, INSERT_VALUES, mode));
    SOFT_PETSC(VecScatterEnd(context, from, to, INSERT_VALUES, mode));
}

/// Exceptions must not pass through PETSc's C code. LinearSolver turns this code into an Error again.
template <class Work>
PetscErrorCode guarded(Work&& work) {
    try {
        return work();
    } catch (...) {
        return PETSC_ERR_USER;
    }
}

}  // namespace

class Multigrid::Parts {
public:
    explicit Parts(const ElementLevels& levels);

    /// Returns the code of the V-cycle, whose failure is numerical and not a program error.
    [[nodiscard]] PetscErrorCode set_up(Mat K);
    [[nodiscard]] PetscErrorCode apply(Vec from, Vec to);
    [[nodiscard]] PCFailedReason failure() const;

private:
    void make_cycle(Mat A);
    void make_vectors(Mat K);
    void find_columns();
    void invert_blocks(Mat K);
    void add_bulk();
    void solve_blocks(Vec from, Vec to, Kind kind) const;

    const ElementLevels& levels_;
    bool mixed_ = false;  // has pressure unknowns
    Matrix A_, B_;
    std::vector<double> inverse_;  // of the blocks of C + M_g, one after the other
    BlockIndices indices_;         // of the cells' displacements in A_
    OwnedPC cycle_;
    Vector from_u_, to_u_, from_p_, to_p_;
    Scatter displacements_, pressures_;
};

Multigrid::Parts::Parts(const ElementLevels& levels) : levels_(levels) {
    PetscInt count = 0;
    SOFT_PETSC(ISGetSize(levels_.pressures, &count));
    mixed_ = count > 0;
}

PetscErrorCode Multigrid::Parts::set_up(Mat K) {
    const bool first = cycle_ == nullptr;
    if (mixed_) {
        const MatReuse reuse = first ? MAT_INITIAL_MATRIX : MAT_REUSE_MATRIX;
        SOFT_PETSC(MatCreateSubMatrix(K, levels_.displacements, levels_.displacements, reuse, A_.out()));
        SOFT_PETSC(MatCreateSubMatrix(K, levels_.pressures, levels_.displacements, reuse, B_.out()));
        if (first) {
            make_vectors(K);
            find_columns();
        }
        invert_blocks(K);
        add_bulk();
    }
    const Mat A = mixed_ ? A_.get() : K;
    if (first) make_cycle(A);
    SOFT_PETSC(PCSetOperators(cycle_, A, A));
    return PCSetUp(cycle_);
}

PCFailedReason Multigrid::Parts::failure() const {
    PCFailedReason failed = PC_NOERROR;
    SOFT_PETSC(PCGetFailedReason(cycle_, &failed));
    return failed;
}

void Multigrid::Parts::make_vectors(Mat K) {
    Vector all;
    SOFT_PETSC(MatCreateVecs(K, all.out(), nullptr));
    SOFT_PETSC(MatCreateVecs(B_, from_u_.out(), from_p_.out()));
    to_u_ = duplicate(from_u_);
    to_p_ = duplicate(from_p_);
    SOFT_PETSC(VecScatterCreate(all, levels_.displacements, from_u_, nullptr, displacements_.out()));
    SOFT_PETSC(VecScatterCreate(all, levels_.pressures, from_p_, nullptr, pressures_.out()));
}

/// The rows of B that belong to a cell's pressures have the cell's displacements as columns.
void Multigrid::Parts::find_columns() {
    PetscInt row = 0;
    SOFT_PETSC(MatGetOwnershipRange(B_, &row, nullptr));
    std::vector<std::vector<PetscInt>> columns;
    for (const auto& block : levels_.blocks) {
        auto& of_block = columns.emplace_back();
        if (block.kind == Kind::of_cell) {
            PetscInt count = 0;
            const PetscInt* numbers = nullptr;
            SOFT_PETSC(MatGetRow(B_, row, &count, &numbers, nullptr));
            of_block.assign(numbers, numbers + count);
            SOFT_PETSC(MatRestoreRow(B_, row, &count, &numbers, nullptr));
        }
        row += block.size;
    }
    const std::vector<std::span<const PetscInt>> blocks(columns.begin(), columns.end());
    indices_ = BlockIndices(A_, blocks);
}

void Multigrid::Parts::invert_blocks(Mat K) {
    inverse_.clear();
    const PetscInt* rows = nullptr;
    SOFT_PETSC(ISGetIndices(levels_.pressures, &rows));
    const PetscInt* row = rows;
    for (const auto& block : levels_.blocks) {
        SmallMatrix sum(block.size);
        SOFT_PETSC(MatGetValues(K, block.size, row, block.size, row, sum.values.data()));  // -C
        const double factor = block.kind == Kind::of_cell ? 1.0 / bulk_over_shear : 1.0;
        for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] = factor * block.mass[i] - sum.values[i];
        append_inverse(sum, inverse_);
        row += block.size;
    }
    SOFT_PETSC(ISRestoreIndices(levels_.pressures, &rows));
}

void Multigrid::Parts::add_bulk() {
    PetscInt row = 0;
    SOFT_PETSC(MatGetOwnershipRange(B_, &row, nullptr));
    BlockRows B;
    std::vector<double> bulk;
    const double* inverse = inverse_.data();
    {
        BlockAdder adder(A_);
        for (std::size_t b = 0; b < levels_.blocks.size(); ++b) {
            const auto& block = levels_.blocks[b];
            const auto size = static_cast<std::size_t>(block.size);
            if (block.kind == Kind::of_cell) {
                B.read(B_, row, block.size);
                project(B, inverse, size, bulk);
                adder.add(indices_, b, bulk);
            }
            inverse += size * size;
            row += block.size;
        }
    }
    assemble(A_);
}

void Multigrid::Parts::make_cycle(Mat A) {
    SOFT_PETSC(PCCreate(PetscObjectComm(reinterpret_cast<PetscObject>(A)), cycle_.out()));
    SOFT_PETSC(PCSetOptionsPrefix(cycle_, "multigrid_"));
    SOFT_PETSC(PCSetOperators(cycle_, A, A));
    SOFT_PETSC(PCSetType(cycle_, PCMG));
    SOFT_PETSC(PCMGSetLevels(cycle_, 2, nullptr));
    SOFT_PETSC(PCMGSetInterpolation(cycle_, 1, levels_.interpolation));
    SOFT_PETSC(PCMGSetGalerkin(cycle_, PC_MG_GALERKIN_BOTH));
    KSP smoother = nullptr, coarse = nullptr;
    PC pc = nullptr;
    SOFT_PETSC(PCMGGetSmoother(cycle_, 1, &smoother));
    SOFT_PETSC(KSPSetType(smoother, KSPRICHARDSON));
    SOFT_PETSC(KSPSetTolerances(smoother, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, 1));
    SOFT_PETSC(KSPGetPC(smoother, &pc));
    SOFT_PETSC(PCSetType(pc, PCSOR));  // node by node: PETSc groups rows with the same pattern
    SOFT_PETSC(PCSORSetSymmetric(pc, SOR_LOCAL_SYMMETRIC_SWEEP));
    // LDL^T: beyond a limit point the coarse matrix is indefinite too.
    SOFT_PETSC(PCMGGetCoarseSolve(cycle_, &coarse));
    SOFT_PETSC(KSPGetPC(coarse, &pc));
    SOFT_PETSC(PCSetType(pc, PCCHOLESKY));
    SOFT_PETSC(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
    set_defaults({{"-multigrid_mg_coarse_mat_mumps_icntl_14", "80"},
                  {"-multigrid_mg_coarse_mat_mumps_icntl_6", "0"},
                  {"-multigrid_mg_coarse_mat_mumps_icntl_12", "1"}});  // as in set_mumps
    SOFT_PETSC(PCSetFromOptions(cycle_));
}

/// to = (C + M_g)^-1 from on the blocks of one kind; the other entries are unchanged.
void Multigrid::Parts::solve_blocks(Vec from, Vec to, Kind kind) const {
    const PetscScalar* in = nullptr;
    PetscScalar* out = nullptr;
    SOFT_PETSC(VecGetArrayRead(from, &in));
    SOFT_PETSC(VecGetArray(to, &out));
    const double* inverse = inverse_.data();
    PetscInt row = 0;
    for (const auto& block : levels_.blocks) {
        const int size = block.size;
        for (int i = 0; i < size && block.kind == kind; ++i) {
            double sum = 0;
            for (int j = 0; j < size; ++j) sum += inverse[i * size + j] * in[row + j];
            out[row + i] = sum;
        }
        inverse += size * size;
        row += size;
    }
    SOFT_PETSC(VecRestoreArrayRead(from, &in));
    SOFT_PETSC(VecRestoreArray(to, &out));
}

/// u = A_g^-1 (f + B^T (C + M_g)^-1 g of the cells),   p = (C + M_g)^-1 (B u - g)
PetscErrorCode Multigrid::Parts::apply(Vec from, Vec to) {
    if (!mixed_) return PCApply(cycle_, from, to);
    scatter(displacements_, from, from_u_, SCATTER_FORWARD);
    scatter(pressures_, from, from_p_, SCATTER_FORWARD);
    SOFT_PETSC(VecZeroEntries(to_p_));
    solve_blocks(from_p_, to_p_, Kind::of_cell);
    SOFT_PETSC(MatMultTransposeAdd(B_, to_p_, from_u_, from_u_));
    if (const PetscErrorCode code = PCApply(cycle_, from_u_, to_u_); code != 0) return code;
    SOFT_PETSC(VecScale(from_p_, -1.0));
    SOFT_PETSC(MatMultAdd(B_, to_u_, from_p_, from_p_));
    solve_blocks(from_p_, to_p_, Kind::of_cell);
    solve_blocks(from_p_, to_p_, Kind::of_vertex);
    scatter(displacements_, to_u_, to, SCATTER_REVERSE);
    scatter(pressures_, to_p_, to, SCATTER_REVERSE);
    return 0;
}

Multigrid::Multigrid(ElementLevels levels) : levels_(std::move(levels)) {}
Multigrid::~Multigrid() = default;

void Multigrid::attach(PC pc) {
    parts_ = std::make_unique<Parts>(levels_);
    SOFT_PETSC(PCSetType(pc, PCSHELL));
    SOFT_PETSC(PCShellSetName(pc, "multigrid of second-order elements"));
    SOFT_PETSC(PCShellSetContext(pc, parts_.get()));
    SOFT_PETSC(PCShellSetSetUp(pc, &Multigrid::set_up));
    SOFT_PETSC(PCShellSetApply(pc, &Multigrid::apply));
}

PetscErrorCode Multigrid::set_up(PC pc) {
    return guarded([pc] {
        Parts* parts = nullptr;
        Mat K = nullptr;
        SOFT_PETSC(PCShellGetContext(pc, &parts));
        SOFT_PETSC(PCGetOperators(pc, nullptr, &K));
        const PetscErrorCode code = parts->set_up(K);
        if (code == 0) SOFT_PETSC(PCSetFailedReason(pc, parts->failure()));
        return code;
    });
}

PetscErrorCode Multigrid::apply(PC pc, Vec from, Vec to) {
    return guarded([=] {
        Parts* parts = nullptr;
        SOFT_PETSC(PCShellGetContext(pc, &parts));
        return parts->apply(from, to);
    });
}

}  // namespace soft::linalg
