/// Obstacles in the three kinematics, what is refused, and overlaps with the undeformed actuator.
#include <gtest/gtest.h>

#include "../model/equal.hpp"
#include "geometry/obstacle.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

constexpr double mm = 1e-3;

/// A rod, x from 0 to 50 mm, y and z from 0 to 10 mm; the quarter model is y, z from 0 to 5 mm.
std::string rod(const std::string& model = "solid") {
    return "family: rod\ngeometry: {length: 50 mm, height: 10 mm, width: 10 mm}\nmesh: {size: 5 mm}\nmodel: " + model +
           "\nmaterial: {law: neo-hookean, mu: 100 kPa}\nloads: {end: {traction: 1 kPa, along: x}}\n";
}

/// A tube about x from 0 to 100 mm, radii 8 and 10 mm.
const std::string tube =
    "family: tube\ngeometry: {length: 100 mm, inner_radius: 8 mm, outer_radius: 10 mm}\nmesh: {size: 2 mm}\n"
    "model: axisymmetric\nmaterial: {law: neo-hookean, mu: 100 kPa}\nloads: {cavity: {pressure: 1 kPa}}\n";

/// A disc of radius 10 mm about the origin, in plane strain; its four edges are arcs.
const std::string disc =
    "family: extruded\ngeometry:\n  profile: |\n    x_mm,y_mm,tag,curve,via_x_mm,via_y_mm\n"
    "    10,0,rim,arc,7.0710678119,7.0710678119\n    0,10,rim,arc,-7.0710678119,7.0710678119\n"
    "    -10,0,foot,arc,-7.0710678119,-7.0710678119\n    0,-10,rim,arc,7.0710678119,-7.0710678119\n"
    "model: plane-strain\nmaterial: {law: neo-hookean, mu: 100 kPa}\nsupports: {fixed: foot}\n"
    "loads: {rim: {pressure: 1 kPa}}\noutputs: {shift: {face: rim, along: x}}\n";

design::Design read(const std::string& text) { return design::read_design(text, "a.yaml", catalogue_keys(), {}); }

Built built(const std::string& text) { return build_with_figures(read(text)); }

std::string obstacle(const std::string& shape) { return "obstacles:\n  thing: {" + shape + "}\n"; }

/// An obstacle from a table.
std::string profile(std::initializer_list<const char*> rows) {
    std::string text = "obstacles:\n  thing:\n    profile: |\n";
    for (const char* row : rows) text.append("      ").append(row).append("\n");
    return text;
}

std::string refused(const std::string& text) {
    try {
        static_cast<void>(built(text));
    } catch (const Error& error) {
        EXPECT_TRUE(error.code() == ExitCode::bad_input || error.code() == ExitCode::cannot_open);
        return error.what();
    }
    return "accepted";
}

double gap_m(const std::string& text) { return built(text).gaps.at(0).gap_m; }

void expect_words(const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << text;
}

void expect_point(const mesh::Point& point, const mesh::Point& expected) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(point[i], expected[i], 1e-15);
}

TEST(SolidObstacles, KeepTheirPositionAndUnitVectors) {
    const model::Case c =
        built(rod() +
              "obstacles:\n"
              "  table: {plane: {point: [0 mm, 0 mm, -3 mm], normal: [0, 0, 2]}}\n"
              "  post: {cylinder: {point: [20 mm, 0 mm, 14 mm], axis: [0, -3, 0], radius: 3 mm}}\n"
              "  sleeve: {cylinder: {point: [1 mm, 5 mm, 5 mm], axis: [1, 0, 0], radius: 9 mm, inside: true}}\n"
              "  ball: {sphere: {center: [60 mm, 0 mm, -20 mm], radius: 8 mm}}\n")
            .model;
    ASSERT_EQ(c.obstacles.size(), 4u);
    const auto& plane = std::get<model::Plane>(c.obstacles[0].shape);
    expect_point(plane.point, {0, 0, -3 * mm});
    EXPECT_EQ(plane.normal, (Vector3{0, 0, 1}));
    const auto& post = std::get<model::Cylinder>(c.obstacles[1].shape);
    EXPECT_EQ(post.axis, (Vector3{0, -1, 0}));
    EXPECT_EQ(post.side, model::Side::outside);
    EXPECT_NEAR(post.radius_m, 3 * mm, 1e-15);
    EXPECT_EQ(std::get<model::Cylinder>(c.obstacles[2].shape).side, model::Side::inside);
    expect_point(std::get<model::Sphere>(c.obstacles[3].shape).center, {60 * mm, 0, -20 * mm});
}

