#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/potential.hpp"
#include "contact_samples.hpp"

namespace soft::contact {
namespace {

model::Case with_contact(model::Case model) {
    model.mesh.region_names = {"rubber"};
    model.mesh.cell_regions.assign(model.mesh.cell_types.size(), 0);
    model.path.contact = model::Contact::solve;
    return model;
}

bool touches(const model::Case& model, const std::vector<mesh::Point>& positions) {
    return Potential(model, std::array{1e6}).touches(positions, {}, [](mesh::Index) { return true; });
}

/// A flat surface that becomes a sharp ridge: each side is behind the other, with rubber between them. In a fold that has closed too far they are
/// behind each other too, but each has passed through the other.
TEST(Ridge, ItsSidesDoNotTouchEachOther) {
    for (const auto cells : test::all_cells)
        for (const auto kinematics : {model::Kinematics::plane_strain, model::Kinematics::solid}) {
            const int dimension = kinematics == model::Kinematics::solid ? 3 : 2;
            const auto strip = test::block(dimension, test::box({-1, 1}, {-1, 0}, {0, 1}), {2, 1, 1}, "strip");
            const model::Case model = with_contact(test::make_case(test::as(cells, strip), kinematics));
            const auto touches_at = [&](double width, double deeper, double height) {
                auto positions = model.mesh.points;
                for (mesh::Point& x : positions)
                    x = {x[0] * (width - deeper * x[1]), x[1] + height * std::abs(x[0]), x[2]};
                return touches(model, positions);
            };
            EXPECT_FALSE(touches_at(0.5, 0, -2)) << test::cells_name(cells);
            EXPECT_FALSE(touches_at(0.3, 0, -2)) << test::cells_name(cells);
            EXPECT_FALSE(touches_at(0.3, 0.7, 2)) << test::cells_name(cells);
            EXPECT_TRUE(touches_at(-0.02, 1.02, 2)) << test::cells_name(cells);
        }
}

/// The area of an incompressible wall grows as its thickness falls: its sides, with four cells between them, approach each other through rubber.
TEST(Wall, ItsSidesDoNotTouchWhenItIsStretched) {
    for (const auto kinematics : {model::Kinematics::axisymmetric, model::Kinematics::solid}) {
        const bool solid = kinematics == model::Kinematics::solid;
        const auto wall = test::block(solid ? 3 : 2, test::box({0, 1}, {1, 1.4}, {0, 1}), {2, 4, 2}, "wall");
        const model::Case model = with_contact(test::make_case(wall, kinematics));
        for (const double stretch : {2.0, solid ? 3.0 : 5.0}) {
            const double radius = solid ? 1 : stretch, depth = solid ? stretch : 1, thinner = 1 / (stretch * stretch);
            auto positions = model.mesh.points;
            for (mesh::Point& x : positions) x = {stretch * x[0], radius + thinner * (x[1] - 1), depth * x[2]};
            EXPECT_FALSE(touches(model, positions)) << solid << ' ' << stretch;
        }
    }
}

/// The side of a web lies in one plane with a point of the outer surface of the wall above it. When the wall turns, that point is behind the
/// side's plane, with rubber between them.
TEST(Wall, ItsWebDoesNotTouchItWhenItTurns) {
    test::MeshBuilder builder(2);
    for (const auto& [x, y] :
         {std::pair{test::Interval{-1, 0}, test::Interval{-4, 0}}, {{-1, 0}, {0, 1}}, {{0, 6}, {0, 1}}})
        builder.add_block(test::box(x, y), 1, 1, 1);
    const mesh::Mesh mesh = builder.take();
    const double angle = 40 * std::numbers::pi / 180;
    std::vector<mesh::Point> positions = mesh.points;
    for (mesh::Point& x : positions) {
        if (x[1] < 0) continue;
        const double right = std::max(x[0], 0.0), share = std::min(1 + x[0], 1.0);  // of the turn, over the web
        const mesh::Point turned{std::cos(angle) * right - std::sin(angle) * x[1],
                                 std::sin(angle) * right + std::cos(angle) * x[1], 0};
        x = {std::lerp(-1, turned[0], share), std::lerp(x[1], turned[1], share), 0};
    }
    EXPECT_FALSE(touches(with_contact(test::make_case(mesh, model::Kinematics::plane_strain)), positions));
}

/// The lower side of a neck is in front of the face above the neck, with rubber between them. When the neck is stretched and turned down, that side
/// is behind the face.
TEST(Wall, ItsStepDoesNotTouchTheFarSideOfTheNeck) {
    test::MeshBuilder builder(2);
    for (const auto& [x, y] :
         {std::pair{test::Interval{-1, 0}, test::Interval{0, 1}}, {{-1, 0}, {1, 2}}, {{0, 3}, {0, 1}}})
        builder.add_block(test::box(x, y), 1, 1, 1);
    const mesh::Mesh mesh = builder.take();
    for (const double degrees : {60.0, 70.0, 80.0}) {
        const double angle = degrees * std::numbers::pi / 180, thinner = 0.3;
        std::vector<mesh::Point> positions = mesh.points;
        for (mesh::Point& x : positions) {
            if (x[1] > 1) continue;
            const double right = std::max(x[0], 0.0), up = thinner * (x[1] - 1), share = std::min(1 + x[0], 1.0);
            const mesh::Point turned{std::cos(angle) * right + std::sin(angle) * up,
                                     1 - std::sin(angle) * right + std::cos(angle) * up, 0};
            x = {std::lerp(-1, turned[0], share), std::lerp(x[1], turned[1], share), 0};
        }
        EXPECT_FALSE(touches(with_contact(test::make_case(mesh, model::Kinematics::plane_strain)), positions))
            << degrees;
    }
}

/// An acute edge, one side of which does not face the plate below, passes through the plate's surface: the energy has no jump.
TEST(Edge, PressesOnAPlateWithoutAJump) {
    test::MeshBuilder builder(2);
    for (const auto& [x, y] : {std::pair{test::Interval{-2, 3}, test::Interval{-1, 0}}, {{0, 1}, {1, 2}}})
        builder.add_block(test::box(x, y), 1, 1, 1);
    const model::Case model = with_contact(test::make_case(builder.take(), model::Kinematics::plane_strain));
    Potential potential(model, std::array{1e6});
    const auto energy_J = [&](double gap) {
        auto positions = model.mesh.points;
        for (mesh::Point& x : positions)
            if (x[1] > 0.5) {
                const double left = 1 - x[0], up = x[1] - 1;
                x = {1 - 2 * left - 0.8 * up, gap + 0.3 * left + 1.4 * up, 0};
            }
        return potential
            .evaluate(
                positions, {}, Wanted::gradient, [](mesh::Index) { return true; }, [](const Block&) {})
            .energy_J;
    };
    EXPECT_GT(energy_J(1e-9), 0);
    EXPECT_NEAR(energy_J(-1e-9), energy_J(1e-9), 1e-5 * energy_J(1e-9));
}

/// A right-angled edge slides over the plate along one facet, between its sample points and over them.
TEST(Edge, PressesEvenlyWhileItSlides) {
    test::MeshBuilder builder(2);
    builder.add_block(test::box({-2, 3}, {-1, 0}), 5, 1, 1);
    builder.add_block(test::box({0, 1}, {1, 2}), 1, 1, 1);
    const model::Case model = with_contact(test::make_case(builder.take(), model::Kinematics::plane_strain));
    Potential potential(model, std::array{1e6});
    double least_J = INFINITY, most_J = 0;
    for (double at = 0.2; at < 0.8; at += 0.002) {
        auto positions = model.mesh.points;
        for (mesh::Point& x : positions)
            if (x[1] > 0.5)
                x = {at + std::numbers::sqrt2 / 2 * (x[0] - x[1] + 1),
                     0.01 + std::numbers::sqrt2 / 2 * (x[0] + x[1] - 1), 0};
        const double energy_J =
            potential
                .evaluate(
                    positions, {}, Wanted::gradient, [](mesh::Index) { return true; }, [](const Block&) {})
                .energy_J;
        least_J = std::min(least_J, energy_J);
        most_J = std::max(most_J, energy_J);
    }
    EXPECT_LT(most_J, 1.3 * least_J);
}

}  // namespace
}  // namespace soft::contact
