#include "post/request.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/error.hpp"
#include "path_samples.hpp"

namespace soft::post {
namespace {

std::string usage_error(const std::string& text) {
    try {
        (void)parse_requests(text, make_curve(test::growth, test::sphere_path(5, 2)));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "";
}

TEST(ParseRequests, ParsesSeveralValuesEachWithItsUnit) {
    const auto requests = parse_requests("pressure=10kPa, 0.02 MPa", make_curve(test::growth, test::sphere_path(5, 2)));
    ASSERT_EQ(requests.size(), 2u);
    EXPECT_EQ(requests[0].quantity, "pressure");
    EXPECT_EQ(requests[0].value_SI, 1e4);
    EXPECT_EQ(requests[1].value_SI, 2e4);
}

TEST(ParseRequests, AcceptsUnitsOfOutputsAndVolumes) {
    const Curve curve = make_curve(test::growth, test::sphere_path(5, 2));
    EXPECT_EQ(parse_requests("growth=4cm", curve).at(0).value_SI, 0.04);
    EXPECT_EQ(parse_requests("volume=20mL", curve).at(0).value_SI, 2e-5);
}

TEST(ParseRequests, AcceptsAnglesAndPureNumbers) {
    model::Case model = test::sample_case({"bend"}, test::Loaded::nothing);
    model.outputs[0].measure = model::Measure::bend;
    const Curve curve = make_curve(model, test::sphere_path(5, 2));
    EXPECT_NEAR(parse_requests("bend=30deg", curve).at(0).value_SI, std::numbers::pi / 6, 1e-15);
    EXPECT_EQ(parse_requests("bend=0.25rad", curve).at(0).value_SI, 0.25);
    EXPECT_EQ(parse_requests("load_factor=0.5", curve).at(0).value_SI, 0.5);
    EXPECT_THROW((void)parse_requests("bend=3mm", curve), Error);
    const Curve rows = rows_at(curve, parse_requests("bend=30deg", curve));
    EXPECT_NEAR(rows.find("bend")->values.at(0), 30, 1e-13);
    EXPECT_NEAR(rows.find("load_factor")->values.at(0), test::sphere_pressure_Pa(1 + std::numbers::pi / 6), 1e-3);
}

TEST(ParseRequests, RejectsANumberWithoutUnitAndAWrongUnit) {
    EXPECT_TRUE(usage_error("pressure=10").starts_with("--at pressure: ")) << usage_error("pressure=10");
    EXPECT_NE(usage_error("pressure=10mm"), "");
    EXPECT_NE(usage_error("growth=1mm,"), "");
}

TEST(ParseRequests, RejectsInvalidRequests) {
    EXPECT_EQ(usage_error("pressure"), "--at: 'pressure' names no value; write e.g. pressure=10kPa,20kPa");
    EXPECT_EQ(usage_error("bend=3mm"), "--at: the curve has no 'bend'; it has pressure, growth, volume");
    EXPECT_NE(usage_error("stable=1"), "");  // a column, but not a coordinate of the path
}

TEST(RowsAt, FindsAPressureBeforeAndAfterTheMaximum) {
    const Curve curve = make_curve(test::growth, test::sphere_path(25, 3));
    const double asked_Pa = 0.755433;
    const std::vector<Request> requests{{"pressure", asked_Pa}};
    const Curve rows = rows_at(curve, requests);
    ASSERT_EQ(rows.row_count(), 2u);
    const auto& found = rows.find("growth")->values;
    EXPECT_NEAR(found[0], 500, 0.05);  // l_a = 1.5, verification.md
    EXPECT_GT(found[1], 828);          // beyond the limit point
    EXPECT_NEAR(test::sphere_pressure_Pa(1 + found[1] / 1e3), asked_Pa, 1e-5);
    EXPECT_EQ(rows.find("pressure")->values[0], asked_Pa / 1e3);
    EXPECT_EQ(rows.find("stable")->values, (std::vector<double>{1, 0}));
    EXPECT_LT(rows.find("step")->values[0], rows.find("step")->values[1]);
}

TEST(RowsAt, KeepsTheOrderOfTheRequests) {
    const Curve curve = make_curve(test::growth, test::sphere_path(15, 1.7));
    const std::vector<Request> requests{{"growth", 0.5}, {"growth", 0.25}, {"volume", test::ball_m3(1.25)}};
    const Curve rows = rows_at(curve, requests);
    ASSERT_EQ(rows.row_count(), 3u);
    const auto& pressures = rows.find("pressure")->values;
    EXPECT_NEAR(pressures[0] * 1e3, 0.755433, 2e-5);
    EXPECT_NEAR(pressures[1] * 1e3, 0.551869, 2e-5);
    EXPECT_NEAR(pressures[2] * 1e3, 0.551869, 2e-5);
}

TEST(RowsAt, FindsARowItselfOnceAndTheEndsOfThePath) {
    const Curve curve = make_curve(test::growth, test::sphere_path(5, 2));
    const std::vector<Request> requests{{"growth", 0.0}, {"growth", 0.5}, {"growth", 1.0}};
    const Curve rows = rows_at(curve, requests);
    EXPECT_EQ(rows.find("step")->values, (std::vector<double>{0, 2, 4}));
}

TEST(RowsAt, UsesTheEndOfAPathThatMissedItsGoalByTheTolerance) {
    const Curve curve = make_curve(test::growth, test::sphere_path(15, 1.5 - 1e-8));
    const Curve rows = rows_at(curve, std::vector<Request>{{"growth", 0.5}});
    ASSERT_EQ(rows.row_count(), 1u);
    EXPECT_EQ(rows.find("step")->values[0], 14);
    EXPECT_EQ(rows.find("growth")->values[0], curve.find("growth")->values.back());
    EXPECT_THROW((void)rows_at(curve, std::vector<Request>{{"growth", 0.50001}}), Error);
}

TEST(RowsAt, WorksWithoutSlopes) {
    const Curve curve = make_curve(test::growth, test::sphere_path(60, 3, test::Slopes::missing));
    const std::vector<Request> requests{{"growth", 0.5}};
    EXPECT_NEAR(rows_at(curve, requests).find("pressure")->values.at(0) * 1e3, 0.755433, 2e-4);
}

TEST(RowsAt, IgnoresARepeatedRow) {
    auto steps = test::sphere_path(15, 1.7);
    steps.insert(steps.begin() + 4, steps[4]);
    const std::vector<Request> requests{{"growth", 0.25}};
    const Curve rows = rows_at(make_curve(test::growth, steps), requests);
    ASSERT_EQ(rows.row_count(), 1u);
    EXPECT_NEAR(rows.find("pressure")->values[0] * 1e3, 0.551869, 2e-5);
}

TEST(RowsAt, RejectsAValueBeyondThePathAndReportsTheRange) {
    const Curve curve = make_curve(test::growth, test::sphere_path(15, 1.5));
    const std::vector<Request> requests{{"growth", 0.6}};
    try {
        (void)rows_at(curve, requests);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_STREQ(error.what(), "--at growth=600mm: the path does not reach it; it goes from 0 to 500 mm");
    }
}

TEST(RowsAt, RejectsAnUnknownQuantityAndListsTheKnownOnes) {
    const Curve curve = make_curve(test::growth, test::sphere_path(15, 1.5));
    const std::vector<Request> requests{{"elongation", 0.1}};
    try {
        (void)rows_at(curve, requests);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_STREQ(error.what(), "--at: the curve has no 'elongation'; it has pressure, growth, volume");
    }
}

TEST(RowsAt, RejectsAnEmptyPath) {
    const Curve curve = make_curve(test::growth, {});
    EXPECT_THROW((void)rows_at(curve, std::vector<Request>{{"growth", 0.0}}), Error);
}

}  // namespace
}  // namespace soft::post
