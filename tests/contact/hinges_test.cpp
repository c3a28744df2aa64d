#include "contact/hinges.hpp"

#include <gtest/gtest.h>

#include "contact_samples.hpp"
#include "surface/free_facets.hpp"

namespace soft::contact {
namespace {

using std::numbers::pi;

/// Three of the four squares (or columns) around the origin, whose inner corner is a hinge of 3/4 of a turn.
model::Case three_squares(int dimension, test::Cells cells) {
    test::MeshBuilder builder(dimension);
    for (const auto& [x, y] :
         {std::pair{test::Interval{0, 1}, test::Interval{0, 1}}, {{-1, 0}, {0, 1}}, {{-1, 0}, {-1, 0}}})
        builder.add_block(test::of_dimension(dimension, test::box(x, y, {0, 1})), 1, 1);
    return test::make_case(test::as(cells, builder.take()),
                           dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid);
}

TEST(Hinges, TheFilledAngleMayExceedAFullTurn) {
    for (const int dimension : {2, 3})
        for (const test::Cells cells : test::all_cells) {
            const model::Case model = three_squares(dimension, cells);
            const std::vector<mesh::Facet> facets = surface::free_facets(model);
            int inner = 0;
            for (const Hinge& hinge : hinges(model.mesh, facets)) {
                bool at_origin = true;
                for (const mesh::Index end : hinge.vertices)
                    at_origin = at_origin && std::hypot(model.mesh.point(end)[0], model.mesh.point(end)[1]) == 0;
                if (!at_origin) continue;
                ++inner;
                for (const double factor : {0.5, 1.0, 1.3, 1.35, 1.6}) {  // of every angle about the hinge
                    std::vector<mesh::Point> turned;
                    for (const mesh::Point& p : model.mesh.points) {
                        const double r = std::hypot(p[0], p[1]),
                                     angle = std::remainder(std::atan2(p[1], p[0]) - 0.75 * pi, 2 * pi);
                        turned.push_back({r * std::cos(factor * angle), r * std::sin(factor * angle), p[2]});
                    }
                    EXPECT_NEAR(filled_angle(model.mesh, hinge, turned), factor * 1.5 * pi,
                                1e-7);  // acos near 0 and pi
                }
            }
            EXPECT_EQ(inner, 1);
        }
}

TEST(Hinges, AreAllEdgesOfABoxExceptThoseOnASymmetryPlane) {
    model::Case model =
        test::make_case(test::block(3, test::box({0, 1}, {0, 1}, {0, 1}), {1, 1, 1}, "box"), model::Kinematics::solid);
    EXPECT_EQ(hinges(model.mesh, surface::free_facets(model)).size(), 12u);
    for (const Hinge& hinge : hinges(model.mesh, surface::free_facets(model)))
        EXPECT_NEAR(filled_angle(model.mesh, hinge, model.mesh.points), pi / 2, 1e-12);
    model.symmetry_planes = {true, false, false};
    EXPECT_EQ(hinges(model.mesh, surface::free_facets(model)).size(), 8u);
}

}  // namespace
}  // namespace soft::contact
