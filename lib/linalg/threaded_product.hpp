#pragma once
/// Products y = K x of a sequential matrix by several threads. Each row is summed by one thread in the same order, so that the
/// result does not depend on the number of threads. Tested by linalg/threaded_product_test.
#include <vector>

#include "linalg/petsc.hpp"

namespace soft::linalg {

/// The number of entries from which on threads are faster.
inline constexpr PetscInt entries_of_threaded_product = 1'000'000;

class ThreadedProduct {
public:
    /// Multiplies by the current values of K, which must outlive it with its pattern. `threads`: math/threads.hpp.
    ThreadedProduct(Mat K, int threads);
    ThreadedProduct(const ThreadedProduct&) = delete;
    ThreadedProduct& operator=(const ThreadedProduct&) = delete;
    ~ThreadedProduct() = default;

    [[nodiscard]] Mat operation() const noexcept { return operation_; }  ///< has no other operation

private:
    static PetscErrorCode multiply(Mat operation, Vec from, Vec to);

    Mat K_;
    int threads_;
    std::vector<PetscInt> first_row_;  // of each group of rows with the same columns, and one past the last
    Matrix operation_;
};

}  // namespace soft::linalg
