#pragma once
/// Vectors of three components. Points of a mesh (mesh::Point) have the same type. Tested by math/tensor_test.
#include <array>
#include <cmath>

namespace soft {

using Vector3 = std::array<double, 3>;

[[nodiscard]] inline double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
[[nodiscard]] inline double norm(const Vector3& a) { return std::sqrt(dot(a, a)); }
[[nodiscard]] inline Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// a - b
[[nodiscard]] inline Vector3 difference(const Vector3& a, const Vector3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
/// p + t d
[[nodiscard]] inline Vector3 along(const Vector3& p, double t, const Vector3& d) {
    return {p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]};
}

}  // namespace soft
