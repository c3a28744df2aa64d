#include "fields/reached.hpp"

#include <gtest/gtest.h>

namespace soft::fields {
namespace {

model::Case tube_of(const std::string& law, std::map<std::string, std::vector<double>> constants) {
    model::Case solved;
    solved.materials = {{.name = "rubber", .law = law, .constants = std::move(constants), .bulk_modulus_Pa = {}}};
    solved.path.stages.emplace_back();
    return solved;
}

Reached stretched_to(double stretch) {
    Reached reached;
    reached.max_stretch_p99 = stretch;
    return reached;
}

bool holds(const std::vector<std::string>& warnings, std::string_view words) {
    return warnings.size() == 1 && warnings[0].find(words) != std::string::npos;
}

// Mooney-Rivlin with c01 < 0: the equibiaxial limit is where c10 + c01 l^2 = 0 at the latest; its place is that of
// material/stability_test, here only which side of it the path has come to counts.
TEST(Reached, ALawIsToldOnlyWherePathsPassItsStability) {
    const model::Case solved = tube_of("mooney-rivlin", {{"c10", {100e3}}, {"c01", {-18e3}}});
    EXPECT_TRUE(warnings_at(solved, stretched_to(1.5), solution::StopReason::done).empty());
    EXPECT_TRUE(
        holds(warnings_at(solved, stretched_to(2.0), solution::StopReason::self_contact),
              "stretched to 2; mooney-rivlin with these constants is unstable beyond a stretch of equibiaxial 1.71"));
    EXPECT_TRUE(
        warnings_at(tube_of("neo-hookean", {{"mu", {1e5}}}), stretched_to(8), solution::StopReason::done).empty());
}

// A rubber that softens gathers its strain where less than 1 % of it is.
TEST(Reached, ALawPassedAtOnePlaceIsToldWhereTheBodyGaveWay) {
    const model::Case solved = tube_of("mooney-rivlin", {{"c10", {100e3}}, {"c01", {-18e3}}});
    Reached reached = stretched_to(1.5);
    reached.most_stretched.max_stretch = 2.0;
    EXPECT_TRUE(warnings_at(solved, reached, solution::StopReason::done).empty()) << "a sharp corner does no harm";
    EXPECT_TRUE(holds(warnings_at(solved, reached, solution::StopReason::diverged), "at one place the rubber is"));
    reached.gave_way = true;
    reached.most_stretched.extremes = {{5e-3, 12e-3, 0}, 0};
    EXPECT_TRUE(holds(warnings_at(solved, reached, solution::StopReason::done),
                      "at one place (x = 5 mm, y = 12 mm, z = 0 mm) the rubber is stretched to 2; mooney-rivlin"));
    EXPECT_TRUE(warnings_at(tube_of("neo-hookean", {{"mu", {1e5}}}), reached, solution::StopReason::done).empty());
    reached.max_stretch_p99 = 2.0;  // said once
    EXPECT_TRUE(
        holds(warnings_at(solved, reached, solution::StopReason::done), "material: the rubber is stretched to 2;"));
}

TEST(Reached, SmallStrainIsToldWhereItIsNoMore) {
    model::Case solved = tube_of("linear-elastic", {{"mu", {1e5}}});
    EXPECT_TRUE(warnings_at(solved, stretched_to(1.05), solution::StopReason::done).empty());
    EXPECT_TRUE(
        holds(warnings_at(solved, stretched_to(1.3), solution::StopReason::done), "small strains (linear-elastic)"));
    solved = tube_of("neo-hookean", {{"mu", {1e5}}});
    solved.materials[0].strain = model::Strain::small;
    EXPECT_TRUE(
        holds(warnings_at(solved, stretched_to(1.3), solution::StopReason::done), "small strains (neo-hookean)"));
}

TEST(Reached, RubberThatIsCrushedThoughItKeepsItsVolumeIsTold) {
    model::Case solved = tube_of("neo-hookean", {{"mu", {1e5}}});
    Reached reached;
    reached.first_crushed_row = 7;
    reached.min_jacobian = 0.31;
    EXPECT_TRUE(holds(warnings_at(solved, reached, solution::StopReason::limit_point),
                      "from row 7 on the mesh presses rubber that keeps its volume to 0.31 of it"));
    solved.materials[0].bulk_modulus_Pa = 2e5;  // a foam may be
    EXPECT_TRUE(warnings_at(solved, reached, solution::StopReason::limit_point).empty());
    solved.materials[0].bulk_modulus_Pa.reset();
    reached.first_crushed_row.reset();
    EXPECT_TRUE(warnings_at(solved, reached, solution::StopReason::limit_point).empty());
}

TEST(Reached, AMaximumBehindWhichAPathEndsEarlyIsTold) {
    model::Case solved = tube_of("neo-hookean", {{"mu", {1e5}}});
    solved.loads = {{.name = "cavity", .targets = {"cavity"}, .gas = {}}};
    solved.path.stages[0].supplies = {{model::Prescription::pressure, 30e3}};
    const std::vector<solution::LimitPoint> points{{4, 9.2e3, {}, {}}, {7, 5e3, {}, {}}};
    Reached reached;
    reached.last.pressure_Pa = 6e3;
    EXPECT_TRUE(warnings_at(solved, reached, solution::StopReason::inverted_element).empty());
    reached.limit_points = points;
    EXPECT_TRUE(holds(warnings_at(solved, reached, solution::StopReason::inverted_element),
                      "loads.cavity: 9.2 kPa is the largest pressure that the body bears on its way to 30 kPa"));
    EXPECT_TRUE(warnings_at(solved, reached, solution::StopReason::done).empty());
    reached.last.pressure_Pa = 12e3;  // it has risen again
    EXPECT_TRUE(warnings_at(solved, reached, solution::StopReason::inverted_element).empty());
    reached.last.pressure_Pa = 6e3;
    solved.path.stages[0].supplies = {{model::Prescription::pressure, 8e3}};
    EXPECT_TRUE(warnings_at(solved, reached, solution::StopReason::self_contact).empty()) << "reached on the way";
}

TEST(Reached, AGoalThatTheFullLoadDoesNotReachIsTold) {
    model::Case solved = tube_of("neo-hookean", {{"mu", {1e5}}});
    solved.outputs = {{.name = "elongation", .face = "end", .direction = {1, 0, 0}}};
    solved.path.stages[0].until = {{"elongation", 50e-3}};
    Reached reached;
    reached.last.outputs = {2e-3};
    EXPECT_TRUE(holds(warnings_at(solved, reached, solution::StopReason::done),
                      "elongation 50 mm is not reached, it ends with 2 mm"));
    EXPECT_TRUE(warnings_at(solved, reached, solution::StopReason::limit_point).empty()) << "the end says why itself";
    reached.last.outputs = {50e-3 * (1 + 1e-9)};
    EXPECT_TRUE(warnings_at(solved, reached, solution::StopReason::done).empty());
    solved.path.stages[0].until.push_back({"pressure", 1e3});  // the first of several ends the path
    EXPECT_TRUE(warnings_at(solved, reached, solution::StopReason::done).empty());
}

// A block that is pressed together as a whole has the same stretch everywhere; at a held edge it is larger than in 99 % of the rubber.
TEST(Reached, ABlockThatIsCompressedAsAWholeIsNotCrushedAtAPoint) {
    solution::Step row;
    row.min_jacobian = 0.3;
    row.max_stretch = row.stretch_p99 = 1.2;
    EXPECT_FALSE(is_crushed_at_a_point(row));
    row.max_stretch = 1.5;
    EXPECT_TRUE(is_crushed_at_a_point(row));
    row.min_jacobian = 0.8;
    EXPECT_FALSE(is_crushed_at_a_point(row));
}

}  // namespace
}  // namespace soft::fields
