#include "fem/face_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/circle_fit.hpp"
#include "fem/plane_axes.hpp"
#include "linalg/small_matrix.hpp"
#include "math/spectral.hpp"

namespace soft::fem {

namespace {

using linalg::SmallMatrix;
using Points = std::vector<Vector3>;

double sum_of(const std::vector<double>& weights) { return std::accumulate(weights.begin(), weights.end(), 0.0); }

Vector3 mean_of(const Points& points, const std::vector<double>& weights) {
    Vector3 mean{};
    for (std::size_t a = 0; a < points.size(); ++a)
        for (std::size_t i = 0; i < 3; ++i) mean[i] += weights[a] * points[a][i];
    for (double& m : mean) m /= sum_of(weights);
    return mean;
}

Vector3 across_of(const Vector3& p, const Vector3& d) {
    const double along = dot(p, d);
    return {p[0] - along * d[0], p[1] - along * d[1], p[2] - along * d[2]};
}

double radial(const FaceShape& shape, const Points& x, Points* gradient) {
    const double area = sum_of(shape.weights);
    double sum = 0;
    for (std::size_t a = 0; a < x.size(); ++a) {
        const Vector3 here = across_of(x[a], shape.direction), there = across_of(shape.X[a], shape.direction);
        const double distance = std::sqrt(dot(here, here));
        sum += shape.weights[a] * (distance - std::sqrt(dot(there, there)));
        for (std::size_t i = 0; i < 3 && gradient != nullptr && distance > 0; ++i)  // zero gradient on the axis
            (*gradient)[a][i] = shape.weights[a] / area * here[i] / distance;
    }
    return sum / area;
}

/// Horn's matrix of S = sum w X x^T: the eigenvector of its largest eigenvalue is the unit quaternion of the rotation.
SmallMatrix horn(const Tensor& S) {
    SmallMatrix N(4);
    const std::array<double, 3> skew{S[5] - S[7], S[6] - S[2], S[1] - S[3]};
    N.at(0, 0) = trace(S);
    for (int i = 0; i < 3; ++i) {
        N.at(0, i + 1) = N.at(i + 1, 0) = skew[static_cast<std::size_t>(i)];
        for (int j = 0; j < 3; ++j)
            N.at(i + 1, j + 1) = S[static_cast<std::size_t>(3 * i + j)] + S[static_cast<std::size_t>(3 * j + i)] -
                                 (i == j ? trace(S) : 0.0);
    }
    return N;
}

double form(const std::array<double, 4>& y, const SmallMatrix& N, const std::array<double, 4>& q) {
    double sum = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) sum += y[static_cast<std::size_t>(i)] * N.at(i, j) * q[static_cast<std::size_t>(j)];
    return sum;
}

/// The component of the rotation vector of a unit quaternion q, q[0] >= 0, and its derivative by q.
double rotation_of(const std::array<double, 4>& q, const Vector3& d, std::array<double, 4>& by_q) {
    const Vector3 v{q[1], q[2], q[3]};
    const double s = std::sqrt(dot(v, v)), along = dot(v, d);
    constexpr double series_below = 1e-4;  // the next term is s^2 smaller
    const double half = std::atan2(s, q[0]);
    const double factor = s > series_below ? 2 * half / s : 2 + s * s / 3;
    const double by_length = s > series_below ? 2 * (q[0] - half / s) / (s * s) : -4.0 / 3.0;
    by_q = {-2 * along, 0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) by_q[i + 1] = factor * d[i] + along * by_length * v[i];
    return factor * along;
}

double rotation(const FaceShape& shape, const Points& x, Points* gradient) {
    const Vector3 mean_X = mean_of(shape.X, shape.weights), mean_x = mean_of(x, shape.weights);
    Tensor S{};
    for (std::size_t a = 0; a < x.size(); ++a) {
        const Vector3 there = difference(shape.X[a], mean_X), here = difference(x[a], mean_x);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) S[3 * i + j] += shape.weights[a] * there[i] * here[j];
    }
    const auto eigen = linalg::symmetric_eigen(horn(S));
    const auto vector = [&](int k) {
        std::array<double, 4> v{};
        for (int i = 0; i < 4; ++i) v[static_cast<std::size_t>(i)] = eigen.vectors.at(k, i);
        return v;
    };
    std::array<double, 4> q = vector(3), by_q{}, y{};
    if (q[0] < 0)
        for (double& component : q) component = -component;
    const double value = rotation_of(q, shape.direction, by_q);
    if (gradient == nullptr) return value;
    for (int k = 0; k < 3; ++k) {
        const auto v = vector(k);
        const double share = std::inner_product(v.begin(), v.end(), by_q.begin(), 0.0) /
                             (eigen.values[3] - eigen.values[static_cast<std::size_t>(k)]);
        for (std::size_t i = 0; i < 4; ++i) y[i] += share * v[i];
    }
    Tensor by_S{};
    for (std::size_t k = 0; k < 9; ++k) {
        Tensor unit{};
        unit[k] = 1;
        by_S[k] = form(y, horn(unit), q);
    }
    for (std::size_t a = 0; a < x.size(); ++a) {
        const Vector3 there = difference(shape.X[a], mean_X);
        for (std::size_t j = 0; j < 3; ++j) {
            (*gradient)[a][j] = 0;
            for (std::size_t i = 0; i < 3; ++i) (*gradient)[a][j] += shape.weights[a] * there[i] * by_S[3 * i + j];
        }
    }
    return value;
}

