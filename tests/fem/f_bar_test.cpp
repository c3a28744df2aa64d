#include <gtest/gtest.h>

#include "matrix.hpp"

namespace soft::fem {
namespace {

using material::NeoHookean;
using material::Rubber;
using material::VolumetricLaw;
using mesh::CellType;
using model::Kinematics;

constexpr double mu_Pa = 0.1644e6, kappa_Pa = 100 * mu_Pa;
const Rubber<NeoHookean> rubber{{mu_Pa}, VolumetricLaw::quadratic, 1.0 / kappa_Pa};

std::vector<Combination> f_bar_combinations() {
    return {{CellType::quad4, Kinematics::axisymmetric, Form::f_bar},
            {CellType::quad4, Kinematics::plane_strain, Form::f_bar},
            {CellType::hex8, Kinematics::solid, Form::f_bar}};
}

std::vector<double> force(const ReferenceCell& cell, Kinematics kinematics, const CellInput& in) {
    CellOutput out(cell);
    integrate_cell(cell, kinematics, rubber, in, material::Wanted::stress, out);
    return out.residual;
}

/// Jm = v / V of a cell.
double mean_dilatation(const auto& points) {
    double V = 0, v = 0;
    for (const auto& point : points) {
        V += point.weight_m3;
        v += point.weight_m3 * determinant(point.F);
    }
    return v / V;
}

// Oracle: the element of Simo, Taylor, Pister (1985) with one pressure p = kappa (Jm - 1) per cell, whose forces follow from the mixed
// stress P(F, p), summed here over the points.
TEST(FBar, IsTheMeanDilatationElementForASplitLaw) {
    for (const auto& c : f_bar_combinations()) {
        const Sample s(c, rubber);
        const auto points = s.points(s.unknowns);
        const double p = kappa_Pa * (mean_dilatation(points) - 1.0);
        std::vector<double> expected(s.unknowns.size(), 0.0);
        const bool axisymmetric = c.kinematics == Kinematics::axisymmetric;
        CellPoints mapped(s.cell);
        if (axisymmetric)
            detail::map_points<true>(s.cell, s.input(s.unknowns), mapped);
        else
            detail::map_points<false>(s.cell, s.input(s.unknowns), mapped);
        for (int q = 0; q < s.cell.points; ++q) {
            material::PointResponse response;
            mixed_response(rubber, {}, points[q].F, p, material::Wanted::stress, response);
            const int n = s.cell.nodes;
            const auto gradient = [&](int J, int a) {
                return mapped.volume[q] * mapped.gradient[(J * s.cell.points + q) * n + a];
            };
            for (int a = 0; a < n; ++a) {
                for (int i = 0; i < s.cell.dimension; ++i)
                    for (int J = 0; J < s.cell.dimension; ++J)
                        expected[i * n + a] += response.first_piola[3 * i + J] * gradient(J, a);
                if (axisymmetric) expected[n + a] += response.first_piola[8] * gradient(2, a);
            }
        }
        const auto R = force(s.cell, c.kinematics, s.input(s.unknowns));
        for (std::size_t i = 0; i < R.size(); ++i) EXPECT_NEAR(R[i], expected[i], 1e-12 * norm(expected)) << label(c);
    }
}

// A quad4 in plane strain is a slice of unit depth between rigid walls: both faces of a hex8 with u_z = 0.
TEST(FBar, PlaneStrainEqualsASolidSliceBetweenRigidWalls) {
    const Sample flat({CellType::quad4, Kinematics::plane_strain, Form::f_bar}, rubber);
    const auto solid = make_reference_cell(CellType::hex8, Form::f_bar);
    std::vector<double> X(24, 0.0), u(24, 0.0);
    for (int i = 0; i < 2; ++i)
        for (int a = 0; a < 8; ++a) {
            X[i * 8 + a] = flat.X[i * 4 + a % 4];
            u[i * 8 + a] = flat.unknowns[i * 4 + a % 4];
        }
    for (int a = 4; a < 8; ++a) X[16 + a] = 1.0;  // [m]
    const auto expected = force(solid, Kinematics::solid, {X, u, {}, 1.0});
    const auto R = force(flat.cell, Kinematics::plane_strain, flat.input(flat.unknowns));
    for (int i = 0; i < 2; ++i)
        for (int a = 0; a < 4; ++a)
            EXPECT_NEAR(R[i * 4 + a], expected[i * 8 + a] + expected[i * 8 + a + 4], 1e-12 * norm(expected));
}

TEST(FBar, FBarHasTheMeanDilatationAndTheIsochoricPartOfF) {
    for (const auto& c : f_bar_combinations()) {
        const Sample s(c, rubber);
        const auto points = s.points(s.unknowns);
        const double mean = mean_dilatation(points);
        double spread = 0;
        for (const auto& point : points) {
            EXPECT_NEAR(determinant(point.F_law), mean, 1e-13) << label(c);
            for (int m = 0; m < 9; ++m)
                EXPECT_NEAR(point.F_law[m] * point.F[0], point.F[m] * point.F_law[0], 1e-13) << label(c);
            spread = std::max(spread, std::abs(determinant(point.F) / mean - 1.0));
        }
        EXPECT_GT(spread, 1e-4) << label(c) << ": the dilatation of the sample is too uniform for this test";
    }
}

// One corner is inverted while the mean dilatation stays positive.
TEST(FBar, AnInvertedCornerIsReportedAlthoughTheMeanIsPositive) {
    Sample s({CellType::quad4, Kinematics::plane_strain, Form::f_bar}, rubber);
    s.X = {0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0};
    const std::vector<double> u{0.0, 0.0, -0.9, 0.0, 0.0, 0.0, -0.9, 0.0};  // the third corner, almost to the first
    const auto points = s.points(u);
    double v = 0;
    for (const auto& point : points) v += point.weight_m3 * determinant(point.F);
    EXPECT_GT(v, 0.0);
    EXPECT_LT(s.integrate(u).min_jacobian, 0.0);
}

}  // namespace
}  // namespace soft::fem
