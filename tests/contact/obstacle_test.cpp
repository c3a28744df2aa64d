#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "../fem/block_mesh.hpp"
#include "contact/contact.hpp"
#include "contact/potential.hpp"
#include "potential_samples.hpp"

namespace soft::contact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A board in front of the block [0, 1] x [0, 1], between x = 2 and 2 + thickness and from y = -1 to `end`.
std::vector<model::Obstacle> boards(double thickness, double end = 2) {
    const double back = 2 + thickness;
    return {{"box", model::Box{{2, -1, -infinity}, {back, end, infinity}, 0.01 * thickness}},
            {"profile", model::FacetedSurface{{{2, -1, 0}, {back, -1, 0}, {back, end, 0}, {2, end, 0}},
                                              {{0, 1, -1}, {1, 2, -1}, {2, 3, -1}, {3, 0, -1}}}}};
}

model::Case block_before(const model::Obstacle& obstacle) {
    model::Case model =
        block_case(mesh::CellType::quad9, model::Kinematics::plane_strain, model::Formulation::displacement, {.n = 2});
    model.mesh.region_names = {"rubber"};
    model.mesh.cell_regions.assign(model.mesh.cell_types.size(), 0);
    model.path.contact = model::Contact::solve;
    model.obstacles.push_back(obstacle);
    return model;
}

std::vector<mesh::Point> moved(const model::Case& model, double way, double beside) {
    auto positions = model.mesh.points;
    for (mesh::Point& x : positions) {
        x[0] += way;
        x[1] += beside;
    }
    return positions;
}

/// A step through an obstacle that is thinner than the step ends where it enters; beside it, and along it, nothing is shortened.
TEST(ThinObstacle, IsNotJumpedOver) {
    for (const double thickness : {0.1, 0.01, 0.001})
        for (const model::Obstacle& obstacle : boards(thickness)) {
            const model::Case model = block_before(obstacle);
            Potential potential(model, std::array{1e5});
            const std::vector<Vector3> shifts(1);
            const auto share = [&](double from, double to, double beside) {
                return potential.share_without_crossing(moved(model, from, beside), shifts, moved(model, to, beside),
                                                        shifts);
            };
            const auto passes = [&](double from, double to, double beside) {
                return potential.passes_through(moved(model, from, beside), shifts, moved(model, to, beside), shifts);
            };
            EXPECT_NEAR(share(0, 4, 0), 0.25, 0.01) << obstacle.name << thickness;  // from x = 1 to the board
            EXPECT_LT(share(0.999, 1 + thickness, 0), 1) << obstacle.name << thickness;
            EXPECT_EQ(share(0, 0.9, 0), 1);
            EXPECT_EQ(share(0, 4, 10), 1);
            EXPECT_TRUE(passes(0, 4, 0)) << obstacle.name << thickness;
            EXPECT_TRUE(passes(4, 0, 0)) << obstacle.name << thickness;
            EXPECT_FALSE(passes(0, 0.999, 0));
            EXPECT_FALSE(passes(0, 4, 10));
            EXPECT_TRUE(passes(1, 1 + 1.5 * thickness, 0)) << obstacle.name << thickness;  // they touch
            EXPECT_FALSE(passes(1, 0.9, 0)) << obstacle.name << thickness;
            EXPECT_FALSE(passes(1, 1, 0.3)) << obstacle.name << thickness;
            // The same where the board moves.
            EXPECT_TRUE(potential.passes_through(model.mesh.points, shifts, model.mesh.points, {{{-4, 0, 0}}}));
        }
}

/// The face passes a post that stands 0.3 beside its middle: it would be pressed in, and is not on another side of the post's axis than before.
TEST(RoundObstacle, IsNotPassedOffItsCentre) {
    const model::Case model = block_before({"post", model::Cylinder{{2, 1.45, 0}, {0, 0, 1}, 0.5}});
    Potential potential(model, std::array{1e5});
    const std::vector<Vector3> shifts(1);
    const auto passes = [&](double way, double beside) {
        return potential.passes_through(model.mesh.points, shifts, moved(model, way, beside), shifts);
    };
    EXPECT_TRUE(passes(3, 0));
    EXPECT_FALSE(passes(3, -1));
    EXPECT_FALSE(passes(0.4, 0));
    EXPECT_TRUE(potential.passes_through(model.mesh.points, shifts, model.mesh.points, {{{-3, 0, 0}}}));
}