/// Enclosed volume, positive if the normals point out.
double volume_m3(const model::FacetedSurface& surface) {
    double volume = 0;
    for (const auto& facet : surface.facets)
        volume += dot(model::facet_normal(surface, facet), surface.points.at(static_cast<std::size_t>(facet[0]))) / 6;
    return volume;
}

TEST(SolidObstacles, SurfacesHaveNormalsOutOfTheObstacle) {
    const Built t =
        built(rod() +
              "obstacles:\n  thing:\n    unit: cm\n    surface: |\n      v 0 2 0\n      v 1 2 0\n      v 0 3 0\n      "
              "v 0 2 1\n      f 1 2 3\n      f 1 2 4\n      f 2 3 4\n      f 3 1 4\n");  // orientation repaired
    EXPECT_NEAR(volume_m3(std::get<model::FacetedSurface>(t.model.obstacles.at(0).shape)), 1e-6 / 6, 1e-16);
}

/// Facets of the rod have sides of 5 mm, so that auto is limited by the box.
TEST(SolidObstacles, EdgesOfABoxAreRounded) {
    const auto radius_mm = [](const std::string& radius) {
        const Built b =
            built(rod() + obstacle("box: {from: [0 mm, 11 mm, 0 mm], to: [20 mm, 31 mm, 12 mm]" + radius + "}"));
        EXPECT_NEAR(b.gaps.at(0).gap_m, 1 * mm, 1e-15);
        return std::get<model::Box>(b.model.obstacles.at(0).shape).radius_m / mm;
    };
    EXPECT_NEAR(radius_mm(", radius: 2 mm"), 2, 1e-12);
    EXPECT_EQ(radius_mm(", radius: 0 mm"), 0);
    EXPECT_NEAR(radius_mm(""), 3, 1e-12);
    expect_words(refused(rod() + obstacle("box: {from: [0 mm, 11 mm, 0 mm], to: [9 mm, 13 mm, 5 mm], radius: 1.1 mm}")),
                 {"a.yaml:", "obstacles.thing.box.radius", "thinner than twice this radius"});
}

TEST(SolidObstacles, ProfilesExtendFarAlongZ) {
    const Built b =
        built(rod() +
              "obstacles:\n  die:\n    profile: |\n      x_mm,y_mm,tag\n      0,11,a\n      50,11,a\n      25,25,a\n");
    const auto& die = std::get<model::FacetedSurface>(b.model.obstacles.at(0).shape);
    ASSERT_EQ(die.facets.size(), 6u);
    for (const mesh::Point& point : die.points) EXPECT_GT(std::abs(point[2]), 10 * 50 * mm);
    EXPECT_LT(model::facet_normal(die, die.facets[0])[1], 0);  // the lower side points down, to the rod
    EXPECT_NEAR(b.gaps.at(0).gap_m, 1 * mm, 1e-15);
}

TEST(PlaneStrainObstacles, ExtendAlongZ) {
    const auto accepted = [](const std::string& shape) { return gap_m(disc + obstacle(shape)); };
    EXPECT_NEAR(accepted("plane: {point: [0 mm, -12 mm, 3 mm], normal: [0, 1, 0]}"), 2 * mm, 1e-6 * mm);
    EXPECT_NEAR(accepted("cylinder: {point: [15 mm, 0 mm, 3 mm], axis: [0, 0, -1], radius: 4 mm}"), 1 * mm, 1e-6 * mm);
    EXPECT_NEAR(accepted("box: {from: [11 mm, -3 mm, 0 mm], to: [20 mm, 3 mm, 0 mm]}"), 1 * mm, 1e-6 * mm);
    EXPECT_NEAR(gap_m(disc + profile({"x_mm,y_mm,tag", "13,0,a", "20,-3,a", "20,3,a"})), 3 * mm, 1e-6 * mm);
    expect_words(refused(disc + obstacle("plane: {point: [0 mm, -12 mm, 0 mm], normal: [0, 1, 1]}")),
                 {"a.yaml:", "obstacles.thing.plane.normal: a plane in a plane strain model is parallel to z"});
    expect_words(refused(disc + obstacle("cylinder: {point: [0 mm, 0 mm, 0 mm], axis: [1, 0, 0], radius: 4 mm}")),
                 {"obstacles.thing.cylinder.axis: ", "use [0, 0, 1]"});
    expect_words(refused(disc + obstacle("sphere: {center: [0 mm, 0 mm, 0 mm], radius: 4 mm}")),
                 {"obstacles.thing.sphere.center: a plane strain model has no spheres"});
    expect_words(refused(disc + obstacle("surface: a.stl")), {"obstacles.thing.surface: a section has no obstacles"});
}

