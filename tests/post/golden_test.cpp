#include "post/golden.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/text.hpp"
#include "path_samples.hpp"
#include "post/csv.hpp"

namespace soft::post {
namespace {

/// Rows of the closed form at evenly spaced stretches, in the format of postprocess.
std::string exact_table(int rows, double last_stretch) {
    std::string text = "step,pressure_kPa,growth_mm,volume_mL,stable\n";
    for (int row = 0; row < rows; ++row) {
        const double stretch = 1 + (last_stretch - 1) * row / (rows - 1);
        text += std::to_string(row) + "," + core::number_text(test::sphere_pressure_Pa(stretch) / 1e3) + "," +
                core::number_text((stretch - 1) * 1e3) + "," + core::number_text(test::ball_m3(stretch) * 1e6) + "," +
                (stretch < 1.8281 ? "1" : "0") + "\n";
    }
    return text;
}

Verdict verdict_on(const std::string& golden, const Tolerance& tolerance = {}, int rows = 40, double last = 3) {
    return check_golden(make_curve(test::growth, test::sphere_path(rows, last)), core::read_table(golden, "golden.csv"),
                        tolerance);
}

std::string failure(const std::string& golden, const Tolerance& tolerance = {}, int rows = 40, double last = 3) {
    return failure_text(verdict_on(golden, tolerance, rows, last), core::read_table(golden, "golden.csv"));
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
    const auto at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), by);
}

TEST(Golden, AcceptsOtherStepsOnTheSameCurve) {
    for (const int rows : {25, 40, 77}) {
        const Verdict verdict = verdict_on(exact_table(31, 3), {}, rows);
        EXPECT_TRUE(verdict.agrees()) << rows << failure(exact_table(31, 3), {}, rows);
        EXPECT_EQ(verdict.rows, 31u);
        EXPECT_EQ(verdict.leader, "growth_mm");
        EXPECT_NEAR(verdict.covered, 1, 1e-9);
    }
}

TEST(Golden, ReportsTheCoveredFractionOfThePath) {
    EXPECT_TRUE(verdict_on(exact_table(31, 1.5)).agrees());
    const double half_way = verdict_on(exact_table(31, 1.5)).covered;
    EXPECT_GT(half_way, 0.1);
    EXPECT_LT(half_way, 0.9);
    EXPECT_LT(verdict_on(exact_table(31, 1.2)).covered, half_way);
}

TEST(Golden, SameRowsAgreeToRoundingInEveryColumn) {
    const Curve curve = make_curve(test::growth, test::sphere_path(20, 3));
    const core::Table golden = core::read_table(csv_text(curve), "golden.csv");
    const Verdict verdict = check_golden(curve, golden, {1e-12, {}});
    EXPECT_TRUE(verdict.agrees()) << failure_text(verdict, golden);
    EXPECT_EQ(verdict.columns.size(), curve.columns.size() - 1) << "all columns except step";
}

TEST(Golden, ReportsTheFirstDifferingRowWithColumnValuesAndDifference) {
    // p(1.5) = 0.755433 mu (verification.md), here with mu = 1 Pa. The stretch 1.5 is row 5 of 0..20 up to 3 (0.75543312 by the formula)
    // and row 10 of the path.
    std::string golden = exact_table(21, 3);
    const std::string right = core::number_text(test::sphere_pressure_Pa(1.5) / 1e3);
    golden = replaced(golden, "5," + right + ",500,", "5,0.00077,500,");
    EXPECT_EQ(failure(golden, {}, 41),
              "golden.csv:7: pressure_kPa is 0.0007554331 where growth_mm is 500, golden 0.00077: 1.46e-05 apart, "
              "allowed 7.7e-07; 1 of 21 rows differs");
    EXPECT_FALSE(verdict_on(golden).agrees());
    EXPECT_TRUE(verdict_on(golden, {0.02, {}}).agrees());
    EXPECT_TRUE(verdict_on(golden, {1e-3, {{"pressure", 1.5e-5}}}).agrees());
    EXPECT_FALSE(verdict_on(golden, {1e-3, {{"growth", 1.5e-5}}}).agrees());
}