/// Of the radius R, about a point at x = 1 + `away`: it touches the block at (1, 0.5) if R = away.
std::vector<model::Obstacle> round_obstacles(double radius, double away) {
    constexpr int segments = 2000;
    const mesh::Point centre{1 + away, 0.5, 0};
    model::FacetedSurface polygon;
    for (int i = 0; i < segments; ++i) {
        const double angle = 2 * std::numbers::pi * i / segments;
        polygon.points.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle), 0});
        polygon.facets.push_back({i, (i + 1) % segments, -1});
    }
    return {{"cylinder", model::Cylinder{centre, {0, 0, 1}, radius, model::Side::outside}}, {"polygon", polygon}};
}

/// The contact distance h is 2 % of facets of 0.5. Nothing acts without motion; then as on an obstacle that is smaller by h, which acts from its
/// distance of h on. A different offset at each point would give the obstacle a dent.
TEST(RoundObstacle, ThatTouchesAtTheStartKeepsItsShape) {
    constexpr double radius = 3, h = 0.01;
    for (std::size_t k = 0; k < 2; ++k) {
        const model::Case touching = block_before(round_obstacles(radius, radius)[k]),
                          smaller = block_before(round_obstacles(radius - h, radius)[k]);
        const auto energy = [](const model::Case& model, double way) {
            Potential potential(model, std::array{1e5});
            const std::vector<Vector3> shifts(1);
            return potential
                .evaluate(
                    moved(model, way, 0), shifts, Wanted::gradient, [](mesh::Index) { return true; },
                    [](const Block&) {})
                .energy_J;
        };
        EXPECT_EQ(energy(touching, 0), 0);
        for (const double way : {0.3 * h, 2 * h, 4 * h}) {
            EXPECT_GT(energy(touching, way), 0);
            EXPECT_NEAR(energy(touching, way) / energy(smaller, way), 1, k == 0 ? 1e-9 : 1e-2) << way;
        }
    }
}

/// A face that is draped over an edge of 60 degrees slides over it.
TEST(SharpObstacle, IsNotPassedThroughByWhatSlidesOverItsEdge) {
    const double half = std::tan(std::numbers::pi / 6);
    const model::Case model =
        block_before({"wedge", model::FacetedSurface{{{2, 0.5, 0}, {3, 0.5 - half, 0}, {3, 0.5 + half, 0}},
                                                     {{0, 1, -1}, {1, 2, -1}, {2, 0, -1}}}});
    const Potential potential(model, std::array{1e5});
    const std::vector<Vector3> shifts(1);
    const double depth = 0.1 * potential.distance_m();
    for (const double way : {0.001, 0.01, 0.1})
        EXPECT_FALSE(
            potential.passes_through(moved(model, 1 + depth, -way), shifts, moved(model, 1 + depth, way), shifts));
}

/// The back of a thin obstacle does not act on what is in front of it, or has gone less than half of its thickness into it.
TEST(ThinObstacle, ActsAsAThickOne) {
    for (std::size_t kind : {0U, 1U})
        for (const double thickness : {0.1, 0.02, 0.008})
            for (const auto& [way, end] :
                 {std::pair{0.995, 2.0}, {0.9995, 2.0}, {1.003, 2.0}, {0.995, 1.03}, {1.003, 1.03}}) {
                if (kind == 0 && end < 2) continue;  // the edges of a box are rounded by its thickness
                const auto at = [&, end = end, way = way](double board) {
                    const model::Case model = block_before(boards(board, end)[kind]);
                    Potential potential(model, std::array{1e5});
                    return potential.evaluate(
                        moved(model, way, 0), std::vector<Vector3>(1), Wanted::gradient,
                        [](mesh::Index) { return true; }, [](const Block&) {});
                };
                const Summary thin = at(thickness), thick = at(1);
                EXPECT_GT(thin.energy_J, 0);
                EXPECT_NEAR(thin.energy_J, thick.energy_J, 1e-9 * thick.energy_J) << kind << ' ' << thickness;
                EXPECT_NEAR(thin.max_pressure_Pa, thick.max_pressure_Pa, 1e-9 * thick.max_pressure_Pa);
            }
}

