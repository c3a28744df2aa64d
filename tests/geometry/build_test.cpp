#include <gtest/gtest.h>

#include <algorithm>

#include "sample.hpp"

namespace soft::geometry {
namespace {

using sample::refusal;

design::Design design_of(const std::string& family, const std::string& model, const sample::Changes& changes = {}) {
    design::Design d;
    d.family = family;
    d.name = "a " + family;
    d.values = sample::values(family, model, changes);
    d.material = {"rubber",     "neo-hookean", {{"mu", {0.1644e6}}},
                  std::nullopt, std::nullopt,  model::Volumetric::quadratic};
    return d;
}

/// Components that the supports fix on a face; {false, false, false} without a support.
std::array<bool, 3> fixed_components(const model::Case& c, const std::string& face) {
    std::array<bool, 3> result{};
    for (const model::Support& support : c.supports)
        for (std::size_t i = 0; i < 3; ++i) result[i] = result[i] || (support.face == face && support.fixed[i]);
    return result;
}

using Components = std::array<bool, 3>;

TEST(BuildCase, CopiesSupportsLoadsAndOutputsOfTheDesign) {
    design::Design d = design_of("bellows", "axisymmetric");
    d.supports = {{"fixed", {true, true, true}}};
    d.loads = {{.name = "cavity", .targets = {"cavity"}, .gas = {}}};
    d.outputs = {{"elongation", "inlet", "axis"}};
    d.path.stages = {{.name = "", .until = {{"elongation", 0.13}}}};
    const model::Case c = build_case(d);
    EXPECT_EQ(c.name, "a bellows");
    EXPECT_EQ(c.kinematics, model::Kinematics::axisymmetric);
    EXPECT_EQ(c.formulation, model::Formulation::mixed);
    ASSERT_EQ(c.materials.size(), 1u);
    EXPECT_EQ(c.mesh.region_names, (std::vector<std::string>{c.materials[0].name}));
    EXPECT_EQ(fixed_components(c, "fixed"), (Components{true, true, true}));
    EXPECT_EQ(fixed_components(c, "axis"), (Components{false, true, false}));
    ASSERT_EQ(c.loads.size(), 1u);
    EXPECT_EQ(c.loads[0].targets, std::vector<std::string>{"cavity"});
    ASSERT_EQ(c.outputs.size(), 1u);
    EXPECT_EQ(c.outputs[0].direction, (std::array<double, 3>{-1, 0, 0}));  // the inlet moves towards -x
    EXPECT_EQ(c.path.stages.at(0).until.size(), 1u);
}

TEST(BuildCase, BellowsCavityOpensThroughTheBore) {
    const model::Case c = build_case(design_of("bellows", "quarter"));
    ASSERT_EQ(c.cavities.size(), 1u);
    ASSERT_EQ(c.cavities[0].openings.size(), 1u);
    EXPECT_NEAR(c.cavities[0].openings[0].area_m2, std::numbers::pi * 6.25e-6, 1e-18);  // whole actuator
    EXPECT_EQ(c.cavities[0].openings[0].direction, (std::array<double, 3>{-1, 0, 0}));
    for (const std::string& face : c.cavities[0].inner_faces) EXPECT_TRUE(c.mesh.facet_sets.contains(face));
    EXPECT_TRUE(c.mesh.facet_sets.contains(c.cavities[0].wall));
    EXPECT_TRUE(c.mesh.facet_sets.contains(c.cavities[0].openings[0].face));
}

TEST(BuildCase, SymmetryPlanesAreFixedInTheirNormalDirection) {
    const model::Case quarter = build_case(design_of("tube", "quarter"));
    EXPECT_EQ(quarter.model_fraction, 0.25);
    EXPECT_EQ(quarter.symmetry_planes, (Components{false, true, true}));
    EXPECT_EQ(fixed_components(quarter, meshing::symmetry_y_face), (Components{false, true, false}));
    EXPECT_EQ(fixed_components(quarter, meshing::symmetry_z_face), (Components{false, false, true}));
    const model::Case half = build_case(design_of("tube", "half"));
    EXPECT_EQ(half.model_fraction, 0.5);
    EXPECT_EQ(half.symmetry_planes, (Components{false, true, false}));
    EXPECT_EQ(fixed_components(half, meshing::symmetry_y_face), (Components{false, true, false}));
    const model::Case plate = build_case(design_of("plate", "quarter"));
    EXPECT_EQ(plate.model_fraction, 0.25);
    EXPECT_EQ(fixed_components(plate, meshing::symmetry_x_face), (Components{true, false, false}));
    EXPECT_EQ(fixed_components(plate, meshing::symmetry_y_face), (Components{false, true, false}));
    EXPECT_TRUE(build_case(design_of("tube", "solid")).supports.empty());
}

/// Supports must resist all three translations and three rotations of a shell for which the design has no supports.
TEST(BuildCase, UnsupportedShellHasNoRigidBodyMotion) {
    for (const char* model : {"solid", "half", "quarter"}) {
        const model::Case c = build_case(design_of("sphere", model));
        for (int motion = 0; motion < 6; ++motion) {
            double resisted = 0;
            for (const model::Support& support : c.supports)
                for (const mesh::Facet& facet : c.mesh.facet_sets.at(support.face))
                    for (const mesh::Index n : facet_nodes(c.mesh, facet)) {
                        const mesh::Point& p = c.mesh.point(n);
                        std::array<double, 3> u{};
                        if (motion < 3)
                            u[motion] = 1;
                        else {
                            u[(motion + 1) % 3] = -p[(motion + 2) % 3];
                            u[(motion + 2) % 3] = p[(motion + 1) % 3];
                        }
                        for (std::size_t i = 0; i < 3; ++i)
                            if (support.fixed[i]) resisted = std::max(resisted, std::abs(u[i]));
                    }
            EXPECT_GT(resisted, 1e-3) << model << " motion " << motion;
        }
    }
}

TEST(BuildCase, DirectionsFollowTheRequest) {
    design::Design d = design_of("rod", "solid");
    d.outputs = {{"a", "end", "axis"}, {"b", "top", "normal"}, {"c", "left", "normal"}, {"d", "end", "y"}};
    const model::Case c = build_case(d);
    const std::vector<std::array<double, 3>> expected{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}};
    for (std::size_t k = 0; k < expected.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(c.outputs[k].direction[i], expected[k][i], 1e-12) << c.outputs[k].name;
}

TEST(BuildCase, FacesOutsideTheModelAreRejected) {
    design::Design d = design_of("rod", "half");
    d.supports = {{"left", {false, true, false}}};
    EXPECT_EQ(refusal(d), "supports: this model has no face 'left'; available faces: fixed, end, bottom, top, right");
    d.supports.clear();
    d.loads = {{.name = "left", .targets = {"left"}, .gas = {}}};
    EXPECT_EQ(refusal(d), "loads.left: this model has no face 'left'; available faces: fixed, end, bottom, top, right");
    d.loads.clear();
    d.outputs = {{"shift", "left", "y"}};
    EXPECT_EQ(refusal(d),
              "outputs.shift.face: this model has no face 'left'; available faces: fixed, end, bottom, top, right");
}

TEST(BuildCase, DirectionsOutsideTheModelAreRejected) {
    design::Design d = design_of("tube", "axisymmetric");
    d.outputs = {{"shift", "inlet", "z"}};
    EXPECT_EQ(refusal(d), "outputs.shift.along: 'z' is not a direction of this model; use axis, x, r or normal");
    d.outputs = {{"shift", "outer", "normal"}};
    EXPECT_EQ(refusal(d), "accepted");  // a straight line in the section
    d = design_of("tube", "quarter");
    d.outputs = {{"shift", "outer", "normal"}};
    EXPECT_EQ(refusal(d), "outputs.shift.along: face 'outer' is not flat; use axis, x, y or z");
}

TEST(BuildCase, PlaneModelLiesInTheXYPlane) {
    design::Design d =
        design_of("panel", "plane-strain", {{"geometry.rise", "48 mm"}});  // the bottom rises at 45 degrees
    d.outputs = {{"a", "end", "axis"}, {"b", "end", "y"}, {"c", "bottom", "normal"}};
    const model::Case c = build_case(d);
    EXPECT_EQ(c.kinematics, model::Kinematics::plane_strain);
    EXPECT_EQ(c.mesh.dimension, 2);
    const double half = std::sqrt(0.5);
    const std::vector<std::array<double, 3>> expected{{1, 0, 0}, {0, 1, 0}, {half, -half, 0}};
    for (std::size_t k = 0; k < expected.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(c.outputs[k].direction[i], expected[k][i], 1e-12) << c.outputs[k].name;
    d.outputs = {{"shift", "end", "z"}};
    EXPECT_EQ(refusal(d), "outputs.shift.along: 'z' is not a direction of this model; use axis, x, y or normal");
}

TEST(BuildCase, RingIsSupportedByItsSymmetryPlanes) {
    const model::Case plane = build_case(design_of("ring", "plane-strain"));
    EXPECT_EQ(plane.model_fraction, 0.25);
    EXPECT_EQ(fixed_components(plane, meshing::symmetry_x_face), (Components{true, false, false}));
    EXPECT_EQ(fixed_components(plane, meshing::symmetry_y_face), (Components{false, true, false}));
    const model::Case slice = build_case(design_of("ring", "solid"));
    EXPECT_EQ(slice.model_fraction, 0.25);
    EXPECT_EQ(fixed_components(slice, "left"), (Components{false, false, true}));  // it cannot lengthen
    EXPECT_EQ(fixed_components(slice, "right"), (Components{false, false, true}));
    ASSERT_EQ(slice.cavities.at(0).openings.size(), 2u);
    for (const model::Opening& opening : slice.cavities[0].openings)
        EXPECT_NEAR(opening.area_m2, std::numbers::pi * 1e-4, 1e-18);
}

TEST(BuildCase, TractionsHaveTheRequestedDirection) {
    using enum model::DeadLoadKind;
    design::Design d = design_of("panel", "plane-strain", {{"geometry.rise", "48 mm"}});
    d.dead_loads = {
        {"end", traction, 62.5e3, "y"}, {"bottom", traction, -1e3, "normal"}, {"top", traction, -2e3, "axis"}};
    const model::Case c = build_case(d);
    ASSERT_EQ(c.dead_loads.size(), 3u);
    EXPECT_EQ(c.dead_loads[0].name, "end");
    EXPECT_EQ(c.dead_loads[0].vector_SI, (std::array<double, 3>{0, 62.5e3, 0}));
    EXPECT_NEAR(c.dead_loads[1].vector_SI[0], -1e3 * std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(c.dead_loads[1].vector_SI[1], 1e3 * std::sqrt(0.5), 1e-9);
    EXPECT_EQ(c.dead_loads[2].vector_SI[0], -2e3);
    d.dead_loads = {{"patch", traction, 1e3, "y"}};
    EXPECT_EQ(refusal(d), "loads.patch: this model has no face 'patch'; available faces: fixed, end, bottom, top");
    d.dead_loads = {{"end", traction, 1e3, "z"}};
    EXPECT_EQ(refusal(d), "loads.end.along: 'z' is not a direction of this model; use axis, x, y or normal");
    d = design_of("tube", "axisymmetric");
    d.dead_loads = {{"outer", traction, 1e3, "r"}};
    EXPECT_EQ(build_case(d).dead_loads[0].vector_SI, (std::array<double, 3>{0, 1e3, 0}));
    d = design_of("tube", "quarter");
    d.dead_loads = {{"outer", traction, 1e3, "normal"}};
    EXPECT_EQ(refusal(d), "loads.outer.along: face 'outer' is not flat; use axis, x, y or z");
}

TEST(BuildCase, FBarRequiresFirstOrderQuadrilateralsOrHexahedra) {
    const sample::Changes first{{"mesh.order", "1"}, {"mesh.formulation", "f-bar"}};
    for (const char* model : {"plane-strain", "solid"})
        EXPECT_EQ(build_case(design_of("panel", model, first)).formulation, model::Formulation::f_bar);
    EXPECT_EQ(build_case(design_of("tube", "axisymmetric", first)).formulation, model::Formulation::f_bar);
    EXPECT_EQ(
        refusal(design_of("tube", "quarter", first)),
        "test: mesh.formulation: F-bar is for first-order quadrilaterals and hexahedra, not wedge6; use mesh.order 2 with "
        "formulation mixed");
}

TEST(BuildCase, UnknownWordsAreRejected) {
    EXPECT_EQ(refusal(design_of("tube", "torus")),
              "test: model: 'torus' is not a model; use axisymmetric, plane-strain, solid, half or quarter");
    design::Design d = design_of("tube", "solid");
    d.family = "torus";
    EXPECT_EQ(refusal(d), "family: no family is called 'torus'");
}

}  // namespace
}  // namespace soft::geometry
