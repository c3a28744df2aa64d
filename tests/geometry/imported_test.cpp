/// The family `imported`: designs with a mesh from a file; and mesh.refine, which every family has.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../meshing/gmsh_files.hpp"
#include "mesh/quality.hpp"
#include "sample.hpp"

namespace soft::geometry {
namespace {

using meshing::sample::Cells;
using meshing::sample::Sides;
using meshing::sample::TemporaryFile;

/// A design of a quarter ring with additional keys.
std::string design_text(const std::filesystem::path& file, const std::string& more, const std::string& geometry = {}) {
    return "family: imported\ngeometry: {file: " + file.string() + geometry + "}\n" +
           "material: {law: neo-hookean, mu: 0.1644 MPa, kappa: 10 MPa}\n" + more;
}

design::Design import_design(const std::string& text, const std::string& source = "part.yaml",
                             std::vector<design::Override> overrides = {}) {
    return design::read_design(text, source, catalogue_keys(), overrides);
}

model::Case built_import(const std::string& text, std::vector<design::Override> overrides = {}) {
    return build_case(import_design(text, "part.yaml", std::move(overrides)));
}

std::string import_refusal(const std::string& text, std::vector<design::Override> overrides = {}) {
    try {
        static_cast<void>(built_import(text, std::move(overrides)));
    } catch (const Error& error) {
        EXPECT_TRUE(error.code() == ExitCode::bad_input || error.code() == ExitCode::cannot_open);
        return error.what();
    }
    return "accepted";
}

constexpr const char* usual =
    "mesh: {formulation: displacement}\nsupports: {fixed: bottom}\nloads: {inner: {pressure: 5 kPa}}\n"
    "outputs: {rise: {face: top, along: z}}\n";

class ImportedSolid : public testing::Test {
protected:
    ImportedSolid() { meshing::sample::write_part(file.path, Cells::tetrahedra, Sides::round, {}); }
    const TemporaryFile file{"solid.msh"};
};

TEST_F(ImportedSolid, BuildsWithTheFacesOfTheFileInMillimetres) {
    const model::Case c = built_import(design_text(file.path, usual));
    EXPECT_EQ(c.kinematics, model::Kinematics::solid);
    EXPECT_EQ(c.model_fraction, 1);
    ASSERT_EQ(c.materials.size(), 1u);
    EXPECT_EQ(c.materials[0].name, "part");
    ASSERT_EQ(c.supports.size(), 1u);
    EXPECT_EQ(c.supports[0].face, "bottom");
    EXPECT_EQ(c.outputs[0].direction, (std::array<double, 3>{0, 0, 1}));
    const double volume_m3 = measure(c.mesh, mesh::Measure::plain);
    EXPECT_LT(volume_m3, 0.75e-9 * std::numbers::pi);
    EXPECT_GT(volume_m3, 2.249e-9);  // three chords of 30 degrees: 4.5 sin 30 degrees
    const model::Case inches = built_import(design_text(file.path, usual, ", unit: in"));
    EXPECT_NEAR(measure(inches.mesh, mesh::Measure::plain) / volume_m3, std::pow(25.4, 3), 1e-8);
}

TEST_F(ImportedSolid, UnknownFaceIsRejectedWithASuggestion) {
    EXPECT_EQ(import_refusal(design_text(
                  file.path,
                  "mesh: {formulation: displacement}\nsupports: {fixed: botom}\nloads: {inner: {pressure: 5 kPa}}\n")),
              "part.yaml:5:19: supports.fixed: no face is called 'botom'; did you mean 'bottom'?");
    EXPECT_EQ(import_refusal(design_text(file.path, "loads: {iner: {pressure: 5 kPa}}\n")),
              "part.yaml:4:9: loads.iner: unknown key; did you mean 'inner'?");
}

TEST_F(ImportedSolid, FileIsRelativeToTheDesignOrTheWorkingDirectory) {
    const std::string name = file.path.filename().string(), folder = file.path.parent_path().string();
    EXPECT_NO_THROW((void)build_case(import_design(design_text(name, usual), folder + "/part.yaml")));
    EXPECT_NO_THROW((void)built_import(design_text("elsewhere.msh", usual), {{"geometry.file", file.path.string()}}));
    const std::string missing = import_refusal(design_text("elsewhere.msh", usual));
    EXPECT_TRUE(missing.starts_with("part.yaml:2:18: geometry.file: elsewhere.msh: ")) << missing;
    EXPECT_EQ(
        import_refusal(
            "family: imported\nmaterial: {law: neo-hookean, mu: 1 MPa}\nloads: {inner: {pressure: 5 kPa}}\n"),
        "part.yaml:1:1: geometry.file: missing (mesh (Gmsh .msh 2.2 or 4.1) or surface (.stl, .obj, .step) of the part, relative to "
        "the design file; or (file: |) the lines of an OBJ file); add geometry: {file: FILE}");
}

TEST_F(ImportedSolid, ListedFacesFormACavity) {
    const std::string loads =
        "mesh: {formulation: displacement}\nsupports: {fixed: bottom}\nloads: {cavity: {pressure: 5 kPa";
    const model::Case c = built_import(design_text(file.path, loads + "}}\n", ", cavity: [inner, ends]"));
    ASSERT_EQ(c.cavities.size(), 1u);
    EXPECT_EQ(c.cavities[0].name, "cavity");
    EXPECT_FALSE(c.loads[0].sealed);
    EXPECT_EQ(c.path.stages.at(0).control, model::Control::automatic);
    EXPECT_EQ(c.mesh.facet_sets.at("cavity").size(),
              c.mesh.facet_sets.at("inner").size() + c.mesh.facet_sets.at("ends").size());
    EXPECT_NO_THROW((void)built_import(
        design_text(file.path, loads + ", sealed: true}}\n", ", cavity: [inner, outer, ends, bottom, top]")));
    EXPECT_EQ(import_refusal(design_text(file.path, loads + "}}\n", ", cavity: [inner, end]")),
              "part.yaml:2:" + std::to_string(18 + file.path.string().size() + 18) +
                  ": geometry.cavity: no face is called 'end'; did you mean 'ends'?");
    EXPECT_EQ(import_refusal(design_text(file.path, loads + "}}\n")).substr(0, 63),
              "part.yaml:6:9: loads.cavity: there is no cavity to load; faces:");
}

TEST_F(ImportedSolid, NamedCavitiesHaveSeparateWalls) {
    const std::string physics = "mesh: {formulation: displacement}\nsupports: {fixed: bottom}\n";
    const std::string loads =
        physics + "loads: {cavities: {west: {pressure: 5 kPa, sealed: false}, east: {shares: west}}}\n";
    const model::Case c = built_import(design_text(file.path, loads, ", cavities: {west: [inner, ends], east: outer}"));
    ASSERT_EQ(c.cavities.size(), 2u);
    EXPECT_EQ(c.mesh.facet_sets.at("east"), c.mesh.facet_sets.at("outer"));
    EXPECT_EQ(c.mesh.facet_sets.at("west").size(),
              c.mesh.facet_sets.at("inner").size() + c.mesh.facet_sets.at("ends").size());
    ASSERT_EQ(c.loads.size(), 1u);
    EXPECT_EQ(c.loads[0].targets, (std::vector<std::string>{"west", "east"}));
    const auto refused = [&](const std::string& cavities) {
        return import_refusal(design_text(file.path, loads, ", cavities: " + cavities));
    };
    EXPECT_NE(refused("{west: [inner, ends], east: [outer, inner]}").find("its wall shares facets with that of "),
              std::string::npos);
    EXPECT_NE(refused("{west: [inner, ends], east: outr}")
                  .find("geometry.cavities.east: no face is called 'outr'; did you mean 'outer'?"),
              std::string::npos);
    EXPECT_NE(refused("{west: inner, 2nd: outer}").find("geometry.cavities.2nd: not a name of a cavity"),
              std::string::npos);
    EXPECT_NE(refused("{west: inner}").find("loads.cavities.east: unknown key"), std::string::npos);
    EXPECT_NE(refused("{west: inner, east: top, outer: ends}").find("the file already has a face called 'outer'"),
              std::string::npos);
    const design::Design design =
        import_design(design_text(file.path, loads, ", cavities: {west: [inner, ends], east: outer}"));
    EXPECT_EQ(import_design(design.effective_yaml).effective_yaml, design.effective_yaml);
}

/// The wall of a quarter ring without bottom and top: two openings of the ring's area, up and down.
TEST_F(ImportedSolid, OpeningsOfACavityAreFoundWithTheirFaces) {
    const std::string loads =
        "mesh: {formulation: displacement}\nsupports: {fixed: bottom}\nloads: {cavity: {pressure: 5 kPa, sealed: ";
    const model::Case c = built_import(design_text(file.path, loads + "true}}\n", ", cavity: [inner, outer, ends]"));
    ASSERT_EQ(c.cavities[0].openings.size(), 2u);
    for (const model::Opening& opening : c.cavities[0].openings) {
        double area_m2 = 0;
        for (const mesh::Facet& facet : c.mesh.facet_sets.at(opening.face)) {
            const mesh::CellType type = facet_type(c.mesh, facet);
            for (const auto& point : mesh::volume_rule(type))
                area_m2 +=
                    point.weight * std::abs(mesh::facet_normal(c.mesh, facet, mesh::shape_values(type, point.xi))[2]);
        }
        EXPECT_NEAR(opening.area_m2 / area_m2, 1, 1e-12);
        // The wall is the outer boundary of a solid: "out of the cavity" is into the body.
        EXPECT_NEAR(opening.direction[2], opening.face == "top" ? -1 : 1, 1e-12);
    }
    EXPECT_EQ(import_refusal(design_text(file.path, loads + "true}}\n", ", cavity: [inner, bottom]")).substr(0, 93),
              "part.yaml:6:43: loads.cavity.sealed: no single named face surrounds an opening of the cavity,");
    const model::Case open = built_import(design_text(file.path, loads + "false}}\n", ", cavity: [inner, bottom]"));
    ASSERT_EQ(open.cavities[0].openings.size(), 1u);
    EXPECT_TRUE(open.mesh.facet_sets.contains(open.cavities[0].openings[0].face));
}

TEST_F(ImportedSolid, FaceOfSeveralPiecesIsAlsoAvailableByPiece) {
    const model::Case c = built_import(design_text(file.path, usual));
    const auto& sets = c.mesh.facet_sets;
    ASSERT_TRUE(sets.contains("ends_1") && sets.contains("ends_2"));
    EXPECT_FALSE(sets.contains("inner_1") || sets.contains("ends_3"));
    EXPECT_EQ(sets.at("ends_1").size() + sets.at("ends_2").size(), sets.at("ends").size());
    for (const mesh::Facet& facet : sets.at("ends_1"))
        for (const mesh::Index n : facet_nodes(c.mesh, facet))
            EXPECT_NEAR(c.mesh.point(n)[0], 0, 1e-12);  // the lower x
    for (const mesh::Facet& facet : sets.at("ends_2"))
        for (const mesh::Index n : facet_nodes(c.mesh, facet)) EXPECT_NEAR(c.mesh.point(n)[1], 0, 1e-12);
}

TEST_F(ImportedSolid, OrderIsThatOfTheFileOrTheRequestedOne) {
    const auto order = [&](const std::string& mesh) {
        const model::Case c = built_import(design_text(file.path, std::string{usual}),
                                           {{"mesh", "{formulation: displacement, " + mesh + "}"}});
        return mesh::topology(c.mesh.cell_types.front()).order;
    };
    EXPECT_EQ(order("order: file"), 1);
    EXPECT_EQ(order("order: 1"), 1);
    EXPECT_EQ(order("order: 2"), 2);
    EXPECT_EQ(order("raise_order: false"), 1);
    EXPECT_EQ(import_refusal(design_text(file.path, usual), {{"mesh", "{order: 2, raise_order: false}"}}),
              "--set mesh: mesh.raise_order: the file contains first-order cells; use true, or order: 1");
    const TemporaryFile second{"second.msh"};
    meshing::sample::write_part(second.path, Cells::tetrahedra, Sides::round, {4.1, true, 2, false});
    const model::Case lowered = built_import(design_text(second.path, usual), {{"mesh.order", "1"}});
    EXPECT_EQ(lowered.mesh.cell_type(0), mesh::CellType::tet4);
    EXPECT_EQ(built_import(design_text(second.path, usual)).mesh.cell_type(0), mesh::CellType::tet10);
}

TEST_F(ImportedSolid, MeshSizeRequiresASurfaceAndRefineDoesNot) {
    EXPECT_EQ(import_refusal(design_text(file.path, usual), {{"mesh.size", "1 mm"}}).substr(0, 51),
              "--set mesh.size: a mesh file already contains cells");
    const model::Case coarse = built_import(design_text(file.path, usual)),
                      fine = built_import(design_text(file.path, usual), {{"mesh.refine", "1"}});
    EXPECT_EQ(fine.mesh.cell_count(), 8 * coarse.mesh.cell_count());
    EXPECT_EQ(import_refusal(design_text(file.path, usual), {{"mesh.refine", "8"}}).substr(0, 38),
              "--set mesh.refine: the mesh would have");
}

TEST_F(ImportedSolid, ModelMustMatchTheMesh) {
    const auto model = [&](const char* name) {
        return import_refusal(design_text(file.path, usual), {{"model", name}, {"outputs", "{}"}});
    };
    EXPECT_EQ(model("axisymmetric"),
              "--set model: 'axisymmetric' needs a plane mesh, but the file contains a solid; use model: solid");
    EXPECT_EQ(model("plane-strain"),
              "--set model: 'plane-strain' needs a plane mesh, but the file contains a solid; use model: solid");
}

TEST_F(ImportedSolid, EffectiveDesignIsReproducible) {
    const design::Design design = import_design(design_text(file.path, usual, ", cavity: [inner, ends]"));
    EXPECT_EQ(import_design(design.effective_yaml).effective_yaml, design.effective_yaml);
    EXPECT_FALSE(design::explain_design(design.effective_yaml, "part.yaml", catalogue_keys(), {}).empty());
}

TEST(ImportedSection, IsRevolvedAboutTheAxisItTouches) {
    const TemporaryFile file{"section.msh"};
    meshing::sample::write_part(file.path, Cells::quadrilaterals, Sides::round, {4.1, false, 2, false});
    const std::string more = "supports: {x: ends}\nloads: {cavity: {pressure: 5 kPa}}\n";
    const model::Case c = built_import(design_text(file.path, more + "model: axisymmetric\n", ", cavity: inner"));
    EXPECT_EQ(c.kinematics, model::Kinematics::axisymmetric);
    // The section's side on y = 0 is half of "ends": the axis. Half a spherical shell.
    EXPECT_EQ(c.mesh.facet_sets.at("axis").size() * 2, c.mesh.facet_sets.at("ends").size());
    EXPECT_NEAR(measure(c.mesh, mesh::Measure::revolved) / (2e-9 * std::numbers::pi / 3 * 7), 1, 1e-3);
    const auto axis =
        std::find_if(c.supports.begin(), c.supports.end(), [](const model::Support& s) { return s.face == "axis"; });
    ASSERT_NE(axis, c.supports.end());
    EXPECT_EQ(axis->fixed, (std::array<bool, 3>{false, true, false}));
    ASSERT_EQ(c.cavities[0].openings.size(),
              1u);  // the wall ends at r = 1 mm; its sides run towards that end and x = 0
    EXPECT_NEAR(c.cavities[0].openings[0].area_m2, 1e-6 * std::numbers::pi, 1e-15);
    EXPECT_EQ(c.cavities[0].openings[0].direction, (std::array<double, 3>{-1, 0, 0}));
    const model::Case plane = built_import(
        design_text(file.path, "supports: {fixed: ends}\nloads: {inner: {pressure: 5 kPa}}\nmodel: plane-strain\n"));
    EXPECT_EQ(plane.kinematics, model::Kinematics::plane_strain);
    EXPECT_FALSE(plane.mesh.facet_sets.contains("axis"));
    EXPECT_EQ(import_refusal(design_text(file.path, "supports: {fixed: ends}\nloads: {inner: {pressure: 5 kPa}}\n")),
              "default: model: the file contains a plane mesh; use axisymmetric or plane-strain");
}

TEST(ImportedSection, PointsBelowTheAxisAreRejected) {
    const TemporaryFile file{"below.msh"};
    {
        const meshing::sample::Gmsh session;
        meshing::sample::draw_part(Cells::triangles, Sides::straight, 2);
        gmsh::model::mesh::generate(2);
        meshing::sample::move_nodes(1, -0.5);
        meshing::sample::write(file.path, {});
    }
    const std::string what = import_refusal(design_text(
        file.path, "mesh: {formulation: displacement}\nloads: {inner: {pressure: 5 kPa}}\nmodel: axisymmetric\n"));
    EXPECT_EQ(
        what,
        "part.yaml:2:18: geometry.file: a point lies at y = -0.5 mm, below the axis; draw the section at y >= 0; the "
        "axis of revolution is x");
}

TEST(Imported, EveryRegionHasTheMainMaterialByDefault) {
    const TemporaryFile file{"regions.msh"};
    {
        const meshing::sample::Gmsh session;
        namespace geo = gmsh::model::geo;
        gmsh::vectorpair made;
        for (int p = 0; p < 3; ++p) geo::addPoint(p, 0, 0, 0, p + 1);
        geo::addLine(1, 2, 1);
        geo::addLine(2, 3, 2);
        geo::extrude({{1, 1}, {1, 2}}, 0, 1, 0, made, {2}, {}, true);
        geo::synchronize();
        meshing::sample::name_group(2, {made[1].second}, "soft");
        meshing::sample::name_group(2, {made[5].second}, "stiff");
        meshing::sample::name_group(1, {1, 2}, "base");
        gmsh::model::mesh::generate(2);
        meshing::sample::write(file.path, {});
    }
    const std::string text = design_text(
        file.path, "mesh: {formulation: displacement}\nloads: {base: {pressure: 5 kPa}}\nmodel: plane-strain\n");
    const model::Case c = built_import(text);
    std::set<std::string> names;
    for (const model::Material& material : c.materials) {
        names.insert(material.name);
        EXPECT_EQ(material.law, "neo-hookean");
    }
    EXPECT_EQ(names, (std::set<std::string>{"soft", "stiff"}));
    EXPECT_EQ(std::set<std::string>(c.mesh.region_names.begin(), c.mesh.region_names.end()), names);

    const model::Case two =
        built_import(text + "materials: {stiff: {law: yeoh, c1: 1 MPa, c2: 0 kPa, c3: 0 kPa, kappa: 1 GPa}}\n");
    for (const model::Material& material : two.materials) {
        EXPECT_EQ(material.law, material.name == "stiff" ? "yeoh" : "neo-hookean");
        EXPECT_EQ(material.source, material.name == "stiff" ? "materials.stiff" : "material");
    }
    EXPECT_EQ(import_refusal(text + "materials: {stif: {law: neo-hookean, mu: 1 MPa, kappa: 1 GPa}}\n"),
              "part.yaml:7:25: materials.stif.law: no region uses this material; regions: soft, stiff");
}

TEST(Imported, TemplateBuilds) {
    const std::string text = design::template_yaml(sample::family("imported").keys);
    const model::Case c = build_case(import_design(text, std::string{SOFT_SOURCE_DIR} + "/template.yaml"));
    EXPECT_GT(mesh::quality(c.mesh).min_scaled_jacobian, 0.1);
    EXPECT_EQ(c.cavities.size(), 1u);
    for (const std::string& face : sample::family("imported").keys.faces)
        EXPECT_TRUE(c.mesh.facet_sets.contains(face)) << face;
}

TEST(Imported, FirstOrderSimplicesTriggerALockingWarning) {
    const std::string source = std::string{SOFT_SOURCE_DIR} + "/template.yaml";
    const std::string text = design::template_yaml(sample::family("imported").keys);
    const auto locks = [&](const std::vector<design::Override>& sets) {
        const auto design = design::read_design(text, source, catalogue_keys(), sets);
        const auto warnings = warnings_of(design, build_with_figures(design));
        return std::ranges::any_of(warnings,
                                   [](const std::string& w) { return w.starts_with("geometry.file: first-order"); });
    };
    EXPECT_TRUE(locks({{"mesh.order", "1"}, {"mesh.formulation", "displacement"}, {"material.kappa", "1 MPa"}}));
    EXPECT_FALSE(locks({{"mesh.order", "2"}}));
}

TEST(Refine, HalvesTheCellsOfEveryFamily) {
    const Solid coarse = sample::solid("tube", "axisymmetric"),
                fine = sample::solid("tube", "axisymmetric", {{"mesh.refine", "1"}});
    EXPECT_EQ(fine.mesh.cell_count(), 4 * coarse.mesh.cell_count());
    EXPECT_NEAR(sample::rubber_m3(fine) / sample::rubber_m3(coarse), 1, 1e-13);
    const Solid quarter = sample::solid("sphere", "quarter"),
                finer = sample::solid("sphere", "quarter", {{"mesh.refine", "1"}});
    EXPECT_EQ(finer.mesh.cell_count(), 8 * quarter.mesh.cell_count());
    EXPECT_NEAR(sample::rubber_m3(finer) / sample::rubber_m3(quarter), 1, 1e-13);
    EXPECT_GT(mesh::quality(finer.mesh).min_scaled_jacobian, 0.1);
}

}  // namespace
}  // namespace soft::geometry
