#include "post/recovery.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../fem/distorted_cell.hpp"
#include "fem/solid_kernel.hpp"

namespace soft::post {
namespace {

using mesh::CellType;

TEST(Extrapolation, ReproducesLinearFunctionsInDistortedCells) {
    constexpr std::array<std::pair<CellType, fem::Form>, 8> cells{{{CellType::quad4, fem::Form::displacement},
                                                                   {CellType::hex8, fem::Form::f_bar},
                                                                   {CellType::triangle6, fem::Form::displacement},
                                                                   {CellType::triangle6, fem::Form::mixed},
                                                                   {CellType::tet10, fem::Form::mixed},
                                                                   {CellType::hex27, fem::Form::mixed},
                                                                   {CellType::wedge18, fem::Form::mixed},
                                                                   {CellType::wedge6, fem::Form::displacement}}};
    for (const auto& [type, form] : cells) {
        const auto cell = fem::make_reference_cell(type, form);
        const auto X = fem::distorted_nodes(type);
        const auto matrix = extrapolation(cell, X);
        const auto points = static_cast<std::size_t>(cell.points), nodes = static_cast<std::size_t>(cell.nodes);
        const std::array<double, 3> slope{50, -200, 70};
        std::vector<double> exact(nodes, 3.0);
        for (std::size_t i = 0; i < static_cast<std::size_t>(cell.dimension); ++i)
            for (std::size_t a = 0; a < nodes; ++a) exact[a] += slope[i] * X[i * nodes + a];
        for (std::size_t a = 0; a < nodes; ++a) {
            double value = 0;
            for (std::size_t q = 0; q < points; ++q)
                for (std::size_t b = 0; b < nodes; ++b)
                    value += matrix[a * points + q] * cell.N[q * nodes + b] * exact[b];
            EXPECT_NEAR(value, exact[a], 1e-12) << mesh::topology(type).name << " node " << a;
        }
    }
}

TEST(Extrapolation, OnePointGivesAConstant) {
    for (const double entry : extrapolation(fem::make_reference_cell(CellType::tet4, fem::Form::displacement),
                                            fem::distorted_nodes(CellType::tet4)))
        EXPECT_DOUBLE_EQ(entry, 1.0);
}

class CellPressure : public ::testing::TestWithParam<CellType> {};

TEST_P(CellPressure, RecoversTheUnknownsFromNodalPressures) {
    const CellType type = GetParam();
    const auto cell = fem::make_reference_cell(type, fem::Form::mixed);
    const auto X = fem::distorted_nodes(type);
    std::vector<double> unknowns;
    for (int s = 0; s < cell.pressure_dofs; ++s) unknowns.push_back(1000.0 * std::cos(1.0 + s));
    auto nodal = fem::nodal_pressures(cell, X, unknowns, 1.0);
    std::array<bool, 27> shared{};
    const std::size_t on_interface = cell.pressure == fem::PressureSpace::discontinuous_linear ? 3 : 1;
    for (std::size_t a = 0; a < on_interface; ++a) {
        shared[a] = true;  // perturbed by the neighbouring region
        nodal[a] += 5000.0;
    }
    const auto found = cell_pressure(cell, {X, nodal, {shared.data(), nodal.size()}});
    ASSERT_EQ(found.size(), unknowns.size());
    for (std::size_t s = 0; s < found.size(); ++s) EXPECT_NEAR(found[s], unknowns[s], 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Cells, CellPressure,
                         ::testing::Values(CellType::quad9, CellType::hex27, CellType::triangle6, CellType::tet10,
                                           CellType::wedge18));

TEST(CellPressure, IsTheCentreValueIfAllOtherNodesAreShared) {
    const auto cell = fem::make_reference_cell(CellType::quad9, fem::Form::mixed);
    const auto X = fem::distorted_nodes(CellType::quad9);
    std::vector<double> nodal(9, 777.0);
    nodal[8] = 50.0;
    std::array<bool, 9> shared{};
    shared.fill(true);
    const auto found = cell_pressure(cell, {X, nodal, shared});
    EXPECT_DOUBLE_EQ(found[0], 50.0);
    EXPECT_DOUBLE_EQ(found[1], 0.0);
    EXPECT_DOUBLE_EQ(found[2], 0.0);
}

}  // namespace
}  // namespace soft::post
