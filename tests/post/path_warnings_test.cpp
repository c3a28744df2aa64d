#include "post/path_warnings.hpp"

#include <gtest/gtest.h>

namespace soft::post {
namespace {

model::Case tube_of(const std::string& law, std::map<std::string, std::vector<double>> constants) {
    model::Case solved;
    solved.materials = {{.name = "rubber", .law = law, .constants = std::move(constants), .bulk_modulus_Pa = {}}};
    solved.path.stages.emplace_back();
    return solved;
}

PathSummary stretched_to(double stretch) {
    PathSummary reached;
    reached.max_stretch_p99 = stretch;
    return reached;
}

bool holds(const std::vector<std::string>& warnings, std::string_view words) {
    return warnings.size() == 1 && warnings[0].find(words) != std::string::npos;
}

// Mooney-Rivlin with c01 < 0: the equibiaxial limit is at c10 + c01 l^2 = 0 at the latest; its value is tested by
// material/stability_test. Here only the side of the limit on which the path ends matters.
TEST(PathWarnings, ALawIsNamedIfThePathPassesItsStabilityLimit) {
    const model::Case solved = tube_of("mooney-rivlin", {{"c10", {100e3}}, {"c01", {-18e3}}});
    EXPECT_TRUE(path_warnings(solved, stretched_to(1.5), model::StopReason::done).empty());
    EXPECT_TRUE(holds(
        path_warnings(solved, stretched_to(2.0), model::StopReason::self_contact),
        "stretched to 2, but mooney-rivlin with these constants is unstable beyond a stretch of equibiaxial 1.71"));
    EXPECT_TRUE(
        path_warnings(tube_of("neo-hookean", {{"mu", {1e5}}}), stretched_to(8), model::StopReason::done).empty());
}

// A softening rubber localizes its strain in less than 1 % of its volume.
TEST(PathWarnings, ALocallyExceededLimitIsReportedIfThePathBecameUnstable) {
    const model::Case solved = tube_of("mooney-rivlin", {{"c10", {100e3}}, {"c01", {-18e3}}});
    PathSummary reached = stretched_to(1.5);
    reached.max_stretch_step.max_stretch = 2.0;
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::done).empty())
        << "local strain at a sharp corner alone is no problem";
    EXPECT_TRUE(holds(path_warnings(solved, reached, model::StopReason::diverged), "at one point the rubber is"));
    reached.became_unstable = true;
    reached.max_stretch_step.extremes = {{5e-3, 12e-3, 0}, 0};
    EXPECT_TRUE(holds(path_warnings(solved, reached, model::StopReason::done),
                      "at one point (x = 5 mm, y = 12 mm, z = 0 mm) the rubber is stretched to 2, but mooney-rivlin"));
    EXPECT_TRUE(path_warnings(tube_of("neo-hookean", {{"mu", {1e5}}}), reached, model::StopReason::done).empty());
    reached.max_stretch_p99 = 2.0;  // one warning only
    EXPECT_TRUE(
        holds(path_warnings(solved, reached, model::StopReason::done), "material: the rubber is stretched to 2,"));
}

TEST(PathWarnings, SmallStrainLawsAreReportedAtLargeStrain) {
    model::Case solved = tube_of("linear-elastic", {{"mu", {1e5}}});
    EXPECT_TRUE(path_warnings(solved, stretched_to(1.05), model::StopReason::done).empty());
    EXPECT_TRUE(
        holds(path_warnings(solved, stretched_to(1.3), model::StopReason::done), "small strains (linear-elastic)"));
    solved = tube_of("neo-hookean", {{"mu", {1e5}}});
    solved.materials[0].strain = model::Strain::small;
    EXPECT_TRUE(
        holds(path_warnings(solved, stretched_to(1.3), model::StopReason::done), "small strains (neo-hookean)"));
}

