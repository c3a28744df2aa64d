#pragma once
/// A rank's part of a distributed matrix: its interior unknowns I, which do not couple with unknowns of other ranks, and the shared
/// unknowns T that couple with the interior. Internal to the module. Tested by linalg/substructures_test.
#include <vector>

#include "linalg/factors.hpp"
#include "linalg/matrix_rows.hpp"

namespace soft::linalg {

/// Global indices, ascending, unless stated otherwise.
struct PartLayout {
    PetscInt begin = 0, end = 0;       ///< the rank's own unknowns
    std::vector<PetscInt> shared;      ///< of all ranks: unknowns that couple with unknowns of a higher rank
    std::vector<PetscInt> own_shared;  ///< shared unknowns that this rank owns
    std::vector<PetscInt> interior;    ///< the other unknowns that this rank owns
    std::vector<PetscInt> coupled;     ///< T, as indices into `shared`
};

/// The values of all ranks, concatenated in rank order, on every rank.
template <class Value>
[[nodiscard]] std::vector<Value> gather_all(const std::vector<Value>& own, MPI_Datatype type, MPI_Comm ranks);
extern template std::vector<int> gather_all(const std::vector<int>&, MPI_Datatype, MPI_Comm);
extern template std::vector<double> gather_all(const std::vector<double>&, MPI_Datatype, MPI_Comm);

[[nodiscard]] PartLayout layout_of(Mat K, MPI_Comm ranks);

[[nodiscard]] IndexSet index_set(const std::vector<PetscInt>& indices);

/// The rows of [K_II K_IT; K_TI 0], numbered from 0: first I, then T. For a symmetric matrix the rows of T are empty.
class PartRows {
public:
    PartRows(Mat K, const PartLayout& layout, Symmetry symmetry);
    ~PartRows();
    PartRows(const PartRows&) = delete;
    PartRows& operator=(const PartRows&) = delete;

    /// Collective.
    void read(Mat K);
    [[nodiscard]] MatrixRows rows() const {
        return {static_cast<PetscInt>(begin_.size()) - 1, begin_.data(), columns_.data(), values_.data()};
    }

private:
    void add_interior_rows(Mat K, const PartLayout& layout);
    void add_coupled_rows(Mat K, const PartLayout& layout);

    std::vector<PetscInt> begin_{0}, columns_;
    /// Of the entries of I: index k in the rank's diagonal block, ~k in its off-diagonal block.
    std::vector<PetscInt> sources_;
    std::vector<double> values_;
    IndexSet coupled_, interior_;
    Mat* coupled_rows_ = nullptr;  // K_TI, general matrices only
};

}  // namespace soft::linalg
