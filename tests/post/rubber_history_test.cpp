// Stress of inelastic rubber at the rows of a result, from uniform states of a block.
#include "post/rubber_history.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../fem/sample_cases.hpp"
#include "core/error.hpp"
#include "material/response.hpp"
#include "model/rubber.hpp"
#include "post/quantity.hpp"
#include "post/step_fields.hpp"

namespace soft::post {
namespace {

constexpr double stretches[] = {1, 1.3, 1.6, 1.2, 1.4};

/// A viscoelastic, softening block at these stretches, one second apart.
struct Block {
    model::Case model = box_case(1, true);
    std::vector<model::Step> steps;

    Block() {
        model.materials[0].inelastic = {{0.5}, {1.0}, false, material::Softening{2, 5e3, 0.1}};
        model.path.stages = {{.name = "all"}};
        model.path.stages[0].time_s = 4;
        for (int row = 0; row < 5; ++row) steps.emplace_back().time_s = row;
    }
    [[nodiscard]] std::vector<double> displacement(double l) const {
        std::vector<double> u;
        for (const auto& X : model.mesh.points)
            for (std::size_t i = 0; i < 3; ++i) u.push_back(((i == 0 ? l : 1 / std::sqrt(l)) - 1) * X[i]);
        return u;
    }
    [[nodiscard]] RubberHistory history(std::vector<int> inside_steps = {}, int missing = -1) const {
        return {model, steps, std::move(inside_steps),
                [this, missing](std::int64_t row) {
                    return row == missing ? std::nullopt
                                          : std::optional(displacement(stretches[static_cast<std::size_t>(row)]));
                },
                missing < 0};
    }
};

/// The same by steps of one point.
material::PointStep expected(const model::Case& model, const std::vector<int>& rows) {
    const auto rubber = model::make_rubber(model.materials[0]);
    std::vector<double> history(material::history_size(*material::inelastic_of(rubber)), 0.0), next = history;
    material::PointStep step;
    int before = 0;
    for (const int row : rows) {
        const double l = stretches[static_cast<std::size_t>(row)], t = 1 / std::sqrt(l);
        step = material::advance(rubber, material::step_coefficients(*material::inelastic_of(rubber), row - before), {},
                                 {l, 0, 0, 0, t, 0, 0, 0, t}, history, next);
        history = next;
        before = row;
    }
    return step;
}

TEST(RubberHistory, RowsAreTheStepsOfEveryPoint) {
    const Block block;
    RubberHistory history = block.history();
    for (const int row : {4, 2, 3}) {  // in any order
        const auto found = history.at(row, block.displacement(stretches[static_cast<std::size_t>(row)]));
        ASSERT_EQ(found.size(), 27U);
        std::vector<int> rows;
        for (int k = 1; k <= row; ++k) rows.push_back(k);
        const double scale = std::abs(expected(block.model, rows).stress[0]);
        for (const auto& point : found)
            for (std::size_t c = 0; c < 6; ++c)
                EXPECT_NEAR(point.stress[c], expected(block.model, rows).stress[c], 1e-9 * scale) << row;
    }
}

TEST(RubberHistory, LocatedRowsAreNoSteps) {
    const Block block;
    const auto found = block.history({2}).at(3, block.displacement(stretches[3]));
    EXPECT_NEAR(found[0].stress[0], expected(block.model, {1, 3}).stress[0], 1e-6);
}

TEST(RubberHistory, FieldsShowTheStressOfTheHistory) {
    const Block block;
    const auto u = block.displacement(stretches[3]);
    const std::vector<double> no_pressure(block.model.mesh.points.size(), 0.0);
    const auto regions = make_region_points(block.model.mesh);
    RubberHistory history = block.history();
    const auto fields = step_fields(block.model, regions, {u, no_pressure, {}, history.at(3, u)});
    const double l = stretches[3], S = expected(block.model, {1, 2, 3}).stress[0];
    EXPECT_NEAR(fields.cells[0].cauchy_Pa[0], l * l * S, 1e-6 * std::abs(S));  // sigma = F S F^T at J = 1
    EXPECT_TRUE(fields.stress_is_known);
    const auto without = step_fields(block.model, regions, {u, no_pressure});
    EXPECT_FALSE(without.stress_is_known);
    const NodalState state{u, no_pressure};
    EXPECT_THROW(static_cast<void>(nodal_values(Quantity::von_mises, block.model, regions, state, without)), Error);
    EXPECT_FALSE(nodal_values(Quantity::stretch, block.model, regions, state, without).empty());
}

TEST(RubberHistory, AMissingRowIsNamed) {
    const Block block;
    EXPECT_TRUE(block.history({}, 2).at_if_known(4, block.displacement(stretches[4]), 4).empty());
    try {
        static_cast<void>(block.history({}, 2).at(4, block.displacement(stretches[4])));
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("row 2"), std::string::npos);
    }
}

}  // namespace
}  // namespace soft::post