TEST(AxisymmetricObstacles, AreBodiesOfRevolution) {
    const auto accepted = [](const std::string& shape) { return gap_m(tube + obstacle(shape)); };
    EXPECT_NEAR(accepted("plane: {point: [103 mm, 5 mm, 2 mm], normal: [-4, 0, 0]}"), 3 * mm, 1e-12);
    EXPECT_NEAR(accepted("cylinder: {point: [9 mm, 0 mm, 0 mm], axis: [1, 0, 0], radius: 14 mm, inside: true}"), 4 * mm,
                1e-12);
    EXPECT_NEAR(gap_m(tube + profile({"x_mm,r_mm,tag", "110,0,axis", "120,0,a", "120,10,a", "110,10,a"})), 10 * mm,
                1e-12);
    expect_words(refused(tube + obstacle("plane: {point: [103 mm, 0 mm, 0 mm], normal: [1, 1, 0]}")),
                 {"obstacles.thing.plane.normal: a plane in an axisymmetric model is normal to x"});
    expect_words(refused(tube + obstacle("cylinder: {point: [0 mm, 1 mm, 0 mm], axis: [1, 0, 0], radius: 4 mm}")),
                 {"obstacles.thing.cylinder.point: ", "use y = 0 and z = 0"});
    expect_words(refused(tube + obstacle("cylinder: {point: [0 mm, 0 mm, 0 mm], axis: [0, 1, 0], radius: 4 mm}")),
                 {"obstacles.thing.cylinder.axis: "});
    expect_words(refused(tube + obstacle("sphere: {center: [0 mm, 1 mm, 0 mm], radius: 4 mm}")),
                 {"obstacles.thing.sphere.center: "});
    expect_words(refused(tube + obstacle("box: {from: [0 mm, 0 mm, 0 mm], to: [1 mm, 1 mm, 1 mm]}")),
                 {"obstacles.thing.box.from: a box is not a body of revolution about x"});
}

TEST(AxisymmetricObstacles, OfAProfileHaveNoSurfaceOnTheAxis) {
    const Built b = built(tube + profile({"x_mm,r_mm,tag", "110,0,axis", "120,0,a", "120,10,a", "110,10,a"}));
    const auto& turned = std::get<model::FacetedSurface>(b.model.obstacles.at(0).shape);
    ASSERT_EQ(turned.facets.size(), 3u);
    for (const auto& facet : turned.facets) {
        EXPECT_EQ(facet[2], -1);
        const Vector3 normal = model::facet_normal(turned, facet);
        const mesh::Point& start = turned.points.at(static_cast<std::size_t>(facet[0]));
        EXPECT_GT(dot(normal, difference(start, {115 * mm, 5 * mm, 0})), 0);  // out of the profile
    }
}

TEST(Obstacles, NeedThreeValuesAndADirection) {
    expect_words(refused(rod() + obstacle("plane: {point: [0 mm, 0 mm], normal: [0, 0, 1]}")),
                 {"obstacles.thing.plane.point: three values are needed; use [x, y, z]"});
    expect_words(refused(rod() + obstacle("plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 0]}")),
                 {"obstacles.thing.plane.normal: the direction is zero"});
    expect_words(refused(rod() + obstacle("box: {from: [0 mm, 7 mm, 0 mm], to: [1 mm, 6 mm, 1 mm]}")),
                 {"obstacles.thing.box.to: its y is not greater than that of from"});
    expect_words(refused(rod() + obstacle("surface: nothing.txt")), {"'nothing.txt' is not a surface file"});
    expect_words(refused(rod() + obstacle("surface: nothing.stl")), {"a.yaml:", "obstacles.thing.surface: "});
}