/// A disc before a plane: its tip on the axis is stopped on its own, however large its cells, and the derivatives are exact also where contact
/// acts on the deformed area.
TEST(AxisOfRevolution, ATipDoesNotPassThroughAPlane) {
    const auto block = test::block(2, test::box({0, 1}, {0, 1}), {1, 1, 1}, "block");
    model::Case model = with_settings(test::make_case(block, model::Kinematics::axisymmetric));
    const double h = Potential(model, std::array{modulus_Pa}).distance_m();
    model.obstacles.push_back({"plane", model::Plane{{1 + 2 * h, 0, 0}, {-1, 0, 0}}});
    Potential potential(model, std::array{modulus_Pa});
    for (const double stretch : {1.0, 3.0}) {
        State state{model.mesh.points, {{}}};
        for (mesh::Point& x : state.positions) {
            x[1] *= stretch;
            if (x[0] > 0.99) x[0] += 1.5 * h;
        }
        expect_exact_derivatives(potential, state, direction_of(model, 6, 0.5 * h));
        const double area_m2 = derivatives(potential, state.positions, state.shifts).summary.area_m2[0];
        EXPECT_NEAR(area_m2, std::numbers::pi * stretch * stretch, 1e-9 * area_m2);
    }
    State tip{model.mesh.points, {{}}};
    for (mesh::Point& x : tip.positions)
        if (x[0] > 0.99) x[0] -= x[1] < 0.01 ? -2.2 * h : 20 * h;
    EXPECT_GT(derivatives(potential, tip.positions, tip.shifts).summary.energy_J, 0);
}

/// The area of a half that touches its mirror image is half of that of the pair, as if both walls were in the mesh.
TEST(SymmetryPlane, HalfOfTheAreaIsThatOfTheHalf) {
    const auto block = test::block(2, test::box({1, 2}, {0, 1}), {2, 2, 1}, "block");
    model::Case model = with_settings(test::make_case(block, model::Kinematics::plane_strain));
    model.symmetry_planes[0] = true;
    Potential potential(model, std::array{modulus_Pa});
    State state{model.mesh.points, {}};
    for (mesh::Point& x : state.positions) x[0] += 0.5 * potential.distance_m() - 1;
    EXPECT_NEAR(derivatives(potential, state.positions, state.shifts).summary.area_m2[0], 0.5, 1e-9);
}

/// A point that is pressed onto the axis of revolution is pushed away, the harder the nearer: its area vanishes there, its resistance must not.
TEST(AxisOfRevolution, RepelsWhatIsPressedOntoIt) {
    const auto block = test::block(2, test::box({0, 1}, {1, 2}), {2, 2, 1}, "block");
    model::Case model = test::make_case(block, model::Kinematics::axisymmetric);
    model.mesh.region_names = {"rubber"};
    model.mesh.cell_regions.assign(model.mesh.cell_types.size(), 0);
    model.path.contact = model::Contact::solve;
    Potential potential(model, std::array{1e5});
    const double h = potential.distance_m();
    double force = 0;
    for (const double radius : {0.9, 0.5, 0.2, 0.1, 0.0, -0.3}) {
        auto positions = model.mesh.points;
        for (mesh::Point& x : positions) x[1] += radius * h - 1;
        double outward = 0;
        const auto add = [&](const Block& b) {
            for (std::size_t n = 0; n < b.nodes.size(); ++n) outward -= b.gradient[b.nodes.size() + n];
        };
        static_cast<void>(potential.evaluate(
            positions, {}, Wanted::gradient, [](mesh::Index) { return true; }, add));
        EXPECT_GT(outward, force) << radius;
        force = outward;
    }
}

/// A face that is moved into an obstacle cannot give way, unless it may slide along an inclined one; the other faces can.
TEST(Obstacle, WhatIsDrivenIntoItIsTold) {
    for (const bool is_inclined : {false, true})
        for (const bool is_moved : {false, true}) {
            model::Case model = block_before(
                {"wall", model::Plane{{2, 0, 0}, is_inclined ? Vector3{-0.8, 0.6, 0} : Vector3{-1, 0, 0}}, 0});
            if (is_moved) model.motions.push_back({"boundary", {0.0, std::nullopt, std::nullopt}});
            std::vector<double> displacement_m(3 * model.mesh.points.size());
            for (std::size_t n = 0; n < model.mesh.points.size(); ++n) displacement_m[3 * n] = 1.3;
            const auto found = ContactFinder(model).find(displacement_m);
            ASSERT_TRUE(found);
            EXPECT_EQ(found->is_driven, is_moved && !is_inclined);
        }
}

}  // namespace
}  // namespace soft::contact
