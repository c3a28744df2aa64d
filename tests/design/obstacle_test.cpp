/// Obstacles, contact keys, loads that move an obstacle, and outputs of contact.
#include <gtest/gtest.h>

#include "sample.hpp"

namespace {

using namespace soft;
using namespace soft::design;
using namespace soft::design::sample;

const std::string table =
    "obstacles: {table: {plane: {point: [0 mm, 0 mm, -5 mm], normal: [0, 0, 1]}}}\nmodel: solid\n";

/// The design without its loads, with a table.
std::string with_loads(const std::string& loads) {
    return "family: pipe\nmaterial: {law: neo-hookean, mu: 0.1644 MPa}\n" + table + "loads: " + loads + "\n";
}

std::string output_refusal(const std::string& output, const std::string& more = {}) {
    return refusal(base + table + "outputs: {grip: {" + output + "}}\n" + more);
}

TEST(Obstacle, IsAbsentByDefaultAndContactIsSolved) {
    const Design design = read(minimal_design);
    EXPECT_TRUE(design.obstacles.empty());
    EXPECT_TRUE(design.contact.self);
    EXPECT_EQ(design.path.contact, model::Contact::solve);
    EXPECT_EQ(read(base + "path: {contact: stop}\n").path.contact, model::Contact::stop);
    EXPECT_TRUE(contains(refusal(base + "path: {contact: sovle}\n"), "did you mean 'solve'"));
}

TEST(Obstacle, MovesContinuouslyInAMotion) {
    const std::string design = "family: pipe\nmaterial: {law: neo-hookean, mu: 0.1644 MPa, density: 1000 kg/m^3}\n" +
                               table + "dynamics: {duration: 10 ms}\n";
    const auto moved = [&](const std::string& time_function) {
        return design + "loads: {cavity: {pressure: 1 kPa}, table: {displacement: 1 mm, along: z" + time_function +
               "}}\n";
    };
    const Design ramp = read(moved(", time_function: {kind: ramp, rise: 4 ms}"));
    EXPECT_EQ(ramp.motions.at(0).time_function.time_s, 0.004);
    EXPECT_EQ(read(moved("")).motions.at(0).time_function.kind, model::TimeFunctionKind::ramp);
    const std::string jump = "loads.table.time_function: an obstacle cannot jump away from its place";
    for (const char* function :
         {", time_function: {kind: step}", ", time_function: {kind: table, times: [0 s, 1 s], shares: [0.1, 1]}"}) {
        const std::string line = refusal(moved(function));
        EXPECT_TRUE(contains(line, jump)) << line;
    }
}

TEST(Obstacle, HasAShapeAndTheOrderOfTheDesign) {
    const Design design = read(base +
                               "contact: {self: false, friction: 0.2}\nobstacles:\n"
                               "  wall: {surface: wall.stl, unit: m, friction: 0.5}\n"
                               "  table: {plane: {point: [0 mm, 1 cm, -5 mm], normal: [0, 0, 1]}}\n");
    EXPECT_FALSE(design.contact.self);
    EXPECT_EQ(design.contact.friction, 0.2);
    EXPECT_EQ(design.values.number("obstacles.wall.friction"), 0.5);
    EXPECT_TRUE(design.values.numbers("obstacles.table.friction").empty());  // that of contact
    ASSERT_EQ(design.obstacles.size(), 2u);
    EXPECT_EQ(design.obstacles[0].name, "wall");  // in the order of the design
    EXPECT_EQ(design.obstacles[0].shape, "surface");
    EXPECT_EQ(design.values.text("obstacles.wall.unit"), "m");
    EXPECT_EQ(design.obstacles[1].shape, "plane");
    EXPECT_EQ(design.values.numbers("obstacles.table.plane.point"), (std::vector{0.0, 0.01, -0.005}));
    EXPECT_EQ(read(design.effective_yaml).effective_yaml, design.effective_yaml);
}

TEST(Obstacle, TakesOverridesAndIsExplained) {
    const Design design = read(base + table, {{"obstacles.table.plane.point", "[0 mm, 0 mm, -7 mm]"}});
    EXPECT_EQ(design.values.numbers("obstacles.table.plane.point").at(2), -0.007);
    const std::string explained = explain_design(base + table, "p.yaml", families(), {});
    EXPECT_TRUE(contains(explained, "point: [0 mm, 0 mm, -5 mm]")) << explained;
}

TEST(Obstacle, ThatIsInvalidIsRefusedAtItsPlace) {
    const auto refused = [](const std::string& obstacles) {
        return refusal(base + "obstacles: {" + obstacles + "}\n");
    };
    const std::string plane = "plane: {point: [0 mm, 0 mm, 0 mm], normal: [1, 0, 0]}";
    EXPECT_TRUE(contains(refused("a: {}"),
                         "p.yaml:4:13: obstacles.a: the shape of the obstacle is missing; add plane | surface"));
    EXPECT_TRUE(contains(refused("a: {plne: {point: 1}}"), "obstacles.a.plne: unknown key; did you mean 'plane'?"));
    EXPECT_TRUE(contains(refused("a: {" + plane + ", surface: b.stl}"),
                         "obstacles.a.surface: the obstacle is a plane already; write two obstacles"));
    EXPECT_TRUE(contains(refused("a: {" + plane + ", friction: -1}"), "obstacles.a.friction: -1 is out of range"));
    EXPECT_TRUE(contains(refusal(base + "contact: {friction: rough}\n"), "contact.friction: "));
    EXPECT_TRUE(contains(refused("a: {plane: {normal: [1, 0, 0]}}"), "obstacles.a.plane.point: missing"));
    EXPECT_TRUE(contains(refused("a: {plane: {point: [0, 0, 1], normal: [1, 0, 0]}}"), "obstacles.a.plane.point: "));
    for (const std::string name : {"inlet", "end_disc"})  // a face and its alias
        EXPECT_TRUE(contains(refused(name + ": {" + plane + "}"),
                             "obstacles." + name + ": a face of the actuator has this name; choose another name"));
    for (const std::string name : {"self", "gravity", "cavities"})
        EXPECT_TRUE(contains(refused(name + ": {" + plane + "}"), "the name is reserved")) << name;
    EXPECT_TRUE(contains(refused("my-table: {" + plane + "}"), "not a name of an obstacle"));
}

TEST(Obstacle, IsMovedByALoadOfItsName) {
    const Design design = read(with_loads("{cavity: {pressure: 3 kPa}, table: {displacement: 5 mm, along: z}}"));
    ASSERT_EQ(design.motions.size(), 1u);
    EXPECT_EQ(design.motions[0].face, "table");
    EXPECT_EQ(design.motions[0].displacement_m, 5e-3);
    EXPECT_EQ(design.motions[0].along, "z");
    EXPECT_EQ(read(design.effective_yaml).effective_yaml, design.effective_yaml);
    EXPECT_EQ(read_built(design.effective_yaml, {{"loads.table.displacement", "2 mm"}, {"contact.self", "false"}})
                  .motions.at(0)
                  .displacement_m,
              2e-3);
    const Design stages = read(with_loads("{cavity: {pressure: 3 kPa}, table: {displacement: 4 mm, along: axis}}") +
                               "path: {stages: {close: {loads: {table: {displacement: 1 mm}}}, "
                               "inflate: {loads: {cavity: {pressure: 3 kPa}}}}}\n");
    EXPECT_EQ(stages.path.stages.at(0).motions, std::vector{0.25});
}

TEST(Obstacle, HasNoLoadOtherThanADisplacement) {
    EXPECT_TRUE(contains(refusal(with_loads("{table: {force: 1 N, along: z}}")),
                         "loads.table.force: an obstacle is moved; write displacement"));
    EXPECT_TRUE(contains(refusal(with_loads("{table: {displacement: 1 mm, along: normal}}")), "loads.table.along: "));
    EXPECT_TRUE(contains(refusal(with_loads("{tabel: {displacement: 1 mm, along: z}}")), "did you mean 'table'"));
    EXPECT_TRUE(contains(refusal(with_loads("{table: {displacement: 1 mm, along: z}}"), {{"model", "axisymmetric"}}),
                         "loads.table.along: an obstacle of an axisymmetric model has the direction x; use axis or x"));
}

TEST(ContactOutput, IsAForceAnAreaOrAPressure) {
    const Design design = read(base + table +
                               "outputs: {grip: {obstacle: table, measure: force, along: z}, "
                               "patch: {obstacle: table, measure: area}, peak: {obstacle: self, measure: pressure}}\n"
                               "path: {until: {grip: 2 N, patch: 30 mm^2, peak: 5 kPa}}\n");
    ASSERT_EQ(design.outputs.size(), 3u);
    EXPECT_EQ(design.outputs[0].obstacle, "table");
    EXPECT_TRUE(design.outputs[0].face.empty());
    EXPECT_EQ(design.outputs[0].measure, model::Measure::force);
    EXPECT_EQ(design.outputs[0].along, "z");
    EXPECT_EQ(design.outputs[1].measure, model::Measure::contact_area);
    EXPECT_TRUE(design.outputs[1].along.empty());
    EXPECT_EQ(design.outputs[2].obstacle, model::self_contact);
    EXPECT_EQ(design.outputs[2].measure, model::Measure::contact_pressure);
    const auto& until = design.path.stages.at(0).until;
    EXPECT_EQ(until.at(0).value, 2.0);
    EXPECT_NEAR(until.at(1).value, 30e-6, 1e-18);
    EXPECT_EQ(until.at(2).value, 5e3);
    EXPECT_EQ(read(design.effective_yaml).effective_yaml, design.effective_yaml);
}

TEST(ContactOutput, ThatIsInconsistentIsRefused) {
    EXPECT_TRUE(contains(output_refusal("obstacle: tabel, measure: area"), "did you mean 'table'"));
    EXPECT_TRUE(contains(output_refusal("obstacle: table"), "outputs.grip.measure: missing"));
    EXPECT_TRUE(contains(output_refusal("obstacle: table, measure: bend"), "outputs.grip.measure: 'bend'"));
    EXPECT_TRUE(contains(output_refusal("obstacle: table, face: inlet, measure: area"),
                         "outputs.grip.face: the output has an obstacle already"));
    EXPECT_TRUE(contains(output_refusal("obstacle: table, measure: area, along: z"),
                         "outputs.grip.along: this measure has no direction; leave it out"));
    EXPECT_TRUE(contains(output_refusal("face: inlet, measure: area"),
                         "outputs.grip.measure: only contact has this measure; write obstacle: NAME"));
    EXPECT_TRUE(contains(output_refusal("obstacle: self, measure: force"),
                         "outputs.grip.measure: the forces of self-contact cancel each other"));
    EXPECT_TRUE(contains(output_refusal("obstacle: self, measure: displacement"),
                         "outputs.grip.measure: only an obstacle has a displacement"));
    EXPECT_TRUE(contains(output_refusal("obstacle: self, measure: area", "contact: {self: false}\n"),
                         "outputs.grip.obstacle: contact.self is false, so there is no self-contact"));
}

TEST(ContactOutput, IsTheDisplacementOfAnObstacle) {
    const Design design = read(base + table + "outputs: {way: {obstacle: table, measure: displacement, along: z}}\n");
    EXPECT_EQ(design.outputs.at(0).measure, model::Measure::displacement);
    EXPECT_EQ(design.outputs.at(0).along, "z");
}

TEST(ContactOutput, IsPossibleInAMotion) {
    const Design design = read(
        "family: pipe\nmaterial: {law: neo-hookean, mu: 1 kPa, density: 1000 kg/m^3}\nloads: {cavity: {pressure: 1 kPa}}\n" +
        table + "outputs: {a: {obstacle: table, measure: force, along: z}}\ndynamics: {duration: 1 s}\n");
    EXPECT_EQ(design.outputs.size(), 1u);
}

}  // namespace
