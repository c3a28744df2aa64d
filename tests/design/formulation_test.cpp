#include <gtest/gtest.h>

#include "sample.hpp"

namespace {

using namespace soft::design;
using namespace soft::design::sample;

const std::string compressible =
    "family: pipe\nmaterial: {law: neo-hookean, mu: 0.1644 MPa, kappa: 5 MPa}\nloads: {cavity: {pressure: 30 kPa}}\n";

void expect(const std::string& text, std::string_view start, std::string_view remedy) {
    const std::string line = refusal(text);
    EXPECT_EQ(line.find(start), 0u) << line;
    EXPECT_TRUE(contains(line, remedy)) << line;
}

TEST(Formulation, MixedFirstOrderIsRejectedAsUnstable) {
    const std::string remedy = "order: 2, or formulation: f-bar for quadrilaterals and hexahedra";
    expect(base + "mesh: {formulation: mixed, order: 1}\n",
           "p.yaml:4:35: mesh.order: first-order cells have no stable pair with a pressure", remedy);
    expect(base + "mesh: {order: 1}\n", "p.yaml:4:15: mesh.order: first-order cells", remedy);  // mixed is the default
}

TEST(Formulation, FBarIsForFirstOrderQuadrilateralsAndHexahedra) {
    expect(compressible + "mesh: {formulation: f-bar}\n",
           "p.yaml:4:21: mesh.formulation: f-bar is for first-order cells", "add order: 1");
    expect(compressible + "mesh: {formulation: f-bar, order: 1, cells: simplices}\n",
           "p.yaml:4:21: mesh.formulation: f-bar does nothing for triangles and tetrahedra", "cells: auto");
    EXPECT_EQ(read(compressible + "mesh: {formulation: f-bar, order: 1}\n").values.text("mesh.formulation"), "f-bar");
}

TEST(Formulation, WithoutPressureUnknownsRequiresACompressibleMaterial) {
    for (const char* formulation : {"displacement", "f-bar"})
        expect(base + "mesh: {order: 1, formulation: " + formulation + "}\n",
               std::string{"p.yaml:4:31: mesh.formulation: "} + formulation + " needs a finite bulk modulus",
               "formulation: mixed, or a value for material.kappa");
    expect(base + "mesh: {formulation: displacement}\n", "p.yaml:4:21: mesh.formulation: displacement needs",
           "material.kappa");
    for (const char* order : {"1", "2"})
        EXPECT_NO_THROW(
            static_cast<void>(read(compressible + "mesh: {formulation: displacement, order: " + order + "}\n")));
}

}  // namespace
