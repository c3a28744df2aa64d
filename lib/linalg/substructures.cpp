#include "linalg/substructures.hpp"

#include <algorithm>
#include <numeric>

#include "linalg/dense_factor.hpp"
#include "linalg/interior_factor.hpp"
#include "linalg/matrix_rows.hpp"

namespace soft::linalg {

namespace {

using Indices = std::vector<PetscInt>;

/// What each rank gives, one after the other, on each.
template <class Value>
std::vector<Value> gather_all(const std::vector<Value>& own, MPI_Datatype type, MPI_Comm ranks) {
    int size = 1;
    MPI_Comm_size(ranks, &size);
    const int count = static_cast<int>(own.size());
    std::vector<int> counts(static_cast<std::size_t>(size)), begins(static_cast<std::size_t>(size));
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, ranks);
    std::exclusive_scan(counts.begin(), counts.end(), begins.begin(), 0);
    std::vector<Value> all(static_cast<std::size_t>(begins.back() + counts.back()));
    MPI_Allgatherv(own.data(), count, type, all.data(), counts.data(), begins.data(), type, ranks);
    return all;
}

bool all_agree(bool good, MPI_Comm ranks) {
    int all = good ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, ranks);
    return all != 0;
}

PetscInt place_of(const Indices& sorted, PetscInt value) {
    const auto found = std::ranges::lower_bound(sorted, value);
    return found != sorted.end() && *found == value ? static_cast<PetscInt>(found - sorted.begin()) : -1;
}

struct Layout {
    PetscInt begin = 0, end = 0;  // the rank's own unknowns
    Indices shared;               // G, of all ranks, ascending
    Indices own_shared;           // those of them that the rank owns
    Indices touched;              // places in `shared` of those that the interior couples with
    Indices part;                 // the interior and what it touches, ascending
    Indices touched_in_part;
};

/// The blocks of a matrix on several ranks.
struct Blocks {
    Mat own = nullptr, other = nullptr;
    const PetscInt* other_columns = nullptr;  // in the whole matrix

    explicit Blocks(Mat K) { SOFT_PETSC(MatMPIAIJGetSeqAIJ(K, &own, &other, &other_columns)); }
};

Layout layout_of(Mat K, MPI_Comm ranks) {
    Layout layout;
    SOFT_PETSC(MatGetOwnershipRange(K, &layout.begin, &layout.end));
    const Blocks blocks(K);
    const MatrixRows own = rows_of(blocks.own), other = rows_of(blocks.other);
    for (PetscInt row = 0; row < other.count; ++row) {
        const bool couples_upward =
            std::any_of(other.columns + other.begin[row], other.columns + other.begin[row + 1],
                        [&](PetscInt column) { return blocks.other_columns[column] >= layout.end; });
        if (couples_upward) layout.own_shared.push_back(layout.begin + row);
    }
    layout.shared = gather_all(layout.own_shared, MPIU_INT, ranks);
    std::vector<bool> is_touched(layout.shared.size(), false);
    const auto touch = [&](PetscInt unknown) {
        const PetscInt place = place_of(layout.shared, unknown);
        if (place >= 0) is_touched[static_cast<std::size_t>(place)] = true;
    };
    for (PetscInt row = 0; row < own.count; ++row) {
        if (place_of(layout.own_shared, layout.begin + row) >= 0) continue;
        layout.part.push_back(layout.begin + row);
        for (PetscInt k = own.begin[row]; k < own.begin[row + 1]; ++k) touch(layout.begin + own.columns[k]);
        for (PetscInt k = other.begin[row]; k < other.begin[row + 1]; ++k)
            touch(blocks.other_columns[other.columns[k]]);
    }
    for (std::size_t i = 0; i < is_touched.size(); ++i)
        if (is_touched[i]) layout.touched.push_back(static_cast<PetscInt>(i));
    for (const PetscInt i : layout.touched) layout.part.push_back(layout.shared[static_cast<std::size_t>(i)]);
    std::ranges::sort(layout.part);
    for (const PetscInt i : layout.touched)
        layout.touched_in_part.push_back(place_of(layout.part, layout.shared[static_cast<std::size_t>(i)]));
    return layout;
}

