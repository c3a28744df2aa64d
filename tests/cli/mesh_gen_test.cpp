#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "process.hpp"

namespace {

using namespace soft::process;

std::vector<std::string> families(const Folder& folder) {
    std::istringstream lines{run(folder, "mesh-gen --list").out};
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) names.push_back(line.substr(0, line.find(' ')));
    return names;
}

TEST(MeshGen, EveryTemplateRunsUnchanged) {
    Folder folder;
    const auto names = families(folder);
    EXPECT_GE(names.size(), 5u);
    for (const std::string& name : names) {
        const Outcome outcome =  // in an empty folder
            run(folder, "mkdir -p empty && cd empty && mesh-gen --template " + name + " | mesh-gen -q | head -c 4");
        EXPECT_EQ(outcome.code, 0) << name << outcome.err;
        EXPECT_EQ(outcome.out, "\x89HDF") << name;
        EXPECT_EQ(outcome.err, "") << name;
    }
}

/// A bar of 40 x 10 x 10 with a closed cavity of 20 x 4 x 4, in the length unit of an OBJ file.
constexpr const char* hollow_bar =
    "printf 'v 0 0 0\\nv 40 0 0\\nv 40 10 0\\nv 0 10 0\\nv 0 0 10\\nv 40 0 10\\nv 40 10 10\\nv 0 10 10\\n"
    "v 10 3 3\\nv 30 3 3\\nv 30 7 3\\nv 10 7 3\\nv 10 3 7\\nv 30 3 7\\nv 30 7 7\\nv 10 7 7\\n"
    "f 4 3 2 1\\nf 5 6 7 8\\nf 1 2 6 5\\nf 2 3 7 6\\nf 3 4 8 7\\nf 4 1 5 8\\n"
    "f 9 10 11 12\\nf 16 15 14 13\\nf 13 14 10 9\\nf 14 15 11 10\\nf 15 16 12 11\\nf 16 13 9 12\\n' > bar.obj; ";

TEST(MeshGen, DescriptionOfAPartIsTheBeginningOfADesign) {
    Folder folder;
    const Outcome described = run(
        folder, std::string{hollow_bar} + "mesh-gen --describe bar.obj --picture bar.svg -o bar.yaml && cat bar.yaml");
    EXPECT_EQ(described.code, 0) << described.err;
    for (const char* line :
         {"# bar.obj: x from 0 to 40 mm, y from 0 to 10 mm, z from 0 to 10 mm; volume 3.68 mL, surface 2152 mm^2",
          "# closed cavity `cavity`: 320 mm^3 about [20 mm, 5 mm, 5 mm]",
          "{plane: {x: 0 mm}}   # plane, normal -x, 100 mm^2", "{plane: {x: 40 mm}}   # plane, normal x, 100 mm^2"})
        EXPECT_NE(described.out.find(line), std::string::npos) << line << described.out;
    EXPECT_NE(run(folder, "cat bar.svg").out.find(">12</text>"), std::string::npos);
    const Outcome built =
        run(folder,
            "face=$(sed -n 's/^ *\\(face_[0-9]*\\): {plane: {x: 0 mm}}.*/\\1/p' bar.yaml); "
            "printf 'material: {law: neo-hookean, mu: 0.1 MPa, kappa: incompressible}\\nsupports: {fixed: %s}\\n"
            "loads: {cavity: {pressure: 5 kPa}}\\n' $face >> bar.yaml; mesh-gen bar.yaml --check");
    EXPECT_EQ(built.code, 0) << built.err;
}

TEST(MeshGen, WarnsThatAPartOfOneMillimetreMayBeInInches) {
    Folder folder;
    const std::string small = std::string{hollow_bar} + "sed '/^v/s/ \\([0-9]*\\)/ \\1e-2/g' bar.obj > small.obj; ";
    EXPECT_NE(run(folder, small + "mesh-gen --describe small.obj")
                  .err.find("if its lengths are in inches, use `unit: in`, which gives 10.16 mm"),
              std::string::npos);
    EXPECT_EQ(run(folder, "mesh-gen --describe small.obj --set geometry.unit=in").err, "");
    EXPECT_EQ(run(folder, "mesh-gen --describe bar.obj").err, "");
}

TEST(MeshGen, APartGivenInsteadOfADesignIsReported) {
    Folder folder;
    for (const char* file : {"chamber.step", "a.STL", "b.obj"}) {
        const Outcome outcome = run(folder, std::string{"mesh-gen "} + file);
        EXPECT_EQ(outcome.code, 65);
        EXPECT_NE(outcome.err.find(std::string{file} + ": a CAD part, not a design (YAML); use family: imported"),
                  std::string::npos)
            << outcome.err;
    }
}

