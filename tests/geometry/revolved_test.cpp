/// The families revolved and extruded: shapes from tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

#include "../meshing/gmsh_files.hpp"
#include "mesh/quality.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

using meshing::sample::TemporaryFile;

std::string drawn_text(const std::string& family, const std::filesystem::path& file, const std::string& more) {
    return "family: " + family + "\ngeometry: {profile: " + file.string() +
           "}\nmaterial: {law: neo-hookean, mu: 0.1644 MPa}\n" + more;
}

design::Design read_drawn(const std::string& text, std::vector<design::Override> overrides = {}) {
    return design::read_design(text, "part.yaml", catalogue_keys(), overrides);
}

Solid solid(const std::string& text, std::vector<design::Override> overrides = {}) {
    const design::Design design = read_drawn(text, std::move(overrides));
    return mesh_body(sample::family(design.family).build(design.values), design.values);
}

std::string drawn_refusal(const std::string& text, std::vector<design::Override> overrides = {}) {
    try {
        return sample::refusal(read_drawn(text, std::move(overrides)));
    } catch (const Error& error) {
        return error.what();
    }
}

const std::string usual_sections = "supports: {fixed: fixed}\nloads: {cavity: {pressure: 5 kPa}}\noutputs: {}\n";

/// designs/tube.yaml: 100 mm long, radii 7 and 10 mm, caps of 5 mm.
const std::string tube =
    "x_mm,r_mm,tag\n0,0,axis\n5,0,cavity\n5,7,cavity\n95,7,cavity\n95,0,axis\n100,0,inlet\n100,10,outer\n0,10,fixed\n";

TEST(Revolved, TubeHasTheVolumesOfTheFamilyTube) {
    const TemporaryFile file{"tube.csv", tube};
    for (const char* model : {"axisymmetric", "half", "quarter", "solid"}) {
        const Solid body =
            solid(drawn_text("revolved", file.path, usual_sections),
                  {{"model", model}, {"mesh.size", "3 mm"}, {"mesh.sectors", "4"}, {"mesh.through_wall", "1"}});
        EXPECT_GT(mesh::quality(body.mesh).min_scaled_jacobian, 0.1) << model;
        EXPECT_NEAR(1e9 * sample::rubber_m3(body) / (pi * (100 * 100 - 49 * 90)), 1, curved) << model;
        EXPECT_NEAR(1e9 * sample::cavity_m3(body) / (pi * 49 * 90), 1, curved) << model;
        EXPECT_NEAR(1e6 * sample::area_m2(body, "fixed") / (pi * 100), 1, curved) << model;
        const auto boundary = mesh::boundary_facets(body.mesh);
        std::set<mesh::Facet> named;
        for (const auto& [face, facets] : body.mesh.facet_sets) named.insert(facets.begin(), facets.end());
        EXPECT_EQ(named, std::set<mesh::Facet>(boundary.begin(), boundary.end())) << model;
    }
}

/// Pappus: a circle of radius 2 about r = 9 mm; its cavity is the hole of radius 1.
TEST(Revolved, TorusHasTheVolumeOfPappus) {
    const TemporaryFile file{
        "torus.csv",
        "x_mm,r_mm,tag,loop,curve,via_x_mm,via_r_mm\n2,9,fixed,out,arc,0,11\n-2,9,outer,out,arc,0,7\n"
        "1,9,cavity,in,arc,0,8\n-1,9,cavity,in,arc,0,10\n"};
    for (const char* model : {"axisymmetric", "half"}) {
        const Solid body = solid(drawn_text("revolved", file.path, usual_sections),
                                 {{"model", model}, {"mesh.size", "1 mm"}, {"mesh.sectors", "8"}});
        EXPECT_NEAR(1e9 * sample::rubber_m3(body) / (2 * pi * 9 * pi * 3), 1, curved) << model;
        EXPECT_NEAR(1e9 * sample::cavity_m3(body) / (2 * pi * 9 * pi), 1, curved) << model;
        for (const mesh::CellType type : body.mesh.cell_types)  // no contact with the axis, so no simplices
            EXPECT_EQ(type, std::string{model} == "half" ? mesh::CellType::hex27 : mesh::CellType::quad9);
    }
}

TEST(Revolved, OpeningHasAPlugOnTheAdjacentFace) {
    const TemporaryFile file{"cup.csv",
                             "x_mm,r_mm,tag\n0,6,cavity\n20,6,cavity\n20,0,axis\n22,0,tip\n22,8,outer\n0,8,rim\n"};
    const model::Case c = build_case(
        read_drawn(drawn_text("revolved", file.path, "supports: {fixed: tip}\nloads: {cavity: {pressure: 5 kPa}}\n")));
    ASSERT_EQ(c.cavities.size(), 1u);
    ASSERT_EQ(c.cavities[0].openings.size(), 1u);
    EXPECT_EQ(c.cavities[0].openings[0].face, "rim");
    EXPECT_NEAR(c.cavities[0].openings[0].area_m2, pi * 36e-6, 1e-15);
    EXPECT_EQ(c.cavities[0].openings[0].direction, (std::array<double, 3>{-1, 0, 0}));
}

