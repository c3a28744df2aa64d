#pragma once
/// Spectral form of a symmetric tensor, S = sum_a value_a n_a (x) n_a, by cyclic Jacobi rotations. Values and vectors are accurate
/// to rounding, also for equal values. Source: Golub and Van Loan, Matrix Computations (2013), 8.5. Tested by math/spectral_test.
#include <array>

#include "math/tensor.hpp"

namespace soft {

struct Spectral {
    std::array<double, 3> value{};  ///< eigenvalues, unsorted
    Tensor vector{};                ///< n_a is column a: vector[3 i + a]; orthonormal
};

[[nodiscard]] Spectral spectral_form(const Tensor& symmetric);

}  // namespace soft
