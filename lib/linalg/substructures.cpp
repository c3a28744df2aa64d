#include "linalg/substructures.hpp"

#include <algorithm>

#include "linalg/dense_factor.hpp"
#include "linalg/elimination_order.hpp"
#include "linalg/interior_factor.hpp"
#include "linalg/rank_part.hpp"

namespace soft::linalg {

namespace {

using Indices = std::vector<PetscInt>;

bool all_agree(bool good, MPI_Comm ranks) {
    int all = good ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, ranks);
    return all != 0;
}

}  // namespace

struct Substructures::Parts {
    Vector like;  // keeps PETSc's communicator alive
    MPI_Comm ranks = MPI_COMM_SELF;
    Symmetry symmetry;
    PartLayout layout;
    Indices all_coupled;                            // of all ranks, concatenated
    std::vector<int> coupled_counts, owned_counts;  // per rank: coupled unknowns, owned shared unknowns
    std::unique_ptr<PartRows> part;
    IndexSet shared;
    Mat* shared_block = nullptr;  // K_GG
    std::unique_ptr<InteriorFactor> interior;
    DenseFactor complement;
    std::vector<double> values, x_shared;  // work space of solve()

    Parts(Mat K, Symmetry kind) : symmetry(kind), complement(kind) {
        SOFT_PETSC(MatCreateVecs(K, nullptr, like.out()));
        SOFT_PETSC(PetscObjectGetComm(reinterpret_cast<PetscObject>(like.get()), &ranks));
    }
    ~Parts() {
        if (shared_block != nullptr) (void)MatDestroySubMatrices(1, &shared_block);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    void read(Mat K, MatReuse reuse) {
        part->read(K);
        const IS set = shared;
        SOFT_PETSC(MatCreateSubMatrices(K, 1, &set, &set, reuse, &shared_block));
    }
    [[nodiscard]] std::vector<double> sum_of_complements() const;
};

/// S by columns: the shared block of K plus the contribution of each rank's interior, in rank order.
std::vector<double> Substructures::Parts::sum_of_complements() const {
    const std::size_t size = layout.shared.size();
    std::vector<double> S(size * size, 0.0);
    const MatrixRows rows = rows_of(shared_block[0]);
    for (PetscInt row = 0; row < rows.count; ++row)
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k)
            S[static_cast<std::size_t>(rows.columns[k]) * size + static_cast<std::size_t>(row)] += rows.values[k];
    const auto own = interior->schur();
    const auto all = gather_all(std::vector<double>(own.begin(), own.end()), MPI_DOUBLE, ranks);
    const double* value = all.data();
    const PetscInt* coupled = all_coupled.data();
    for (const int count : coupled_counts) {
        for (int column = 0; column < count; ++column)
            for (int row = 0; row < count; ++row)
                S[static_cast<std::size_t>(coupled[column]) * size + static_cast<std::size_t>(coupled[row])] +=
                    *value++;
        coupled += count;
    }
    return S;
}

std::unique_ptr<Substructures> Substructures::create(Mat K, Symmetry symmetry, std::vector<PetscInt>& order) {
    auto parts = std::make_unique<Parts>(K, symmetry);
    int size = 1;
    MPI_Comm_size(parts->ranks, &size);
    if (size == 1) return nullptr;
    parts->layout = layout_of(K, parts->ranks);
    const auto& layout = parts->layout;
    const bool useful = !layout.shared.empty() && layout.shared.size() <= max_shared_unknowns &&
                        !layout.interior.empty() && !layout.coupled.empty();
    if (!all_agree(useful, parts->ranks)) return nullptr;
    parts->all_coupled = gather_all(layout.coupled, MPIU_INT, parts->ranks);
    parts->coupled_counts =
        gather_all(std::vector<int>{static_cast<int>(layout.coupled.size())}, MPI_INT, parts->ranks);
    parts->owned_counts =
        gather_all(std::vector<int>{static_cast<int>(layout.own_shared.size())}, MPI_INT, parts->ranks);
    parts->part = std::make_unique<PartRows>(K, layout, symmetry);
    parts->shared = index_set(layout.shared);
    parts->read(K, MAT_INITIAL_MATRIX);
    const MatrixRows rows = parts->part->rows();
    if (order.empty()) order = elimination_order(rows, static_cast<PetscInt>(layout.interior.size()));
    parts->interior = std::make_unique<InteriorFactor>(symmetry, rows, layout.coupled.size(), order);
    return std::unique_ptr<Substructures>(new Substructures(std::move(parts)));
}

