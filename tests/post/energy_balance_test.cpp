#include "post/energy_balance.hpp"

#include <gtest/gtest.h>

namespace soft::post {
namespace {

model::Step at_rest(double work_J, double stored_J) {
    model::Step step;
    step.max_stretch = 1.5;
    step.energies = {.stored_J = stored_J, .load_work_J = work_J, .tangent_J = {}};
    return step;
}

model::Step moving(double kinetic_J, double stored_J, double work_J, double damping_J) {
    model::Step step;
    step.motion = {0.0, kinetic_J, stored_J, work_J, damping_J};
    return step;
}

EnergyBalance balance_of(std::initializer_list<model::Step> rows) {
    EnergyBalance balance;
    for (const auto& row : rows) balance.add(row);
    return balance;
}

TEST(EnergyBalance, TheErrorIsTheLargestDifferenceOverTheLargestEnergy) {
    const auto balance = balance_of({at_rest(0, 0), at_rest(1, 1.3), at_rest(10, 10), at_rest(2, 2)});
    EXPECT_NEAR(*balance.error(), 0.03, 1e-15);
    EXPECT_NE(balance.problem().find("at row 1 the loads have done 1000 mJ of work, the rubber stores 1300 mJ"),
              std::string::npos)
        << balance.problem();
}

TEST(EnergyBalance, LeavesOutStrainsNextToRounding) {
    auto row = at_rest(1, 1.3);
    row.max_stretch = 1 + 1e-12;
    EXPECT_EQ(balance_of({at_rest(0, 0), row}).problem(), "");
    row.max_stretch = 1 - 1e-8;
    EXPECT_NE(balance_of({at_rest(0, 0), row}).problem(), "");
}

TEST(EnergyBalance, OfAMotionIncludesKineticEnergyAndDissipation) {
    EXPECT_NEAR(*balance_of({moving(0, 0, 0, 0), moving(2, 5, 10, 3)}).error(), 0, 1e-15);
    const auto losing = balance_of({moving(0, 0, 0, 0), moving(2, 5, 10, 0)});
    EXPECT_NEAR(*losing.error(), 0.3, 1e-15);
    EXPECT_NE(losing.problem().find("dynamics.accuracy"), std::string::npos) << losing.problem();
}

TEST(EnergyBalance, IsRelativeToTheFirstRow) {
    EXPECT_NEAR(*balance_of({at_rest(0, 5), at_rest(1, 6)}).error(), 0, 1e-15);
}

TEST(EnergyBalance, ErrorsAboveOnePercentAreReported) {
    EXPECT_EQ(balance_of({at_rest(0, 0), at_rest(1, 0.991)}).problem(), "");
    EXPECT_NE(balance_of({at_rest(0, 0), at_rest(1, 0.989)}).problem(), "");
    EXPECT_EQ(balance_of({at_rest(0, 0)}).problem(), "");
    EXPECT_EQ(balance_of({model::Step{}, model::Step{}}).problem(), "") << "a law without an energy function";
}

}  // namespace
}  // namespace soft::post