IndexSet index_set(const Indices& indices) {
    IndexSet set;
    SOFT_PETSC(ISCreateGeneral(PETSC_COMM_SELF, static_cast<PetscInt>(indices.size()), indices.data(),
                               PETSC_COPY_VALUES, set.out()));
    return set;
}

}  // namespace

struct Substructures::Parts {
    Vector like;  // keeps the ranks' communicator, which is PETSc's own
    MPI_Comm ranks = MPI_COMM_SELF;
    Symmetry symmetry;
    Layout layout;
    Indices all_touched;                            // of all ranks, one after the other
    std::vector<int> touched_counts, owned_counts;  // of touched, of shared unknowns that a rank owns
    IndexSet part, shared;
    Mat* blocks = nullptr;  // of K: the rank's part, the shared unknowns
    std::unique_ptr<InteriorFactor> interior;
    DenseFactor complement;
    std::vector<double> values, x_shared;  // of a solve

    Parts(Mat K, Symmetry kind) : symmetry(kind), complement(kind) {
        SOFT_PETSC(MatCreateVecs(K, nullptr, like.out()));
        SOFT_PETSC(PetscObjectGetComm(reinterpret_cast<PetscObject>(like.get()), &ranks));
    }
    ~Parts() {
        if (blocks != nullptr) (void)MatDestroySubMatrices(2, &blocks);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    void read(Mat K, MatReuse reuse) {
        const IS sets[] = {part, shared};
        SOFT_PETSC(MatCreateSubMatrices(K, 2, sets, sets, reuse, &blocks));
    }
    [[nodiscard]] std::vector<double> sum_of_complements() const;
};

/// S by columns: the shared block of K, and what each rank's interior adds, in the order of the ranks.
std::vector<double> Substructures::Parts::sum_of_complements() const {
    const std::size_t size = layout.shared.size();
    std::vector<double> S(size * size, 0.0);
    const MatrixRows rows = rows_of(blocks[1]);
    for (PetscInt row = 0; row < rows.count; ++row)
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k)
            S[static_cast<std::size_t>(rows.columns[k]) * size + static_cast<std::size_t>(row)] += rows.values[k];
    const auto own = interior->schur();
    const auto all = gather_all(std::vector<double>(own.begin(), own.end()), MPI_DOUBLE, ranks);
    const double* value = all.data();
    const PetscInt* touched = all_touched.data();
    for (const int count : touched_counts) {
        for (int column = 0; column < count; ++column)
            for (int row = 0; row < count; ++row)
                S[static_cast<std::size_t>(touched[column]) * size + static_cast<std::size_t>(touched[row])] +=
                    *value++;
        touched += count;
    }
    return S;
}

std::unique_ptr<Substructures> Substructures::of(Mat K, Symmetry symmetry) {
    auto parts = std::make_unique<Parts>(K, symmetry);
    int size = 1;
    MPI_Comm_size(parts->ranks, &size);
    if (size == 1) return nullptr;
    parts->layout = layout_of(K, parts->ranks);
    const auto& layout = parts->layout;
    const bool useful = !layout.shared.empty() && layout.shared.size() <= most_shared_unknowns &&
                        layout.part.size() > layout.touched.size() && !layout.touched.empty();
    if (!all_agree(useful, parts->ranks)) return nullptr;
    parts->all_touched = gather_all(layout.touched, MPIU_INT, parts->ranks);
    parts->touched_counts =
        gather_all(std::vector<int>{static_cast<int>(layout.touched.size())}, MPI_INT, parts->ranks);
    parts->owned_counts =
        gather_all(std::vector<int>{static_cast<int>(layout.own_shared.size())}, MPI_INT, parts->ranks);
    parts->part = index_set(layout.part);
    parts->shared = index_set(layout.shared);
    parts->read(K, MAT_INITIAL_MATRIX);
    parts->interior = std::make_unique<InteriorFactor>(symmetry, rows_of(parts->blocks[0]), layout.touched_in_part);
    return std::unique_ptr<Substructures>(new Substructures(std::move(parts)));
}

