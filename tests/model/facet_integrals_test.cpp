#include "model/facet_integrals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace soft::model {
namespace {

using mesh::CellType;

struct Combination {
    CellType type;
    Kinematics kinematics;
};
constexpr Combination combinations[] = {{CellType::line3, Kinematics::axisymmetric},
                                        {CellType::line3, Kinematics::plane_strain},
                                        {CellType::quad9, Kinematics::solid},
                                        {CellType::triangle6, Kinematics::solid}};

std::vector<double> curved_facet(const ReferenceFacet& facet) {
    const auto& cell = mesh::topology(facet.type);
    std::vector<double> x(facet.dofs());
    for (int a = 0; a < facet.nodes; ++a) {
        const auto& s = cell.nodes[a];
        const double position[] = {1.0 + s[0] + 0.1 * s[1] * s[1], 2.0 + s[1] + 0.3 * s[0] * s[0] + 0.2 * s[0],
                                   0.5 + 0.2 * s[0] * s[1] - 0.1 * s[0] * s[0] + 0.15 * s[1]};
        for (int i = 0; i < facet.dimension; ++i) x[i * facet.nodes + a] = position[i];
    }
    return x;
}

std::vector<double> direction(std::size_t size) {
    std::vector<double> d(size);
    for (std::size_t i = 0; i < size; ++i) d[i] = std::cos(0.4 + 2.3 * static_cast<double>(i));
    return d;
}

TEST(FacetIntegrals, TangentIsTheDerivativeOfTheForce) {
    for (const auto& [type, kinematics] : combinations) {
        const auto& facet = reference_facet(type);
        const auto x = curved_facet(facet);
        const auto n = x.size();
        const auto d = direction(n);
        std::vector<double> f(n, 0.0), K(n * n, 0.0);
        pressure_force(facet, kinematics, x, f, K);
        const auto remainder = [&](double h) {
            auto there = x;
            for (std::size_t i = 0; i < n; ++i) there[i] += h * d[i];
            std::vector<double> g(n, 0.0);
            pressure_force(facet, kinematics, there, g, {});
            double sum = 0;
            for (std::size_t i = 0; i < n; ++i) {
                double linear = 0;
                for (std::size_t j = 0; j < n; ++j) linear += K[i * n + j] * d[j];
                sum += std::pow(g[i] - f[i] - h * linear, 2);
            }
            return std::sqrt(sum);
        };
        if (kinematics == Kinematics::plane_strain)  // the force is linear in x: no remainder at all
            EXPECT_NEAR(remainder(1e-2), 0.0, 1e-13);
        else
            EXPECT_NEAR(remainder(2e-3) / remainder(1e-3), 4.0, 0.05);
    }
}

TEST(FacetIntegrals, VolumeGradientIsTheDerivativeOfTheVolume) {
    for (const auto& [type, kinematics] : combinations) {
        const auto& facet = reference_facet(type);
        const auto x = curved_facet(facet);
        const auto d = direction(x.size());
        std::vector<double> gradient(x.size(), 0.0);
        const double V = swept_volume(facet, kinematics, x, gradient);
        double slope = 0;
        for (std::size_t i = 0; i < d.size(); ++i) slope += gradient[i] * d[i];
        const auto remainder = [&](double h) {
            auto there = x;
            for (std::size_t i = 0; i < d.size(); ++i) there[i] += h * d[i];
            std::vector<double> unused(x.size(), 0.0);
            return std::abs(swept_volume(facet, kinematics, there, unused) - V - h * slope);
        };
        EXPECT_NEAR(remainder(2e-3) / remainder(1e-3), 4.0, 0.05);
    }
}

// A facet in the plane r = R of an axisymmetric wall, rubber outside: t along +x, normal towards the axis.
TEST(FacetIntegrals, ForceAndVolumeOfACylindricalWallMatchTheClosedForm) {
    const auto& facet = reference_facet(CellType::line3);
    const double R = 0.007, L = 0.02;
    const std::vector<double> x{0.0, L, L / 2, R, R, R};
    std::vector<double> f(6, 0.0), gradient(6, 0.0);
    pressure_force(facet, Kinematics::axisymmetric, x, f, {});
    EXPECT_NEAR(f[3] + f[4] + f[5], 2 * std::numbers::pi * R * L, 1e-15);  // pushes outwards: positive r
    EXPECT_NEAR(f[0] + f[1] + f[2], 0.0, 1e-18);
    EXPECT_NEAR(swept_volume(facet, Kinematics::axisymmetric, x, gradient), std::numbers::pi * R * R * L, 1e-18);
    std::vector<double> weights(3, 0.0);
    EXPECT_NEAR(facet_area(facet, Kinematics::axisymmetric, x, weights), 2 * std::numbers::pi * R * L, 1e-16);
}

TEST(FacetIntegrals, TheForceOnAFlatSquareIsItsAreaAlongTheNormal) {
    const auto& facet = reference_facet(CellType::quad9);
    std::vector<double> x(27, 0.0), f(27, 0.0), weights(9, 0.0);
    for (int a = 0; a < 9; ++a) {
        x[a] = 0.5 * mesh::topology(CellType::quad9).nodes[a][0];
        x[9 + a] = 0.5 * mesh::topology(CellType::quad9).nodes[a][1];
        x[18 + a] = 0.3;
    }
    pressure_force(facet, Kinematics::solid, x, f, {});  // normal +z, unit area: total force -z
    double total[3] = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
        for (int a = 0; a < 9; ++a) total[i] += f[9 * i + a];
    EXPECT_NEAR(total[0], 0.0, 1e-15);
    EXPECT_NEAR(total[1], 0.0, 1e-15);
    EXPECT_NEAR(total[2], -1.0, 1e-15);
    EXPECT_NEAR(facet_area(facet, Kinematics::solid, x, weights), 1.0, 1e-15);
}

// Cap of a square rim with its normal along +z at height z: the volume is 1/3 z times the area for an apex in the plane of the rim.
TEST(FacetIntegrals, CapOfAFlatRimIsTheConeFromTheOrigin) {
    const auto& edge = reference_facet(CellType::line3);
    const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double apex[3] = {0.2, -0.1, 0.6};
    double volume = 0;
    std::vector<double> gradient(9, 0.0);
    double apex_gradient[3] = {0, 0, 0};
    for (int e = 0; e < 4; ++e) {
        const auto* a = corner[e];
        const auto* b = corner[(e + 1) % 4];
        const std::vector<double> y{a[0], b[0], (a[0] + b[0]) / 2, a[1], b[1], (a[1] + b[1]) / 2, 0.6, 0.6, 0.6};
        volume += cap_volume(edge, y, apex, gradient, apex_gradient);
    }
    EXPECT_NEAR(volume, 0.6 * 4.0 / 3.0, 1e-14);
}

TEST(FacetIntegrals, CapGradientsAreTheDerivativesOfTheVolume) {
    const auto& edge = reference_facet(CellType::line3);
    const std::vector<double> y{0.1, 0.9, 0.55, -0.3, 0.4, 0.1, 0.8, 0.6, 0.75};
    const double apex[3] = {0.2, -0.1, 0.6};
    std::vector<double> gradient(9, 0.0), unused(9, 0.0);
    double apex_gradient[3] = {0, 0, 0}, ignored[3] = {0, 0, 0};
    (void)cap_volume(edge, y, apex, gradient, apex_gradient);
    constexpr double h = 1e-6;  // the volume is cubic at most: central differences are accurate to h^2
    for (int i = 0; i < 9; ++i) {
        auto plus = y, minus = y;
        plus[i] += h;
        minus[i] -= h;
        const double slope =
            (cap_volume(edge, plus, apex, unused, ignored) - cap_volume(edge, minus, apex, unused, ignored)) / (2 * h);
        EXPECT_NEAR(gradient[i], slope, 1e-10);
    }
    for (int i = 0; i < 3; ++i) {
        double plus[3] = {apex[0], apex[1], apex[2]}, minus[3] = {apex[0], apex[1], apex[2]};
        plus[i] += h;
        minus[i] -= h;
        const double slope =
            (cap_volume(edge, y, plus, unused, ignored) - cap_volume(edge, y, minus, unused, ignored)) / (2 * h);
        EXPECT_NEAR(apex_gradient[i], slope, 1e-10);
    }
}

}  // namespace
}  // namespace soft::model
