/// The family `imported` with a surface file (STL, OBJ) or a CAD file (STEP).
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <numbers>
#include <set>

#include "../meshing/gmsh_files.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

using meshing::sample::TemporaryFile;

std::string part_text(const std::filesystem::path& file, const std::string& geometry = {},
                      const std::string& more = {}) {
    return "family: imported\ngeometry: {file: " + file.string() + geometry + "}\n" +
           "material: {law: neo-hookean, mu: 0.1644 MPa, kappa: incompressible}\n" + more;
}

design::Design read_part(const std::string& text, std::vector<design::Override> sets = {}) {
    return design::read_design(text, "part.yaml", catalogue_keys(), sets);
}

Built built_part(const std::string& text, std::vector<design::Override> sets = {}) {
    return build_with_figures(read_part(text, std::move(sets)));
}

std::string part_refusal(const std::string& text, std::vector<design::Override> sets = {}) {
    try {
        static_cast<void>(built_part(text, std::move(sets)));
    } catch (const Error& error) {
        EXPECT_TRUE(error.code() == ExitCode::bad_input || error.code() == ExitCode::cannot_open);
        return error.what();
    }
    return "accepted";
}

namespace occ = gmsh::model::occ;

/// Writes the shapes that `draw` adds.
template <class Draw>
void write_step(const std::filesystem::path& path, const Draw& draw) {
    const meshing::sample::Gmsh session;
    gmsh::option::setNumber("General.Verbosity", 0);
    gmsh::vectorpair made;
    std::vector<gmsh::vectorpair> map;
    draw(made, map);
    occ::synchronize();
    testing::internal::CaptureStdout();
    gmsh::write(path.string());
    testing::internal::GetCapturedStdout();
}

/// A can along x: 30 mm long, radii 10 and 7 mm, caps of 5 mm around a closed cavity. Its facets turn by 10 degrees.
enum class Can { closed, open, two };
void write_can(const std::filesystem::path& path, Can can, double scale = 1) {
    const meshing::sample::Gmsh session;
    gmsh::option::setNumber("General.Verbosity", 0);
    const int body = occ::addCylinder(0, 0, 0, 30 * scale, 0, 0, 10 * scale);
    const int hole = occ::addCylinder(5 * scale, 0, 0, (can == Can::open ? 25 : 20) * scale, 0, 0, 7 * scale);
    gmsh::vectorpair made;
    std::vector<gmsh::vectorpair> map;
    occ::cut({{3, body}}, {{3, hole}}, made, map);
    if (can == Can::two) occ::addBox(20 * scale, 20 * scale, 0, scale, scale, scale);
    occ::synchronize();
    if (path.extension() != ".step") {
        gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", 36);
        gmsh::option::setNumber("Mesh.MeshSizeMax", 4 * scale);
        gmsh::model::mesh::generate(2);
    }
    testing::internal::CaptureStdout();  // the CAD library writes to stdout
    gmsh::write(path.string());
    testing::internal::GetCapturedStdout();
}

constexpr double can_m3 = std::numbers::pi * (100 * 30 - 49 * 20) * 1e-9;
constexpr const char* ends = ", faces: {fixed: {plane: {x: 0 mm}}, tip: {normal: [1, 0, 0], plane: {x: 30 mm}}}";
constexpr const char* usual =
    "mesh: {size: 5 mm}\nsupports: {fixed: fixed}\nloads: {cavity: {pressure: 5 kPa}}\noutputs: {rise: {face: tip, along: x}}\n";

double area_m2(const mesh::Mesh& mesh, const std::string& face) {
    double area = 0;
    for (const mesh::Facet& facet : mesh.facet_sets.at(face)) {
        const mesh::CellType type = facet_type(mesh, facet);
        for (const auto& point : mesh::volume_rule(type)) {
            const auto n = mesh::facet_normal(mesh, facet, mesh::shape_values(type, point.xi));
            area += point.weight * std::hypot(n[0], n[1], n[2]);
        }
    }
    return area;
}

TEST(Part, AClosedCanFromStepIsMeshedAroundItsCavity) {
    const TemporaryFile file{"can.step"};
    write_can(file.path, Can::closed);
    const Built can = built_part(part_text(file.path, ends, usual));
    EXPECT_EQ(can.model.kinematics, model::Kinematics::solid);
    EXPECT_EQ(std::set(can.model.mesh.cell_types.begin(), can.model.mesh.cell_types.end()),
              std::set{mesh::CellType::tet10});
    ASSERT_EQ(can.model.cavities.size(), 1u);
    EXPECT_EQ(can.model.cavities[0].name, "cavity");
    EXPECT_TRUE(can.model.cavities[0].openings.empty());
    EXPECT_NEAR(measure(can.model.mesh, mesh::Measure::plain) / can_m3, 1, 5e-3);
    EXPECT_NEAR(area_m2(can.model.mesh, "cavity") / (2 * std::numbers::pi * 7 * (7 + 20) * 1e-6), 1, 5e-3);
    EXPECT_NEAR(area_m2(can.model.mesh, "fixed") / (std::numbers::pi * 100e-6), 1, 2e-3);
    EXPECT_NEAR(area_m2(can.model.mesh, "outer") / (2 * std::numbers::pi * 10 * (10 + 30) * 1e-6), 1, 5e-3);
    EXPECT_GT(mesh::quality(can.model.mesh).min_scaled_jacobian, 0.2);
    ASSERT_TRUE(can.part.has_value());
    EXPECT_NEAR(can.part->volume_m3 / can_m3, 1, 5e-3);
    EXPECT_NEAR(can.part->walls.median_m, 3e-3, 0.05e-3);
}

