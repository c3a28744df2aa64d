#include "linalg/interior_factor.hpp"

#include <dmumps_c.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>

#include "core/error.hpp"
#include "linalg/mumps.hpp"

namespace soft::linalg {

namespace {

static_assert(sizeof(PetscInt) == sizeof(MUMPS_INT), "MUMPS takes the indices of PETSc");

enum Job : MUMPS_INT { begin = -1, end = -2, analysis = 1, factorization = 2, solution = 3 };

/// MUMPS may need more work space for pivoting than estimated: each attempt doubles it.
constexpr int max_work_space_attempts = 3;
constexpr std::array work_space_errors{-8, -9, -14, -15};

}  // namespace

struct InteriorFactor::Mumps {
    DMUMPS_STRUC_C id{};
    std::vector<MUMPS_INT> rows, columns, shared;
    std::vector<double> values;

    explicit Mumps(Symmetry symmetry) {
        id.sym = symmetry == Symmetry::symmetric ? 2 : 0;
        id.par = 1;
        id.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_SELF));
        call(begin);
        for (const int stream : {1, 2, 3}) control(stream) = -1;
        control(4) = 0;
        control(6) = 0;  // as set_mumps in preconditioner.cpp: the order depends on the pattern only
        control(12) = 1;
        control(14) = mumps_work_space;
        control(19) = 3;  // the whole Schur complement, by columns
        control(24) = 1;  // report zero pivots; with a Schur complement MUMPS ignores them silently otherwise
        control(33) = 1;  // the determinant
        read_options();
    }
    ~Mumps() { call(end); }
    Mumps(const Mumps&) = delete;
    Mumps& operator=(const Mumps&) = delete;

    /// Applies -mat_mumps_icntl_N and -mat_mumps_cntl_N as PETSc does, except for the controls that this class depends on.
    void read_options() {
        constexpr std::array fixed{5, 7, 18, 19, 24, 26, 33};
        for (int number = 1; number <= static_cast<int>(std::size(id.icntl)); ++number) {
            if (std::ranges::find(fixed, number) != fixed.end()) continue;
            const std::string option = "-mat_mumps_icntl_" + std::to_string(number);
            PetscInt value = control(number);
            SOFT_PETSC(PetscOptionsGetInt(nullptr, nullptr, option.c_str(), &value, nullptr));
            control(number) = value;
        }
        for (int number = 1; number <= static_cast<int>(std::size(id.cntl)); ++number) {
            const std::string option = "-mat_mumps_cntl_" + std::to_string(number);
            SOFT_PETSC(PetscOptionsGetReal(nullptr, nullptr, option.c_str(), &id.cntl[number - 1], nullptr));
        }
    }

    MUMPS_INT& control(int number) { return id.icntl[number - 1]; }
    void call(Job job) {
        id.job = job;
        dmumps_c(&id);
    }
    [[nodiscard]] MUMPS_INT status() const { return id.infog[0]; }
    void require_success(const char* what) const {
        require_mumps_memory(status());
        if (status() < 0)
            throw Error(ExitCode::internal, std::string("MUMPS, ") + what, "status " + std::to_string(status()));
    }
};

InteriorFactor::InteriorFactor(Symmetry symmetry, const MatrixRows& rows, std::size_t shared,
                               std::span<const PetscInt> order)
    : symmetry_(symmetry),
      schur_(shared * shared, 0.0),
      reduced_(shared, 0.0),
      mumps_(std::make_unique<Mumps>(symmetry)) {
    const PetscInt interior = rows.count - static_cast<PetscInt>(shared);
    for (PetscInt i = interior; i < rows.count; ++i) mumps_->shared.push_back(i + 1);
    const auto max_entries = static_cast<std::size_t>(rows.begin[rows.count]);
    for (auto* indices : {&mumps_->rows, &mumps_->columns}) indices->reserve(max_entries);
    for (PetscInt row = 0; row < rows.count; ++row)
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k) {
            if (!is_stored(row, rows.columns[k])) continue;
            mumps_->rows.push_back(row + 1);
            mumps_->columns.push_back(rows.columns[k] + 1);
        }
    mumps_->values.assign(mumps_->rows.size(), 0.0);
    auto& id = mumps_->id;
    id.n = static_cast<MUMPS_INT>(rows.count);
    id.nnz = static_cast<MUMPS_INT8>(mumps_->rows.size());
    id.irn = mumps_->rows.data();
    id.jcn = mumps_->columns.data();
    id.a = mumps_->values.data();
    id.size_schur = static_cast<MUMPS_INT>(shared);
    id.listvar_schur = mumps_->shared.data();
    id.nprow = id.npcol = 1;
    id.mblock = id.nblock = 100;
    id.schur = schur_.data();
    id.schur_lld = id.size_schur;
    std::vector<MUMPS_INT> positions(order.begin(), order.end());
    for (MUMPS_INT& position : positions) ++position;
    mumps_->control(7) = 1;  // user-provided order: with a Schur complement MUMPS supports only AMD itself
    id.perm_in = positions.data();
    mumps_->call(analysis);
    id.perm_in = nullptr;
    mumps_->require_success("ordering of a rank's part");
}

InteriorFactor::~InteriorFactor() = default;

void InteriorFactor::read_values(const MatrixRows& rows) {
    double* value = mumps_->values.data();
    for (PetscInt row = 0; row < rows.count; ++row)
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k)
            if (is_stored(row, rows.columns[k])) *value++ = rows.values[k];
}

bool InteriorFactor::factorize(const MatrixRows& rows) {
    read_values(rows);
    for (int attempt = 1;; ++attempt) {
        std::ranges::fill(schur_, 0.0);
        mumps_->call(factorization);
        const bool lacks_space = std::ranges::find(work_space_errors, mumps_->status()) != work_space_errors.end();
        if (!lacks_space || attempt == max_work_space_attempts) break;
        mumps_->control(14) *= 2;
    }
    require_mumps_memory(mumps_->status());
    constexpr int vanishing_pivots = 28;  // INFOG
    return mumps_->status() >= 0 && mumps_->id.infog[vanishing_pivots - 1] == 0;
}

PetscInt InteriorFactor::negative_pivots() const { return mumps_->id.infog[11]; }

bool InteriorFactor::determinant_is_negative() const { return mumps_->id.rinfog[11] < 0.0; }

std::span<const double> InteriorFactor::condense(std::span<double> values) {
    auto& id = mumps_->id;
    id.rhs = values.data();
    id.nrhs = 1;
    id.lrhs = id.n;
    id.redrhs = reduced_.data();
    id.lredrhs = id.size_schur;
    mumps_->control(26) = 1;
    mumps_->call(solution);
    mumps_->require_success("condensing");
    return reduced_;
}

void InteriorFactor::expand(std::span<const double> x_shared, std::span<double> values) {
    std::ranges::copy(x_shared, reduced_.begin());
    mumps_->id.rhs = values.data();
    mumps_->control(26) = 2;
    mumps_->call(solution);
    mumps_->require_success("expanding");
}

}  // namespace soft::linalg