Substructures::Substructures(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Substructures::~Substructures() = default;

bool Substructures::factorize(Mat K) {
    parts_->read(K, MAT_REUSE_MATRIX);
    if (!all_agree(parts_->interior->factorize(parts_->part->rows()), parts_->ranks)) return false;
    const int size = static_cast<int>(parts_->layout.shared.size());
    return all_agree(parts_->complement.factorize(parts_->sum_of_complements(), size), parts_->ranks);
}

std::optional<PetscInt> Substructures::negative_pivots() const {
    if (parts_->symmetry == Symmetry::general) return std::nullopt;
    PetscInt negative = parts_->interior->negative_pivots();
    MPI_Allreduce(MPI_IN_PLACE, &negative, 1, MPIU_INT, MPI_SUM, parts_->ranks);
    PetscInt of_complement = parts_->complement.negative_eigenvalues();
    // Rank 0 decides, because last digits may differ between processor types.
    MPI_Bcast(&of_complement, 1, MPIU_INT, 0, parts_->ranks);
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
    const PartLayout& layout = parts_->layout;
    parts_->values.assign(layout.interior.size() + layout.coupled.size(), 0.0);
    const PetscScalar* from = nullptr;
    SOFT_PETSC(VecGetArrayRead(b, &from));
    for (std::size_t i = 0; i < layout.interior.size(); ++i)
        parts_->values[i] = from[layout.interior[i] - layout.begin];
    // Contribution of this rank: its part of the shared right-hand side, then the condensed interior.
    std::vector<double> given;
    for (const PetscInt unknown : layout.own_shared) given.push_back(from[unknown - layout.begin]);
    SOFT_PETSC(VecRestoreArrayRead(b, &from));
    const auto reduced = parts_->interior->condense(parts_->values);
    given.insert(given.end(), reduced.begin(), reduced.end());
    const auto all = gather_all(given, MPI_DOUBLE, parts_->ranks);

    auto& shared = parts_->x_shared;
    shared.assign(layout.shared.size(), 0.0);
    const double* value = all.data();
    const PetscInt* coupled = parts_->all_coupled.data();
    std::size_t next = 0;
    for (std::size_t rank = 0; rank < parts_->coupled_counts.size(); ++rank) {
        const int count = parts_->coupled_counts[rank];
        for (int i = 0; i < parts_->owned_counts[rank]; ++i) shared[next++] += *value++;
        for (int i = 0; i < count; ++i) shared[static_cast<std::size_t>(*coupled++)] += *value++;
    }
    parts_->complement.solve(shared);

    std::vector<double> x_coupled;
    for (const PetscInt i : layout.coupled) x_coupled.push_back(shared[static_cast<std::size_t>(i)]);
    parts_->interior->expand(x_coupled, parts_->values);
    PetscScalar* to = nullptr;
    SOFT_PETSC(VecGetArray(x, &to));
    for (std::size_t i = 0; i < layout.interior.size(); ++i) to[layout.interior[i] - layout.begin] = parts_->values[i];
    // The shared unknowns are ordered by rank.
    const auto begin = std::ranges::lower_bound(layout.shared, layout.begin) - layout.shared.begin();
    for (std::size_t i = 0; i < layout.own_shared.size(); ++i)
        to[layout.own_shared[i] - layout.begin] = shared[static_cast<std::size_t>(begin) + i];
    SOFT_PETSC(VecRestoreArray(x, &to));
}

}  // namespace soft::linalg
