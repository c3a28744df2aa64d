/// Deformations without contact, however large they are.
#include <gtest/gtest.h>

#include "contact_samples.hpp"

namespace soft::contact {
namespace {

using mesh::Point;
using test::Cells;
using test::contact;
using test::Motion;

TEST(NoContact, FacetsOnSymmetryPlanesAndTheAxisAreNotContact) {
    model::Case ball = test::annulus_section({}, 12);
    EXPECT_FALSE(contact(ball, [](const Point& X) { return Point{X[0], 3 * X[1], 0}; }));
    EXPECT_FALSE(contact(ball, [](const Point& X) { return Point{X[0], 0.2 * X[1], 0}; }));
    const model::Case quarter = test::quarter_box(test::Hole::to_the_right);
    EXPECT_FALSE(contact(quarter, [](const Point& X) { return Point{X[0], 0.3 * X[1], 4 * X[2]}; }));
}

struct Body {
    std::string name;
    model::Case model;
};

/// Each body with every kind of cells.
std::vector<Body> bodies() {
    std::vector<Body> all;
    all.push_back({"ring", test::annulus_section(
                               {.centre_r = 0.001, .inner_radius = 1, .outer_radius = 1.5, .shift = {0.2, 0.1}}, 24)});
    all.back().model.kinematics = model::Kinematics::plane_strain;  // the axis is not a mirror
    all.push_back({"box", test::hollow_box(test::Hole::to_the_right)});
    all.push_back({"shell", test::sphere_shell(3)});
    all.push_back({"blocks", test::two_blocks(3, Cells::second_order, model::Kinematics::solid)});
    std::vector<Body> of_all_cells;
    for (const Body& body : all)
        for (const Cells cells : test::all_cells) {
            of_all_cells.push_back({body.name + ' ' + test::cells_name(cells), body.model});
            of_all_cells.back().model.mesh = test::as(cells, body.model.mesh);
        }
    return of_all_cells;
}

TEST(NoContact, RotatedTranslatedAndScaledBodiesHaveNoContact) {
    for (const auto& [name, model] : bodies()) {
        const ContactFinder finder(model);
        const double about_x = model.mesh.dimension == 3 ? 2.1 : 0;
        for (const double scale : {0.01, 1.0, 30.0})
            EXPECT_FALSE(contact(finder, model, test::placed(about_x, 4.0, scale, {3, -20, 0}))) << name << scale;
    }
}

// r -> sqrt(r^2 + 30^2) preserves the area: the wall thickness decreases from 0.02 to 0.0007, while the pieces of the facets deviate by
// 0.004 from their curve. The outside is rotated relative to the inside, so that their pieces are not parallel.
TEST(NoContact, TheSidesOfAStronglyThinnedWallDoNotTouch) {
    const Motion inflated = [](const Point& X) {
        const double r = std::hypot(X[0], X[1]), angle = std::atan2(X[1], X[0]) + 0.8 * (r - 1),
                     to = std::hypot(r, 30.0);
        return Point{to * std::cos(angle), to * std::sin(angle), 0};
    };
    for (const int through : {1, 2, 3}) {
        test::MeshBuilder builder(2);
        builder.add_block(
            [](double u, double v, double) {
                const double angle = (1.5 - u) * std::numbers::pi, r = 1 + 0.02 * v;
                return Point{r * std::cos(angle), r * std::sin(angle), 0};
            },
            40, through, 1);
        model::Case arch;
        arch.kinematics = model::Kinematics::plane_strain;
        arch.mesh = builder.take();
        EXPECT_FALSE(contact(arch, inflated)) << through << " cells through the wall";
    }
}

/// The middle of the wall is pushed through itself: its cells are inverted where its sides cross, and no air is between them.
TEST(NoContact, AnInvertedWallIsNotReportedAsContact) {
    const Motion crushed = [](const Point& X) {
        return Point{X[0], X[1] * (1 - 1.5 * std::exp(-X[0] * X[0] - X[2] * X[2])), X[2]};
    };
    for (const int dimension : {2, 3})
        for (const int through : {1, 2, 3, 4})
            for (const Cells cells : test::all_cells) {
                const auto wall = test::block(dimension, test::box({-4, 4}, {0, 1}, {0, 4}), {16, through, 8}, "wall");
                model::Case model = test::make_case(
                    test::as(cells, wall), dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid);
                model.symmetry_planes[2] = dimension == 3;
                const auto found = contact(model, crushed);
                ASSERT_TRUE(found || through < 3) << dimension << " D, " << through << " through the wall";
                if (!found) continue;  // the sides of one cell, or of two
                EXPECT_TRUE(found->is_inverted) << dimension << " D, " << through << " through the wall";
                EXPECT_NE(found->text.find("the wall between the face wall and the face wall is inverted at x = "),
                          std::string::npos)
                    << found->text;
            }
}

TEST(NoContact, LargeSmoothOneToOneDeformationsGiveNoFalsePositive) {
    for (const auto& [name, model] : bodies()) {
        const ContactFinder finder(model);
        for (unsigned seed = 0; seed < 25; ++seed)
            for (const double wave_number : {0.5, 1.5}) {
                const Motion motion = test::wobble(seed, 0.9, wave_number);
                const auto found = contact(finder, model, model.mesh.dimension == 2 ? test::in_plane(motion) : motion);
                EXPECT_FALSE(found) << name << ' ' << seed << ": " << found->text;
            }
    }
}

}  // namespace
}  // namespace soft::contact
