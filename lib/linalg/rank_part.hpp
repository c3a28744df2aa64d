#pragma once
/// A rank's part of a matrix on several ranks: its interior I, which no other rank touches, and the shared unknowns T that the
/// interior couples with. Internal to the module. Tested by linalg/substructures_test.
#include <vector>

#include "linalg/factors.hpp"
#include "linalg/matrix_rows.hpp"

namespace soft::linalg {

/// Numbers of the whole matrix, ascending, unless said otherwise.
struct PartLayout {
    PetscInt begin = 0, end = 0;       ///< the rank's own unknowns
    std::vector<PetscInt> shared;      ///< of all ranks: what couples with unknowns of a higher rank
    std::vector<PetscInt> own_shared;  ///< those of them that the rank owns
    std::vector<PetscInt> interior;    ///< the rank's own others
    std::vector<PetscInt> touched;     ///< T, as places in `shared`
};

/// What each rank gives, one after the other, on each.
template <class Value>
[[nodiscard]] std::vector<Value> gather_all(const std::vector<Value>& own, MPI_Datatype type, MPI_Comm ranks);
extern template std::vector<int> gather_all(const std::vector<int>&, MPI_Datatype, MPI_Comm);
extern template std::vector<double> gather_all(const std::vector<double>&, MPI_Datatype, MPI_Comm);

[[nodiscard]] PartLayout layout_of(Mat K, MPI_Comm ranks);

[[nodiscard]] IndexSet index_set(const std::vector<PetscInt>& indices);

/// The rows of [K_II K_IT; K_TI 0], numbered from 0: I, then T. A symmetric matrix gives the rows of I alone.
class PartRows {
public:
    PartRows(Mat K, const PartLayout& layout, Symmetry symmetry);
    ~PartRows();
    PartRows(const PartRows&) = delete;
    PartRows& operator=(const PartRows&) = delete;

    /// On all ranks.
    void read(Mat K);
    [[nodiscard]] MatrixRows rows() const {
        return {static_cast<PetscInt>(begin_.size()) - 1, begin_.data(), columns_.data(), values_.data()};
    }

private:
    void add_interior_rows(Mat K, const PartLayout& layout);
    void add_touched_rows(Mat K, const PartLayout& layout);

    std::vector<PetscInt> begin_{0}, columns_;
    std::vector<PetscInt> sources_;  // of the entries of I: place in the rank's own block, ~place in its other columns
    std::vector<double> values_;
    IndexSet touched_, interior_;
    Mat* touched_rows_ = nullptr;  // K_TI of a general matrix
};

}  // namespace soft::linalg
