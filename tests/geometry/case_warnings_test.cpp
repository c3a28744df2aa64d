#include "geometry/case_warnings.hpp"

#include <gtest/gtest.h>

#include <array>

#include "geometry/build.hpp"

namespace soft::geometry {
namespace {

constexpr const char* rubber = "material: {law: neo-hookean, mu: 0.1644 MPa}\n";

/// Warnings that need the case.
std::vector<std::string> warnings_for(const std::string& text) {
    const design::Design design = design::read_design(text + rubber, "test.yaml", catalogue_keys(), {});
    return case_warnings(design, build_case(design));
}

void expect_warning(const std::string& text, std::string_view words) {
    const auto warnings = warnings_for(text);
    ASSERT_EQ(warnings.size(), 1u) << text;
    EXPECT_NE(warnings[0].find(words), std::string::npos) << warnings[0];
}

const std::string rod = "family: rod\nmesh: {size: 10 mm}\n", tube = "family: tube\nmesh: {size: 4 mm}\n";

TEST(CaseWarnings, UnusualSizesAreReported) {
    const auto of_length = [](const std::string& length, const std::string& other) {
        return "family: rod\ngeometry: {length: " + length + ", width: " + other + ", height: " + other +
               "}\nmesh: {size: " + other + "}\nloads: {end: {traction: 1 kPa, along: x}}\n";
    };
    EXPECT_TRUE(warnings_for(of_length("2.9 m", "0.5 m")).empty());
    EXPECT_TRUE(warnings_for(of_length("2.1 mm", "0.5 mm")).empty());
    expect_warning(of_length("100 m", "10 m"), "the body is 100 m long");
    expect_warning(of_length("0.1 mm", "0.01 mm"), "the body is 100 um long");
}

TEST(CaseWarnings, OnlyLoadsAcrossASymmetryPlaneAreReported) {
    const auto loaded = [](const std::string& model, const std::string& load) {
        return rod + "model: " + model + "\nloads: {" + load + "}\n";
    };
    expect_warning(loaded("half", "end: {traction: 1 kPa, along: y}"),
                   "loads.end: acts across the symmetry plane y = 0");
    expect_warning(loaded("quarter", "end: {traction: 1 kPa, along: z}"), "across the symmetry plane z = 0");
    EXPECT_TRUE(warnings_for(loaded("half", "end: {traction: 1 kPa, along: z}")).empty());
    EXPECT_TRUE(warnings_for(loaded("half", "end: {displacement: 1 mm, along: x}")).empty());
    EXPECT_TRUE(warnings_for(loaded("solid", "end: {traction: 1 kPa, along: y}")).empty());
}

TEST(CaseWarnings, DisplacementOutputOfAFixedFaceIsReported) {
    const std::string load = "loads: {cavity: {pressure: 5 kPa}}\n";
    expect_warning(tube + load + "supports: {fixed: [fixed, inlet]}\n",
                   "outputs.elongation: supports fix the face inlet");
    EXPECT_TRUE(warnings_for(tube + load).empty());
    EXPECT_TRUE(
        warnings_for(tube + load +
                     "supports: {fixed: [fixed, inlet]}\noutputs: {block: {face: inlet, measure: force, along: x}}\n")
            .empty());
}

TEST(CaseWarnings, GasInWrongUnitsIsReported) {
    // The cavity of the tube contains some mL, i.e. some mg of air at ambient pressure.
    const auto gas = [](const std::string& supply, const std::string& keys) {
        return tube + "loads: {cavity: {" + supply + ", gas: {" + keys + "}}}\n";
    };
    const std::string pressure = "pressure: 5 kPa", mass = "mass: 5 mg";
    expect_warning(gas(pressure, "ambient: 101.325 GPa"),
                   "loads.cavity.gas.ambient: 101.325 GPa is an unusual ambient pressure");
    expect_warning(gas(pressure, "ambient: 1 Pa"), "loads.cavity.gas.ambient: 1 Pa is an unusual ambient pressure");
    expect_warning(gas(pressure, "density: 1.2 g/cm^3"), "loads.cavity.gas.density: ");
    expect_warning(gas(pressure, "ambient: 5 MPa"), "air has 59.4");  // the stated 1.204 kg/m^3 does not fit 5 MPa
    expect_warning(gas(mass, "dead_volume: 1 m^3"),
                   "loads.cavity.gas.dead_volume: 1 m^3 is more than a thousand times");
    expect_warning(gas("mass: 12 kg", "dead_volume: 0 mL"), "loads.cavity.mass: 12 kg is more than a thousand times");
    EXPECT_TRUE(warnings_for(gas(mass, "dead_volume: 1 L, process: adiabatic")).empty());
    EXPECT_TRUE(warnings_for(gas(pressure, "ambient: 70 kPa")).empty());                       // in the mountains
    EXPECT_TRUE(warnings_for(gas(pressure, "ambient: 1 MPa, density: 11.9 kg/m^3")).empty());  // 90 m below the sea
    EXPECT_TRUE(warnings_for(gas(pressure, "density: 0.166 kg/m^3")).empty());                 // helium
}

TEST(CaseWarnings, OutsidePressureIsReportedIfTheCavityIsNotLoaded) {
    expect_warning(tube + "loads: {outer: {pressure: 5 kPa}}\n", "loads.outer: acts on the face outer");
    EXPECT_TRUE(warnings_for(tube + "loads: {outer: {pressure: 5 kPa}, cavity: {pressure: 5 kPa}}\n").empty());
    EXPECT_TRUE(warnings_for("family: dome\nmesh: {size: 2 mm}\nloads: {outer: {pressure: 5 kPa}}\n").empty());
}

TEST(CaseWarnings, DisplacementOfAnObstacleAtRestIsReported) {
    const std::string design =
        rod +
        "model: solid\nobstacles: {wall: {plane: {point: [500 mm, 0 mm, 0 mm], normal: [-1, 0, 0]}}}\n"
        "outputs: {way: {obstacle: wall, measure: displacement, along: x}}\n";
    const auto warnings = warnings_for(design + "loads: {end: {traction: 1 kPa, along: x}}\n");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("outputs.way: no load moves the obstacle wall"), std::string::npos) << warnings[0];
    EXPECT_TRUE(warnings_for(design + "loads: {wall: {displacement: -1 mm, along: x}}\n").empty());
}

/// A quadrilateral of side 1 whose corner (1, 1) moves to (c, c): the determinant is (2 c - 1) / 4 there, 1 / 4 opposite.
TEST(CaseWarnings, PoorCellIsReported) {
    const design::Design design = design::read_design(
        rod + "model: solid\nloads: {end: {traction: 1 kPa, along: x}}\n" + rubber, "test.yaml", catalogue_keys(), {});
    model::Case built = build_case(design);
    for (const auto& [c, words] : {std::pair{0.56, ""}, {0.52, "worst scaled Jacobian 0.04 at"}}) {
        built.mesh = {};
        built.mesh.dimension = 2;
        built.mesh.points = {{0, 0, 0}, {1, 0, 0}, {c, c, 0}, {0, 1, 0}};
        mesh::add_cell(built.mesh, mesh::CellType::quad4, std::array<mesh::Index, 4>{0, 1, 2, 3}, 0);
        built.outputs.clear();
        const auto warnings = case_warnings(design, built);
        if (std::string_view{words}.empty()) {
            EXPECT_TRUE(warnings.empty()) << warnings[0];
        } else {
            ASSERT_EQ(warnings.size(), 1u);
            EXPECT_NE(warnings[0].find(words), std::string::npos) << warnings[0];
        }
    }
}

}  // namespace
}  // namespace soft::geometry
