#include "geometry/case_warnings.hpp"

#include <gtest/gtest.h>

#include <array>

#include "geometry/build.hpp"

namespace soft::geometry {
namespace {

constexpr const char* rubber = "material: {law: neo-hookean, mu: 0.1644 MPa}\n";

/// What only the case shows.
std::vector<std::string> told(const std::string& text) {
    const design::Design design = design::read_design(text + rubber, "test.yaml", catalogue_keys(), {});
    return case_warnings(design, build_case(design));
}

void expect_told(const std::string& text, std::string_view words) {
    const auto warnings = told(text);
    ASSERT_EQ(warnings.size(), 1u) << text;
    EXPECT_NE(warnings[0].find(words), std::string::npos) << warnings[0];
}

const std::string rod = "family: rod\nmesh: {size: 10 mm}\n", tube = "family: tube\nmesh: {size: 4 mm}\n";

TEST(CaseWarnings, BodiesOfUnusualSizeAreTold) {
    const auto of_length = [](const std::string& length, const std::string& other) {
        return "family: rod\ngeometry: {length: " + length + ", width: " + other + ", height: " + other +
               "}\nmesh: {size: " + other + "}\nloads: {end: {traction: 1 kPa, along: x}}\n";
    };
    EXPECT_TRUE(told(of_length("2.9 m", "0.5 m")).empty());
    EXPECT_TRUE(told(of_length("2.1 mm", "0.5 mm")).empty());
    expect_told(of_length("100 m", "10 m"), "the body is 100 m long");
    expect_told(of_length("0.1 mm", "0.01 mm"), "the body is 100 um long");
}

TEST(CaseWarnings, LoadsAcrossAPlaneOfSymmetryAreToldAndOthersAreNot) {
    const auto loaded = [](const std::string& model, const std::string& load) {
        return rod + "model: " + model + "\nloads: {" + load + "}\n";
    };
    expect_told(loaded("half", "end: {traction: 1 kPa, along: y}"),
                "loads.end: it acts across the plane of symmetry y = 0");
    expect_told(loaded("quarter", "end: {traction: 1 kPa, along: z}"), "across the plane of symmetry z = 0");
    EXPECT_TRUE(told(loaded("half", "end: {traction: 1 kPa, along: z}")).empty());
    EXPECT_TRUE(told(loaded("half", "end: {displacement: 1 mm, along: x}")).empty());
    EXPECT_TRUE(told(loaded("solid", "end: {traction: 1 kPa, along: y}")).empty());
}

TEST(CaseWarnings, AnOutputOfAHeldFaceIsTold) {
    const std::string load = "loads: {cavity: {pressure: 5 kPa}}\n";
    expect_told(tube + load + "supports: {fixed: [fixed, inlet]}\n", "outputs.elongation: the face inlet is held");
    EXPECT_TRUE(told(tube + load).empty());
    EXPECT_TRUE(told(tube + load +
                     "supports: {fixed: [fixed, inlet]}\noutputs: {block: {face: inlet, measure: force, along: x}}\n")
                    .empty());
}

TEST(CaseWarnings, AGasInWrongUnitsIsReportedAndUsualOnesAreNot) {
    // The tube's cavity holds some mL, at ambient pressure some mg of air.
    const auto gas = [](const std::string& supply, const std::string& keys) {
        return tube + "loads: {cavity: {" + supply + ", gas: {" + keys + "}}}\n";
    };
    const std::string pressure = "pressure: 5 kPa", mass = "mass: 5 mg";
    expect_told(gas(pressure, "ambient: 101.325 GPa"), "loads.cavity.gas.ambient: 101.325 GPa is no usual pressure");
    expect_told(gas(pressure, "ambient: 1 Pa"), "loads.cavity.gas.ambient: 1 Pa is no usual pressure");
    expect_told(gas(pressure, "density: 1.2 g/cm^3"), "loads.cavity.gas.density: ");
    expect_told(gas(pressure, "ambient: 5 MPa"), "air has 59.4");  // 1.204 kg/m^3 stays stated for 5 MPa
    expect_told(gas(mass, "dead_volume: 1 m^3"), "loads.cavity.gas.dead_volume: 1 m^3 is more than a thousand times");
    expect_told(gas("mass: 12 kg", "dead_volume: 0 mL"), "loads.cavity.mass: 12 kg is more than a thousand times");
    EXPECT_TRUE(told(gas(mass, "dead_volume: 1 L, process: adiabatic")).empty());
    EXPECT_TRUE(told(gas(pressure, "ambient: 70 kPa")).empty());                       // in the mountains
    EXPECT_TRUE(told(gas(pressure, "ambient: 1 MPa, density: 11.9 kg/m^3")).empty());  // 90 m below the sea
    EXPECT_TRUE(told(gas(pressure, "density: 0.166 kg/m^3")).empty());                 // helium
}

TEST(CaseWarnings, APressedOutsideIsToldWhereTheCavityIsNotLoaded) {
    expect_told(tube + "loads: {outer: {pressure: 5 kPa}}\n", "loads.outer: presses on the face outer");
    EXPECT_TRUE(told(tube + "loads: {outer: {pressure: 5 kPa}, cavity: {pressure: 5 kPa}}\n").empty());
    EXPECT_TRUE(told("family: dome\nmesh: {size: 2 mm}\nloads: {outer: {pressure: 5 kPa}}\n").empty());
}

/// A quadrilateral of side 1 whose corner (1, 1) moves to (c, c): the determinant is (2 c - 1) / 4 there, 1 / 4 opposite.
TEST(CaseWarnings, APoorCellIsNamed) {
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