TEST(Golden, ReportsWhereThePathEndsEarly) {
    EXPECT_EQ(failure(exact_table(21, 3), {}, 40, 2),
              "golden.csv:13: the path does not reach growth_mm 1100; it ends at 1000; 10 of 21 rows differ");
    EXPECT_TRUE(verdict_on(exact_table(21, 3), {}, 40, 2.9995).agrees());  // 2000 mm within the relative tolerance 1e-3
}

TEST(Golden, ReportsAColumnMissingInTheResult) {
    const std::string golden = "step,pressure_kPa,growth_mm,bend_deg\n0,0,0,0\n";
    const Verdict verdict = verdict_on(golden);
    EXPECT_FALSE(verdict.agrees());
    EXPECT_EQ(failure_text(verdict, core::read_table(golden, "golden.csv")),
              "golden.csv: the result has no column 'bend_deg'");
}

TEST(Golden, ComparesStabilityWithTheRowsOnBothSides) {
    const std::string golden = exact_table(31, 3);
    EXPECT_EQ(failure(replaced(golden, ",1\n1,", ",0\n1,")).substr(0, 31), "golden.csv:2: stable is 1 where");
    // between the last stable and the first unstable row of the path both values are accepted
    const std::string between = "growth_mm,stable\n825,1\n826,0\n";
    EXPECT_TRUE(verdict_on(between, {}, 9).agrees());
}

TEST(Golden, RejectsATableThatChecksNothing) {
    const Curve curve = make_curve(test::growth, test::sphere_path(20, 3));
    EXPECT_THROW((void)check_golden(curve, core::read_table("growth_mm\n0\n100\n", "g.csv"), {}), Error);
    EXPECT_THROW((void)check_golden(curve, core::read_table("step,growth_mm\n0,0\n1,100\n", "g.csv"), {}), Error);
    EXPECT_THROW((void)parse_allowance("-5", curve), Error);
    EXPECT_THROW((void)parse_allowance("pressure=-5Pa", curve), Error);
}

TEST(Golden, FollowsALoadingAndUnloadingPathInItsOrder) {
    // the pressure rises and falls along two different curves; the first output reverses with it
    auto steps = test::sphere_path(9, 1.8);
    const auto up = steps;
    for (std::size_t i = up.size() - 1; i-- > 0;) {
        steps.push_back(up[i]);
        steps.back().pressure_Pa *= 0.9;
        steps.back().tangent_outputs = {0};
        steps.back().tangent_pressure = steps.back().tangent_volume = 0;
    }
    const Curve curve = make_curve(test::growth, steps);
    core::Table golden = core::read_table(csv_text(curve), "golden.csv");
    EXPECT_TRUE(check_golden(curve, golden, {1e-9, {}}).agrees());
    golden.rows[12][1] = golden.rows[4][1];  // a row of the unloading path with the pressure of the loading path
    const Verdict verdict = check_golden(curve, golden, {1e-3, {}});
    EXPECT_EQ(verdict.differing_rows, 1u) << failure_text(verdict, golden);
    EXPECT_EQ(verdict.columns[0].first->row, 12u);
}

TEST(Golden, FindsAStageInWhichTheStateDoesNotChange) {
    auto steps = test::sphere_path(6, 1.5);
    steps.push_back(steps.back());
    steps.back().stage = 1;
    for (std::size_t i = 5; i-- > 0;) {
        steps.push_back(steps[i]);
        steps.back().stage = 2;
        steps.back().tangent_outputs = {0};
        steps.back().tangent_pressure = steps.back().tangent_volume = 0;
    }
    model::Case model = test::growth;
    model.path.stages.resize(3);
    const Curve curve = make_curve(model, steps);
    core::Table golden = core::read_table(csv_text(curve), "golden.csv");
    EXPECT_TRUE(check_golden(curve, golden, {1e-12, {}}).agrees())
        << failure_text(check_golden(curve, golden, {1e-12, {}}), golden);
    golden.rows[3][1] = "2";  // wrong "stage" in the middle of the first stage
    EXPECT_EQ(check_golden(curve, golden, {1e-12, {}}).differing_rows, 1u);
}

