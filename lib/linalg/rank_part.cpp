#include "linalg/rank_part.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace soft::linalg {

namespace {

using Indices = std::vector<PetscInt>;

std::size_t at(PetscInt index) { return static_cast<std::size_t>(index); }

/// Diagonal and off-diagonal block of a distributed matrix.
struct Blocks {
    Mat own = nullptr, other = nullptr;
    const PetscInt* other_columns = nullptr;  // global indices, ascending

    explicit Blocks(Mat K) { SOFT_PETSC(MatMPIAIJGetSeqAIJ(K, &own, &other, &other_columns)); }
};

PetscInt index_of(const Indices& sorted, PetscInt value) {
    const auto found = std::ranges::lower_bound(sorted, value);
    return found != sorted.end() && *found == value ? static_cast<PetscInt>(found - sorted.begin()) : -1;
}

Indices global_indices(const Indices& local, const Indices& shared) {
    Indices global;
    for (const PetscInt i : local) global.push_back(shared[at(i)]);
    return global;
}

}  // namespace

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
template std::vector<int> gather_all(const std::vector<int>&, MPI_Datatype, MPI_Comm);
template std::vector<double> gather_all(const std::vector<double>&, MPI_Datatype, MPI_Comm);

PartLayout layout_of(Mat K, MPI_Comm ranks) {
    PartLayout layout;
    SOFT_PETSC(MatGetOwnershipRange(K, &layout.begin, &layout.end));
    const Blocks blocks(K);
    const MatrixRows own = rows_of(blocks.own), other = rows_of(blocks.other);
    std::vector<bool> is_shared(at(other.count), false);
    for (PetscInt row = 0; row < other.count; ++row) {
        const bool couples_upward =
            std::any_of(other.columns + other.begin[row], other.columns + other.begin[row + 1],
                        [&](PetscInt column) { return blocks.other_columns[column] >= layout.end; });
        is_shared[at(row)] = couples_upward;
        (couples_upward ? layout.own_shared : layout.interior).push_back(layout.begin + row);
    }
    layout.shared = gather_all(layout.own_shared, MPIU_INT, ranks);
    Indices coupled;
    for (const PetscInt unknown : layout.interior) {
        const PetscInt row = unknown - layout.begin;
        for (PetscInt k = own.begin[row]; k < own.begin[row + 1]; ++k)
            if (is_shared[at(own.columns[k])]) coupled.push_back(layout.begin + own.columns[k]);
        for (PetscInt k = other.begin[row]; k < other.begin[row + 1]; ++k)
            coupled.push_back(blocks.other_columns[other.columns[k]]);
    }
    std::ranges::sort(coupled);
    coupled.erase(std::unique(coupled.begin(), coupled.end()), coupled.end());
    // The lower rank stores every coupling too, because the pattern of K is symmetric.
    for (const PetscInt unknown : coupled)
        if (const PetscInt i = index_of(layout.shared, unknown); i >= 0) layout.coupled.push_back(i);
    return layout;
}

IndexSet index_set(const Indices& indices) {
    IndexSet set;
    SOFT_PETSC(ISCreateGeneral(PETSC_COMM_SELF, static_cast<PetscInt>(indices.size()), indices.data(),
                               PETSC_COPY_VALUES, set.out()));
    return set;
}

PartRows::PartRows(Mat K, const PartLayout& layout, Symmetry symmetry) {
    add_interior_rows(K, layout);
    if (symmetry == Symmetry::general)
        add_coupled_rows(K, layout);
    else
        begin_.insert(begin_.end(), layout.coupled.size(), begin_.back());
    values_.assign(columns_.size(), 0.0);
}

PartRows::~PartRows() {
    if (coupled_rows_ != nullptr) (void)MatDestroySubMatrices(1, &coupled_rows_);
}

void PartRows::add_interior_rows(Mat K, const PartLayout& layout) {
    const Blocks blocks(K);
    const MatrixRows own = rows_of(blocks.own), other = rows_of(blocks.other);
    const auto interior = static_cast<PetscInt>(layout.interior.size());
    const Indices coupled = global_indices(layout.coupled, layout.shared);
    const auto number_of_coupled = [&](PetscInt unknown) {
        const PetscInt i = index_of(coupled, unknown);
        return i < 0 ? i : interior + i;
    };
    Indices number(at(own.count), -1);  // local index of the rank's own unknowns
    for (PetscInt i = 0; i < interior; ++i) number[at(layout.interior[at(i)] - layout.begin)] = i;
    for (const PetscInt unknown : layout.own_shared) number[at(unknown - layout.begin)] = number_of_coupled(unknown);
    columns_.reserve(at(own.begin[own.count] + other.begin[other.count]));
    sources_.reserve(columns_.capacity());
    std::vector<std::pair<PetscInt, PetscInt>> tail;  // index and source of the columns after the interior
    for (const PetscInt unknown : layout.interior) {
        const PetscInt row = unknown - layout.begin;
        tail.clear();
        for (PetscInt k = own.begin[row]; k < own.begin[row + 1]; ++k) {
            const PetscInt column = number[at(own.columns[k])];
            if (column >= interior) {
                tail.emplace_back(column, k);
                continue;
            }
            columns_.push_back(column);
            sources_.push_back(k);
        }
        for (PetscInt k = other.begin[row]; k < other.begin[row + 1]; ++k)
            if (const PetscInt column = number_of_coupled(blocks.other_columns[other.columns[k]]); column >= 0)
                tail.emplace_back(column, ~k);
        std::ranges::sort(tail);
        for (const auto& [column, source] : tail) {
            columns_.push_back(column);
            sources_.push_back(source);
        }
        begin_.push_back(static_cast<PetscInt>(columns_.size()));
    }
}

void PartRows::add_coupled_rows(Mat K, const PartLayout& layout) {
    coupled_ = index_set(global_indices(layout.coupled, layout.shared));
    interior_ = index_set(layout.interior);
    const IS rows = coupled_, columns = interior_;
    SOFT_PETSC(MatCreateSubMatrices(K, 1, &rows, &columns, MAT_INITIAL_MATRIX, &coupled_rows_));
    const MatrixRows coupled = rows_of(coupled_rows_[0]);
    const PetscInt before = begin_.back();
    columns_.insert(columns_.end(), coupled.columns, coupled.columns + coupled.begin[coupled.count]);
    for (PetscInt row = 1; row <= coupled.count; ++row) begin_.push_back(before + coupled.begin[row]);
}

void PartRows::read(Mat K) {
    const Blocks blocks(K);
    const double *own = rows_of(blocks.own).values, *other = rows_of(blocks.other).values;
    for (std::size_t k = 0; k < sources_.size(); ++k)
        values_[k] = sources_[k] >= 0 ? own[sources_[k]] : other[~sources_[k]];
    if (coupled_rows_ == nullptr) return;
    const IS rows = coupled_, columns = interior_;
    SOFT_PETSC(MatCreateSubMatrices(K, 1, &rows, &columns, MAT_REUSE_MATRIX, &coupled_rows_));
    const MatrixRows coupled = rows_of(coupled_rows_[0]);
    std::copy_n(coupled.values, coupled.begin[coupled.count], values_.data() + sources_.size());
}

}  // namespace soft::linalg
