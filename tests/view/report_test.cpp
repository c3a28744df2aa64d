#include "view/report.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "stretched_bar.hpp"
#include "view/text.hpp"
#include "view/viewer_bundle.hpp"

namespace soft::view {
namespace {

const std::string trap = "</pre></script><script>alert(1)</script>' onerror=\"alert(2)\"";

class Report : public ::testing::Test {
protected:
    void SetUp() override {
        if (!viewer_bundle().missing.empty()) GTEST_SKIP() << "built without npm";
    }
};

std::string page_of(const io::Result& result) {
    const post::Curve curve = post::make_curve(result.model, result.steps);
    const std::vector<post::PlotSeries> series = {{trap, curve, {}}, {"other " + trap, curve, {}}};
    return make_report({.result = result,
                        .curve = curve,
                        .series = series,
                        .plot = {.title = trap},
                        .made_by = trap,
                        .material_notes = {"fitted over 4:109 % " + trap}});
}

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++n;
    return n;
}

TEST_F(Report, TextOfTheDesignIsNeverExecuted) {
    io::Result result = test::bar_result(3, trap);
    result.model.name = trap;
    const std::string page = page_of(result);
    EXPECT_EQ(count(page, "<script"), 2u);  // the scene and the viewer
    EXPECT_EQ(count(page, "</script"), 2u);
    EXPECT_EQ(count(page, "alert(1)"), count(page, "&lt;script&gt;alert(1)"));
    EXPECT_EQ(count(page, "\"alert(2)"), 0u);
    EXPECT_GE(
        count(page, escaped(trap)),
        8u);  // title, heading, end of the path, design, override, two commands, this page, the note on the material
}

TEST_F(Report, ItsPolicyContainsTheHashOfItsScript) {
    const std::string page = page_of(test::bar_result(2));
    const auto begin = page.rfind("<script>") + 8, end = page.rfind("</script>");
    EXPECT_EQ(count(page, "script-src '" + policy_hash(page.substr(begin, end - begin)) + "'"), 1u);
    EXPECT_EQ(count(page, "default-src 'none'"), 1u);
}

TEST_F(Report, TheSameResultGivesTheSameBytes) {
    EXPECT_EQ(page_of(test::bar_result(3)), page_of(test::bar_result(3)));
}

TEST_F(Report, WithoutFieldsItContainsNoScript) {
    const std::string page = page_of(test::bar_result(3, "", io::FieldsPolicy::Keep::none));
    EXPECT_EQ(count(page, "contains no fields"), 1u);
    EXPECT_EQ(count(page, "<script"), 0u);
}

TEST_F(Report, ShowsTheDiscretizationErrorOrHowToEstimateIt) {
    io::Result result = test::bar_result(3);
    EXPECT_EQ(count(page_of(result), "solve --tolerance"), 1u);
    for (std::size_t i = 0; i < result.steps.size(); ++i) {
        result.steps[i].pressure_error_Pa = 10.0 * static_cast<double>(i);  // 20 Pa of 2 kPa
        result.steps[i].output_errors = {1e-5};
    }
    EXPECT_EQ(count(page_of(result), "pressure \u00B1 0.02 kPa (1 % of its largest value)"), 1u);
}

TEST_F(Report, ContainsTableMaterialDesignProvenanceAndLicence) {
    const std::string page = page_of(test::bar_result(3));
    for (const char* part :
         {"<th>elongation_mm</th>", "<td>20</td>", "mu = 100 kPa", "kappa = 10 MPa", "family: tube", "PETSc 3.18",
          "Permission is hereby granted, free of charge", "stable (Drucker)", "fitted over 4:109 %"})
        EXPECT_GE(count(page, part), 1u) << part;
}

TEST(ReportWithoutViewer, IsRefused) {
    if (viewer_bundle().missing.empty()) {
        EXPECT_NO_THROW(require_viewer());
        return;
    }
    EXPECT_THROW(require_viewer(), Error);
}

}  // namespace
}  // namespace soft::view
