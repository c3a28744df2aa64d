#include "sweep/results.hpp"

#include <gtest/gtest.h>

namespace {

using namespace soft;
using namespace soft::sweep;

const Sweep sweep = read_sweep(
    "design: d\nvary: {geometry.wall: [2 mm, 3 mm], material.law: [yeoh]}\noutputs: [pressure_kPa]\n", "s.yaml");
const Plan plan{{{"aa", {"2 mm", "yeoh"}, "x", ""}, {"bb", {"3mm", "yeoh"}, "", "s.yaml:2:3: a, \"b\"; c"}}};

Outcome done(const std::string& column) {
    return {.exit_code = 0,
            .stop_reason = "done",
            .error = "",
            .columns = {"step", "pressure_kPa"},
            .outputs = {{column, 0.1}}};
}

TEST(PlanCsv, HasOneRowPerDesignWithItsStateAndSettings) {
    EXPECT_EQ(plan_csv(sweep, plan, std::vector<State>{State::done, State::refused}),
              "id,state,geometry_wall_mm,material_law,settings,refusal\n"
              "aa,done,2,yeoh,--set 'geometry.wall=2 mm' --set material.law=yeoh,\n"
              "bb,refused,3,yeoh,--set geometry.wall=3mm --set material.law=yeoh,\"s.yaml:2:3: a, \"\"b\"\"; c\"\n");
}

TEST(WaitingIds, AreListedWithoutDuplicates) {
    const Plan several{{{"aa", {"2 mm", "yeoh"}, "x", ""},
                        {"bb", {"3 mm", "yeoh"}, "", "refused"},
                        {"aa", {"2.0 mm", "yeoh"}, "x", ""},
                        {"cc", {"4 mm", "yeoh"}, "x", ""}}};
    EXPECT_EQ(waiting_ids(several, std::vector<State>{State::waiting, State::refused, State::waiting, State::waiting}),
              (std::vector<std::string>{"aa", "cc"}));
}

TEST(ResultsCsv, FailedDesignsAreRowsWithTheirReason) {
    const std::vector<Outcome> outcomes{done("pressure_kPa_at_end"),
                                        {.exit_code = 65, .stop_reason = "refused", .error = "a, b"}};
    EXPECT_EQ(results_csv(sweep, plan, outcomes),
              "id,geometry_wall_mm,material_law,pressure_kPa_at_end,stop_reason,exit_code,error\n"
              "aa,2,yeoh,0.1,done,0,\n"
              "bb,3,yeoh,,refused,65,\"a, b\"\n");
}

TEST(ResultsCsv, DesignThatIsNotComputedHasNoExitCode) {
    const std::vector<Outcome> outcomes{done("pressure_kPa_at_end"), {.stop_reason = "not_computed"}};
    EXPECT_NE(results_csv(sweep, plan, outcomes).find("\nbb,3,yeoh,,not_computed,,\n"), std::string::npos);
}

TEST(ResultsCsv, ValuesOfDifferentUnitsAreKeptAsWritten) {
    const Plan mixed{{{"aa", {"2 mm", "yeoh"}, "x", ""}, {"bb", {"0.3 cm", "yeoh"}, "x", ""}}};
    const std::string text = plan_csv(sweep, mixed, std::vector<State>(2));
    EXPECT_EQ(text.substr(0, text.find('\n')), "id,state,geometry_wall,material_law,settings,refusal");
    EXPECT_NE(text.find("aa,waiting,2 mm,"), std::string::npos);
}

TEST(ResultsCsv, RejectsAnOutputThatNoCurveHas) {
    const Sweep slip = read_sweep(
        "design: d\nvary: {geometry.wall: [2 mm, 3 mm], material.law: [yeoh]}\noutputs: [presure_kPa]\n", "s.yaml");
    try {
        static_cast<void>(results_csv(slip, plan, std::vector<Outcome>{done("x"), done("x")}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "s.yaml:3:11: outputs: no curve has a column 'presure_kPa'; did you mean 'pressure_kPa'?");
    }
}

}  // namespace