TEST(PathWarnings, CrushedNearlyIncompressibleRubberIsReported) {
    model::Case solved = tube_of("neo-hookean", {{"mu", {1e5}}});
    PathSummary reached;
    reached.first_crushed_row = 7;
    reached.min_jacobian = 0.31;
    EXPECT_TRUE(holds(path_warnings(solved, reached, model::StopReason::limit_point),
                      "from row 7 on, nearly incompressible rubber is compressed to 0.31 of its volume"));
    solved.materials[0].bulk_modulus_Pa = 2e5;  // a foam may be compressed
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::limit_point).empty());
    solved.materials[0].bulk_modulus_Pa.reset();
    reached.first_crushed_row.reset();
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::limit_point).empty());
}

TEST(PathWarnings, SnapsAreComparedWithTheLargestWork) {
    const model::Case solved = tube_of("neo-hookean", {{"mu", {1e5}}});
    PathSummary reached;
    reached.last.energies = model::Step::Energies{0, 1e-9, {}, 0.02};  // pressed and released again
    reached.largest_work_J = 1;
    EXPECT_TRUE(holds(path_warnings(solved, reached, model::StopReason::done),
                      "small parts snap and set energy free, 2 % of the largest work of the loads"));
    reached.last.energies->dissipated_J = 0.005;
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::done).empty());
}

TEST(PathWarnings, ALimitPressureBelowTheRequestedOneIsReported) {
    model::Case solved = tube_of("neo-hookean", {{"mu", {1e5}}});
    solved.loads = {{.name = "cavity", .targets = {"cavity"}, .gas = {}}};
    solved.path.stages[0].supplies = {{model::Prescription::pressure, 30e3}};
    const std::vector<model::LimitPoint> points{{4, 9.2e3, {}, {}}, {7, 5e3, {}, {}}};
    PathSummary reached;
    reached.last.pressure_Pa = 6e3;
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::inverted_element).empty());
    reached.limit_points = points;
    EXPECT_TRUE(holds(path_warnings(solved, reached, model::StopReason::inverted_element),
                      "loads.cavity: 9.2 kPa is the limit pressure on the way to 30 kPa"));
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::done).empty());
    reached.last.pressure_Pa = 12e3;  // it has risen again
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::inverted_element).empty());
    reached.last.pressure_Pa = 6e3;
    solved.path.stages[0].supplies = {{model::Prescription::pressure, 8e3}};
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::self_contact).empty()) << "reached on the way";
}

TEST(PathWarnings, AGoalThatTheFullLoadDoesNotReachIsReported) {
    model::Case solved = tube_of("neo-hookean", {{"mu", {1e5}}});
    solved.outputs = {{.name = "elongation", .face = "end", .direction = {1, 0, 0}}};
    solved.path.stages[0].until = {{"elongation", 50e-3}};
    PathSummary reached;
    reached.last.outputs = {2e-3};
    EXPECT_TRUE(
        holds(path_warnings(solved, reached, model::StopReason::done), "elongation 50 mm is not reached, it is 2 mm"));
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::limit_point).empty())
        << "the stop reason explains the end";
    reached.last.outputs = {50e-3 * (1 + 1e-9)};
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::done).empty());
    solved.path.stages[0].until.push_back({"pressure", 1e3});  // the first of several ends the path
    EXPECT_TRUE(path_warnings(solved, reached, model::StopReason::done).empty());
}

// A uniformly compressed block has the same stretch everywhere; at a fixed edge the stretch is larger than in 99 % of the rubber.
TEST(PathWarnings, AUniformlyCompressedBlockIsNotCrushedAtAPoint) {
    model::Step row;
    row.min_jacobian = 0.3;
    row.max_stretch = row.stretch_p99 = 1.2;
    EXPECT_FALSE(is_crushed_at_a_point(row));
    row.max_stretch = 1.5;
    EXPECT_TRUE(is_crushed_at_a_point(row));
    row.min_jacobian = 0.8;
    EXPECT_FALSE(is_crushed_at_a_point(row));
}

}  // namespace
}  // namespace soft::post
