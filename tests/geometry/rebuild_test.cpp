/// Cases rebuilt from mesh, shape and effective design, as programs read them from a file.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../model/equal.hpp"
#include "core/error.hpp"
#include "geometry/build.hpp"

namespace soft::geometry {
namespace {

using Overrides = std::vector<design::Override>;

constexpr const char* source = "case.h5:/design/effective_yaml";
const std::filesystem::path designs = std::filesystem::path{SOFT_SOURCE_DIR} / "designs";

design::Design read(const std::string& text, const std::string& name, const Overrides& overrides = {}) {
    return design::read_design(text, name, catalogue_keys(), overrides);
}

design::Design read_file(const std::filesystem::path& path, const Overrides& overrides = {}) {
    std::ifstream file{path};
    std::ostringstream text;
    text << file.rdbuf();
    return read(text.str(), path.string(), overrides);
}

/// The case after overrides of solve.
model::Case changed(const Built& built, const design::Design& design, const Overrides& overrides) {
    const design::Design changed =
        read_built_design(built.model.mesh, built.shape, design.effective_yaml, source, overrides);
    return build_case(changed, built.model.mesh, built.shape);
}

std::string refusal(const Built& built, const design::Design& design, const Overrides& overrides) {
    try {
        static_cast<void>(changed(built, design, overrides));
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

class EveryDesign : public testing::TestWithParam<std::string> {};

TEST_P(EveryDesign, IsRebuiltEqualInEveryField) {
    std::string name = GetParam();
    std::ranges::replace(name, '_', '-');  // names of tests have no '-'
    const design::Design design = read_file(
        designs / (name + ".yaml"), name.starts_with("imported") ? Overrides{} : Overrides{{"mesh.quality", "draft"}});
    const Built built = build_with_figures(design);
    model::test::expect_equal(rebuild_case(built.model.mesh, built.shape, design.effective_yaml, source), built.model);
}

INSTANTIATE_TEST_SUITE_P(Rebuild, EveryDesign,
                         testing::Values("bellows", "bending_bellows", "bending_fiber_tube", "cycle", "dome",
                                         "extruded", "fiber_tube", "imported", "imported_part", "panel", "plate",
                                         "pneunet", "revolved", "ring", "rod", "segment", "sphere", "tube",
                                         "two_spheres"),
                         [](const auto& design) { return design.param; });

TEST(Rebuild, ChangedLoadsEqualThoseOfADesignWithTheSameOverrides) {
    const auto path = designs / "bellows.yaml";
    const design::Design design = read_file(path);
    const Built built = build_with_figures(design);
    const Overrides overrides{{"loads.cavity.pressure", "12 kPa"},
                              {"loads.inlet", "{traction: 2 kPa, along: x}"},
                              {"material.density", "1080 kg/m^3"},
                              {"loads.gravity", "{acceleration: 9.81 m/s^2, along: -axis}"},
                              {"solver.threads", "2"}};
    model::test::expect_equal(changed(built, design, overrides), build_case(read_file(path, overrides)));
    EXPECT_NE(refusal(built, design, {{"loads.gravity", "{acceleration: 9.81 m/s^2, along: x}"}}).find("no density"),
              std::string::npos);
}

TEST(Rebuild, RejectsAMaterialThatNoRegionUses) {
    const design::Design design = read_file(designs / "bellows.yaml");
    const Built built = build_with_figures(design);
    EXPECT_EQ(refusal(built, design, {{"materials.felt", "{law: neo-hookean, mu: 1 MPa}"}}),
              "--set materials.felt: materials.felt.law: no region uses this material; regions: rubber");
}

TEST(Rebuild, RejectsAMeshThatDoesNotFitTheDesign) {
    const design::Design design = read_file(designs / "bellows.yaml");
    Built built = build_with_figures(design);
    Built other = built;
    other.shape.kinematics = model::Kinematics::plane_strain;
    EXPECT_NE(refusal(other, design, {}).find("model: the mesh of the case is of another kind"), std::string::npos);
    other = built;
    other.model.mesh.facet_sets.at("inlet").clear();
    EXPECT_NE(refusal(other, design, {}).find("the face 'inlet' is empty"), std::string::npos);
    built.shape.cavities.clear();
    EXPECT_EQ(
        refusal(built, design, {{"path.control", "auto"}, {"loads.cavity", "{volume_ratio: 2}"}}),
        "loads.cavity: is no cavity of this model, and has no volume; prescribe its pressure, or rebuild the case with "
        "mesh-gen");
}

TEST(Rebuild, DoesNotReadTheFileOfAnImportedShape) {
    const auto folder = std::filesystem::temp_directory_path() / "rebuild-test";
    std::filesystem::create_directories(folder);
    const design::Design example = read_file(designs / "imported-part.yaml");
    std::filesystem::copy_file(designs / example.values.text("geometry.file"), folder / "part",
                               std::filesystem::copy_options::overwrite_existing);
    std::string text = example.effective_yaml;
    const std::string name = example.values.text("geometry.file");
    const auto extension = std::filesystem::path{name}.extension().string();
    std::filesystem::rename(folder / "part", folder / ("part" + extension));
    text.replace(text.find(name), name.size(), "part" + extension);
    const design::Design design = read(text, (folder / "design.yaml").string());
    const Built built = build_with_figures(design);
    std::filesystem::remove_all(folder);
    model::test::expect_equal(rebuild_case(built.model.mesh, built.shape, design.effective_yaml, source), built.model);
}

}  // namespace
}  // namespace soft::geometry
