#include "fem/face_shape.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/circle_fit.hpp"
#include "fem/plane_axes.hpp"
#include "math/spectral.hpp"

namespace soft::fem {

namespace {

using Eigen::Matrix3d, Eigen::Matrix4d, Eigen::Vector4d;
using Points = std::vector<Vector3>;

Eigen::Vector3d as_eigen(const Vector3& v) { return {v[0], v[1], v[2]}; }

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
Matrix4d horn(const Matrix3d& S) {
    Matrix4d N;
    N(0, 0) = S.trace();
    N.bottomLeftCorner<3, 1>() = Eigen::Vector3d(S(1, 2) - S(2, 1), S(2, 0) - S(0, 2), S(0, 1) - S(1, 0));
    N.topRightCorner<1, 3>() = N.bottomLeftCorner<3, 1>().transpose();
    N.bottomRightCorner<3, 3>() = S + S.transpose() - S.trace() * Matrix3d::Identity();
    return N;
}

/// The component of the rotation vector of a unit quaternion q, q[0] >= 0, and its derivative by q.
double rotation_of(const Vector4d& q, const Vector3& d, Vector4d& by_q) {
    const Vector3 v{q[1], q[2], q[3]};
    const double s = norm(v), along = dot(v, d);
    constexpr double series_below = 1e-4;  // the next term is s^2 smaller
    const double half = std::atan2(s, q[0]);
    const double factor = s > series_below ? 2 * half / s : 2 + s * s / 3;
    const double by_length = s > series_below ? 2 * (q[0] - half / s) / (s * s) : -4.0 / 3.0;
    by_q << -2 * along, factor * as_eigen(d) + along * by_length * as_eigen(v);
    return factor * along;
}

double rotation(const FaceShape& shape, const Points& x, Points* gradient) {
    const Vector3 mean_X = mean_of(shape.X, shape.weights), mean_x = mean_of(x, shape.weights);
    Matrix3d S = Matrix3d::Zero();
    for (std::size_t a = 0; a < x.size(); ++a)
        S += shape.weights[a] * as_eigen(difference(shape.X[a], mean_X)) *
             as_eigen(difference(x[a], mean_x)).transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(horn(S));  // ascending
    Vector4d q = eigen.eigenvectors().col(3), by_q, y = Vector4d::Zero();
    if (q[0] < 0) q = -q;
    const double value = rotation_of(q, shape.direction, by_q);
    if (gradient == nullptr) return value;
    for (int k = 0; k < 3; ++k) {
        const Vector4d v = eigen.eigenvectors().col(k);
        y += v.dot(by_q) / (eigen.eigenvalues()[3] - eigen.eigenvalues()[k]) * v;
    }
    Matrix3d by_S;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            Matrix3d unit = Matrix3d::Zero();
            unit(i, j) = 1;
            by_S(i, j) = y.dot(horn(unit) * q);
        }
    for (std::size_t a = 0; a < x.size(); ++a)
        Eigen::Map<Eigen::Vector3d>((*gradient)[a].data()) =
            shape.weights[a] * by_S.transpose() * as_eigen(difference(shape.X[a], mean_X));
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
        case model::Measure::moment:
        case model::Measure::contact_area:
        case model::Measure::contact_pressure: break;
    }
    return std::nan("");
}

}  // namespace soft::fem