/// The facets of the bore must not be as short along the axis as around it.
TEST(Part, LongNarrowBoreHasFewFacets) {
    const TemporaryFile file{"bore.step"};
    write_step(file.path, [](gmsh::vectorpair& made, std::vector<gmsh::vectorpair>& map) {
        occ::addBox(0, -10, -10, 60, 20, 20, 1);
        occ::addCylinder(-1, 0, 0, 56, 0, 0, 1, 2);
        occ::cut({{3, 1}}, {{3, 2}}, made, map);
    });
    const std::string faces =
        ", faces: {fixed: {plane: {x: 0 mm}}, tip: {plane: {x: 60 mm}}, cavity: {point: [10 mm, 0 mm, 1 mm], up_to: fixed}}";
    const Built bore = built_part(part_text(file.path, faces, usual));
    EXPECT_LT(bore.part->facets, 1000u);
    EXPECT_NEAR(bore.part->volume_m3 / ((60 * 400 - 55 * std::numbers::pi) * 1e-9), 1, 1e-4);
    EXPECT_NEAR(measure(bore.model.mesh, mesh::Measure::plain) / bore.part->volume_m3, 1, 1e-3);
}

TEST(Part, StlInAnyUnitGivesTheSameVolumeReproducibly) {
    const TemporaryFile file{"can.stl"}, inches{"inches.stl"};
    write_can(file.path, Can::closed);
    write_can(inches.path, Can::closed, 1 / 25.4);
    const Built once = built_part(part_text(file.path, ends, usual)),
                again = built_part(part_text(file.path, ends, usual));
    EXPECT_EQ(once.model.mesh.points, again.model.mesh.points);
    EXPECT_EQ(once.model.mesh.connectivity, again.model.mesh.connectivity);
    const double volume_m3 = measure(once.model.mesh, mesh::Measure::plain);
    EXPECT_NEAR(volume_m3 / once.part->volume_m3, 1, 2e-3);
    EXPECT_NEAR(measure(built_part(part_text(inches.path, std::string{", unit: in"} + ends, usual)).model.mesh,
                        mesh::Measure::plain) /
                    volume_m3,
                1, 5e-3);
}

TEST(Part, OpenCavityIsNamedByAFloodUpToItsInlet) {
    const TemporaryFile file{"open.stl"};
    write_can(file.path, Can::open);
    const std::string faces =
        ", faces: {fixed: {plane: {x: 0 mm}}, tip: {plane: {x: 30 mm}}, cavity: {point: [10 mm, 6 mm, 0 mm], up_to: tip}}";
    const Built can = built_part(part_text(file.path, faces, usual));
    ASSERT_EQ(can.model.cavities.size(), 1u);
    ASSERT_EQ(can.model.cavities[0].openings.size(), 1u);
    const model::Opening& opening = can.model.cavities[0].openings[0];
    EXPECT_EQ(opening.face, "tip");
    EXPECT_NEAR(opening.area_m2 / (49e-6 * std::numbers::pi), 1, 0.01);
    EXPECT_NEAR(opening.direction[0], 1, 1e-9);
    EXPECT_NEAR(area_m2(can.model.mesh, "cavity") / (std::numbers::pi * 7 * (7 + 2 * 25) * 1e-6), 1, 0.01);
    EXPECT_NE(part_refusal(part_text(file.path, ends, usual)).find("there is no cavity to load"), std::string::npos);
}

TEST(Part, CutPartRepresentsTheWholeBody) {
    const TemporaryFile file{"quarter.step"};
    write_step(file.path, [](gmsh::vectorpair& made, std::vector<gmsh::vectorpair>& map) {
        occ::addCylinder(0, 0, 0, 30, 0, 0, 10, 1);
        occ::addCylinder(5, 0, 0, 25, 0, 0, 7, 2);
        occ::cut({{3, 1}}, {{3, 2}}, made, map);
        occ::addBox(-1, 0, 0, 32, 11, 11, 7);
        gmsh::vectorpair quarter;
        occ::intersect(made, {{3, 7}}, quarter, map);
    });
    const std::string faces =
        ", faces: {fixed: {plane: {x: 0 mm}}, tip: {plane: {x: 30 mm}}, cavity: {point: [10 mm, 4 mm, 4 mm], up_to: tip}}";
    const Built can = built_part(part_text(file.path, ", symmetry: yz" + faces, usual));
    EXPECT_EQ(can.model.model_fraction, 0.25);
    EXPECT_EQ(can.model.symmetry_planes, (std::array{false, true, true}));
    EXPECT_NEAR(measure(can.model.mesh, mesh::Measure::plain) / (std::numbers::pi / 4 * (100 * 30 - 49 * 25) * 1e-9), 1,
                5e-3);
    ASSERT_EQ(can.model.cavities[0].openings.size(), 1u);
    EXPECT_NEAR(can.model.cavities[0].openings[0].area_m2 / (49e-6 * std::numbers::pi), 1, 5e-3);  // of the whole body
    EXPECT_EQ(can.model.cavities[0].openings[0].direction, (std::array{1.0, 0.0, 0.0}));
    for (const mesh::Facet& facet : can.model.mesh.facet_sets.at("symmetry_y"))
        for (const mesh::Index node : facet_nodes(can.model.mesh, facet)) EXPECT_EQ(can.model.mesh.point(node)[1], 0);
    const auto support = std::ranges::find(can.model.supports, "symmetry_z", &model::Support::face);
    ASSERT_NE(support, can.model.supports.end());
    EXPECT_EQ(support->fixed, (std::array{false, false, true}));
}

