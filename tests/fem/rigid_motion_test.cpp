#include "fem/rigid_motion.hpp"

#include <gtest/gtest.h>

#include "sample_cases.hpp"

namespace soft::fem {
namespace {

TEST(RigidMotion, AFullySupportedBodyHasNone) {
    EXPECT_FALSE(free_rigid_motion(box_case(2, true)));
    EXPECT_FALSE(free_rigid_motion(sphere_case(2, 4)));
}

TEST(RigidMotion, NamesTheFreeTranslation) {
    auto input = box_case(2, true);
    input.supports = {{"fixed", {true, false, false}}, {"left", {false, true, false}}};
    EXPECT_EQ(free_rigid_motion(input), "translation along z");
    auto sphere = sphere_case(2, 4);
    sphere.supports = {{"axis", {false, true, false}}};
    EXPECT_EQ(free_rigid_motion(sphere), "translation along x");
}

// A hinge: the fixed face is collapsed onto the line y = z = 0, so that no constraint prevents the rotation about it.
TEST(RigidMotion, NamesTheFreeRotation) {
    auto input = box_case(1, true);
    auto& mesh = input.mesh;
    for (auto& point : mesh.points)
        if (point[1] < 1e-9) point[2] = 0.0;
    input.supports = {{"left", {true, true, true}}};
    EXPECT_EQ(free_rigid_motion(input), "rotation about an axis along x");
    input.supports = {{"fixed", {true, true, true}}};
    EXPECT_FALSE(free_rigid_motion(input));
}

TEST(RigidMotion, FindsTheUnsupportedPartOfTwo) {
    auto input = box_case(1, true);
    const auto other = box_case(1, true);
    const auto shift = static_cast<mesh::Index>(input.mesh.points.size());
    for (auto point : other.mesh.points) input.mesh.points.push_back({point[0] + 0.1, point[1], point[2]});
    std::vector<mesh::Index> nodes;
    for (const auto node : other.mesh.cell_nodes(0)) nodes.push_back(node + shift);
    mesh::add_cell(input.mesh, mesh::CellType::hex27, nodes, 0);
    const auto motion = free_rigid_motion(input);
    ASSERT_TRUE(motion);
    EXPECT_NE(motion->find("of the part near x = 105"), std::string::npos) << *motion;
}

}  // namespace
}  // namespace soft::fem