TEST(Revolved, SeveralTagsFormACavity) {
    const TemporaryFile file{
        "two.csv",
        "x_mm,r_mm,tag\n0,0,axis\n2,0,a_low\n2,6,a_side\n8,6,a_high\n8,0,axis\n10,0,b_low\n10,6,b_side\n16,6,b_high\n16,0,axis\n"
        "18,0,tip\n18,8,outer\n0,8,fixed\n"};
    const std::string text =
        "family: revolved\ngeometry: {profile: " + file.path.string() +
        ", cavities: {left: [a_low, a_side, a_high], right: [b_low, b_side, b_high]}}\nmaterial: {law: neo-hookean, mu: 0.1644 MPa}\n"
        "supports: {fixed: fixed}\nloads: {cavities: {left: {pressure: 5 kPa}, right: {pressure: 2 kPa}}}\n";
    const Solid body = solid(text);
    for (const char* wall : {"left", "right"})
        EXPECT_NEAR(1e9 * sample::cavity_m3(body, 0, wall), pi * 36 * 6, 1e-6) << wall;
    const TemporaryFile other{"one.csv", tube};
    const std::string loaded = "supports: {fixed: fixed}\nloads: {cavities: {left: {pressure: 5 kPa}}}\noutputs: {}\n";
    EXPECT_EQ(
        drawn_refusal(drawn_text("revolved", other.path, loaded),
                      {{"geometry.cavities.left", "[outer]"}, {"geometry.cavities.right", "[outer, inlet]"}}),
        "--set geometry.cavities.right: its wall shares edges with that of 'left'; assign each edge to one cavity");
}

TEST(Revolved, SymmetryPlaneHalvesTheBody) {
    const TemporaryFile file{
        "half-sphere.csv",
        "x_mm,r_mm,tag,curve,via_x_mm,via_r_mm\n10,0,axis,,,\n20,0,outer,arc,14.142135623730951,14.142135623730951\n"
        "0,20,symmetry_x,,,\n0,10,cavity,arc,7.0710678118654755,7.0710678118654755\n"};
    const std::string text = drawn_text("revolved", file.path, "supports: {}\nloads: {cavity: {pressure: 5 kPa}}\n");
    const Solid body = solid(text);
    EXPECT_EQ(body.fraction, 0.5);
    EXPECT_EQ(body.symmetry_planes, (std::array<bool, 3>{true, false, false}));
    EXPECT_NEAR(1e9 * sample::rubber_m3(body) / (4 * pi / 3 * 7000), 1, curved);
    EXPECT_NEAR(1e9 * sample::cavity_m3(body) / (4 * pi / 3 * 1000), 1, curved);
    EXPECT_TRUE(build_case(read_drawn(text)).cavities[0].openings.empty());
}

TEST(Revolved, FileErrorsNameTheLocationInTheDesign) {
    const TemporaryFile file{"bad.csv", "x_mm,r_mm,tag\n0,0,axis\n5,0,end\n5,-10,outer\n"};
    const std::string text = drawn_text("revolved", file.path, usual_sections);
    EXPECT_EQ(drawn_refusal(text).find("part.yaml:2:21: geometry.profile: " + file.path.string() +
                                       ":2: the outline is clockwise"),
              0u)
        << drawn_refusal(text);
    EXPECT_NE(drawn_refusal(drawn_text("revolved", "missing.csv", usual_sections))
                  .find("part.yaml:2:21: geometry.profile: missing.csv: "),
              std::string::npos);
    EXPECT_EQ(drawn_refusal("family: revolved\nmaterial: {law: neo-hookean, mu: 1 MPa}\n")
                  .find("part.yaml:1:1: geometry.profile: missing (the half section as a table"),
              0u);
}

TEST(Revolved, UnknownFacesAreRejectedWithASuggestion) {
    const TemporaryFile file{"tube.csv", tube};
    EXPECT_EQ(drawn_refusal(
                  drawn_text("revolved", file.path, "supports: {fixed: fixd}\nloads: {cavity: {pressure: 5 kPa}}\n")),
              "part.yaml:4:19: supports.fixed: no face is called 'fixd'; did you mean 'fixed'?");
    const TemporaryFile full{"full.csv", "x_mm,r_mm,tag\n0,0,axis\n5,0,end\n5,10,outer\n0,10,fixed\n"};
    EXPECT_EQ(drawn_refusal(
                  drawn_text("revolved", full.path, "supports: {fixed: fixed}\nloads: {cavity: {pressure: 5 kPa}}\n")),
              "part.yaml:5:9: loads.cavity: there is no cavity to load; faces: axis, end, outer, fixed");
    EXPECT_EQ(drawn_refusal(drawn_text("revolved", file.path, usual_sections), {{"mesh.size", "0.001 mm"}})
                  .find("--set mesh.size: the mesh would have"),
              0u);
}