TEST(Part, FileErrorsNameTheLocationInTheDesign) {
    const TemporaryFile two{"two.step"}, pieces{"two.stl"}, nothing{"nothing.stl", "solid a\nendsolid a\n"},
        words{"words.step", "these are words\n"};
    write_can(two.path, Can::two);
    write_can(pieces.path, Can::two);
    const auto misses = [](const std::filesystem::path& file, const std::string& what) {
        const std::string problem = part_refusal(part_text(file, ends, usual));
        return problem.starts_with("part.yaml:2:18: geometry.file: " + file.string() + ": ") &&
                       problem.find(what) != std::string::npos
                   ? ""
                   : problem;
    };
    EXPECT_EQ(misses(two.path, "2 solids in one file; unite them"), "");
    EXPECT_EQ(misses(pieces.path, "2 bodies in one file, the second around x = 20.5, y = 20.5, z = 0.5; unite"), "");
    EXPECT_EQ(misses(nothing.path, "the file contains no facets"), "");
    EXPECT_EQ(misses(words.path, "it cannot be read as STEP"), "");
    EXPECT_EQ(misses("/nowhere/part.obj", ""), "");
    const TemporaryFile whole{"whole.stl"};
    write_can(whole.path, Can::closed);
    const std::string text = whole.text();
    const TemporaryFile open{"open.stl", text.substr(0, text.rfind("facet normal")) + "endsolid\n"};
    EXPECT_EQ(misses(open.path, "1 hole in the surface, near x = "), "");
}

TEST(Part, InvalidRulesAreRejected) {
    const TemporaryFile file{"can.stl"};
    write_can(file.path, Can::closed);
    const auto expect = [&](const std::string& geometry, const std::string& words,
                            std::vector<design::Override> sets = {}) {
        const std::string refusal = part_refusal(part_text(file.path, geometry, usual), std::move(sets));
        EXPECT_NE(refusal.find(words), std::string::npos) << refusal;
    };
    for (const auto& [rule, words] : std::vector<std::array<std::string, 2>>{
             {"{plane: {x: 31 mm}}", "geometry.faces.tip.plane.x: no facet of the surface matches this rule"},
             {"{plane: {x: 0 mm, y: 0 mm}}", "geometry.faces.tip.plane.y: only one plane is possible"},
             {"{box: {from: [1 mm, 2 mm, 3 mm]}}", "geometry.faces.tip.box.from: a box needs two corners"},
             {"{point: [1 mm, 2 mm]}", "geometry.faces.tip.point: three values are needed"},
             {"{within: 5 deg}", "geometry.faces.tip.within: within needs a normal"},
             {"{up_to: fixed}", "geometry.faces.tip.up_to: up_to needs a point"},
             {"{point: [30 mm, 0 mm, 0 mm], up_to: outer}", "'outer' is not a face of geometry.faces without up_to"},
             {"{plain: {x: 0 mm}}", "geometry.faces.tip.plain: unknown key; known: plane, box"}})
        expect(", faces: {fixed: {plane: {x: 0 mm}}, tip: " + rule + "}", words);
    expect(", faces: {outer: {plane: {x: 0 mm}}}", "the file has a face of this name already");
    expect(std::string{", symmetry: y"} + ends, "and is not cut at 0");
    expect(ends, "a larger mesh.size", {{"mesh.size", "1 um"}});
}

TEST(Part, EffectiveDesignIsReproducibleAndAnUnusualUnitIsReported) {
    const TemporaryFile file{"can.stl"};
    write_can(file.path, Can::closed);
    const design::Design design = read_part(part_text(file.path, ends, usual));
    EXPECT_EQ(read_part(design.effective_yaml).effective_yaml, design.effective_yaml);
    const std::string metres =
        part_text(file.path, ", unit: m, faces: {fixed: {plane: {x: 0 mm}}, tip: {plane: {x: 30 m}}}", usual);
    const design::Design large = read_part(metres, {{"mesh.size", "5 m"}});
    const auto warnings = warnings_of(large, build_with_figures(large));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0], "geometry.unit: the part is 30 m long; are the file's lengths in m?");
}

}  // namespace
}  // namespace soft::geometry
