/// The example designs and the templates of all families, from text to case.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "geometry/build.hpp"
#include "mesh/quality.hpp"

namespace soft::geometry {
namespace {

design::Design read_from(const std::string& text, const std::string& source,
                         std::vector<design::Override> overrides = {}) {
    return design::read_design(text, source, catalogue_keys(), overrides);
}

std::string file_text(const std::filesystem::path& path) {
    std::ifstream file{path};
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// GoogleTest names consist of letters, digits and _.
class EveryFamily : public testing::TestWithParam<std::string> {
protected:
    const std::filesystem::path path = std::filesystem::path{SOFT_SOURCE_DIR} / "designs" / (GetParam() + ".yaml");
};

TEST_P(EveryFamily, ExampleDesignBuildsInEveryModel) {
    for (const Family& family : catalogue()) {
        if (family.keys.name != GetParam()) continue;
        for (const std::string& model : family.keys.models) {
            std::vector<design::Override> overrides{{"model", model}};
            if (model == "axisymmetric" && GetParam() == "plate") overrides.push_back({"geometry.radius", "50mm"});
            if (GetParam() == "rod") overrides.push_back({"supports.y", "right"});  // the half model has no face y = 0
            if (GetParam() == "rod") overrides.push_back({"supports.z", "top"});
            const model::Case c = build_case(read_from(file_text(path), path.string(), overrides));
            EXPECT_GT(mesh::quality(c.mesh).min_scaled_jacobian, 0.1) << model;
            EXPECT_FALSE(c.loads.empty() && c.dead_loads.empty());
            EXPECT_FALSE(c.supports.empty());
        }
    }
}

TEST_P(EveryFamily, TemplateBuilds) {
    for (const design::FamilyKeys& keys : catalogue_keys()) {
        if (keys.name != GetParam()) continue;
        EXPECT_NO_THROW((void)build_case(read_from(design::template_yaml(keys), "template")));
    }
}

TEST_P(EveryFamily, BuildsFromFamilyMaterialAndPressureOnly) {
    struct Short {
        std::string target = "cavity: {pressure: 5 kPa}";
        std::size_t cavities = 1, outputs = 1;
    };
    const std::map<std::string, Short> others{{"two-spheres", {"cavities: {left: {pressure: 5 kPa}}", 2, 0}},
                                              {"segment", {"cavities: {chamber_1: {pressure: 5 kPa}}", 1, 3}},
                                              {"pneunet", {.outputs = 3}},
                                              {"sphere", {.outputs = 0}},
                                              {"ring", {.outputs = 0}},
                                              {"rod", {"end: {pressure: 5 kPa}", 0}},
                                              {"dome", {"outer: {pressure: 5 kPa}", 0}},
                                              {"panel", {"bottom: {pressure: 5 kPa}", 0}},
                                              {"plate", {"bottom: {pressure: 5 kPa}", 0}}};
    const auto own = others.find(GetParam());
    const Short expected = own == others.end() ? Short{} : own->second;
    const model::Case c = build_case(read_from(
        "family: " + GetParam() + "\nmaterial: {law: neo-hookean, mu: 0.1644 MPa}\nloads: {" + expected.target + "}\n",
        "short.yaml"));
    ASSERT_EQ(c.loads.size(), 1u);
    EXPECT_EQ(c.cavities.size(), expected.cavities);
    EXPECT_EQ(c.outputs.size(), expected.outputs);
}

INSTANTIATE_TEST_SUITE_P(Designs, EveryFamily,
                         testing::Values("rod", "panel", "plate", "sphere", "two-spheres", "ring", "tube", "fiber-tube",
                                         "dome", "bellows", "pneunet", "segment"),
                         [](const auto& test) { return test_name(test.param); });

/// Further example designs.
class ExampleDesign : public testing::TestWithParam<std::string> {
protected:
    const std::filesystem::path path = std::filesystem::path{SOFT_SOURCE_DIR} / "designs" / (GetParam() + ".yaml");
};

TEST_P(ExampleDesign, BuildsWithoutWarning) {
    const design::Design design = read_from(file_text(path), path.string());
    EXPECT_TRUE(design.warnings.empty()) << design.warnings.front();
    EXPECT_GT(mesh::quality(build_case(design).mesh).min_scaled_jacobian, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Designs, ExampleDesign,
                         testing::Values("balloon", "vacuum", "cycle", "yeoh-bellows", "two-spheres", "dome",
                                         "twisting-tube", "bellows-inflation", "bending-bellows", "pneunet", "segment"),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace soft::geometry
