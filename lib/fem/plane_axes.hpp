#pragma once
/// Two unit vectors perpendicular to an axis, right-handed with it. Tested by fem/loads_test, fem/face_shape_test.
#include <array>
#include <cmath>

#include "math/tensor.hpp"

namespace soft::fem {

[[nodiscard]] inline std::array<Vector3, 2> plane_axes(const Vector3& e) {
    std::size_t smallest = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(e[i]) < std::abs(e[smallest])) smallest = i;
    Vector3 first{};
    first[smallest] = 1.0;
    double norm = 0;
    for (std::size_t i = 0; i < 3; ++i) first[i] -= e[smallest] * e[i];
    for (const double f : first) norm += f * f;
    for (double& f : first) f /= std::sqrt(norm);
    return {first, cross(e, first)};
}

}  // namespace soft::fem