TEST(MeshGen, PipeAndFileGiveTheSameBytesTwice) {
    Folder folder;
    const Outcome outcome =
        run(folder,
            "mesh-gen --template tube > t.yaml && mesh-gen -q t.yaml -o a.h5 && mesh-gen -q t.yaml -o a2.h5 && "
            "mesh-gen -q - < t.yaml > b.h5 && mv a2.h5 a.copy && mesh-gen -q - < t.yaml | cmp - b.h5");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(MeshGen, SeveralDesignsGiveTheSameBytesAsSeparateRuns) {
    Folder folder;
    const Outcome outcome = run(
        folder,
        "mesh-gen --template tube > 'a tube.yaml' && mesh-gen --template rod > rod.yaml && "
        "mesh-gen -q 'a tube.yaml' rod.yaml --output-folder new/cases --set mesh.size=3mm && mkdir kept && "
        "mv new/cases/* kept && mesh-gen 'a tube.yaml' -o 'new/cases/a tube.h5' --set mesh.size=3mm 2>tube.txt && "
        "cmp 'kept/a tube.h5' 'new/cases/a tube.h5' && mesh-gen rod.yaml -o new/cases/rod.h5 --set mesh.size=3mm 2>rod.txt && "
        "cmp kept/rod.h5 new/cases/rod.h5");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.err, "");
}

TEST(MeshGen, AnInvalidDesignDoesNotStopTheOthers) {
    Folder folder;
    const Outcome outcome = run(
        folder,
        "mesh-gen --template tube > a.yaml && sed 's/cap: .*/cap: 1 m/' a.yaml > b.yaml && "
        "cp a.yaml c.yaml && mesh-gen -q a.yaml absent.yaml b.yaml c.yaml --output-folder cases; code=$?; ls cases; exit $code");
    EXPECT_EQ(outcome.code, 66) << outcome.err;
    EXPECT_EQ(outcome.out, "a.h5\nc.h5\n");
    EXPECT_TRUE(contains(outcome.err, "mesh-gen: absent.yaml: ")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "mesh-gen: b.yaml:")) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << outcome.err;
}

/// Loading gmsh and its dependencies takes longer than the rest of the program start.
TEST(MeshGen, GmshIsLoadedOnlyToMakeAMesh) {
    Folder folder;
    const auto loads = [&folder](const std::string& command) {
        const Outcome outcome =
            run(folder, "LD_DEBUG=files " + command + " 2>&1 >out.txt | grep -c 'libgmsh.*generating link map'");
        return std::stoi(outcome.out);
    };
    EXPECT_EQ(loads("mesh-gen --version"), 0);
    EXPECT_EQ(loads("mesh-gen --template tube"), 0);
    run(folder, "mesh-gen --template tube > t.yaml");
    EXPECT_EQ(loads("mesh-gen --explain t.yaml"), 0);
    EXPECT_EQ(loads("mesh-gen --check t.yaml --set geometry.wal=2mm"), 0);
    EXPECT_EQ(loads("mesh-gen --check t.yaml"), 1);
}

TEST(MeshGen, TheSummaryContainsTheExactVolumes) {
    Folder folder;
    const Outcome outcome =
        run(folder,
            "mesh-gen --template tube | mesh-gen -o t.h5 --json - --set geometry.length=100mm --set geometry.cap=5mm "
            "--set geometry.outer_radius=10mm --set geometry.inner_radius=7mm");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    const double outside = std::numbers::pi * 0.01 * 0.01 * 0.1, inside = std::numbers::pi * 0.007 * 0.007 * 0.09;
    EXPECT_NEAR(json.at("rubber_volume_m3").get<double>(), outside - inside, 1e-9 * outside);
    EXPECT_NEAR(json.at("cavities").at(0).at("volume_m3").get<double>(), inside, 1e-9 * inside);
    EXPECT_NEAR(json.at("cavities").at(0).at("min_wall_m").get<double>(), 0.003, 1e-6);
    EXPECT_GT(json.at("min_scaled_jacobian").get<double>(), 0.0);
    EXPECT_TRUE(contains(outcome.err, "rubber 17.5")) << outcome.err;
    EXPECT_FALSE(json.contains("mass_kg"));  // without a density
}

