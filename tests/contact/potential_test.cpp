#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "../fem/block_mesh.hpp"
#include "contact/area.hpp"
#include "contact/barrier.hpp"
#include "contact/potential.hpp"
#include "potential_samples.hpp"

namespace soft::contact {
namespace {

/// Along y about y = 0.5, so that contact acts on the deformed area.
State stretched(State state, double stretch) {
    for (Point& x : state.positions) x[1] = 0.5 + stretch * (x[1] - 0.5);
    return state;
}

class PotentialOf : public testing::TestWithParam<Cells> {};

TEST_P(PotentialOf, DerivativesOfContactBetweenTwoBlocksAreExact) {
    for (const auto kinematics :
         {model::Kinematics::plane_strain, model::Kinematics::axisymmetric, model::Kinematics::solid}) {
        const model::Case model =
            with_settings(test::two_blocks(kinematics == model::Kinematics::solid ? 3 : 2, GetParam(), kinematics));
        Potential potential(model, std::array{modulus_Pa});
        const double h = potential.distance_m();
        State state{model.mesh.points, {}};
        for (Point& x : state.positions)
            if (x[0] >= 2) x[0] -= 1 - 0.6 * h;
        EXPECT_FALSE(derivatives(potential, model.mesh.points, {}).summary.touches());
        for (const double stretch : {1.0, 6.0}) {
            const State next = moved(stretched(state, stretch), 1, direction_of(model, 3, 0.15 * h));  // curved walls
            expect_exact_derivatives(potential, next, direction_of(model, 4, h));
        }
    }
}

TEST_P(PotentialOf, DerivativesOfContactWithObstaclesAreExact) {
    for (const auto kinematics : {model::Kinematics::plane_strain, model::Kinematics::solid}) {
        const int dimension = kinematics == model::Kinematics::solid ? 3 : 2;
        model::Case model = with_settings(test::two_blocks(dimension, GetParam(), kinematics));
        const double h = Potential(model, std::array{modulus_Pa}).distance_m();
        // The obstacles are 3 h away from the left block's face x = 0, and are then moved to about 0.6 h.
        const double x = -3 * h;
        model.obstacles.push_back({"plane", model::Plane{{x, 0, 0}, {1, 0, 0}}});
        model.obstacles.push_back({"cylinder", model::Cylinder{{x - 2, 0.5, 0}, {0, 0, 1}, 2}});
        model.obstacles.push_back({"box", model::Box{{x - 1, 0.3, -1}, {x, 3, 2}, 0.1}});
        if (dimension == 3) model.obstacles.push_back({"sphere", model::Sphere{{x - 3, 0.5, 0.5}, 3}});
        model::FacetedSurface wall{{{x, 2, -1}, {x, -1, -1}, {x, 0.5, 3}}, {{0, 2, 1}}};
        if (dimension == 2) wall = {{{x, -1, 0}, {x, 2, 0}}, {{0, 1, -1}}};
        model.obstacles.push_back({"wall", wall});
        Potential potential(model, std::array{modulus_Pa});
        State state{model.mesh.points, {}};
        for (std::size_t k = 0; k < model.obstacles.size(); ++k)
            state.shifts.push_back({(2.5 - 0.1 * static_cast<double>(k)) * h, 0, 0});
        for (const double stretch : {6.0, 1.0}) {
            state = moved(stretched(state, stretch), 1, direction_of(model, 5, 0.1 * h));
            expect_exact_derivatives(potential, state, direction_of(model, 6, h));
            state = stretched(state, 1 / stretch);
        }
        const auto at = derivatives(potential, state.positions, state.shifts);
        for (std::size_t k = 0; k < model.obstacles.size(); ++k)
            EXPECT_GT(at.summary.pressure_Pa[k], 0) << model.obstacles[k].name;
    }
}

/// With a uniform gap g the pressure is uniform on the face: proportional to |b'(g)|, and inversely to the stretch of the area
/// until contact acts on the deformed area.
TEST(Potential, NodalPressureIsTheSlopeOfTheBarrierOverTheStretch) {
    using enum mesh::CellType;
    for (const auto type : {quad9, triangle6, hex27, tet10}) {
        const bool solid = mesh::dimension(type) == 3;
        model::Case model = block_case(type, solid ? model::Kinematics::solid : model::Kinematics::plane_strain,
                                       model::Formulation::displacement, {.n = 2});
        const double h = Potential(model, std::array{modulus_Pa}).distance_m();
        model.obstacles.push_back({"plane", model::Plane{{-3 * h, 0, 0}, {1, 0, 0}}});
        Potential potential(model, std::array{modulus_Pa});
        double unit_Pa = 0;  // of the first gap
        for (const auto& [gap, stretch] : {std::pair{0.6 * h, 1.0}, {0.6 * h, 1.5}, {0.6 * h, 40.0}, {0.2 * h, 1.0}}) {
            State state{model.mesh.points, {{3 * h - gap, 0, 0}}};
            for (Point& x : state.positions) x[1] *= stretch;
            const auto pressures_Pa = potential.nodal_pressures_Pa(state.positions, state.shifts);
            const double scale = -barrier(gap, h).slope * area_factor(stretch).value / stretch;
            for (std::size_t n = 0; n < pressures_Pa.size(); ++n) {
                const auto& [x, y, z] =
                    model.mesh.points[n];  // the ends of the sides are within h as well, and not stretched
                if (stretch > 2 && (std::abs(y - 0.5) > 0.3 || (solid && std::abs(z - 0.5) > 0.3))) continue;
                if (x < 1e-9 && unit_Pa == 0) unit_Pa = pressures_Pa[n] / scale;
                if (x < 1e-9 || x > 0.5) {
                    EXPECT_NEAR(pressures_Pa[n], x < 0.5 ? unit_Pa * scale : 0, 1e-9 * unit_Pa * scale);
                }
            }
        }
        EXPECT_GT(unit_Pa, 0);
    }
}

const Potential::Take all = [](mesh::Index) { return true; };

/// Sum of the forces on the block, the left one of two, along y.
double force_along_y(const Derivatives& at, const model::Case& model) {
    double force = 0;
    for (std::size_t n = 0; n < model.mesh.points.size(); ++n)
        if (model.mesh.points[n][0] < 1.5) force += at.gradient[3 * n + 1];
    return force;
}

/// A block slides on a plane, or on another block: mu times the normal force, against the motion; the work is stored or dissipated.
TEST_P(PotentialOf, FrictionFollowsCoulombsLaw) {
    constexpr double mu = 0.4;
    for (const bool has_plane : {true, false})
        for (const int dimension : {2, 3}) {
            model::Case model = with_settings(test::two_blocks(
                dimension, GetParam(), dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid));
            model.contact.friction = mu;
            if (has_plane) {
                model.contact.self = false;
                model.obstacles.push_back({"plane", model::Plane{{-1, 0, 0}, {1, 0, 0}}, mu});
            }
            Potential potential(model, std::array{modulus_Pa});
            const double h = potential.distance_m();
            const std::vector<Vector3> shifts(model.obstacles.size());
            const auto at_slip = [&](double slip_m, double gap_m) {
                State state{model.mesh.points, shifts};
                for (Point& x : state.positions)
                    if (x[0] < 1.5) {
                        x[0] += has_plane ? gap_m - 1 : 1 - gap_m;
                        x[1] += slip_m;
                    }
                return state;
            };
            const auto start = [&](const State& state) {
                static_cast<void>(derivatives(potential, state.positions, state.shifts));
                EXPECT_TRUE(potential.start_friction(state.positions, state.shifts,
                                                     potential.friction_state(state.positions, state.shifts), all));
            };
            const auto evaluate = [&](const State& state) { return derivatives(potential, state.positions, shifts); };
            const auto normal_force = [&](const Derivatives& at) {
                double force = 0;
                for (std::size_t n = 0; n < model.mesh.points.size(); ++n)
                    if (model.mesh.points[n][0] < 1.5) force += at.gradient[3 * n];
                return std::abs(force);
            };
            const double gap = 0.5 * h, slip = 1e-4 * h;
            start(at_slip(0, gap));
            const auto rest = evaluate(at_slip(0, gap)), stick = evaluate(at_slip(slip, gap)),
                       slide = evaluate(at_slip(5 * h, gap)), back = evaluate(at_slip(-5 * h, gap));
            const double limit = mu * normal_force(rest);
            EXPECT_NEAR(force_along_y(rest, model), 0, 1e-12 * limit);
            EXPECT_GT(force_along_y(stick, model), 0);
            EXPECT_LT(force_along_y(stick, model), limit);
            // The lightest points beyond the edge of another block, with inclined normals, slide from the approach on.
            const double stuck_J = has_plane ? 0 : rest.summary.dissipated_J;
            EXPECT_GE(stick.summary.dissipated_J, stuck_J);
            EXPECT_LE(stick.summary.dissipated_J, stuck_J + (has_plane ? 0 : 1e-3 * limit * slip));
            // Points beyond the edge of another block have inclined normals.
            const double tolerance = has_plane ? 1e-9 * limit : 0.05 * limit;
            EXPECT_NEAR(force_along_y(slide, model), mu * normal_force(slide), tolerance);
            EXPECT_NEAR(force_along_y(back, model), -mu * normal_force(back), tolerance);
            if (!has_plane) continue;  // the overlap of two blocks depends on the slip
            // From rest the force grows over a slip of less than h, and is constant then.
            start(at_slip(5 * h, gap));
            const double before_J = evaluate(at_slip(5 * h, gap)).summary.dissipated_J;
            const auto further = evaluate(at_slip(9 * h, gap));
            EXPECT_NEAR(further.summary.dissipated_J - before_J, limit * 4 * h, 1e-9 * limit * h);
            EXPECT_NEAR(further.summary.energy_J, slide.summary.energy_J, 1e-9 * limit * h);
            // Where contact ends, what friction has stored is lost.
            start(at_slip(9 * h, gap));
            const auto apart = evaluate(at_slip(9 * h, 1.1 * h));
            EXPECT_NEAR(apart.summary.dissipated_J - further.summary.dissipated_J,
                        further.summary.energy_J - rest.summary.energy_J, 1e-9 * limit * h);
        }
}

/// The derivative of the forces is exact where the normal does not turn; here along any motion of a block on a plane.
TEST_P(PotentialOf, DerivativesOfFrictionAreExactOnAPlane) {
    for (const auto kinematics : {model::Kinematics::plane_strain, model::Kinematics::solid})
        for (const double slip : {0.05, 3.0}) {
            model::Case model =
                with_settings(test::two_blocks(kinematics == model::Kinematics::solid ? 3 : 2, GetParam(), kinematics));
            const double h = Potential(model, std::array{modulus_Pa}).distance_m();
            model.contact.self = false;
            model.obstacles.push_back({"plane", model::Plane{{-2 * h, 0, 0}, {1, 0, 0}}, 0.6});
            Potential potential(model, std::array{modulus_Pa});
            State state{model.mesh.points, {{}}};
            state.shifts[0] = {1.5 * h, 0, 0};
            EXPECT_TRUE(potential.start_friction(state.positions, state.shifts, {}, all));
            state.shifts[0] = {1.5 * h, slip * h, 0};
            const auto direction = direction_of(model, 6, 0.3 * h);
            const auto at = derivatives(potential, state.positions, state.shifts, Wanted::hessian);
            ASSERT_TRUE(at.summary.touches());
            std::vector<double> left;
            for (const double step : {4e-3, 2e-3, 1e-3}) {
                const State next = moved(state, step, direction);
                const auto there = derivatives(potential, next.positions, next.shifts);
                double sum = 0;
                for (std::size_t p = 0; p < direction.size(); ++p) {
                    double change = there.gradient[p] - at.gradient[p];
                    for (std::size_t q = 0; q < direction.size(); ++q)
                        change -= step * at.hessian[p * direction.size() + q] * direction[q];
                    sum = std::hypot(sum, change);
                }
                left.push_back(sum);
            }
            EXPECT_GT(std::log2(left[1] / left[2]), 1.8) << left[0] << ' ' << left[1] << ' ' << left[2];
        }
}

/// Pairs of facets that are apart are not computed again until they may have moved by their distance.
TEST_P(PotentialOf, EnergyDoesNotDependOnEarlierStates) {
    const model::Case model = with_settings(test::two_blocks(3, GetParam(), model::Kinematics::solid));
    Potential potential(model, std::array{modulus_Pa});
    const double h = potential.distance_m();
    int touching = 0;
    for (double gap = 1; gap > 0.3 * h; gap -= std::max(0.05 * gap, 0.1 * h)) {
        State state{model.mesh.points, {}};
        for (Point& x : state.positions)
            if (x[0] >= 2) x[0] -= 1 - gap;
        state = moved(state, 1, direction_of(model, 3, 0.1 * h));
        Potential fresh(model, std::array{modulus_Pa});
        const auto at = derivatives(potential, state.positions, {}), again = derivatives(fresh, state.positions, {});
        EXPECT_EQ(at.summary.energy_J, again.summary.energy_J) << gap;
        EXPECT_EQ(potential.touches(state.positions, {}, [](mesh::Index) { return true; }), again.summary.touches());
        touching += again.summary.touches() ? 1 : 0;
    }
    EXPECT_GT(touching, 3);
}

/// Points in front of the small end of a block lie behind the extended planes of its long sides, which must not act.
TEST(Potential, ActsOnlyBetweenTheClosestFacetsOfABlock) {
    const auto cells = test::Cells::second_order;
    const auto left = test::block(2, test::box({0, 4}, {0, 1}), {1, 1, 1}, "left");
    const auto right = test::block(2, test::box({6, 7}, {-1, 2}), {1, 3, 1}, "right");
    const model::Case model =
        with_settings(test::make_case(test::as(cells, test::beside(left, right)), model::Kinematics::plane_strain));
    Potential potential(model, std::array{modulus_Pa});
    const double wide = 2.5 * model.contact.distance, narrow = model.contact.distance, gap = 0.5 * narrow;
    State state{model.mesh.points, {}};
    for (Point& x : state.positions)
        if (x[0] >= 6) x[0] -= 2 - gap;
    const Summary at = derivatives(potential, state.positions, {}).summary;
    const double k = 0.1 * modulus_Pa;
    EXPECT_NEAR(at.max_pressure_Pa, -0.5 * k * (barrier(gap, wide).slope + barrier(gap, narrow).slope),
                1e-9 * at.max_pressure_Pa);
    // Half of each side: on the right, the points opposite the end.
    const double expected = 0.5 * k * (barrier(gap, wide).value_m + barrier(gap, narrow).value_m);
    EXPECT_NEAR(at.energy_J, expected, 0.1 * expected);
}

double energy_J(const mesh::Mesh& undeformed, const std::vector<Point>& positions) {
    Potential potential(with_settings(test::make_case(undeformed, model::Kinematics::plane_strain)),
                        std::array{modulus_Pa});
    return derivatives(potential, positions, {}).summary.energy_J;
}

/// A strip with a concave end that folds to the other side: its parts lie behind each other's planes, and nothing has passed through.
TEST(Potential, DoesNotActBetweenPartsOfAConcaveSurfaceThatFolds) {
    mesh::Mesh mesh = test::block(
        2,
        [](double u, double v, double) {
            return Point{u < 1.0 / 3 ? 15 * u : u < 2.0 / 3 ? 4.5 + 1.5 * u : 5.3 + 0.3 * u, 0.1 * v, 0};
        },
        {3, 1, 1}, "strip");
    const auto bent = [&](double curvature) {
        std::vector<Point> points = mesh.points;
        for (Point& x : points) {
            const double angle = curvature * std::max(0.0, x[0] - 5), start = std::min(x[0], 5.0);
            x = {start + (std::sin(angle) - curvature * x[1] * std::sin(angle)) / curvature,
                 x[1] + (1 - std::cos(angle)) * (1 / curvature - x[1]), 0};
        }
        return points;
    };
    const std::vector<Point> folded = bent(-2.5);
    mesh.points = bent(2.5);
    EXPECT_EQ(energy_J(mesh, folded), 0);
}

INSTANTIATE_TEST_SUITE_P(AllCells, PotentialOf, testing::ValuesIn(test::all_cells));

}  // namespace
}  // namespace soft::contact
