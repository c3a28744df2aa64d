#include "linalg/sparse_ldlt.hpp"

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "core/error.hpp"
#include "linalg/matrix_rows.hpp"

namespace soft::linalg {

namespace {

static_assert(sizeof(PetscInt) == sizeof(int), "CHOLMOD's int interface is used");

constexpr double min_diagonal = 1e-6;

}  // namespace

struct SparseLdlt::Parts {
    cholmod_common common{};
    cholmod_sparse* upper = nullptr;  // row i of the upper triangle of K, stored as column i of the lower one
    cholmod_factor* factor = nullptr;
    cholmod_dense *x = nullptr, *y = nullptr, *e = nullptr;  // work space of cholmod_solve2, reused by all solves
    std::vector<double> diagonal;
    double flops = 0;
    MPI_Comm ranks = MPI_COMM_SELF;
    Matrix whole;  // the whole distributed K, on every rank
    Scatter to_all;
    Vector all;  // the whole right-hand side, on every rank

    [[nodiscard]] bool is_shared() const { return to_all.get() != nullptr; }

    Parts() {
        cholmod_start(&common);
        common.print = 0;
        common.supernodal = CHOLMOD_SIMPLICIAL;
        common.final_ll = 0;
        common.nmethods = 1;
        common.method[0].ordering = CHOLMOD_AMD;
        common.postorder = 1;
    }
    ~Parts() {
        for (auto** dense : {&x, &y, &e}) cholmod_free_dense(dense, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_free_sparse(&upper, &common);
        cholmod_finish(&common);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    void check() const {
        if (common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
        if (common.status < CHOLMOD_OK)
            throw Error(ExitCode::internal, "CHOLMOD", "status " + std::to_string(common.status));
    }
    void read_pattern(const MatrixRows& rows);
    void read_values(const MatrixRows& rows);
    [[nodiscard]] double bounded_diagonal(const MatrixRows& rows, PetscInt row) const;
};

void SparseLdlt::Parts::read_pattern(const MatrixRows& rows) {
    upper = cholmod_allocate_sparse(rows.count, rows.count, rows.begin[rows.count], 1, 1, -1, CHOLMOD_REAL, &common);
    check();
    auto* start = static_cast<int*>(upper->p);
    auto* index = static_cast<int*>(upper->i);
    int next = 0;
    for (PetscInt row = 0; row < rows.count; ++row) {
        start[row] = next;
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k)
            if (rows.columns[k] >= row) index[next++] = rows.columns[k];
    }
    start[rows.count] = next;
}

void SparseLdlt::Parts::read_values(const MatrixRows& rows) {
    diagonal.assign(static_cast<std::size_t>(rows.count), 0.0);
    for (PetscInt row = 0; row < rows.count; ++row)
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k)
            if (rows.columns[k] == row) diagonal[static_cast<std::size_t>(row)] = rows.values[k];
    auto* value = static_cast<double*>(upper->x);
    for (PetscInt row = 0; row < rows.count; ++row)
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k)
            if (rows.columns[k] >= row)
                *value++ = rows.columns[k] == row ? bounded_diagonal(rows, row) : rows.values[k];
}

double SparseLdlt::Parts::bounded_diagonal(const MatrixRows& rows, PetscInt row) const {
    const double own = diagonal[static_cast<std::size_t>(row)];
    if (own > 0.0) return own;
    double schur = 0;
    for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k) {
        const double other = diagonal[static_cast<std::size_t>(rows.columns[k])];
        if (other > 0.0) schur += rows.values[k] * rows.values[k] / other;
    }
    return std::min(own, -min_diagonal * schur);
}

