#include "post/local_state.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/spectral.hpp"

namespace soft::post {

PrincipalStretches principal_stretches(const Tensor& deformation_gradient) {
    const Spectral b = spectral_form(left_cauchy_green(deformation_gradient));
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::sort(order, [&](std::size_t i, std::size_t j) { return b.value[i] > b.value[j]; });
    PrincipalStretches principal;
    for (std::size_t a = 0; a < 3; ++a) {
        principal.stretch[a] = std::sqrt(std::max(b.value[order[a]], 0.0));
        Vector3& n = principal.direction[a];
        for (std::size_t i = 0; i < 3; ++i) n[i] = b.vector[3 * i + order[a]];
        const double largest = *std::ranges::max_element(n, {}, [](double x) { return std::abs(x); });
        if (largest < 0.0)
            for (double& component : n) component = -component;
    }
    return principal;
}

double von_mises_Pa(const Tensor& cauchy_Pa) {
    const double mean = trace(cauchy_Pa) / 3.0;
    double squares = 0;
    for (std::size_t i = 0; i < 9; ++i) {
        const double deviator = cauchy_Pa[i] - (i % 4 == 0 ? mean : 0.0);
        squares += deviator * deviator;
    }
    return std::sqrt(1.5 * squares);
}

double pressure_Pa(const Tensor& cauchy_Pa) { return -trace(cauchy_Pa) / 3.0; }

}  // namespace soft::post
