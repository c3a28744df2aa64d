/// Weight, prescribed motions, forces and outputs: directions given as words become vectors.
#include <gtest/gtest.h>

#include "geometry/loading.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

using sample::refusal;

design::Design loaded_design(const std::string& family, const std::string& model) {
    design::Design d;
    d.family = family;
    d.values = sample::values(family, model);
    d.material = {"rubber", "neo-hookean", {{"mu", {0.1644e6}}}, std::nullopt, 1080.0};
    return d;
}

TEST(Traction, HasTheRequestedDirectionAndTheStatedSign) {
    design::Design d = loaded_design("rod", "solid");
    for (const auto& [size, along] : {std::pair{1e3, "-x"}, {-1e3, "x"}}) {
        d.dead_loads = {{"end", model::DeadLoadKind::traction, size, along}};
        const model::DeadLoad load = build_case(d).dead_loads.at(0);
        EXPECT_EQ(load.vector_SI, (std::array<double, 3>{-1e3, 0, 0})) << along;
        EXPECT_EQ(load.sign, size < 0 ? -1 : 1) << along;
    }
}

TEST(Weight, HasTheRequestedDirection) {
    design::Design d = loaded_design("bellows", "axisymmetric");
    for (const auto& [along, x] :
         std::map<std::string, double>{{"x", 9.81}, {"-x", -9.81}, {"axis", -9.81}, {"-axis", 9.81}}) {
        // The axis of the bellows points from the fixed disc to the inlet, along -x.
        d.dead_loads = {{"gravity", model::DeadLoadKind::gravity, 9.81, along}};
        EXPECT_EQ(build_case(d).dead_loads.at(0).vector_SI, (std::array<double, 3>{x, 0, 0})) << along;
    }
    d.dead_loads = {{"gravity", model::DeadLoadKind::gravity, 9.81, "-y"}};
    EXPECT_EQ(refusal(d), "loads.gravity.along: 'y' is not a direction of this model; use axis, x, r or normal");
    d = loaded_design("rod", "solid");
    d.dead_loads = {{"gravity", model::DeadLoadKind::gravity, 9.81, "-z"}};
    EXPECT_EQ(build_case(d).dead_loads.at(0).vector_SI, (std::array<double, 3>{0, 0, -9.81}));
}

TEST(Weight, AcrossASymmetryPlaneIsRejected) {
    design::Design d = loaded_design("rod", "quarter");
    d.dead_loads = {{"gravity", model::DeadLoadKind::gravity, 9.81, "-z"}};
    EXPECT_EQ(
        refusal(d),
        "loads.gravity.along: the symmetry plane z = 0 of the model would mirror the weight; use a model without this "
        "plane, or another direction");
    d.dead_loads = {{"gravity", model::DeadLoadKind::gravity, 9.81, "x"}};
    EXPECT_EQ(refusal(d), "accepted");
    d = loaded_design("rod", "half");
    d.dead_loads = {{"gravity", model::DeadLoadKind::gravity, 9.81, "-z"}};
    EXPECT_EQ(refusal(d), "accepted");
    d = loaded_design("sphere", "solid");
    d.dead_loads = {{"gravity", model::DeadLoadKind::gravity, 9.81, "-z"}};
    EXPECT_EQ(refusal(d), "loads.gravity.along: no support carries the weight of the body; remove gravity");
}

TEST(Motions, MoveOneComponentOfAFace) {
    design::Design d = loaded_design("rod", "solid");
    d.motions = {{"end", 10e-3, "axis"}, {"left", 1e-3, "normal"}};
    const model::Case c = build_case(d);
    ASSERT_EQ(c.motions.size(), 2u);
    EXPECT_EQ(c.motions[0].displacement_m[0], 10e-3);
    EXPECT_FALSE(c.motions[0].displacement_m[1] || c.motions[0].displacement_m[2]);
    EXPECT_EQ(c.motions[1].displacement_m[1], -1e-3);  // left is y = 0
    d = loaded_design("tube", "axisymmetric");
    d.motions = {{"outer", 2e-3, "r"}};
    EXPECT_EQ(build_case(d).motions.at(0).displacement_m[1], 2e-3);
    d = loaded_design("panel", "plane-strain");
    d.values.set("geometry.rise", {48e-3, "48 mm", "test", true});
    d.motions = {{"bottom", 1e-3, "normal"}};
    EXPECT_EQ(
        refusal(d),
        "loads.bottom.along: a motion must follow a coordinate axis, and this direction does not; rotate the part, or "
        "use x, y or z");
}

