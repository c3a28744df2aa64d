#include "fem/circle_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace soft::fem {

namespace {

using Eigen::Matrix4d, Eigen::Vector4d;

/// N of the constraint v^T N v = 1 on v = (A, B, C, D).
Vector4d times_N(const Vector4d& v) { return {-2 * v[3], v[1], v[2], -2 * v[0]}; }

/// The points as z = (u^2 + v^2, u, v, 1) relative to their mean and in units of their size. The fit does not depend on the
/// origin, and its curvature is proportional to 1 / size, so both are treated as constants in the derivatives.
struct Features {
    std::vector<Vector4d> z;
    std::vector<double> weights;  // their sum is 1
    double size = 0;
};

Features features_of(std::span<const PlanePoint> points, std::span<const double> weights) {
    Features features;
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    PlanePoint mean{};
    for (std::size_t a = 0; a < points.size(); ++a) {
        features.weights.push_back(weights[a] / total);
        for (std::size_t i = 0; i < 2; ++i) mean[i] += features.weights[a] * points[a][i];
    }
    double size2 = 0;
    for (std::size_t a = 0; a < points.size(); ++a)
        size2 += features.weights[a] * (std::pow(points[a][0] - mean[0], 2) + std::pow(points[a][1] - mean[1], 2));
    features.size = std::sqrt(size2);
    for (const PlanePoint& point : points) {
        const double u = (point[0] - mean[0]) / features.size, v = (point[1] - mean[1]) / features.size;
        features.z.emplace_back(u * u + v * v, u, v, 1);
    }
    return features;
}

Matrix4d moments_of(const Features& features) {
    Matrix4d M = Matrix4d::Zero();
    for (std::size_t a = 0; a < features.z.size(); ++a)
        M += features.weights[a] * features.z[a] * features.z[a].transpose();
    return M;
}

struct Fit {
    Vector4d v;
    double eta;  // (M - eta N) v = 0
};

/// One eigenvalue of N^-1 M is not positive, as N has one negative eigenvalue; the next one is the smallest residual.
Fit best_fit(const Matrix4d& M) {
    Matrix4d pencil;
    pencil << -0.5 * M.row(3), M.row(1), M.row(2), -0.5 * M.row(0);
    const Eigen::EigenSolver<Matrix4d> eigen(pencil);  // imaginary parts are rounding errors
    const Vector4d values = eigen.eigenvalues().real();
    std::array<int, 4> order{0, 1, 2, 3};
    std::ranges::sort(order, {}, [&](int k) { return values[k]; });
    const Vector4d v = eigen.eigenvectors().col(order[1]).real();
    return {v / std::sqrt(v.dot(times_N(v))), values[order[1]]};
}

/// l with d v[0] = -l . dM v for every change dM of M: from (M - eta N) dv = -(dM - d eta N) v and N v . dv = 0.
Vector4d adjoint_of(const Matrix4d& M, const Fit& fit) {
    Eigen::Matrix<double, 5, 5> bordered = Eigen::Matrix<double, 5, 5>::Zero();
    bordered.topLeftCorner<4, 4>() = M;
    bordered.topRightCorner<4, 1>() = times_N(fit.v);
    bordered.bottomLeftCorner<1, 4>() = times_N(fit.v).transpose();
    bordered(0, 3) += 2 * fit.eta;
    bordered(3, 0) += 2 * fit.eta;
    bordered(1, 1) -= fit.eta;
    bordered(2, 2) -= fit.eta;
    return bordered.partialPivLu().solve(Eigen::Matrix<double, 5, 1>::Unit(0)).head<4>();
}

/// Whether the polyline runs clockwise about the centre of v. The normal (2 A u + B, 2 A v + C) points away from the centre for A > 0.
bool is_clockwise(const Features& features, const Vector4d& v, std::span<const std::size_t> along) {
    double turn = 0;
    for (std::size_t k = 1; k < along.size(); ++k) {
        const Vector4d &from = features.z[along[k - 1]], &to = features.z[along[k]];
        const double normal_u = v[0] * (from[1] + to[1]) + v[1], normal_v = v[0] * (from[2] + to[2]) + v[2];
        turn += normal_u * (to[2] - from[2]) - normal_v * (to[1] - from[1]);
    }
    return turn < 0;
}

}  // namespace

double fitted_curvature(std::span<const PlanePoint> points, std::span<const double> weights,
                        std::span<const std::size_t> along, std::vector<PlanePoint>* gradient) {
    const Features features = features_of(points, weights);
    if (gradient != nullptr) gradient->assign(points.size(), {std::nan(""), std::nan("")});
    if (!(features.size > 0)) return std::nan("");
    const Matrix4d M = moments_of(features);
    Fit fit = best_fit(M);
    if (is_clockwise(features, fit.v, along)) fit.v = -fit.v;
    const double value = 2 * fit.v[0] / features.size + 0.0;  // -0 becomes 0
    if (gradient == nullptr) return value;
    const Vector4d l = adjoint_of(M, fit);
    for (std::size_t a = 0; a < points.size(); ++a) {
        const Vector4d& z = features.z[a];
        const double lz = l.dot(z), zv = z.dot(fit.v);
        for (int i = 1; i < 3; ++i) {  // dz = (2 u, 1, 0, 0) du, (2 v, 0, 1, 0) dv
            const double ldz = 2 * z[i] * l[0] + l[i], dzv = 2 * z[i] * fit.v[0] + fit.v[i];
            (*gradient)[a][static_cast<std::size_t>(i - 1)] =
                -2 / (features.size * features.size) * features.weights[a] * (ldz * zv + lz * dzv);
        }
    }
    return value;
}

}  // namespace soft::fem
