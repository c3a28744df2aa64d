#include "fem/pressure_mass.hpp"

#include <gtest/gtest.h>

#include "mesh/shape.hpp"

namespace soft::fem {
namespace {

/// Nodes of the reference cell, scaled by the factors and translated, component by component.
std::vector<double> box(mesh::CellType type, const std::array<double, 3>& factor, const std::array<double, 3>& shift) {
    std::vector<double> X;
    for (int i = 0; i < mesh::dimension(type); ++i)
        for (const auto& node : mesh::topology(type).nodes) X.push_back(factor[i] * node[i] + shift[i]);
    return X;
}

// Functions 1, x, y, z over half the extent of a cube: integrals of 1 and of xi^2 over [-1, 1]^3, times the volume over 8.
TEST(PressureMass, OfACubeIsTheIntegralOfItsMonomials) {
    const auto cell = make_reference_cell(mesh::CellType::hex27, Form::mixed);
    const double edge = 0.02, scale = 7.0, volume = edge * edge * edge;
    const auto M =
        pressure_mass(cell, model::Kinematics::solid, box(cell.type, {edge / 2, edge / 2, edge / 2}, {1, 2, 3}), scale);
    ASSERT_EQ(M.size(), 16u);
    for (int s = 0; s < 4; ++s)
        for (int t = 0; t < 4; ++t)
            EXPECT_NEAR(M[4 * s + t], s != t ? 0.0 : scale * scale * volume * (s == 0 ? 1.0 : 1.0 / 3),
                        1e-12 * scale * scale * volume);
}

// Barycentric coordinates: V / 20 (1 + delta), Zienkiewicz and Taylor, The Finite Element Method.
TEST(PressureMass, OfATetrahedronMatchesTheFormulaForBarycentricCoordinates) {
    const auto cell = make_reference_cell(mesh::CellType::tet10, Form::mixed);
    const double volume = 2.0 * 3.0 * 4.0 / 6;
    const auto M = pressure_mass(cell, model::Kinematics::solid, box(cell.type, {2, 3, 4}, {}), 1.0);
    for (int s = 0; s < 4; ++s)
        for (int t = 0; t < 4; ++t) EXPECT_NEAR(M[4 * s + t], volume / 20 * (s == t ? 2 : 1), 1e-12 * volume);
}

TEST(PressureMass, OfABodyOfRevolutionIncludesTheFullTurn) {
    const auto cell = make_reference_cell(mesh::CellType::quad9, Form::mixed);
    const auto M = pressure_mass(cell, model::Kinematics::axisymmetric, box(cell.type, {0.5, 0.5, 0}, {0, 3, 0}), 1.0);
    EXPECT_NEAR(M[0], 2 * std::numbers::pi * 3.0, 1e-12 * M[0]);  // Pappus: unit area at radius 3
}

TEST(PressureMass, IsEmptyWithoutAPressureUnknown) {
    const auto cell = make_reference_cell(mesh::CellType::hex27, Form::displacement);
    EXPECT_TRUE(pressure_mass(cell, model::Kinematics::solid, box(cell.type, {1, 1, 1}, {}), 1.0).empty());
}

}  // namespace
}  // namespace soft::fem