TEST(Motions, OfFixedFacesAreRejectedWithBothNames) {
    design::Design d = loaded_design("rod", "solid");
    d.supports = {{"fixed", {true, true, true}}};
    d.motions = {{"fixed", 1e-3, "x"}};
    EXPECT_EQ(refusal(d),
              "loads.fixed.displacement: over-constrained in x: a support fixes 'fixed'; keep one of the two");
    d.motions = {{"top", 1e-3, "z"}};  // shares an edge with the fixed face
    EXPECT_EQ(refusal(d),
              "loads.top.displacement: over-constrained in z: a support fixes 'fixed', which shares nodes with 'top'; "
              "keep one of the two");
    d.supports = {{"fixed", {true, false, false}}};
    EXPECT_EQ(refusal(d), "accepted");
    d.motions = {{"top", 1e-3, "z"}, {"left", 2e-3, "z"}};
    EXPECT_EQ(refusal(d),
              "loads.left.displacement: over-constrained in z: another motion moves 'top', which shares nodes with "
              "'left'; keep one of the two");
    d.motions = {{"top", 1e-3, "z"}, {"left", 1e-3, "z"}};
    EXPECT_EQ(refusal(d), "accepted");  // they agree
    d = loaded_design("tube", "axisymmetric");
    d.motions = {{"inlet", 1e-3, "r"}};
    EXPECT_EQ(refusal(d),
              "loads.inlet.displacement: over-constrained in r: a support fixes 'axis', which shares nodes with "
              "'inlet'; keep one of the two");
}

TEST(Angles, HaveAnAxisAndABendHasAReference) {
    design::Design d = loaded_design("rod", "solid");
    d.outputs = {{"tilt", "end", "y", model::Measure::bend, "fixed"}, {"turn", "end", "axis", model::Measure::twist}};
    const model::Case c = build_case(d);
    EXPECT_EQ(c.outputs.at(0).measure, model::Measure::bend);
    EXPECT_EQ(c.outputs[0].reference, "fixed");
    EXPECT_EQ(c.outputs[0].direction, (std::array<double, 3>{0, 1, 0}));
    EXPECT_EQ(c.outputs.at(1).measure, model::Measure::twist);
    EXPECT_EQ(c.outputs[1].reference, "");
    d = loaded_design("panel", "plane-strain");
    d.outputs = {{"tilt", "end", "z", model::Measure::bend, "fixed"}};
    EXPECT_EQ(build_case(d).outputs.at(0).direction, (std::array<double, 3>{0, 0, 1}));
    d.outputs = {{"tilt", "end", "z", model::Measure::bend, "left"}};
    EXPECT_EQ(refusal(d),
              "outputs.tilt.reference: this model has no face 'left'; available faces: fixed, end, bottom, top");
}

TEST(Forces, AreDistributedOverTheWholeFaceOfTheWholeActuator) {
    for (const char* model : {"solid", "half", "quarter"}) {
        design::Design d = loaded_design("rod", model);
        d.dead_loads = {{"end", model::DeadLoadKind::force, 2.0, "x"}};
        const model::Case c = build_case(d);
        ASSERT_EQ(c.dead_loads.size(), 1u);
        const double area = d.values.number("geometry.width") * d.values.number("geometry.height");
        EXPECT_NEAR(c.dead_loads[0].area_m2, area, 1e-12 * area) << model;
        EXPECT_NEAR(c.dead_loads[0].vector_SI[0], 2.0 / area, 1e-9 / area) << model;
        EXPECT_EQ(model::leading_load(c), model::LeadingLoad::force);
    }
    design::Design d = loaded_design("rod", "half");
    d.dead_loads = {{"end", model::DeadLoadKind::force, 2.0, "y"}};
    EXPECT_EQ(refusal(d),
              "loads.end.along: a symmetry plane of the model would mirror the force; use a model without this plane, "
              "or another direction");
    d = loaded_design("sphere", "axisymmetric");  // half the section: the outer face is a whole sphere's
    d.dead_loads = {{"outer", model::DeadLoadKind::force, 2.0, "x"}};
    EXPECT_NE(refusal(d), "accepted");
}

TEST(Reactions, RequireAConstraintInTheirDirection) {
    design::Design d = loaded_design("rod", "half");
    d.supports = {{"fixed", {true, true, true}}};
    d.outputs = {{"pull", "fixed", "x", model::Measure::force}, {"turn", "fixed", "y", model::Measure::moment}};
    EXPECT_EQ(build_case(d).outputs.at(0).measure, model::Measure::force);
    d.outputs = {{"pull", "end", "x", model::Measure::force}};
    EXPECT_EQ(
        refusal(d),
        "outputs.pull.face: 'end' is not constrained in this direction, so there is no reaction force; fix it under "
        "supports, or prescribe a displacement under loads");
    d.motions = {{"end", 1e-3, "x"}};
    EXPECT_EQ(refusal(d), "accepted");
    d.outputs = {{"pull", "end", "z", model::Measure::force}};
    EXPECT_NE(refusal(d), "accepted");
    d.outputs = {{"pull", "fixed", "y", model::Measure::force}};
    EXPECT_EQ(
        refusal(d),
        "outputs.pull.along: the force is 0, because the mirror image of the face cancels it; use another direction");
    d.outputs = {{"turn", "fixed", "z", model::Measure::moment}};
    EXPECT_EQ(
        refusal(d),
        "outputs.turn.along: the moment is 0, because the mirror image of the face cancels it; use another direction");
}

}  // namespace
}  // namespace soft::geometry