TEST(Overlap, OfATouchingObstacleIsAllowed) {
    EXPECT_NEAR(gap_m(rod() + obstacle("plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}")), 0, 1e-12);
    EXPECT_NEAR(gap_m(rod() + obstacle("box: {from: [20 mm, 3 mm, 10 mm], to: [30 mm, 7 mm, 14 mm]}")), 0, 1e-9);
    EXPECT_NEAR(gap_m(rod() + obstacle("sphere: {center: [23 mm, 5 mm, 13 mm], radius: 3 mm}")), 0, 1e-12);
    EXPECT_NEAR(gap_m(rod() + obstacle("cylinder: {point: [23 mm, 0 mm, 13 mm], axis: [0, 1, 0], radius: 3 mm}")), 0,
                1e-12);
    EXPECT_NEAR(gap_m(disc + obstacle("cylinder: {point: [13 mm, 0 mm, 0 mm], axis: [0, 0, 1], radius: 3 mm}")), 0,
                1e-6 * mm);
}

// The cells of the rod have sides of 5 mm.
TEST(SmallObstacle, IsReportedWithTheSizeOfTheCells) {
    const auto warnings = [](const std::string& text) {
        const design::Design design = read(text);
        return warnings_of(design, build_with_figures(design));
    };
    const auto ball = [](const std::string& radius, const std::string& z) {
        return rod() + obstacle("sphere: {center: [23 mm, 5 mm, " + z + "], radius: " + radius + "}");
    };
    EXPECT_TRUE(warnings(ball("6 mm", "20 mm")).empty());
    const auto small = warnings(ball("2 mm", "13 mm"));
    ASSERT_EQ(small.size(), 1);
    expect_words(small[0],
                 {"obstacles.thing: its radius of 2 mm is below the size of the cells that are nearest, 5 mm,"});
    const std::string post = "cylinder: {point: [23 mm, 0 mm, 20 mm], axis: [0, 1, 0], radius: ";
    EXPECT_TRUE(warnings(rod() + obstacle(post + "6 mm}")).empty()) << "5 mm across its axis";
    EXPECT_EQ(warnings(rod() + obstacle(post + "4 mm}")).size(), 1);
    EXPECT_TRUE(warnings(tube + obstacle("cylinder: {point: [0 mm, 0 mm, 0 mm], axis: [1, 0, 0], radius: 11 mm, "
                                         "inside: true}"))
                    .empty());
}

TEST(Overlap, IsRefusedWithItsDepthAndPosition) {
    expect_words(refused(rod() + obstacle("plane: {point: [0 mm, 0 mm, 0.5 mm], normal: [0, 0, 1]}")),
                 {"a.yaml:", "obstacles.thing.plane.point: 'thing' overlaps the undeformed actuator by 500 um at x = ",
                  "z = 0 mm; move it away, touching is allowed"});
    expect_words(
        refused(tube +
                obstacle("cylinder: {point: [0 mm, 0 mm, 0 mm], axis: [1, 0, 0], radius: 9.8 mm, inside: true}")),
        {"overlaps the undeformed actuator by 200 um at x = ", "r = 10 mm"});
    // A small ball in the rubber and a thin post through it contain no point of the surface.
    expect_words(refused(rod() + obstacle("sphere: {center: [23 mm, 5 mm, 8 mm], radius: 0.1 mm}")),
                 {"overlaps the undeformed actuator by 2.1 mm", "z = 10 mm"});
    expect_words(refused(rod() + obstacle("cylinder: {point: [23 mm, 6 mm, 0 mm], axis: [0, 0, 1], radius: 0.1 mm}")),
                 {"overlaps the undeformed actuator by 4.1 mm"});
    // A rod on the axis passes through the cap of the tube.
    expect_words(refused(tube + obstacle("cylinder: {point: [9 mm, 0 mm, 0 mm], axis: [1, 0, 0], radius: 5 mm}")),
                 {"overlaps the undeformed actuator by 6.6 mm", "r = 0 mm"});
    // The edge of a box dips into the surface between its nodes.
    expect_words(refused(rod() + obstacle("box: {from: [21 mm, -4 mm, 9.99 mm], to: [21.2 mm, 14 mm, 14 mm]}")),
                 {"overlaps the undeformed actuator by 10 um"});
    expect_words(refused(rod() + obstacle("box: {from: [-9 mm, -9 mm, -9 mm], to: [99 mm, 19 mm, 19 mm]}")),
                 {"overlaps the undeformed actuator by 14 mm"});
}