TEST(MeshGen, TheSummaryContainsTheMassOfTheWholeActuator) {
    Folder folder;
    const Outcome outcome =
        run(folder,
            "mesh-gen --template rod | mesh-gen -o r.h5 --json - --set model=quarter --set geometry.length=100mm "
            "--set geometry.width=10mm --set geometry.height=10mm --set material.density=1080kg/m^3");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NEAR(nlohmann::json::parse(outcome.out).at("mass_kg").get<double>(), 0.0108, 1e-9);
    EXPECT_TRUE(contains(outcome.err, "10.8 g")) << outcome.err;
}

TEST(MeshGen, AQuarterSolidReportsTheWholeActuator) {
    Folder folder;
    const Outcome outcome =
        run(folder, "mesh-gen --template tube | mesh-gen -o t.h5 --json - --set model=quarter --set mesh.size=5mm");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const double inside = std::numbers::pi * 0.007 * 0.007 * 0.09;
    const double cavity = nlohmann::json::parse(outcome.out).at("cavities").at(0).at("volume_m3").get<double>();
    EXPECT_NEAR(cavity, inside, 1e-3 * inside);  // second-order arcs, four around the quarter
}

TEST(MeshGen, CountsTheUnknownsOfABar) {
    Folder folder;
    const Outcome outcome =
        run(folder,
            "mesh-gen --template rod | mesh-gen -o t.h5 --json - --set geometry.length=20mm --set geometry.width=10mm "
            "--set geometry.height=10mm --set mesh.size=10mm --set mesh.through_wall=1");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(json.at("cells"), 2);
    ASSERT_EQ(json.at("points"), 5 * 3 * 3);
    EXPECT_EQ(json.at("unknowns"), 3 * (5 * 3 * 3 - 9) + 2 * 4);  // one fixed face; four pressures per hexahedron
}

TEST(MeshGen, CheckCountsWarnings) {
    Folder folder;
    const Outcome outcome = run(folder,
                                "mesh-gen --template tube > t.yaml && mesh-gen --check t.yaml --set material.mu=100MPa "
                                "--set loads.cavity.pressure=101.325kPa");
    EXPECT_EQ(outcome.code, 0);
    std::istringstream lines{outcome.err};
    int warnings = 0;
    for (std::string line; std::getline(lines, line);) warnings += line.starts_with("mesh-gen: warning: ") ? 1 : 0;
    EXPECT_EQ(warnings, 2) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "t.yaml: valid, 2 warnings\n")) << outcome.err;
}

TEST(MeshGen, WarnsAboutTheMemoryOfAMillionUnknowns) {
    Folder folder;
    const Outcome large = run(
        folder, "mesh-gen --template rod > r.yaml && mesh-gen --check r.yaml --set mesh.size=0.6mm --set mesh.order=2");
    EXPECT_EQ(large.code, 0);
    EXPECT_TRUE(contains(large.err, "unknowns; solve will need about ")) << large.err;
    EXPECT_FALSE(contains(run(folder, "mesh-gen --check r.yaml --set mesh.size=1mm").err, "solve will need"));
}

TEST(MeshGen, CheckAndExplainWriteNoCase) {
    Folder folder;
    ASSERT_EQ(run(folder, "mesh-gen --template bellows > b.yaml").code, 0);
    const Outcome check = run(folder, "mesh-gen --check b.yaml");
    EXPECT_EQ(check.code, 0);
    EXPECT_EQ(check.out, "");
    EXPECT_TRUE(contains(check.err, "b.yaml: valid\n"));
    const Outcome explain = run(
        folder, "mesh-gen --explain b.yaml --set geometry.wall=2.5mm > e.yaml; cat e.yaml; mesh-gen --check e.yaml");
    EXPECT_EQ(explain.code, 0) << explain.err;
    EXPECT_TRUE(contains(explain.out, "2.5 mm"));
    EXPECT_TRUE(contains(explain.out, "given at --set geometry.wall"));
}

TEST(MeshGen, AcceptsTheDeviceNameOfStdout) {
    Folder folder;
    const Outcome outcome = run(folder, "mesh-gen --template rod | mesh-gen --check --json /dev/stdout | cat");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out).at("name"), "rod");
}

TEST(MeshGen, ShortAndLongPathsOfAnOverrideAreEquivalent) {
    Folder folder;
    const Outcome outcome =
        run(folder,
            "mesh-gen --template tube > t.yaml; mesh-gen --explain t.yaml --set load.pressure=60kPa > a; "
            "mesh-gen --explain t.yaml --set loads.cavity.pressure=60kPa > b; cmp a b && grep -c '60 kPa' a");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

}  // namespace