Substructures::Substructures(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Substructures::~Substructures() = default;

bool Substructures::factorize(Mat K) {
    parts_->read(K, MAT_REUSE_MATRIX);
    if (!all_agree(parts_->interior->factorize(rows_of(parts_->blocks[0])), parts_->ranks)) return false;
    const int size = static_cast<int>(parts_->layout.shared.size());
    return all_agree(parts_->complement.factorize(parts_->sum_of_complements(), size), parts_->ranks);
}

std::optional<PetscInt> Substructures::negative_pivots() const {
    if (parts_->symmetry == Symmetry::general) return std::nullopt;
    PetscInt negative = parts_->interior->negative_pivots();
    MPI_Allreduce(MPI_IN_PLACE, &negative, 1, MPIU_INT, MPI_SUM, parts_->ranks);
    PetscInt of_complement = parts_->complement.negative_eigenvalues();
    MPI_Bcast(&of_complement, 1, MPIU_INT, 0, parts_->ranks);  // on unlike processors last digits differ
    return negative + of_complement;
}

std::optional<bool> Substructures::determinant_is_negative() const {
    if (parts_->symmetry == Symmetry::symmetric) return std::nullopt;
    int signs = parts_->interior->determinant_is_negative() ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &signs, 1, MPI_INT, MPI_SUM, parts_->ranks);
    int of_complement = parts_->complement.determinant_is_negative() ? 1 : 0;
    MPI_Bcast(&of_complement, 1, MPI_INT, 0, parts_->ranks);
    return (signs + of_complement) % 2 != 0;
}

void Substructures::solve(Vec b, Vec x) {
    const Layout& layout = parts_->layout;
    const auto own = [&](PetscInt unknown) { return unknown >= layout.begin && unknown < layout.end; };
    parts_->values.assign(layout.part.size(), 0.0);
    const PetscScalar* from = nullptr;
    SOFT_PETSC(VecGetArrayRead(b, &from));
    for (std::size_t i = 0; i < layout.part.size(); ++i)
        if (own(layout.part[i])) parts_->values[i] = from[layout.part[i] - layout.begin];
    for (const PetscInt i : layout.touched_in_part) parts_->values[static_cast<std::size_t>(i)] = 0.0;
    // What a rank gives: its own part of the shared right-hand side, then what its interior adds.
    std::vector<double> given;
    for (const PetscInt unknown : layout.own_shared) given.push_back(from[unknown - layout.begin]);
    SOFT_PETSC(VecRestoreArrayRead(b, &from));
    const auto reduced = parts_->interior->condense(parts_->values);
    given.insert(given.end(), reduced.begin(), reduced.end());
    const auto all = gather_all(given, MPI_DOUBLE, parts_->ranks);

    auto& shared = parts_->x_shared;
    shared.assign(layout.shared.size(), 0.0);
    const double* value = all.data();
    const PetscInt* touched = parts_->all_touched.data();
    std::size_t next = 0;
    for (std::size_t rank = 0; rank < parts_->touched_counts.size(); ++rank) {
        const int count = parts_->touched_counts[rank];
        for (int i = 0; i < parts_->owned_counts[rank]; ++i) shared[next++] += *value++;
        for (int i = 0; i < count; ++i) shared[static_cast<std::size_t>(*touched++)] += *value++;
    }
    parts_->complement.solve(shared);

    std::vector<double> x_touched;
    for (const PetscInt i : layout.touched) x_touched.push_back(shared[static_cast<std::size_t>(i)]);
    parts_->interior->expand(x_touched, parts_->values);
    PetscScalar* to = nullptr;
    SOFT_PETSC(VecGetArray(x, &to));
    for (std::size_t i = 0; i < layout.part.size(); ++i)
        if (own(layout.part[i])) to[layout.part[i] - layout.begin] = parts_->values[i];
    for (const PetscInt unknown : layout.own_shared)
        to[unknown - layout.begin] = shared[static_cast<std::size_t>(place_of(layout.shared, unknown))];
    SOFT_PETSC(VecRestoreArray(x, &to));
}

}  // namespace soft::linalg