TEST(Overlap, OfAProfileIsMeasuredInItsSection) {
    expect_words(refused(disc + profile({"x_mm,y_mm,tag", "9.5,0,a", "20,-3,a", "20,3,a"})),
                 {"overlaps the undeformed actuator by 500 um", "x = 10 mm"});
    // The cavity of a mould surrounds the disc.
    EXPECT_NEAR(gap_m(disc + profile({"x_mm,y_mm,tag,loop", "-30,-30,a,1", "30,-30,a,1", "30,30,a,1", "-30,30,a,1",
                                      "-11,-11,a,2", "-11,11,a,2", "11,11,a,2", "11,-11,a,2"})),
                1 * mm, 1e-6 * mm);
}

TEST(Obstacles, OfACaseFileAreRebuiltWithoutTheirFile) {
    const design::Design design =
        read(rod() +
             "contact: {self: false}\nobstacles:\n  table: {plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}\n"
             "  block: {box: {from: [0 mm, 11 mm, 0 mm], to: [10 mm, 13 mm, 5 mm]}}\n"
             "  die:\n    profile: |\n      x_mm,y_mm,tag\n      0,11,a\n      50,11,a\n      25,25,a\n"
             "outputs: {push: {obstacle: block, measure: force, along: y}, patch: {obstacle: table, measure: area}}\n");
    Built b = build_with_figures(design);
    model::test::expect_equal(rebuild_case(b.model.mesh, b.shape, design.effective_yaml, "case.h5"), b.model);
    b.shape.obstacles.clear();
    try {
        static_cast<void>(rebuild_case(b.model.mesh, b.shape, design.effective_yaml, "case.h5"));
        FAIL() << "accepted";
    } catch (const Error& error) {
        expect_words(error.what(), {"obstacles.die: the case does not contain this obstacle; rebuild"});
    }
}

TEST(MovedObstacle, HasEveryComponentOfItsDisplacement) {
    std::string text = rod() + obstacle("plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}");
    text.replace(text.find("loads: {"), 8, "loads: {thing: {displacement: -2 mm, along: z}, ");
    const model::Case c = built(text).model;
    ASSERT_EQ(c.motions.size(), 1u);
    EXPECT_EQ(c.motions[0].face, "thing");
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(c.motions[0].displacement_m[i], i == 2 ? -2 * mm : 0.0);
}

TEST(ContactForce, ThatAMirrorImageCancelsIsRefused) {
    const std::string plane = obstacle("plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}");
    const std::string force = "outputs: {push: {obstacle: thing, measure: force, along: ";
    const model::Output output = built(rod() + plane + force + "z}}\n").model.outputs.at(0);
    EXPECT_EQ(output.obstacle, "thing");
    EXPECT_EQ(output.direction, (Vector3{0, 0, 1}));
    const std::string above = obstacle("plane: {point: [0 mm, 0 mm, 8 mm], normal: [0, 0, -1]}"),
                      before = obstacle("plane: {point: [52 mm, 0 mm, 0 mm], normal: [-1, 0, 0]}");
    EXPECT_EQ(built(rod("quarter") + above + force + "z}}\n").model.outputs.at(0).direction, (Vector3{0, 0, 1}));
    expect_words(refused(rod("quarter") + before + force + "z}}\n"),
                 {"outputs.push.along: the force on the mirror image at z = 0 cancels it"});
}

TEST(SymmetryPlanes, HaveTheObstaclesOnTheMeshedSide) {
    EXPECT_NEAR(gap_m(rod("quarter") + obstacle("plane: {point: [0 mm, 0 mm, 8 mm], normal: [0, 0, -1]}")), 3 * mm,
                1e-15);
    EXPECT_NEAR(gap_m(rod("quarter") + obstacle("plane: {point: [52 mm, 0 mm, 8 mm], normal: [-1, 0, 0]}")), 2 * mm,
                1e-15);
    expect_words(refused(rod("quarter") + obstacle("plane: {point: [0 mm, 0 mm, -8 mm], normal: [0, 0, 1]}")),
                 {"obstacles.thing.plane.point: 'thing' is nearer to the mirror image at z = 0 than to the part that "
                  "is meshed; mirror its position"});
    expect_words(refused(rod("half") + obstacle("sphere: {center: [25 mm, -9 mm, 5 mm], radius: 2 mm}")),
                 {"the mirror image at y = 0"});
}

}  // namespace
}  // namespace soft::geometry
