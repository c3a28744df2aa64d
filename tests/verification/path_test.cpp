// Ends of paths and convergence of meshes; the table (verification_test) checks the values.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "inflation_formula.hpp"
#include "membrane_formula.hpp"
#include "run_design.hpp"

namespace soft::verification {
namespace {

TEST(Tube, VolumeControlPassesTheLimitPointUpToFiveTimesTheVolume) {
    const auto run = run_design("tube.yaml", {});
    EXPECT_EQ(run.end.reason, model::StopReason::done);
    EXPECT_EQ(run.end.limit_points.size(), 1u);
    EXPECT_NEAR(*run.steps.back().volume_m3 / *run.steps.front().volume_m3, 5.0, 1e-8);
}

TEST(Tube, PressureControlEndsAtTheLimitPointWithTheCurveUpToIt) {
    const auto run = run_design("tube.yaml", {"path.control=pressure"});
    EXPECT_EQ(run.end.reason, model::StopReason::limit_point);
    EXPECT_NEAR(run.pressure_kPa() / 44.3387, 1.0, 5e-4);  // independent code
    EXPECT_NEAR(run.output_mm() / 13.45, 1.0, 2e-3);
    for (std::size_t i = 1; i < run.steps.size(); ++i)
        EXPECT_GT(run.steps[i].pressure_Pa, run.steps[i - 1].pressure_Pa);
}

// In the undeformed state every fibre is at the onset of tension: the first tangent is one-sided, with an error proportional to the step.
TEST(Tube, FibresAtTheOnsetOfTensionDoNotStopThePath) {
    const auto run =
        run_design("tube.yaml", {"material={law: holzapfel-gasser-ogden, mu: 0.1644 MPa, k1: 0.1 MPa, k2: 1, "
                                 "angle: 30 deg}",
                                 "loads.cavity.pressure=20 kPa"});
    EXPECT_EQ(run.end.reason, model::StopReason::done);
    EXPECT_NEAR(run.pressure_kPa(), 20.0, 1e-9);
    EXPECT_LT(run.output_mm(), 0.0);  // fibres nearer to the axis than the magic angle 54.74 degrees: it shortens
}

// The mesh of the whole is the mesh of the half plus its mirror image, so the states agree up to the Newton tolerance.
TEST(Pneunet, WholeModelBendsLikeTheHalfModel) {
    const std::vector<std::string> coarse{"geometry.chambers=2", "mesh.size=8 mm", "mesh.through_wall=1",
                                          "loads.cavity.pressure=3 kPa"};
    auto whole_sets = coarse;
    whole_sets.push_back("model=solid");
    const auto half = run_design("pneunet.yaml", coarse), whole = run_design("pneunet.yaml", whole_sets);
    EXPECT_EQ(half.end.reason, model::StopReason::done);
    EXPECT_EQ(whole.end.reason, model::StopReason::done);
    ASSERT_EQ(half.steps.back().outputs.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(whole.steps.back().outputs[i] / half.steps.back().outputs[i], 1.0, 1e-6);
    EXPECT_NEAR(*whole.steps.back().volume_m3 / *half.steps.back().volume_m3, 1.0, 1e-9);
    EXPECT_GT(half.steps.back().outputs[0], 0.0);  // toward the base
    EXPECT_LT(half.steps.back().outputs[2], 0.0);
}

TEST(Bellows, ReachesAnElongationGoalExactly) {
    const auto run = run_design("bellows.yaml", {"mesh.size=3 mm", "path.until.elongation=20 mm"});
    EXPECT_EQ(run.end.reason, model::StopReason::done);
    EXPECT_NEAR(run.output_mm(), 20.0, 1e-6);
}

/// Greatest relative difference of the pressure between the smooth curves of two runs, from 5 to 130 mm.
double curve_difference(const Run& a, const Run& b) {
    double worst = 0;
    for (int mm = 5; mm < 130; ++mm)
        worst = std::max(
            worst, std::abs(a.at("elongation", 1e-3 * mm).pressure_Pa / b.at("elongation", 1e-3 * mm).pressure_Pa - 1));
    return worst;
}

class BellowsTo130mm : public ::testing::TestWithParam<const char*> {};

// The reference path uses the same code with the other control and steps of about a millimetre.
TEST_P(BellowsTo130mm, NeedsFewFactorizationsAndItsSmoothCurveMatchesSmallSteps) {
    static const verification::Run dense =
        run_design("bellows.yaml", {"path.control=volume", "solver.step_accuracy=1e-6"});
    const auto run = run_design("bellows.yaml", {std::string("path.control=") + GetParam()});
    EXPECT_EQ(run.end.reason, model::StopReason::done);
    EXPECT_NEAR(run.output_mm(), 130.0, 1e-6);
    EXPECT_LE(run.end.factorizations, 25);
    EXPECT_GT(dense.steps.size(), 5 * run.steps.size());
    EXPECT_LT(curve_difference(run, dense), 5e-4);
}

INSTANTIATE_TEST_SUITE_P(Control, BellowsTo130mm, ::testing::Values("auto", "volume"),
                         [](const auto& each) { return std::string(each.param); });

/// Deformed positions of the nodes.
std::vector<mesh::Point> deformed_points(const Run& run) {
    std::vector<mesh::Point> points = run.model.mesh.points;
    for (std::size_t node = 0; node < points.size(); ++node)
        for (std::size_t i = 0; i < 3; ++i) points[node][i] += run.displacement_m[3 * node + i];
    return points;
}

double distance_m(const mesh::Point& a, const mesh::Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// Distance from a point to the segment a b, in the section.
double distance_m(const mesh::Point& p, const mesh::Point& a, const mesh::Point& b) {
    const double x = b[0] - a[0], y = b[1] - a[1];
    const double t = std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y), 0.0, 1.0);
    return distance_m(p, {a[0] + t * x, a[1] + t * y, 0});
}

/// The nodes of the cavity wall, in order along the wall.
std::vector<std::size_t> along_cavity(const Run& run) {
    std::map<std::size_t, std::vector<std::size_t>> beside;
    for (const auto& facet : run.model.mesh.facet_sets.at("cavity")) {
        const auto nodes = mesh::facet_nodes(run.model.mesh, facet);  // ends, then the middle
        for (const std::size_t end : {0, 1}) {
            beside[static_cast<std::size_t>(nodes[end])].push_back(static_cast<std::size_t>(nodes[2]));
            beside[static_cast<std::size_t>(nodes[2])].push_back(static_cast<std::size_t>(nodes[end]));
        }
    }
    const auto first = std::ranges::find_if(beside, [](const auto& node) { return node.second.size() == 1; });
    std::vector<std::size_t> chain{first->first, first->second.front()};
    while (beside.at(chain.back()).size() == 2) {
        const auto& next = beside.at(chain.back());
        chain.push_back(next[0] == chain[chain.size() - 2] ? next[1] : next[0]);
    }
    return chain;
}

/// The smallest deformed distance between two points of the cavity wall that are at least `apart_m` apart along the undeformed wall.
double min_gap_m(const Run& run, double apart_m) {
    const auto now = deformed_points(run);
    const auto chain = along_cavity(run);
    std::vector<double> along_m{0};
    for (std::size_t i = 1; i < chain.size(); ++i)
        along_m.push_back(along_m.back() +
                          distance_m(run.model.mesh.points[chain[i - 1]], run.model.mesh.points[chain[i]]));
    double minimum = 1;
    for (std::size_t i = 0; i < chain.size(); ++i)
        for (std::size_t k = 1; k < chain.size(); ++k)
            if (along_m[k - 1] - along_m[i] >= apart_m || along_m[i] - along_m[k] >= apart_m)
                minimum = std::min(minimum, distance_m(now[chain[i]], now[chain[k - 1]], now[chain[k]]));
    return minimum;
}

TEST(BellowsUnderVacuum, EndsAtSelfContactOfTheFoldsOnEveryMesh) {
    const std::string until_contact = "path.contact=stop";
    const auto run = run_design("vacuum.yaml", {until_contact}),
               finer = run_design("vacuum.yaml", {until_contact, "mesh.size=1 mm"});
    constexpr double apart_m = 1.5e-3, cell_m = 1e-3;  // the bends of the folds are 0.8 mm long
    for (const verification::Run* each : {&run, &finer}) {
        EXPECT_EQ(each->end.reason, model::StopReason::self_contact);
        EXPECT_NE(each->end.detail.find("the face cavity touches itself at x = "), std::string::npos)
            << each->end.detail;
        EXPECT_LT(min_gap_m(*each, apart_m), 0.05 * cell_m);
    }
    EXPECT_NEAR(finer.pressure_kPa() / run.pressure_kPa(), 1, 5e-3);
    EXPECT_NEAR(finer.output_mm() / run.output_mm(), 1, 2e-3);
}

// Cells at the rim snap through one after another. At each snap-through the load of the whole plate reverses within an arc of 1e-6 of a
// step, in the same way as with steps a fifth as long.
TEST(Plate, FollowsTheSnapThroughOfSingleCells) {
    const std::vector<std::string> soft{
        "model=axisymmetric",
        "geometry.radius=34.122 mm",
        "geometry.thickness=2.3397 mm",
        "material={law: mooney-rivlin, c10: 5.0108 kPa, c01: 0.71213 kPa, kappa: 227.81 kPa}",
        "mesh={size: 1.8157 mm, formulation: displacement, grading: 16}",
        "loads={bottom: {pressure: 6.2042 kPa}}",
        "path.stretch_limit=7.6889",
        "path.control=arc-length",  // under other controls the path jumps over them
        "path.contact=stop"};  // not reached; contact forces in the crease at the clamp would change the snap-throughs
    const auto with_accuracy = [&](const std::string& accuracy) {
        auto changes = soft;
        changes.push_back("solver.step_accuracy=" + accuracy);
        return changes;
    };
    // Longer steps miss the snap-throughs, and so do some shorter ones.
    const auto run = run_design("plate.yaml", with_accuracy("8.5e-4")),
               dense = run_design("plate.yaml", with_accuracy("1e-5"));
    EXPECT_EQ(run.end.reason, model::StopReason::limit_point);  // the maximum, with stretches beyond the limit
    EXPECT_GT(dense.steps.size(), 3 * run.steps.size());
    ASSERT_GE(run.end.limit_points.size(), 2u);
    ASSERT_GE(dense.end.limit_points.size(), 2u);
    for (std::size_t i = 1; i <= 2; ++i) {  // the last limit points are the snap-throughs
        const auto &fold = run.end.limit_points.rbegin()[i - 1], &same = dense.end.limit_points.rbegin()[i - 1];
        EXPECT_NEAR(fold.pressure_Pa / same.pressure_Pa, 1.0, 1e-5);
        EXPECT_NEAR(fold.outputs[0] / same.outputs[0], 1.0, 1e-5);
    }
}

// The tangent of the undeformed plate, which bends, predicts the goal at a thousandth of the load at which the membrane reaches it.
TEST(Plate, DoesNotJumpToAGoalThatIsPredictedTooNear) {
    const auto run = run_design("verification/membrane.yaml", {});
    EXPECT_EQ(run.end.reason, model::StopReason::done);
    EXPECT_NEAR(run.output_mm(), 16.0, 1e-6);
    EXPECT_GT(run.steps.size(), 10u);
    const auto& energies = *run.steps.back().energies;
    EXPECT_NEAR(energies.stored_J / energies.load_work_J, 1.0, 1e-3);
}

// Next to the clamped edge the rubber folds up in a crease as large as the cells there, at a load that depends on the mesh, and the plate does not
// feel it: followed along the arc, the path leads back to no load. The pressure is that of a membrane smaller by the zone in which the edge
// bends, about sqrt(D/T) = 0.6 thicknesses wide.
TEST(Plate, PassesCreasesAtItsEdge) {
    const std::vector<std::string> round{"model=axisymmetric",          "geometry.radius=20 mm",
                                         "geometry.thickness=1 mm",     "material.mu=24 kPa",
                                         "loads.bottom.pressure=5 kPa", "path.until.deflection=8 mm"};
    const double membrane_Pa = membrane_deflected({20e-3, 1e-3, 24e3}, 8e-3).pressure_Pa;
    const auto run_with = [&](std::vector<std::string> mesh) {
        mesh.insert(mesh.end(), round.begin(), round.end());
        return run_design("plate.yaml", mesh);
    };
    const auto even = run_with({"mesh={size: 0.25 mm, grading: 1}"});
    const double excess = 1e3 * even.pressure_kPa() / membrane_Pa - 1;
    EXPECT_GT(excess, 2 * 0.6 / 20);
    EXPECT_LT(excess, 4 * 0.6 / 20);
    for (const auto* const mesh :
         {"mesh={size: 0.5 mm, grading: 8}", "mesh={size: 0.5 mm, grading: 16}", "mesh={size: 0.4 mm, grading: 16}"}) {
        const auto run = run_with({mesh});
        EXPECT_EQ(run.end.reason, model::StopReason::done) << mesh;
        EXPECT_TRUE(run.end.limit_points.empty()) << mesh;
        EXPECT_NEAR(run.pressure_kPa() / even.pressure_kPa(), 1.0, 2e-3) << mesh;
        EXPECT_GT(run.steps.back().energies->dissipated_J.value_or(0), 0.0) << mesh;
    }
    // Outputs that are zero by symmetry, or lie in the crease, change nothing.
    const auto shown = run_with({"mesh={size: 0.5 mm, grading: 16}",
                                 "outputs={side: {point: [1 mm, 0 mm], along: r}, crease: {point: [1 mm, 19.4724 mm], "
                                 "along: x}, deflection: {face: top, along: normal}}"});
    EXPECT_EQ(shown.end.reason, model::StopReason::done);
    EXPECT_NEAR(shown.pressure_kPa() / even.pressure_kPa(), 1.0, 2e-3);
    const auto controlled = run_with({"mesh={size: 0.5 mm, grading: 16}", "path.control=pressure"});
    EXPECT_NEAR(controlled.pressure_kPa() / even.pressure_kPa(), 1.0, 2e-3);
}

// A thin sphere of compressible Yeoh rubber, energy c3 (I1 - 3)^3 + kappa/2 (J - 1)^2. For large stretches I1 = 2 l^2 J^(-2/3), the minimum
// of the energy over J is 4 sqrt(c3 kappa) l^3, and p = t/R W'/l^2 tends to 12 t/R sqrt(c3 kappa) from below as l^(-3/2) (derived here).
TEST(Sphere, LoadAboveTheAsymptoteOfACompressibleLawIsAbandoned) {
    const auto run = run_design(
        "sphere.yaml", {"geometry={inner_radius: 50 mm, outer_radius: 51 mm}", "mesh.size=2 mm", "path.until={}",
                        "material={law: yeoh, c1: 10 kPa, c2: 1 kPa, c3: 1 kPa, kappa: 4 MPa}",
                        "loads.cavity.pressure=60 kPa", "path.stretch_limit=3"});
    EXPECT_EQ(run.end.reason, model::StopReason::limit_point);
    EXPECT_NE(run.end.detail.find("the load approaches a limit just above its value at "), std::string::npos)
        << run.end.detail;
    const double asymptote_kPa = 12 * (1 / 50.5) * std::sqrt(1.0 * 4e3);
    EXPECT_LT(run.pressure_kPa(), asymptote_kPa);
    EXPECT_GT(run.pressure_kPa(), 0.95 * asymptote_kPa);
    EXPECT_LT(run.steps.size(), 100u);
}

TEST(Problems, RunDesignThrowsForADivergedPath) {
    try {
        static_cast<void>(
            run_design("bellows.yaml", {"solver.newton_limit=1", "solver.residual_tolerance=1e-14",
                                        "solver.steps=constant", "solver.first_step=0.5", "solver.min_step=1"}));
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("bellows.yaml: the path diverged: "), std::string::npos)
            << error.what();
    }
}

// The same section swept over a quarter turn: only the discretisation around the axis differs.
TEST(Bellows, QuarterSolidAgreesWithTheAxisymmetricSection) {
    const std::vector<std::string> coarse{"mesh.size=3 mm", "mesh.through_wall=1", "path.until.elongation=40 mm"};
    auto quarter = coarse;
    quarter.insert(quarter.end(), {"model=quarter", "mesh.sectors=4"});
    const auto section = run_design("bellows.yaml", coarse), solid = run_design("bellows.yaml", quarter);
    EXPECT_NEAR(solid.pressure_kPa() / section.pressure_kPa(), 1.0, 3e-3);
    EXPECT_NEAR(*solid.steps.back().volume_m3 / *section.steps.back().volume_m3, 1.0, 3e-3);
}

TEST(Sphere, CurveMatchesTheClosedFormOnBothSidesOfTheLimitPoint) {
    const auto run = run_design("sphere.yaml", {});
    EXPECT_EQ(run.end.reason, model::StopReason::done);
    for (std::size_t i = 1; i < run.steps.size(); ++i) {
        const double l = std::cbrt(*run.steps[i].volume_m3 / *run.steps.front().volume_m3);
        EXPECT_NEAR(run.steps[i].pressure_Pa / neo_hookean_sphere_pressure_Pa(0.1644e6, l, 2), 1.0, 1e-3);
    }
    EXPECT_NEAR(*run.steps.back().volume_m3 / *run.steps.front().volume_m3, 27.0, 1e-6);
}

TEST(Sphere, FinerMeshesConvergeToTheClosedForm) {
    const auto error = [](const char* size) {
        const auto run = run_design("sphere.yaml", {std::string("mesh.size=") + size, "path.until.volume_ratio=3.375"});
        return std::abs(run.steps.back().pressure_Pa / neo_hookean_sphere_pressure_Pa(0.1644e6, 1.5, 2) - 1.0);
    };
    EXPECT_LT(error("2.5 mm"), 0.2 * error("5 mm"));  // third order or better
}

}  // namespace
}  // namespace soft::verification
