#include "fem/circle_fit.hpp"

#include <cmath>
#include <numeric>

#include "linalg/small_matrix.hpp"

namespace soft::fem {

namespace {

using linalg::SmallMatrix;
using Vector4 = std::array<double, 4>;

double inner_product(const Vector4& a, const Vector4& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// N of the constraint v^T N v = 1 on v = (A, B, C, D).
Vector4 times_N(const Vector4& v) { return {-2 * v[3], v[1], v[2], -2 * v[0]}; }

/// The points as z = (u^2 + v^2, u, v, 1) relative to their mean and in units of their size. The fit does not depend on the
/// origin, and its curvature is proportional to 1 / size, so both are treated as constants in the derivatives.
struct Features {
    std::vector<Vector4> z;
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
        features.z.push_back({u * u + v * v, u, v, 1});
    }
    return features;
}

SmallMatrix moments_of(const Features& features) {
    SmallMatrix M(4);
    for (std::size_t a = 0; a < features.z.size(); ++a)
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                M.at(i, j) += features.weights[a] * features.z[a][static_cast<std::size_t>(i)] *
                              features.z[a][static_cast<std::size_t>(j)];
    return M;
}

struct Fit {
    Vector4 v;
    double eta;  // (M - eta N) v = 0
};

/// One eigenvalue of N^-1 M is not positive, as N has one negative eigenvalue; the next one is the smallest residual.
Fit best_fit(const SmallMatrix& M) {
    SmallMatrix pencil(4);
    for (int j = 0; j < 4; ++j) {
        pencil.at(0, j) = -0.5 * M.at(3, j);
        pencil.at(1, j) = M.at(1, j);
        pencil.at(2, j) = M.at(2, j);
        pencil.at(3, j) = -0.5 * M.at(0, j);
    }
    const auto eigen = linalg::real_eigen(pencil);
    Fit fit{{}, eigen.values[1]};
    for (int i = 0; i < 4; ++i) fit.v[static_cast<std::size_t>(i)] = eigen.vectors.at(1, i);
    const double norm = std::sqrt(inner_product(fit.v, times_N(fit.v)));
    for (double& component : fit.v) component /= norm;
    return fit;
}

/// l with d v[0] = -l . dM v for every change dM of M: from (M - eta N) dv = -(dM - d eta N) v and N v . dv = 0.
Vector4 adjoint_of(const SmallMatrix& M, const Fit& fit) {
    SmallMatrix bordered(5);
    const Vector4 Nv = times_N(fit.v);
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) bordered.at(i, j) = M.at(i, j);
        bordered.at(i, 4) = bordered.at(4, i) = Nv[static_cast<std::size_t>(i)];
    }
    bordered.at(0, 3) += 2 * fit.eta;
    bordered.at(3, 0) += 2 * fit.eta;
    bordered.at(1, 1) -= fit.eta;
    bordered.at(2, 2) -= fit.eta;
    const auto solution = linalg::solve(bordered, {1, 0, 0, 0, 0});
    Vector4 l{std::nan(""), std::nan(""), std::nan(""), std::nan("")};
    for (std::size_t i = 0; i < 4 && solution; ++i) l[i] = (*solution)[i];
    return l;
}

/// Whether the polyline runs clockwise about the centre of v. The normal (2 A u + B, 2 A v + C) points away from the centre for A > 0.
bool is_clockwise(const Features& features, const Vector4& v, std::span<const std::size_t> along) {
    double turn = 0;
    for (std::size_t k = 1; k < along.size(); ++k) {
        const Vector4 &from = features.z[along[k - 1]], &to = features.z[along[k]];
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
    const SmallMatrix M = moments_of(features);
    Fit fit = best_fit(M);
    if (is_clockwise(features, fit.v, along))
        for (double& component : fit.v) component = -component;
    const double value = 2 * fit.v[0] / features.size + 0.0;  // -0 becomes 0
    if (gradient == nullptr) return value;
    const Vector4 l = adjoint_of(M, fit);
    for (std::size_t a = 0; a < points.size(); ++a) {
        const Vector4& z = features.z[a];
        const double lz = inner_product(l, z), zv = inner_product(z, fit.v);
        for (std::size_t i = 1; i < 3; ++i) {  // dz = (2 u, 1, 0, 0) du, (2 v, 0, 1, 0) dv
            const double ldz = 2 * z[i] * l[0] + l[i], dzv = 2 * z[i] * fit.v[0] + fit.v[i];
            (*gradient)[a][i - 1] = -2 / (features.size * features.size) * features.weights[a] * (ldz * zv + lz * dzv);
        }
    }
    return value;
}

}  // namespace soft::fem