TEST(Golden, TellsRowsWithEqualCoordinatesApartByTheOtherQuantities) {
    auto steps =
        test::sphere_path(6, 1.5);  // then it slides steadily: friction works, and the coordinates change by rounding
    for (const double rounding : {1e-14, -2e-14, 1e-14}) {
        steps.push_back(steps.back());
        steps.back().pressure_Pa *= 1 + rounding;
        steps.back().outputs[0] *= 1 + rounding;
        steps.back().stretch_p99 += 0.1;
    }
    const Curve curve = make_curve(test::growth, steps);
    core::Table golden = core::read_table(csv_text(curve), "golden.csv");
    EXPECT_TRUE(check_golden(curve, golden, {1e-9, {}}).agrees())
        << failure_text(check_golden(curve, golden, {1e-9, {}}), golden);
    for (auto& row : golden.rows)
        if (&row == &golden.rows.back())
            for (std::size_t k = 0; k < row.size(); ++k)
                if (golden.headings[k].name == "stretch_p99") row[k] = "3";
    EXPECT_EQ(check_golden(curve, golden, {1e-3, {}}).differing_rows, 1u);
}

/// Two chambers: the first pressure rises, then it is held while the second one rises.
TEST(Golden, FindsRowsOfAStageThatHoldsTheLeaderByWhatMoves) {
    const auto curve_of = [](int rows) {
        Curve curve;
        for (const char* name : {"left_kPa", "right_kPa", "volume_mL", "stage"}) {
            Column column{.name = name, .quantity = name, .unit = ""};
            column.role = column.name == "stage" ? Role::stage : Role::coordinate;
            for (int row = 0; row <= 2 * rows; ++row) {
                const double left = std::min(1.0, static_cast<double>(row) / rows) * 20,
                             right = std::max(0.0, static_cast<double>(row) / rows - 1) * 10;
                column.values.push_back(column.name == "left_kPa"    ? left
                                        : column.name == "right_kPa" ? right
                                        : column.name == "volume_mL" ? 30 - 0.1 * left + 0.2 * right
                                                                     : (row > rows ? 2 : 1));
            }
            curve.columns.push_back(std::move(column));
        }
        return curve;
    };
    const core::Table golden = core::read_table(csv_text(curve_of(8)), "golden.csv");
    for (const int rows : {8, 5, 13}) EXPECT_TRUE(check_golden(curve_of(rows), golden, {}).agrees()) << rows;
    core::Table wrong = golden;
    wrong.rows[12][2] = "29.5";  // was 29
    const Verdict verdict = check_golden(curve_of(13), wrong, {});
    EXPECT_EQ(verdict.differing_rows, 1u);
}

TEST(Golden, RejectsInvalidTables) {
    EXPECT_THROW((void)verdict_on("1,2\n3,4\n"), Error);
    EXPECT_THROW((void)verdict_on("step,stable\n0,1\n"), Error);
    EXPECT_THROW((void)verdict_on("pressure_kPa,growth_mm\n0,x\n"), Error);
}

TEST(Allowance, IsParsedInUnitsOfTheColumn) {
    const Curve curve = make_curve(test::growth, test::sphere_path(9, 3));
    EXPECT_EQ(parse_allowance("pressure=5Pa", curve).value, 0.005);
    EXPECT_EQ(parse_allowance("growth = 1 um", curve).value, 0.001);
    EXPECT_EQ(parse_allowance("min_J=1e-4", curve).value, 1e-4);
    EXPECT_EQ(parse_allowance("1e-9", curve).quantity, "");
    EXPECT_THROW((void)parse_allowance("pressure=5", curve), Error);
    EXPECT_THROW((void)parse_allowance("presure=5Pa", curve), Error);
}

}  // namespace
}  // namespace soft::post
