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

TEST(OutputsOf, AreTheValuesOfTheCurveAtTheRequestedPoints) {
    const auto cells =
        outputs_of(asking("at: [growth=500mm, end]\noutputs: [pressure_kPa, growth_mm]\n"), sphere(), {}).cells;
    ASSERT_EQ(cells.size(), 4u);
    // between rows the curve is a cubic: 1e-5 of the closed form
    EXPECT_NEAR(value(cells, "pressure_kPa_at_growth_500mm") * 1000, post::test::sphere_pressure_Pa(1.5), 1e-5);
    EXPECT_NEAR(value(cells, "growth_mm_at_growth_500mm"), 500, 1e-6);
    EXPECT_DOUBLE_EQ(value(cells, "pressure_kPa_at_end") * 1000, post::test::sphere_pressure_Pa(2.0));
}

TEST(OutputsOf, AtALimitPointAreThoseOfItsRow) {
    const std::vector<model::LimitPoint> limits{{16, 0, std::nullopt, {}}};  // stretch 1.8
    const auto cells = outputs_of(asking("at: limit\noutputs: growth_mm\n"), sphere(), limits).cells;
    EXPECT_NEAR(value(cells, "growth_mm_at_limit"), 800, 1e-9);
}

TEST(OutputsOf, AtAPointThatThePathDoesNotReachAreMissingWithAReason) {
    const auto [cells, missing] =
        outputs_of(asking("at: [growth=5m, limit, end]\noutputs: pressure_kPa\n"), sphere(), {});
    ASSERT_EQ(cells.size(), 3u);
    EXPECT_FALSE(cells[0].value);
    EXPECT_FALSE(cells[1].value);
    EXPECT_TRUE(cells[2].value);
    EXPECT_EQ(missing,
              (std::vector<std::string>{"at growth=5000mm: the path does not reach it; it goes from 0 to 1000 mm",
                                        "at limit: the path has no limit point"}));
}

TEST(ColumnAt, ContainsOnlyLettersDigitsAndUnderscores) {
    const post::Curve curve = sphere();  // its load is a pressure
    EXPECT_EQ(column_at("elongation_mm", "pressure=20kPa", curve), "elongation_mm_at_20kPa");
    EXPECT_EQ(column_at("elongation_mm", "pressure=20 kPa", curve), "elongation_mm_at_20kPa");
    EXPECT_EQ(column_at("pressure_kPa", "growth=-2.5mm", curve), "pressure_kPa_at_growth_minus2p5mm");
    EXPECT_EQ(column_at("pressure_kPa", "ratio=50%", curve), "pressure_kPa_at_ratio_50percent");
    EXPECT_EQ(column_at("pressure_kPa", "bend=3 1/m", curve), "pressure_kPa_at_bend_3_1_per_m");
    EXPECT_EQ(column_at("pressure_kPa", "limit", curve), "pressure_kPa_at_limit");
}

TEST(CheckRequests, RejectsRequestsThatNoCurveOfTheCaseHasBeforeASolve) {
    const post::Curve curve = unsolved_curve(post::test::sample_case({"growth"}));
    const auto refusal = [&](const std::string& rest) -> std::string {
        try {
            check_requests(asking(rest), curve);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal("at: [growth=5mm, volume=2mL, pressure=3kPa, limit, end]\noutputs: [volume_mL, load_work_mJ]\n"),
              "");
    EXPECT_EQ(refusal("at: [end, grwth=5mm]\n").substr(0, 16), "s.yaml:3:11: at:");
    EXPECT_NE(refusal("at: growth=5kPa\n").find("'5kPa' is a pressure"), std::string::npos);
    EXPECT_NE(refusal("at: growth=5\n").find("has no unit"), std::string::npos);
    EXPECT_EQ(refusal("outputs: [growth_m]\n"),
              "s.yaml:3:11: outputs: no curve has a column 'growth_m'; did you mean 'growth_mm'?");
}

TEST(OutputsOf, WithoutNamesAreAllColumnsExceptTheStepAndTheRequestedQuantity) {
    const auto cells = outputs_of(asking("at: growth=500mm\n"), sphere(), {}).cells;
    EXPECT_EQ(cells.size(), sphere().columns.size() - 2);
    for (const Cell& cell : cells)
        EXPECT_TRUE(cell.column != "step_at_growth_500mm" && cell.column != "growth_mm_at_growth_500mm");
}

TEST(OutputsOf, RejectsAQuantityThatTheCurveDoesNotHaveAtItsLocation) {
    try {
        static_cast<void>(outputs_of(asking("at: [end, grwth=5mm]\n"), sphere(), {}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_EQ(std::string{error.what()}.substr(0, 16), "s.yaml:3:11: at:");
    }
}

TEST(ReadStatus, ReadsExitCodeAndErrorAmongOtherLines) {
    const auto status = read_status("solve_s 0.1 0.2 0.3\nexit_code 65\nerror mesh-gen: a: b; c, \"d\"\n");
    ASSERT_TRUE(status);
    EXPECT_EQ(status->exit_code, 65);
    EXPECT_EQ(status->error, "mesh-gen: a: b; c, \"d\"");
}

TEST(ReadStatus, OfAnIncompleteFileIsNullopt) {
    EXPECT_FALSE(read_status(""));
    EXPECT_FALSE(read_status("solve_s 0.1 0.2 0.3\n"));
    EXPECT_FALSE(read_status("exit_code \n"));
    EXPECT_FALSE(read_status("exit_code x\n"));
}

TEST(IsFinal, IsTrueForResultsOfTheProgramsAndFalseForKillsAndDiskErrors) {
    for (const int code : {0, 1, 2, 64, 65, 70}) EXPECT_TRUE(is_final(code)) << code;
    for (const int code : {66, 73, 74, 124, 126, 127, 137, 139}) EXPECT_FALSE(is_final(code)) << code;
}

}  // namespace
