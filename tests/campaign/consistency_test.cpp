#include "consistency.hpp"

#include <gtest/gtest.h>

namespace soft::campaign {
namespace {

/// Inconsistency of three rows, plus `more` copies of the last, in which the loads do the work `work_J` and the rubber stores 1 J.
std::string wrong_with(double stretch, double work_J, int more = 0, model::StopReason end = model::StopReason::done) {
    model::Case model;
    model.path.stages.resize(1);
    std::vector<model::Step> rows;
    for (const double share : {0.0, 0.5, 1.0}) {
        model::Step step;
        step.load_factor = share;
        step.max_stretch = 1 + share * (stretch - 1);
        step.energies = {.stored_J = share * share, .load_work_J = share * share * work_J, .tangent_J = {}};
        rows.push_back(step);
    }
    rows.insert(rows.end(), static_cast<std::size_t>(more), model::Step{rows.back()});
    return inconsistency(model, rows, end);
}

TEST(Consistency, DetectsAnEnergyImbalance) {
    EXPECT_EQ(wrong_with(2, 1.009), "");
    EXPECT_EQ(wrong_with(2, 1.02), "the energies differ by 1.961 %");
    EXPECT_EQ(wrong_with(2, -1), "the energies differ by 200 %");
}

TEST(Consistency, DetectsLinearResponsesWithTooManyRows) {
    EXPECT_EQ(wrong_with(1 + 1e-9, 1), "");
    EXPECT_EQ(wrong_with(1 + 1e-9, 1, 20), "a linear response needs 23 rows");
    EXPECT_EQ(wrong_with(1 + 1e-9, 1, 0, model::StopReason::step_limit), "a linear response ends as step_limit");
}

}  // namespace
}  // namespace soft::campaign