SparseLdlt::SparseLdlt(Mat K) : parts_(std::make_unique<Parts>()) {
    MPI_Comm comm = MPI_COMM_SELF;
    SOFT_PETSC(PetscObjectGetComm(reinterpret_cast<PetscObject>(K), &comm));
    int size = 1;
    MPI_Comm_size(comm, &size);
    if (size > 1) {
        parts_->ranks = comm;  // PETSc's communicator: to_all keeps it alive
        SOFT_PETSC(MatCreateRedundantMatrix(K, size, MPI_COMM_NULL, MAT_INITIAL_MATRIX, parts_->whole.out()));
        Vector like;
        SOFT_PETSC(MatCreateVecs(K, nullptr, like.out()));
        SOFT_PETSC(VecScatterCreateToAll(like, parts_->to_all.out(), parts_->all.out()));
    }
    parts_->read_pattern(rows_of(size > 1 ? parts_->whole.get() : K));
    parts_->factor = cholmod_analyze(parts_->upper, &parts_->common);
    parts_->check();
    parts_->flops = parts_->common.fl;
}

SparseLdlt::~SparseLdlt() = default;

double SparseLdlt::flops() const { return parts_->flops; }

void SparseLdlt::read_values(Mat K) {
    if (!parts_->is_shared()) return parts_->read_values(rows_of(K));
    int size = 1;
    MPI_Comm_size(parts_->ranks, &size);
    SOFT_PETSC(MatCreateRedundantMatrix(K, size, MPI_COMM_NULL, MAT_REUSE_MATRIX, parts_->whole.out()));
    parts_->read_values(rows_of(parts_->whole));
}

bool SparseLdlt::factorize(Mat K) {
    read_values(K);
    cholmod_factorize(parts_->upper, parts_->factor, &parts_->common);
    parts_->check();
    int good = has_good_pivots() ? 1 : 0;  // last digits may differ between processor types: rank 0 decides
    MPI_Bcast(&good, 1, MPI_INT, 0, parts_->ranks);
    return good != 0;
}

bool SparseLdlt::has_good_pivots() const {
    const auto& factor = *parts_->factor;
    if (parts_->common.status != CHOLMOD_OK || factor.minor < factor.n) return false;
    const auto* start = static_cast<const int*>(factor.p);
    const auto* value = static_cast<const double*>(factor.x);
    return std::all_of(start, start + factor.n,
                       [&](int first) { return std::isfinite(value[first]) && value[first] != 0.0; });
}

std::optional<PetscInt> SparseLdlt::negative_pivots() const {
    const auto& factor = *parts_->factor;
    const auto* start = static_cast<const int*>(factor.p);
    const auto* value = static_cast<const double*>(factor.x);
    auto negative =
        static_cast<PetscInt>(std::count_if(start, start + factor.n, [&](int first) { return value[first] < 0.0; }));
    MPI_Bcast(&negative, 1, MPIU_INT, 0, parts_->ranks);
    return negative;
}

void SparseLdlt::solve(Vec b, Vec x) {
    PetscInt begin = 0, end = 0;
    SOFT_PETSC(VecGetOwnershipRange(x, &begin, &end));
    if (parts_->is_shared()) {
        SOFT_PETSC(VecScatterBegin(parts_->to_all, b, parts_->all, INSERT_VALUES, SCATTER_FORWARD));
        SOFT_PETSC(VecScatterEnd(parts_->to_all, b, parts_->all, INSERT_VALUES, SCATTER_FORWARD));
        b = parts_->all;
    }
    const PetscScalar* from = nullptr;
    SOFT_PETSC(VecGetArrayRead(b, &from));
    cholmod_dense right{};
    right.nrow = right.d = right.nzmax = parts_->factor->n;
    right.ncol = 1;
    right.x = const_cast<PetscScalar*>(from);  // NOLINT(*-const-cast): CHOLMOD only reads it
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_solve2(CHOLMOD_A, parts_->factor, &right, nullptr, &parts_->x, nullptr, &parts_->y, &parts_->e,
                   &parts_->common);
    SOFT_PETSC(VecRestoreArrayRead(b, &from));
    parts_->check();
    PetscScalar* to = nullptr;
    SOFT_PETSC(VecGetArray(x, &to));
    std::copy_n(static_cast<const double*>(parts_->x->x) + begin, end - begin, to);
    SOFT_PETSC(VecRestoreArray(x, &to));
}

}  // namespace soft::linalg
