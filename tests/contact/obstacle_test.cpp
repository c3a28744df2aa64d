#include <gtest/gtest.h>

#include <limits>

#include "../fem/block_mesh.hpp"
#include "contact/potential.hpp"
#include "contact_samples.hpp"

namespace soft::contact {
namespace {

/// A step through an obstacle that is thinner than the step ends where it enters; beside it, and along it, nothing is shortened.
TEST(ThinObstacle, IsNotJumpedOver) {
    model::Case model =
        block_case(mesh::CellType::quad9, model::Kinematics::plane_strain, model::Formulation::displacement, {.n = 2});
    model.mesh.region_names = {"rubber"};
    model.mesh.cell_regions.assign(model.mesh.cell_types.size(), 0);
    model.path.contact = model::Contact::solve;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    model.obstacles.push_back({"board", model::Box{{2, -1, -infinity}, {2.1, 2, infinity}, 0.01}});
    Potential potential(model, std::array{1e5});
    const auto share = [&](double way, double beside) {
        auto positions = model.mesh.points, next = positions;
        for (std::size_t n = 0; n < positions.size(); ++n) {
            positions[n][1] += beside;
            next[n][0] += way;
            next[n][1] += beside;
        }
        const std::vector<Vector3> shifts(1);
        return potential.share_without_crossing(positions, shifts, next, shifts);
    };
    EXPECT_NEAR(share(4, 0), 0.25, 1.0 / 32);  // from x = 1 to the board
    EXPECT_EQ(share(0.9, 0), 1);
    EXPECT_EQ(share(4, 10), 1);
}

/// A point that is pressed onto the axis of revolution is pushed away, the harder the nearer: its area vanishes there, its resistance must not.
TEST(AxisOfRevolution, RepelsWhatIsPressedOntoIt) {
    const auto block = test::block(2, test::box({0, 1}, {1, 2}), {2, 2, 1}, "block");
    model::Case model = test::make_case(block, model::Kinematics::axisymmetric);
    model.mesh.region_names = {"rubber"};
    model.mesh.cell_regions.assign(model.mesh.cell_types.size(), 0);
    model.path.contact = model::Contact::solve;
    Potential potential(model, std::array{1e5});
    const double h = potential.distance_m();
    double force = 0;
    for (const double radius : {0.9, 0.5, 0.2, 0.1, 0.0, -0.3}) {
        auto positions = model.mesh.points;
        for (mesh::Point& x : positions) x[1] += radius * h - 1;
        double outward = 0;
        const auto add = [&](const Block& b) {
            for (std::size_t n = 0; n < b.nodes.size(); ++n) outward -= b.gradient[b.nodes.size() + n];
        };
        static_cast<void>(potential.evaluate(
            positions, {}, Wanted::gradient, [](mesh::Index) { return true; }, add));
        EXPECT_GT(outward, force) << radius;
        force = outward;
    }
}

}  // namespace
}  // namespace soft::contact
