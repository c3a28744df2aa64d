#include "geometry/variations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace soft::geometry {
namespace {

const std::string tube_text =
    "family: tube\ngeometry: {length: 40 mm, inner_radius: 7 mm, outer_radius: 10 mm, cap: 5 mm}\n"
    "material: {law: neo-hookean, mu: 0.1644 MPa, kappa: incompressible}\nloads: {cavity: {pressure: 20 kPa}}\n"
    "mesh: {size: 3 mm}\n";

Variations varied(const std::string& text, const std::vector<std::string>& keys) {
    const design::Design design = design::read_design(text, "tube.yaml", catalogue_keys(), {});
    return make_variations(design, build_with_figures(design), keys, "tube.yaml");
}

std::string refusal(const std::string& text, const std::vector<std::string>& keys) {
    try {
        static_cast<void>(varied(text, keys));
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Variations, MoveTheNodesOfTheOuterFaceWithTheOuterRadius) {
    const auto all = varied(tube_text, {"geometry.outer_radius"}).variations;
    ASSERT_EQ(all.size(), 1u);
    const auto& [parameter, lower, higher] = all[0];
    EXPECT_EQ(parameter.unit, "mm");
    EXPECT_DOUBLE_EQ(parameter.value, 0.01);
    const design::Design design = design::read_design(tube_text, "tube.yaml", catalogue_keys(), {});
    const mesh::Mesh mesh = build_with_figures(design).model.mesh;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const double velocity = (higher.points[i][1] - lower.points[i][1]) / (parameter.higher - parameter.lower);
        if (std::abs(mesh.points[i][1] - 0.01) < 1e-9) {
            EXPECT_NEAR(velocity, 1, 1e-6);
        }
        if (mesh.points[i][1] == 0) {
            EXPECT_NEAR(velocity, 0, 1e-6);
        }
    }
}

/// 21 mm are exactly 2.5 cells of 8.4 mm, and more or less of them 2 or 3; a base of twice the walls has one cell, a thicker one two; half a
/// strip of 58 degrees has one cell, of a larger angle two.
TEST(Variations, RepeatTheNumbersOfCells) {
    const std::string rubber = "material: {law: neo-hookean, mu: 0.1644 MPa, kappa: incompressible}\n";
    const std::vector<std::pair<std::string, std::string>> at_a_step{
        {"family: rod\ngeometry: {length: 21 mm, width: 8.4 mm, height: 8.4 mm}\nmesh: {size: 8.4 mm}\n"
         "loads: {end: {pressure: -20 kPa}}\n",
         "geometry.length"},
        {"family: pneunet\ngeometry: {chambers: 1, base: 3 mm, wall: 1.5 mm}\nloads: {cavity: {pressure: 1 kPa}}\n",
         "geometry.base"},
        {"family: bellows\nmodel: half\ngeometry: {convolutions: 1, strip: {angle: 58 deg}}\nloads: {cavity: {pressure: 1 kPa}}\n",
         "geometry.strip.angle"}};
    for (const auto& [text, key] : at_a_step) {
        const auto all = varied(text + rubber, {key}).variations;
        ASSERT_EQ(all.size(), 1u);
        EXPECT_LT(all[0].parameter.lower, all[0].parameter.value) << key;
        EXPECT_GT(all[0].parameter.higher, all[0].parameter.value) << key;
    }
}

TEST(Variations, OfAConstantMoveNothing) {
    const auto all = varied(tube_text, {"material.mu"}).variations;
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].lower.points, all[0].higher.points);
    EXPECT_NE(all[0].lower.effective_yaml, all[0].higher.effective_yaml);
}

TEST(Variations, OfAllNumbersLeaveOutGasThatIsNotUsed) {
    std::vector<std::string> keys;
    for (const auto& variation : varied(tube_text, {"all"}).variations) keys.push_back(variation.parameter.key);
    EXPECT_EQ(keys, (std::vector<std::string>{"geometry.length", "geometry.inner_radius", "geometry.outer_radius",
                                              "geometry.cap", "material.mu", "loads.cavity.pressure"}));
}

TEST(Variations, RefuseWhatHasNoDerivative) {
    EXPECT_EQ(refusal(tube_text, {"geometry.outer_radios"}).substr(0, 96),
              "--sensitivity geometry.outer_radios: not a number of the design that differs from 0; did you mea");
    EXPECT_NE(refusal(tube_text, {"material.kappa"}).find("not a number of the design"), std::string::npos);
    EXPECT_NE(refusal(tube_text + "contact: {friction: 0.5}\n", {"material.mu"}).find("paths with friction"),
              std::string::npos);
}

}  // namespace
}  // namespace soft::geometry