/// A block with a stadium-shaped hole, and a slice of it.
TEST(Extruded, BlockWithAHoleHasTheExpectedVolumes) {
    const std::string text = drawn_text("extruded", std::string{SOFT_SOURCE_DIR} + "/designs/profiles/pad.csv",
                                        "supports: {fixed: base}\nloads: {cavity: {pressure: 5 kPa}}\n");
    const double hole_mm2 = 12 * 4 + pi * 4;
    const Solid plane = solid(text), slice = solid(text, {{"model", "solid"}});
    EXPECT_EQ(plane.kinematics, model::Kinematics::plane_strain);
    for (const mesh::CellType type : slice.mesh.cell_types) EXPECT_EQ(type, mesh::CellType::hex27);
    for (const auto& [body, depth_mm] : {std::pair{&plane, 1000.0}, {&slice, 10.0}}) {
        EXPECT_GT(mesh::quality(body->mesh).min_scaled_jacobian, 0.1);
        EXPECT_NEAR(1e9 * sample::rubber_m3(*body) / ((24 * 12 - hole_mm2) * depth_mm), 1, 3e-5);
        EXPECT_NEAR(1e9 * sample::cavity_m3(*body, 2) / (hole_mm2 * depth_mm), 1, 1e-4);
        EXPECT_NEAR(1e6 * sample::area_m2(*body, "top"), 24 * depth_mm, 1e-8 * depth_mm);
    }
    const auto openings = build_case(read_drawn(text, {{"model", "solid"}})).cavities[0].openings;
    ASSERT_EQ(openings.size(), 2u);
    for (const model::Opening& opening : openings) EXPECT_NEAR(1e6 * opening.area_m2 / hole_mm2, 1, 1e-9);
}

TEST(Extruded, QuarterRingHasAQuarterOfTheVolume) {
    const TemporaryFile file{
        "quarter.csv",
        "x_mm,y_mm,tag,curve,via_x_mm,via_y_mm\n10,0,symmetry_y,,,\n20,0,outer,arc,14.142135623730951,14.142135623730951\n"
        "0,20,symmetry_x,,,\n0,10,cavity,arc,7.0710678118654755,7.0710678118654755\n"};
    const std::string text =
        drawn_text("extruded", file.path, "supports: {z: [end_z0, end_z1]}\nloads: {cavity: {pressure: 5 kPa}}\n");
    const Solid slice = solid(text, {{"model", "solid"}});
    EXPECT_EQ(slice.fraction, 0.25);
    EXPECT_NEAR(1e9 * sample::rubber_m3(slice) / (pi * 300 * 10), 1, curved);
    const auto openings = build_case(read_drawn(text, {{"model", "solid"}})).cavities[0].openings;
    ASSERT_EQ(openings.size(), 2u);
    EXPECT_NEAR(1e6 * openings[0].area_m2 / (pi * 100), 1, 1e-9);
    EXPECT_EQ(openings[0].face, "end_z0");
}

/// Example designs and templates, in every model.
TEST(Drawn, DesignsAndTemplatesBuild) {
    for (const char* name : {"revolved", "extruded"}) {
        const std::string path = std::string{SOFT_SOURCE_DIR} + "/designs/" + name + ".yaml";
        std::ifstream stream{path};
        std::stringstream text;
        text << stream.rdbuf();
        for (const std::string& model : sample::family(name).keys.models) {
            const design::Design design = design::read_design(text.str(), path, catalogue_keys(),
                                                              std::vector<design::Override>{{"model", model}});
            const model::Case c = build_case(design);
            EXPECT_GT(mesh::quality(c.mesh).min_scaled_jacobian, 0.1) << name << " " << model;
            EXPECT_TRUE(model == sample::family(name).keys.models.front() ? design.warnings.empty() : true);
        }
        const std::string commented = design::template_yaml(sample::family(name).keys);
        const model::Case c = build_case(
            design::read_design(commented, std::string{SOFT_SOURCE_DIR} + "/template.yaml", catalogue_keys(), {}));
        for (const std::string& face : sample::family(name).keys.faces)
            EXPECT_TRUE(face.starts_with("end_z") || c.mesh.facet_sets.contains(face)) << face;
    }
}

}  // namespace
}  // namespace soft::geometry
