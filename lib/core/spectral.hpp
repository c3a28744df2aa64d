#pragma once
/// Spectral form of a symmetric tensor, S = sum_a value_a n_a (x) n_a, by cyclic Jacobi rotations: values and vectors to
/// rounding also where values coincide. Source: Golub and Van Loan, Matrix Computations (2013), 8.5. Held by
/// core/spectral_test.
#include <array>

#include "core/tensor.hpp"

namespace soft {

struct Spectral {
    std::array<double, 3> value{};  ///< in no order
    Tensor vector{};                ///< n_a is column a: vector[3 i + a]; orthonormal
};

[[nodiscard]] Spectral spectral_form(const Tensor& symmetric);

}  // namespace soft
