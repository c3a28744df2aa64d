#include "post/arrays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "fields_samples.hpp"

namespace soft::post {
namespace {

using namespace test;
using model::NamedArray;

const NamedArray& named(const std::vector<NamedArray>& arrays, std::string_view name) {
    return *std::ranges::find(arrays, name, &NamedArray::name);
}

model::Case two_rubbers() {
    auto model = block_case(mesh::CellType::hex8, model::Kinematics::solid, model::Formulation::displacement, {.n = 2});
    model.mesh.region_names = {"rubber", "stiff"};
    for (mesh::Index cell = 0; cell < model.mesh.cell_count(); ++cell)
        model.mesh.cell_regions[static_cast<std::size_t>(cell)] =
            model.mesh.point(model.mesh.cell_nodes(cell)[0])[0] > 0.4;
    model.materials = {neo_hookean(1e5, 1e7), neo_hookean(3e5, 1e7)};
    model.materials[1].name = "stiff";
    return model;
}

TEST(Arrays, HaveOneEntryPerRegionPointMeshPointOrCell) {
    const auto model = two_rubbers();
    const auto sampled = sample(model, linear({1, 0, 0, 0.5, 1, 0, 0, 0, 1}));
    EXPECT_EQ(sampled.region_points.size(), 27U + 9U);
    for (const auto& array : node_arrays(model, sampled.region_points, sampled.state(), sampled.fields))
        EXPECT_EQ(array.values.size(), 36U * static_cast<std::size_t>(array.components)) << array.name;
    for (const auto& array : mesh_point_arrays(model, sampled.region_points, sampled.state(), sampled.fields))
        EXPECT_EQ(array.values.size(), 27U * static_cast<std::size_t>(array.components)) << array.name;
    for (const auto& array : state_arrays(model, sampled.fields.cells))
        EXPECT_EQ(array.values.size(), 8U * static_cast<std::size_t>(array.components)) << array.name;
}

TEST(Arrays, AMeshPointOnAnInterfaceHasTheMeanOfBothSides) {
    const auto model = two_rubbers();
    const auto sampled = sample(model, linear({1, 0, 0, 0.5, 1, 0, 0, 0, 1}));
    const auto arrays = mesh_point_arrays(model, sampled.region_points, sampled.state(), sampled.fields);
    const auto& sigma = named(arrays, "cauchy_stress_Pa");
    for (std::size_t k = 0; k < 27; ++k) {
        const double x = model.mesh.points[k][0];
        const double mu = x < 0.4 ? 1e5 : x > 0.6 ? 3e5 : 2e5;  // sigma_xy = mu g
        EXPECT_NEAR(sigma.values[9 * k + 1], 0.5 * mu, 1.0);
    }
}

TEST(Arrays, TheEnergyIsOmittedIfALawHasNone) {
    auto model = two_rubbers();
    EXPECT_EQ(state_arrays(model, {}).back().name, "energy_density_J_m3");
    model.materials[1].law = "kraken";
    for (const auto& array : state_arrays(model, {})) EXPECT_NE(array.name, "energy_density_J_m3");
}

}  // namespace
}  // namespace soft::post
