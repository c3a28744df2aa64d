/// Contact between parts of one file: of different materials and meshes, and parts that touch from the start.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/barrier.hpp"
#include "potential_samples.hpp"

namespace soft::contact {
namespace {

class PartsOf : public testing::TestWithParam<Cells> {};

/// Both sides show the mean of what both act with, and the area is that of the face, also between different materials and cells.
TEST_P(PartsOf, PressureBetweenUnlikeBlocksIsTheSameOnBothSides) {
    for (const int dimension : {2, 3}) {
        const auto left = test::block(dimension, test::box({0, 1}, {0, 1}, {0, 1}), {2, 2, 2}, "left"),
                   right = test::block(dimension, test::box({2, 3}, {0, 1}, {0, 1}), {3, 3, 3}, "right");
        model::Case model =
            test::make_case(test::as(GetParam(), test::beside(left, right)),
                            dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid);
        model.path.contact = model::Contact::solve;
        model.mesh.region_names = {"left", "right"};
        model.mesh.cell_regions.clear();
        for (mesh::Index c = 0; c < model.mesh.cell_count(); ++c)
            model.mesh.cell_regions.push_back(model.mesh.point(model.mesh.cell_nodes(c)[0])[0] < 1.5 ? 0 : 1);
        Potential potential(model, std::array{modulus_Pa, 5 * modulus_Pa});
        // Halves of the quadrilaterals are smaller, and so is their contact distance.
        const bool halves = dimension == 3 &&
                            (GetParam() == Cells::second_order_simplices || GetParam() == Cells::first_order_simplices);
        const double size = halves ? std::sqrt(0.5) : 1, h_left = model.contact.distance * size / 2,
                     h_right = model.contact.distance * size / 3;
        for (const double gap : {0.5 * h_right, 1.2 * h_right}) {
            State state{model.mesh.points, {}};
            for (Point& x : state.positions)
                if (x[0] > 1.5) x[0] -= 1 - gap;
            EXPECT_NEAR(derivatives(potential, state.positions, {}).summary.area_m2[0], 1, 1e-9) << gap;
            const double expected_Pa =
                -0.05 * modulus_Pa * (barrier(gap, h_left).slope + 5 * barrier(gap, h_right).slope);
            const auto pressures_Pa = potential.nodal_pressures_Pa(state.positions, {});
            for (std::size_t n = 0; n < pressures_Pa.size(); ++n)
                if (std::abs(model.mesh.points[n][0] - 1.5) < 0.51) {
                    EXPECT_NEAR(pressures_Pa[n] / expected_Pa, 1, 1e-9) << model.mesh.points[n][0] << ' ' << gap;
                }
        }
    }
}

/// Faces that touch from the start act as if they were h apart: for an approach of s the energy is the area times k b(h - s), also where
/// they then overlap, and the ends of the blocks beside the faces do not act.
TEST_P(PartsOf, FacesThatTouchFromTheStartActWithTheirApproach) {
    for (const int dimension : {2, 3}) {
        const auto left = test::block(dimension, test::box({0, 1}, {0, 1}, {0, 1}), {2, 2, 2}, "left"),
                   right = test::block(dimension, test::box({1, 2}, {0, 1}, {0, 1}), {2, 2, 2}, "right");
        const model::Case model =
            with_settings(test::make_case(test::as(GetParam(), test::beside(left, right)),
                                          dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid));
        Potential potential(model, std::array{modulus_Pa});
        const double h = potential.distance_m(), k = 0.1 * modulus_Pa;
        const auto at = [&](double approach) {
            std::vector<Point> positions = model.mesh.points;
            for (std::size_t n = positions.size() / 2; n < positions.size(); ++n) positions[n][0] -= approach;
            return derivatives(potential, positions, {}).summary;
        };
        EXPECT_NEAR(at(0).max_pressure_Pa, 0, 1e-12 * k);
        for (const double share : {0.01, 0.3, 0.7}) {
            const Barrier expected = barrier((1 - share) * h, h);
            // The points on the rim, up to an eighth of the weights, lie on the ends of the other block as much as on its face.
            const double energy = at(share * h).energy_J / (k * expected.value_m);
            EXPECT_GT(energy, dimension == 2 ? 0.98 : 0.86) << share;
            EXPECT_LT(energy, 1.01) << share;
            EXPECT_NEAR(at(share * h).max_pressure_Pa / (-k * expected.slope), 1, 1e-6) << share;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(AllCells, PartsOf, testing::ValuesIn(test::all_cells));

}  // namespace
}  // namespace soft::contact
