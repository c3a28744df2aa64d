/// Properties independent of the law: kinematics, fibre frames, pressures. The laws are tested in matrix_test.
#include "fem/solid_kernel.hpp"

#include <gtest/gtest.h>

#include "matrix.hpp"

namespace soft::fem {
namespace {

using mesh::CellType;
using model::Kinematics;

// A linear displacement field gives a constant F, exactly, on a curved and distorted cell.
TEST(SolidKernel, ALinearDisplacementGivesAConstantDeformationGradient) {
    constexpr Tensor G{0.20, 0.05, -0.03, 0.04, -0.10, 0.06, 0.02, -0.07, 0.15};
    for (const auto& c : all_combinations()) {
        Sample s(c);
        const int n = s.cell.nodes, dim = s.cell.dimension;
        const bool axisymmetric = c.kinematics == Kinematics::axisymmetric;
        for (int a = 0; a < n; ++a)
            for (int i = 0; i < dim; ++i) {
                double u = 0;
                for (int J = 0; J < dim; ++J)
                    if (!axisymmetric || i == J) u += G[3 * i + J] * s.X[J * n + a];
                s.unknowns[i * n + a] = u;
            }
        for (const auto& point : s.points(s.unknowns)) {
            for (int i = 0; i < dim; ++i)
                for (int J = 0; J < dim; ++J) {
                    const double expected = (i == J ? 1.0 : 0.0) + (axisymmetric && i != J ? 0.0 : G[3 * i + J]);
                    EXPECT_NEAR(point.F[3 * i + J], expected, 1e-13) << label(c);
                }
            const double across = axisymmetric ? 1.0 + G[4] : (dim == 2 ? 1.0 : 1.0 + G[8]);  // r/R = 1 + u_r/R
            EXPECT_NEAR(point.F[8], across, 1e-13) << label(c);
            for (int m = 0; m < 9; ++m)
                EXPECT_NEAR(point.F_law[m], point.F[m], 1e-13) << label(c);  // uniform dilatation
        }
    }
}

TEST(SolidKernel, PointVolumesSumToTheVolumeOfTheCell) {
    // Straight sides: a box 2 x 3 x 4 mm, or the section 2 x 3 mm at mean radius 11.5 mm (Pappus: V = 2 pi r A).
    for (const auto& c : all_combinations()) {
        const auto& topology = mesh::topology(c.type);
        if (topology.shape != mesh::Shape::quadrilateral && topology.shape != mesh::Shape::hexahedron) continue;
        Sample s(c);
        const int n = s.cell.nodes;
        for (int a = 0; a < n; ++a) {
            s.X[a] = 1e-3 * topology.nodes[a][0];
            s.X[n + a] = 11.5e-3 + 1.5e-3 * topology.nodes[a][1];
            if (s.cell.dimension == 3) s.X[2 * n + a] = 2e-3 * topology.nodes[a][2];
        }
        double V = 0;
        for (const auto& point : s.points(s.unknowns)) V += point.weight_m3;
        const double expected = c.kinematics == Kinematics::axisymmetric   ? 2 * std::numbers::pi * 11.5e-3 * 6e-6
                                : c.kinematics == Kinematics::plane_strain ? 6e-6
                                                                           : 24e-9;
        EXPECT_NEAR(V, expected, 1e-13 * expected) << label(c);
    }
}

// e1 = x, e2 = the hoop direction: tangent to the circle about x through the point, with increasing angle from y to z.
TEST(SolidKernel, TheCylindricalFiberFrameFollowsTheHoopDirection) {
    for (const auto& c : all_combinations()) {
        const Sample s(c, rubber_of(*material::find_law("holzapfel-gasser-ogden")));
        const auto points = s.points(s.unknowns);
        for (int q = 0; q < s.cell.points; ++q) {
            const auto& axes = points[q].axes;
            EXPECT_EQ(axes.e1, (Vector3{1, 0, 0})) << label(c);
            if (c.kinematics == Kinematics::axisymmetric) {
                EXPECT_EQ(axes.e2, (Vector3{0, 0, 1})) << label(c);
                continue;
            }
            Vector3 X{};
            for (int i = 0; i < s.cell.dimension; ++i)
                for (int a = 0; a < s.cell.nodes; ++a)
                    X[i] += s.cell.N[q * s.cell.nodes + a] * s.X[i * s.cell.nodes + a];
            EXPECT_NEAR(axes.e2[1] * X[1] + axes.e2[2] * X[2], 0.0, 1e-15) << label(c);
            EXPECT_NEAR(dot(axes.e2, axes.e2), 1.0, 1e-14) << label(c);
            EXPECT_GT(axes.e2[2], 0.0) << label(c);  // the sample has y > 0
        }
    }
}

TEST(SolidKernel, TheCartesianFiberFrameIsXAndY) {
    auto description = material::sample::description_of("holzapfel-gasser-ogden");
    for (const auto& c : all_combinations())
        for (const auto& point : Sample(c, material::make_rubber(description)).points(Sample(c).unknowns)) {
            EXPECT_EQ(point.axes.e1, (Vector3{1, 0, 0})) << label(c);
            EXPECT_EQ(point.axes.e2, (Vector3{0, 1, 0})) << label(c);
        }
}

TEST(SolidKernel, NodalPressuresReproduceAConstantField) {
    for (const auto type : {CellType::quad9, CellType::tet10, CellType::hex27, CellType::wedge18}) {
        const auto cell = make_reference_cell(type, Form::mixed);
        const auto X = distorted_nodes(type);
        std::vector<double> unknowns(cell.pressure_dofs, cell.pressure == PressureSpace::continuous_vertex ? 2.5 : 0.0);
        unknowns[0] = 2.5;  // a constant field in either space
        for (const double p : nodal_pressures(cell, X, unknowns, 1e3)) EXPECT_NEAR(p, 2500.0, 1e-9);
    }
}

}  // namespace
}  // namespace soft::fem
