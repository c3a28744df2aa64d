#include "post/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "fields_samples.hpp"

namespace soft::post {
namespace {

using namespace test;

TEST(Quantity, TableOrderMatchesTheEnumerationAndNamesAreFound) {
    for (std::size_t i = 0; i < quantities().size(); ++i) {
        const QuantityInfo& entry = quantities()[i];
        EXPECT_EQ(static_cast<std::size_t>(entry.quantity), i);
        EXPECT_EQ(quantity_from_name(entry.name), entry.quantity);
    }
}

TEST(Quantity, AMisspelledNameSuggestsTheNearestOne) {
    try {
        static_cast<void>(quantity_from_name("von-mizes"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_NE(std::string(error.what()).find("did you mean 'von-mises'?"), std::string::npos) << error.what();
    }
}

TEST(Quantity, ValuesOfUniaxialTensionMatchTheClosedForm) {
    const double l = 1.5, t = 1 / std::sqrt(l), mu = 1e5;
    auto model =
        block_case(mesh::CellType::hex27, model::Kinematics::solid, model::Formulation::displacement, {.n = 1});
    model.materials = {neo_hookean(mu, 1e7)};
    const auto sampled = sample(model, linear({l, 0, 0, 0, t, 0, 0, 0, t}));
    const auto values = [&](Quantity quantity) {
        return nodal_values(quantity, model, sampled.region_points, sampled.state(), sampled.fields);
    };
    const double pull = mu * (l * l - 1 / l);
    for (std::size_t k = 0; k < sampled.region_points.size(); ++k) {
        const auto& X = model.mesh.point(sampled.region_points.node[k]);
        EXPECT_NEAR(values(Quantity::stretch)[k], l, 1e-12);
        EXPECT_NEAR(values(Quantity::von_mises)[k], pull, 1e-6 * pull);
        EXPECT_NEAR(values(Quantity::pressure)[k], 0.0, 1e-6 * pull);  // J = 1, no pressure unknown
        EXPECT_NEAR(values(Quantity::jacobian)[k], 1.0, 1e-12);
        EXPECT_NEAR(values(Quantity::energy)[k], 0.5 * mu * (l * l + 2 / l - 3), 1e-6 * mu);
        EXPECT_NEAR(values(Quantity::displacement)[k], std::hypot((l - 1) * X[0], (t - 1) * X[1], (t - 1) * X[2]),
                    1e-12);
    }
}

TEST(Quantity, EnergyIsRefusedForALawWithoutAnEnergyFunction) {
    auto model =
        block_case(mesh::CellType::hex27, model::Kinematics::solid, model::Formulation::displacement, {.n = 1});
    model.materials = {neo_hookean(1e5, 1e7)};
    model.materials[0].law = "kraken";
    const auto sampled = sample(model, linear(identity_tensor));
    EXPECT_THROW(static_cast<void>(
                     nodal_values(Quantity::energy, model, sampled.region_points, sampled.state(), sampled.fields)),
                 Error);
}

}  // namespace
}  // namespace soft::post
