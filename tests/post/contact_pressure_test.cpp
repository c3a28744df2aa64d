#include "post/contact_pressure.hpp"

#include <gtest/gtest.h>

#include "fields_samples.hpp"

namespace soft::post {
namespace {

using namespace test;

model::Case with_table(model::Case model) {
    model.obstacles = {{"table", model::Plane{{-0.1, 0, 0}, {1, 0, 0}}}};
    model.materials = {neo_hookean(1e5, 1e7)};
    return model;
}

TEST(ContactPressure, ObstaclesMoveWithTheLevelsOfTheStages) {
    model::Case model;
    model.obstacles = {{"table", model::Plane{{}, {0, 0, 1}}}};
    model.motions = {{"table", {0, 0, 0.004}}};
    model.path.stages = {{.name = "close", .motions = {1}}, {.name = "open", .motions = {-1}}};
    std::vector<model::Step> steps(3);
    steps[0].load_factor = 0.5;
    steps[1].load_factor = 0.75;  // ends early, at 0.003
    steps[2].load_factor = 0.5;
    steps[2].stage = 1;
    EXPECT_NEAR(obstacle_shifts(model, steps, 0)[0][2], 0.002, 1e-15);
    EXPECT_NEAR(obstacle_shifts(model, steps, 2)[0][2], 0.003 - 0.5 * 0.007, 1e-15);
}

TEST(ContactPressure, ObstaclesMoveWithTheirTimeFunctions) {
    model::Case model;
    model.obstacles = {{"table", model::Plane{{}, {0, 0, 1}}}};
    model.motions = {{"table", {0, 0, 0.004}}};
    model.motions[0].time_function.time_s = 0.5;
    model.path.stages.emplace_back().motions = {2};
    model.dynamics = model::Dynamics{.duration_s = 1};
    std::vector<model::Step> steps(2);
    steps[0].motion = {.time_s = 0.25};
    steps[1].motion = {.time_s = 0.75};
    EXPECT_NEAR(obstacle_shifts(model, steps, 0)[0][2], 0.004, 1e-15);
    EXPECT_NEAR(obstacle_shifts(model, steps, 1)[0][2], 0.008, 1e-15);
}

/// The gap of a block that keeps its shape is uniform, and so is the pressure k |b'| on its face.
TEST(ContactPressure, IsTheBarriersOnTheFaceThatTouchesAndZeroElsewhere) {
    const auto model = with_table(
        block_case(mesh::CellType::hex27, model::Kinematics::solid, model::Formulation::displacement, {.n = 2}));
    const double h = model.contact.distance * 0.5, gap = 0.6 * h;  // facets of size 0.5
    const auto face = [&](double x_m, double table_m) {
        auto sampled = sample(model, [&](const Point& X) { return Point{X[0] + x_m, X[1], X[2]}; });
        NodalState state = sampled.state();
        state.shifts = {{table_m, 0, 0}};
        return contact_pressures_Pa(model, state);
    };
    const auto moved = face(-0.1 + gap, 0), pushed = face(0, 0.1 - gap), apart = face(0, 0);
    double largest = 0;
    for (const double p : moved) largest = std::max(largest, p);
    EXPECT_GT(largest, 0);
    for (std::size_t n = 0; n < moved.size(); ++n) {
        const double x = model.mesh.points[n][0];
        if (x < 1e-12 || x > 0.5) {  // not at the sides
            EXPECT_NEAR(moved[n], x < 0.5 ? largest : 0, 1e-9 * largest);
        }
        EXPECT_NEAR(pushed[n], moved[n], 1e-9 * largest);
        EXPECT_EQ(apart[n], 0);
    }
    EXPECT_FALSE(has_contact([] {
        model::Case alone;
        alone.path.contact = model::Contact::stop;
        return alone;
    }()));
}

}  // namespace
}  // namespace soft::post