/// Direction of the longest undeformed extent perpendicular to d, with its largest component positive.
Vector3 longest_direction(const FaceShape& shape) {
    const Vector3 mean = mean_of(shape.X, shape.weights);
    Tensor moments{};
    for (std::size_t a = 0; a < shape.X.size(); ++a) {
        const Vector3 p = across_of(difference(shape.X[a], mean), shape.direction);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) moments[3 * i + j] += shape.weights[a] * p[i] * p[j];
    }
    const Spectral spectral = spectral_form(moments);
    std::size_t most = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (spectral.value[k] > spectral.value[most]) most = k;
    Vector3 t{spectral.vector[most], spectral.vector[3 + most], spectral.vector[6 + most]};
    std::size_t largest = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(t[i]) > (1 + 1e-9) * std::abs(t[largest])) largest = i;
    if (t[largest] < 0)
        for (double& component : t) component = -component;
    return t;
}

/// Fits the nodes projected along d, in the order of the undeformed longest direction.
double curvature(const FaceShape& shape, const Points& x, Points* gradient) {
    const auto axes = plane_axes(shape.direction);
    const Vector3 t = longest_direction(shape), mean = mean_of(x, shape.weights);
    std::vector<PlanePoint> points, by_points;
    for (const Vector3& position : x) {
        const Vector3 p = difference(position, mean);
        points.push_back({dot(p, axes[0]), dot(p, axes[1])});
    }
    std::vector<std::size_t> along(x.size());
    std::iota(along.begin(), along.end(), std::size_t{0});
    std::ranges::stable_sort(along, {}, [&](std::size_t a) { return dot(shape.X[a], t); });
    const double value = fitted_curvature(points, shape.weights, along, gradient == nullptr ? nullptr : &by_points);
    for (std::size_t a = 0; a < by_points.size(); ++a)
        for (std::size_t i = 0; i < 3; ++i)
            (*gradient)[a][i] = by_points[a][0] * axes[0][i] + by_points[a][1] * axes[1][i];
    return value;
}

}  // namespace

double value_of(const FaceShape& shape, const Points& x, Points* gradient) {
    if (gradient != nullptr) gradient->assign(x.size(), Vector3{});
    switch (shape.measure) {
        case model::Measure::radial: return radial(shape, x, gradient);
        case model::Measure::rotation: return rotation(shape, x, gradient);
        case model::Measure::curvature: return curvature(shape, x, gradient);
        case model::Measure::displacement:
        case model::Measure::bend:
        case model::Measure::twist:
        case model::Measure::force:
        case model::Measure::moment: break;
    }
    return std::nan("");
}

}  // namespace soft::fem
