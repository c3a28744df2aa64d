// Materials of other regions: valid input, and the errors for invalid input.
#include <gtest/gtest.h>

#include "design/fitted.hpp"
#include "sample.hpp"

namespace {

using namespace soft::design;
using namespace soft::design::sample;
namespace model = soft::model;

/// A pipe with a cap that can have another material; the material paper is built into the family.
FamilyKeys capped_pipe() {
    FamilyKeys family = pipe();
    family.name = "capped";
    family.geometry.push_back(
        {.path = "geometry.cap.material", .kind = Kind::text, .fallback = "rubber", .meaning = "of the cap"});
    family.materials = {{"paper", "{law: neo-hookean, mu: 540 MPa, kappa: 720 MPa}"}};
    return family;
}

Design read_capped(const std::string& text, const std::vector<Override>& overrides = {}) {
    const std::vector<FamilyKeys> known{capped_pipe()};
    return read_design(text, "p.yaml", known, overrides);
}

std::string capped(const std::string& more) {
    return "family: capped\nmaterial: {law: neo-hookean, mu: 0.1 MPa}\n" + more +
           "\nloads: {cavity: {pressure: 1 kPa}}\n";
}

std::string refused(const std::string& more, const std::vector<Override>& overrides = {}) {
    try {
        static_cast<void>(read_capped(capped(more), overrides));
    } catch (const soft::Error& error) {
        EXPECT_EQ(error.code(), soft::ExitCode::bad_input);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << more;
    return {};
}

TEST(RegionMaterials, HaveTheKeysOfTheMainMaterial) {
    const Design design =
        read_capped(capped("materials:\n"
                           "  stiff: {law: yeoh, c1: 1 MPa, c2: 1 kPa, c3: 1 kPa, density: 1200 kg/m^3}\n"
                           "  ecoflex-like: {law: saint-venant-kirchhoff, young: 0.1 MPa, poisson: 0.49}\n"
                           "geometry: {cap: {material: stiff}}"));
    ASSERT_EQ(design.materials.size(), 2u);
    const model::Material& stiff = design.materials.at("stiff");
    EXPECT_EQ(stiff.law, "yeoh");
    EXPECT_EQ(stiff.constants.at("c1"), std::vector<double>{1e6});
    EXPECT_EQ(stiff.density_kg_m3, 1200.0);
    EXPECT_EQ(stiff.source, "materials.stiff");
    EXPECT_EQ(design.material.source, "material");
    EXPECT_NEAR(design.materials.at("ecoflex-like").constants.at("mu").at(0), 0.1e6 / 2.98, 1e-6);
    const Design again = read_capped(design.effective_yaml);
    EXPECT_EQ(again.effective_yaml, design.effective_yaml);
    EXPECT_EQ(again.materials.at("stiff").constants, stiff.constants);
}

TEST(RegionMaterials, CanBeASiliconeOfTheLibrary) {
    const Design design = read_capped(capped("materials: {cap: dragon-skin-20}\ngeometry: {cap: {material: cap}}"));
    EXPECT_EQ(design.materials.at("cap").law, "yeoh");
    EXPECT_EQ(fitted_material(design.effective_yaml, "materials.cap").value().name, "dragon-skin-20");
    EXPECT_FALSE(fitted_material(design.effective_yaml));
    const std::string line = refused("materials: {cap: dragon-skin-2}");
    EXPECT_EQ(line.find("p.yaml:3:18: materials.cap.name: no silicone is called 'dragon-skin-2'"), 0u) << line;
}

TEST(RegionMaterials, ErrorsAreReportedAtTheirLocation) {
    EXPECT_EQ(refused("materials: {cap: {law: neo-hokean, mu: 1 MPa}}")
                  .find("p.yaml:3:24: materials.cap.law: no law is called"),
              0u);
    EXPECT_TRUE(contains(refused("materials: {cap: {law: neo-hookean, mo: 1 MPa}}"),
                         "materials.cap.mo: unknown key; did you mean 'mu'"));
    EXPECT_TRUE(contains(refused("materials: {cap: {law: neo-hookean}}"), "materials.cap.mu: missing ("));
    EXPECT_TRUE(contains(refused("materials: {cap: }"), "materials.cap: has no value; write cap: {law: neo-hookean"));
    EXPECT_TRUE(contains(refused("materials: {a b: {law: neo-hookean, mu: 1 MPa}}"), "not a name of a material"));
    EXPECT_TRUE(contains(refused("geometry: {cap: {material: papier}}"),
                         "geometry.cap.material: no material is called 'papier'"));
}

TEST(RegionMaterials, BuiltInMaterialNeedNotBeGiven) {
    EXPECT_TRUE(read_capped(capped("")).materials.empty());
    const Design named = read_capped(capped("geometry: {cap: {material: paper}}"));
    EXPECT_NEAR(named.materials.at("paper").constants.at("mu").at(0), 540e6, 1.0);
    EXPECT_EQ(read_capped(named.effective_yaml).effective_yaml, named.effective_yaml);
    const Design softer = read_capped(capped("geometry: {cap: {material: paper}}"), {{"materials.paper.mu", "10 MPa"}});
    EXPECT_NEAR(softer.materials.at("paper").constants.at("mu").at(0), 10e6, 1.0);
    const Design own =
        read_capped(capped("geometry: {cap: {material: paper}}\nmaterials: {paper: {law: gent, mu: 1 MPa, jm: 3}}"));
    EXPECT_EQ(own.materials.at("paper").law, "gent");
}

TEST(RegionMaterials, AreCheckedLikeTheMainMaterial) {
    const std::string incompressible =
        refused("materials: {cap: {law: neo-hookean, mu: 1 MPa}}\nmesh: {formulation: displacement}",
                {{"material.kappa", "10 MPa"}});
    EXPECT_TRUE(contains(incompressible, "or a value for materials.cap.kappa")) << incompressible;
    const std::string weightless = refused("materials: {cap: {law: neo-hookean, mu: 1 MPa}}\ndynamics: {duration: 1 s}",
                                           {{"material.density", "1 g/cm^3"}});
    EXPECT_TRUE(contains(weightless, "materials.cap has no density; add materials.cap: {density: 1080 kg/m^3}"))
        << weightless;
    const Design unstable = read_capped(capped("materials: {cap: {law: yeoh, c1: 10 kPa, c2: -1 kPa, c3: 0 kPa}}"));
    ASSERT_EQ(unstable.warnings.size(), 1u);
    EXPECT_EQ(unstable.warnings[0].find("materials.cap: yeoh is "), 0u) << unstable.warnings[0];
    const Design slip = read_capped(capped("materials: {cap: {law: neo-hookean, mu: 1 Pa}}"));
    ASSERT_EQ(slip.warnings.size(), 1u);
    EXPECT_TRUE(contains(slip.warnings[0], "materials.cap: an initial Young's modulus of 3 Pa")) << slip.warnings[0];
}

TEST(RegionMaterials, CanBeChangedAndAddedBySolve) {
    const std::string effective =
        read_capped(capped("materials: {cap: {law: neo-hookean, mu: 1 MPa}}\ngeometry: {cap: {material: cap}}"))
            .effective_yaml;
    const std::vector<Override> change{{"materials.cap.mu", "2 MPa"}},
        add{{"materials.cup", "{law: neo-hookean, mu: 2 MPa}"}};
    const std::vector<FamilyKeys> known{capped_pipe()};
    const Design changes = read_built(effective, change, known);
    EXPECT_EQ(changes.materials.at("cap").constants.at("mu"), std::vector<double>{2e6});
    EXPECT_EQ(changes.material.constants.at("mu"), std::vector<double>{0.1e6});
    EXPECT_TRUE(contains(changes.effective_yaml, "mu: 2 MPa"));
    EXPECT_TRUE(
        read_built(effective, add, known).materials.contains("cup"));  // build_case checks whether a region uses it
}

TEST(RegionMaterials, AreIncludedInExplain) {
    const std::vector<FamilyKeys> known{capped_pipe()};
    const std::string text = explain_design(capped("geometry: {cap: {material: paper}}"), "p.yaml", known, {});
    EXPECT_TRUE(contains(text, "materials:")) << text;
    EXPECT_TRUE(contains(text, "mu: 540 MPa")) << text;
    EXPECT_EQ(read_capped(text).effective_yaml,
              read_capped(capped("geometry: {cap: {material: paper}}")).effective_yaml);
}

}  // namespace
