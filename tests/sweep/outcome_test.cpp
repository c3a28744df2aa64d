#include "sweep/outcome.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "../post/path_samples.hpp"

namespace {

using namespace soft;
using namespace soft::sweep;

/// Rows at inner stretches 1, 1.05 ... 2 of the thick sphere; output "growth" in mm.
post::Curve sphere() { return post::make_curve(post::test::sample_case({"growth"}), post::test::sphere_path(21, 2.0)); }

Sweep asking(const std::string& rest) { return read_sweep("design: d\nvary: {a.b: [1]}\n" + rest, "s.yaml"); }

double value(const std::vector<Cell>& cells, const std::string& column) {
    for (const Cell& cell : cells)
        if (cell.column == column) return cell.value.value_or(-1);
    ADD_FAILURE() << "no column " << column;
    return 0;
}

TEST(OutputsOf, AreTheCurveWhereItIsAsked) {
    const auto cells =
        outputs_of(asking("at: [growth=500mm, end]\noutputs: [pressure_kPa, growth_mm]\n"), sphere(), {});
    ASSERT_EQ(cells.size(), 4u);
    // between rows the curve is a cubic: 1e-5 of the closed form
    EXPECT_NEAR(value(cells, "pressure_kPa@growth=500mm") * 1000, post::test::sphere_pressure_Pa(1.5), 1e-5);
    EXPECT_NEAR(value(cells, "growth_mm@growth=500mm"), 500, 1e-6);
    EXPECT_DOUBLE_EQ(value(cells, "pressure_kPa@end") * 1000, post::test::sphere_pressure_Pa(2.0));
}

TEST(OutputsOf, OfALimitPointIsItsRow) {
    const std::vector<solution::LimitPoint> limits{{16, 0, std::nullopt, {}}};  // stretch 1.8
    const auto cells = outputs_of(asking("at: limit\noutputs: growth_mm\n"), sphere(), limits);
    EXPECT_NEAR(value(cells, "growth_mm@limit"), 800, 1e-9);
}

TEST(OutputsOf, WhereThePathDoesNotComeThereIsNoValue) {
    const auto cells = outputs_of(asking("at: [growth=5m, limit]\noutputs: pressure_kPa\n"), sphere(), {});
    ASSERT_EQ(cells.size(), 2u);
    EXPECT_FALSE(cells[0].value);
    EXPECT_FALSE(cells[1].value);
}

TEST(OutputsOf, WithoutNamesAllColumnsButTheStepAndWhatIsAskedFor) {
    const auto cells = outputs_of(asking("at: growth=500mm\n"), sphere(), {});
    EXPECT_EQ(cells.size(), sphere().columns.size() - 2);
    for (const Cell& cell : cells)
        EXPECT_TRUE(cell.column != "step@growth=500mm" && cell.column != "growth_mm@growth=500mm");
}

TEST(OutputsOf, RefusesAQuantityThatTheCurveCannotHaveAtItsPlace) {
    try {
        static_cast<void>(outputs_of(asking("at: [end, grwth=5mm]\n"), sphere(), {}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_EQ(std::string{error.what()}.substr(0, 16), "s.yaml:3:11: at:");
    }
}

TEST(ReadStatus, TakesExitCodeAndErrorAmongOtherLines) {
    const auto status = read_status("solve_s 0.1 0.2 0.3\nexit_code 65\nerror mesh-gen: a: b; c, \"d\"\n");
    ASSERT_TRUE(status);
    EXPECT_EQ(status->exit_code, 65);
    EXPECT_EQ(status->error, "mesh-gen: a: b; c, \"d\"");
}

TEST(ReadStatus, OfAFileThatIsNotWholeIsNone) {
    EXPECT_FALSE(read_status(""));
    EXPECT_FALSE(read_status("solve_s 0.1 0.2 0.3\n"));
    EXPECT_FALSE(read_status("exit_code \n"));
    EXPECT_FALSE(read_status("exit_code x\n"));
}

TEST(IsFinal, HoldsForWhatTheProgramsSayThemselvesAndNotForKillsAndDisks) {
    for (const int code : {0, 1, 2, 64, 65, 70}) EXPECT_TRUE(is_final(code)) << code;
    for (const int code : {66, 73, 74, 124, 126, 127, 137, 139}) EXPECT_FALSE(is_final(code)) << code;
}

}  // namespace
