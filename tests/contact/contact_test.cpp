#include <gtest/gtest.h>

#include "contact_samples.hpp"

namespace soft::contact {
namespace {

using mesh::Index;
using mesh::Point;
using test::Cells;
using test::contact;
using test::Motion;

using std::numbers::pi;

Motion right_block_moved(double x) {
    return [x](const Point& X) { return Point{X[0] + (X[0] >= 2 ? x : 0), X[1], X[2]}; };
}

/// The contact where the right block just touches the left one; expects none before.
auto contact_of_blocks(const model::Case& model) {
    const ContactFinder finder(model);
    EXPECT_FALSE(contact(finder, model, right_block_moved(0)));
    EXPECT_FALSE(contact(finder, model, right_block_moved(-1 + 1e-12)));
    return contact(finder, model, right_block_moved(-1 - 1e-12));
}

class EveryCell : public testing::TestWithParam<Cells> {};

TEST_P(EveryCell, ContactOfTwoBlocksOfASectionIsDetectedExactly) {
    for (const auto kinematics : {model::Kinematics::plane_strain, model::Kinematics::axisymmetric}) {
        const model::Case model = test::two_blocks(2, GetParam(), kinematics);
        const auto found = contact_of_blocks(model);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->location[0], 1, 1e-11);
        EXPECT_GE(found->location[1], 0.4 - 1e-12);
        EXPECT_LE(found->location[1], 0.6 + 1e-12);
        EXPECT_NE(found->text.find("the faces left and right touch at x = 1000 mm, "), std::string::npos)
            << found->text;
        EXPECT_NE(found->text.find(kinematics == model::Kinematics::axisymmetric ? "r = " : "y = "), std::string::npos);
    }
}

TEST_P(EveryCell, ContactOfTwoSolidBlocksIsDetectedExactly) {
    const model::Case model = test::two_blocks(3, GetParam(), model::Kinematics::solid);
    const auto found = contact_of_blocks(model);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->location[0], 1, 1e-11);
    EXPECT_NEAR(found->location[1], 0.5, 0.1 + 1e-12);
    EXPECT_NEAR(found->location[2], 0.5, 0.2 + 1e-12);
    EXPECT_NE(found->text.find("left and right touch"), std::string::npos) << found->text;
}

/// Three squares or cubes around an inner corner, whose two walls touch when every angle about it is stretched by 4/3.
TEST_P(EveryCell, ACreaseIsClosedWhenItsWallsTouch) {
    for (const int dimension : {2, 3}) {
        test::MeshBuilder builder(dimension);
        for (const auto& [x, y] :
             {std::pair{test::Interval{0, 1}, test::Interval{0, 1}}, {{-1, 0}, {0, 1}}, {{-1, 0}, {-1, 0}}})
            builder.add_block(test::of_dimension(dimension, test::box(x, y, {0, 1})), 1, 1);
        const model::Case model =
            test::make_case(test::as(GetParam(), builder.take()),
                            dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid);
        const ContactFinder finder(model);
        const auto stretched = [](double factor) {
            return [factor](const Point& X) {
                const double middle = 0.75 * pi, angle = std::remainder(std::atan2(X[1], X[0]) - middle, 2 * pi);
                const double r = std::hypot(X[0], X[1]);
                return Point{r * std::cos(middle + factor * angle), r * std::sin(middle + factor * angle), X[2]};
            };
        };
        EXPECT_FALSE(contact(finder, model, stretched(1)));
        EXPECT_FALSE(contact(finder, model, stretched(4 / 3.0 - 1e-6))) << dimension;
        EXPECT_TRUE(contact(finder, model, stretched(4 / 3.0 + 1e-6))) << dimension;
    }
}

INSTANTIATE_TEST_SUITE_P(Contact, EveryCell, testing::ValuesIn(test::all_cells),
                         [](const auto& test) { return test::cells_name(test.param); });

/// Two bumps of radius 1 whose tops are `gap` apart.
TEST(Contact, ContactOfCurvedWallsIsFoundToAFewPercentOfACell) {
    const auto bump = [](double sign) {
        return [sign](double u, double v, double) {
            const double angle = (2 * u - 1) * 0.6 * sign;  // keeps the orientation of both
            const double top = sign * (std::cos(angle) - 1.2), foot = -sign * 0.6;
            return Point{std::sin(angle + 0.013), std::lerp(foot, top, v), 0};  // avoids a symmetric mesh
        };
    };
    const auto lower = test::block(2, bump(1), {7, 1, 1}, "lower"),
               upper = test::block(2, bump(-1), {8, 1, 1}, "upper");
    const model::Case model = test::make_case(test::beside(lower, upper), model::Kinematics::plane_strain);
    const std::size_t first_of_upper = lower.points.size();
    const ContactFinder finder(model);
    const auto closed_to = [&](double gap) {
        std::vector<double> u(3 * model.mesh.points.size());
        for (std::size_t p = 0; p < model.mesh.points.size(); ++p)
            u[3 * p + 1] = p < first_of_upper ? 0.2 - gap / 2 : gap / 2 - 0.2;
        return finder.find(u);
    };
    EXPECT_FALSE(closed_to(0.4));
    double open = 0.4, overlapping = -0.1;
    ASSERT_TRUE(closed_to(overlapping));
    while (open - overlapping > 1e-9)
        (closed_to((open + overlapping) / 2) ? overlapping : open) = (open + overlapping) / 2;
    EXPECT_NEAR(open, 0, 2e-4);  // a cell is 0.17 long and rises by 0.0037; chords of its quarters miss 1/16 of that
    EXPECT_NEAR(closed_to(overlapping)->location[0], 0, 0.17 / 4);
}

/// Self-intersections of the outline of a meander of two periods, as arc length and side, from dense polygons.
std::vector<std::array<double, 2>> crossings_of_outline(const test::Meander& meander) {
    constexpr int segments = 400;
    std::vector<std::array<double, 2>> found;
    for (const double side : {-1.0, 1.0}) {
        std::vector<Point> outline;
        for (int i = 0; i <= segments; ++i) outline.push_back(meander(2.0 * i / segments, side));
        const auto turn = [&](int a, int b, int c) {
            const auto &p = outline[static_cast<std::size_t>(a)], &q = outline[static_cast<std::size_t>(b)],
                       &r = outline[static_cast<std::size_t>(c)];
            return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0;
        };
        for (int i = 0; i < segments; ++i)
            for (int j = i + 2; j < segments; ++j)
                if (turn(i, i + 1, j) != turn(i, i + 1, j + 1) && turn(j, j + 1, i) != turn(j, j + 1, i + 1))
                    for (const int k : {i, j}) found.push_back({2.0 * k / segments, side});
    }
    return found;
}

TEST(Contact, FoldsOfABellowsTouchWhereTheirOutlinesIntersect) {
    constexpr int cells = 48;  // along two periods
    model::Case model = test::make_case(test::block(2, test::box({0, 2}, {-1, 1}, {0, 0}), {cells, 1, 1}, "wall"),
                                        model::Kinematics::plane_strain);
    const std::vector<Point> parameters = model.mesh.points;
    const test::Meander start{0.8};
    for (Point& p : model.mesh.points) p = start(p[0], p[1]);
    const ContactFinder finder(model);
    const auto folded = [&](double swing) {
        std::vector<double> u;
        for (std::size_t p = 0; p < parameters.size(); ++p) {
            const Point x = test::Meander{swing}(parameters[p][0], parameters[p][1]);
            for (std::size_t d = 0; d < 3; ++d) u.push_back(x[d] - model.mesh.points[p][d]);
        }
        return finder.find(u);
    };
    const auto first_swing = [](const auto& touches) {
        double open = 0.8, closed = 2.2;
        while (closed - open > 1e-5) (touches((open + closed) / 2) ? closed : open) = (open + closed) / 2;
        return closed;
    };
    const double expected = first_swing([](double swing) { return !crossings_of_outline({swing}).empty(); });
    const double measured = first_swing([&](double swing) { return folded(swing).has_value(); });
    EXPECT_NEAR(measured, expected, 2e-3);
    const auto found = folded(measured);
    double nearest = 1;
    for (const auto& [s, t] : crossings_of_outline({expected + 1e-4})) {
        const Point p = start(s, t);
        nearest = std::min(nearest, std::hypot(p[0] - found->location[0], p[1] - found->location[1]));
    }
    EXPECT_LT(nearest, 0.1 * 2.0 / cells);
    EXPECT_NE(found->text.find("the face wall touches itself at x = "), std::string::npos) << found->text;
}

/// An upside-down L attached to the plane x = 0 (on the side of `sign`), whose leg can bend towards the plane.
model::Case hanging_leg(int dimension, Cells cells, double sign) {
    test::MeshBuilder builder(dimension);
    const auto part = [&](test::Interval x, test::Interval y) {
        return test::of_dimension(dimension, test::box(sign > 0 ? x : test::Interval{-x.to, -x.from}, y, {0, 0.5}));
    };
    builder.add_block(part({0, 1}, {3, 4}), 2, 2);
    builder.add_block(part({1, 2}, {3, 4}), 2, 2);
    builder.add_block(part({1, 2}, {0.5, 3}), 2, 5);
    builder.name_facets("leg", [](const Point&) { return true; });
    model::Case model = test::make_case(test::as(cells, builder.take()),
                                        dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid);
    model.symmetry_planes = {true, false, dimension == 3};
    return model;
}

TEST_P(EveryCell, ALegThatBendsTowardsItsMirrorImageTouchesItAtTheTip) {
    for (const int dimension : {2, 3})
        for (const double sign : {1.0, -1.0}) {
            const model::Case model = hanging_leg(dimension, GetParam(), sign);
            const ContactFinder finder(model);
            const auto swung = [sign](double by) {
                return [=](const Point& X) {
                    return Point{X[0] - sign * by * std::max(0.0, 3 - X[1]) / 2.5, X[1], X[2]};
                };
            };
            EXPECT_FALSE(contact(finder, model, swung(0)));
            EXPECT_FALSE(contact(finder, model, swung(1 - 1e-6)));
            const auto found = contact(finder, model, swung(1 + 1e-6));
            ASSERT_TRUE(found);
            EXPECT_NEAR(found->location[0], sign, 1e-12);
            EXPECT_NEAR(found->location[1], 0.5, 1e-9);
            EXPECT_EQ(found->facets[0], found->facets[1]);
            EXPECT_NE(found->text.find("the face leg touches its mirror image at x = "), std::string::npos)
                << found->text;
        }
}

TEST(Contact, ACurvedWallTouchesItsMirrorImageBetweenNodes) {
    const model::Case model = [] {
        model::Case half = test::make_case(test::block(2, test::box({0.3, 1}, {-1, 1}, {0, 0}), {2, 1, 1}, "wall"),
                                           model::Kinematics::plane_strain);
        half.symmetry_planes[0] = true;
        return half;
    }();
    const ContactFinder finder(model);
    const auto bent = [](double gap) {  // the inner wall becomes the parabola x = gap + (y - 0.37)^2 / 5
        return [gap](const Point& X) { return Point{X[0] - 0.3 + gap + (X[1] - 0.37) * (X[1] - 0.37) / 5, X[1], 0}; };
    };
    EXPECT_FALSE(contact(finder, model, bent(1e-7)));
    const auto found = contact(finder, model, bent(-1e-7));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->location[1], 0.37, 1e-3);
}

/// Where contact is solved: a wall that is a thousandth of its height beyond the plane is allowed, unless its cell is inverted.
TEST(Contact, AnInvertedCellBeyondASymmetryPlaneIsReportedWhereContactIsSolved) {
    model::Case model = test::make_case(test::block(2, test::box({0.3, 1}, {-1, 1}, {0, 0}), {1, 1, 1}, "wall"),
                                        model::Kinematics::plane_strain);
    model.symmetry_planes[0] = true;
    model.path.contact = model::Contact::solve;
    const ContactFinder finder(model);
    const auto moved = [](double middle) {
        return [=](const Point& X) {
            return Point{X[0] < 0.4                           ? 0.1 * X[1] * X[1] - 2e-3
                         : X[0] < 0.9 && std::abs(X[1]) < 0.5 ? middle
                                                              : X[0],
                         X[1], 0};
        };
    };
    EXPECT_FALSE(contact(finder, model, moved(0.5)));
    const auto found = contact(finder, model, moved(-0.1));
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->is_inverted);
}

/// Two neighbouring curved facets fold until they intersect at a fifth of their length from their common node, where contact is solved.
/// With t from the common node, they are x = 1 +- (t / 4 - 5 t^2 / 4), y = t.
TEST(Contact, AFoldBetweenNeighboursIsFoundWithinTheFirstPiecesOfTheirSubdivision) {
    for (const int dimension : {2, 3}) {
        model::Case model =
            test::make_case(test::block(dimension, test::box({0, 2}, {-4, 1}, {0, 1}), {2, 1, 1}, "top"),
                            dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid);
        model.path.contact = model::Contact::solve;
        model.contact.distance = 0.005;
        const auto folded = [](double by) {
            return [by](const Point& X) {
                const double t = std::abs(X[0] - 1), bulge = by * t - (1 + by) * t * t;
                return X[1] < 1 ? X : Point{X[0] < 1 ? 1 + bulge : 1 - bulge, t, X[2]};
            };
        };
        EXPECT_FALSE(contact(model, folded(-0.01))) << dimension;
        EXPECT_TRUE(contact(model, folded(0.25))) << dimension;
        if (dimension == 3) continue;
        model.contact.distance = 0.05;
        EXPECT_FALSE(contact(model, folded(0.25)));
    }
}

TEST(Contact, ARingThatClosesTouchesTheAxis) {
    const model::Case model = test::annulus_section({.centre_r = 3, .inner_radius = 0.5, .outer_radius = 1}, 24);
    const ContactFinder finder(model);
    const auto shrunk = [](double by) { return [by](const Point& X) { return Point{X[0], X[1] - by, 0}; }; };
    EXPECT_FALSE(contact(finder, model, shrunk(2 - 1e-6)));
    const auto found = contact(finder, model, shrunk(2 + 1e-6));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->location[0], 0, 1e-3);
    EXPECT_NEAR(found->location[1], 2, 1e-5);
    EXPECT_NE(found->text.find("an unnamed face touches the axis at x = "), std::string::npos) << found->text;
}

/// The upper side of a cell at the axis (x, r) follows r(s) through 0, 0.24 and 1, so that r < 0 near the axis. At a crater the surface
/// then crosses its mirror image through air, at a spike through rubber.
TEST(Contact, AClosingCraterTouchesTheAxisAndASpikeIsInverted) {
    const auto drawn = [](double tip) {
        return [tip](const Point& X) {
            const double s = X[1], middle = 4 * s * (1 - s), end = s * (2 * s - 1);
            return X[0] < 1 ? X : Point{tip * (1 - s) * (1 - 2 * s) + middle + end, 0.24 * middle + end, 0};
        };
    };
    model::Case model =
        test::make_case(test::block(2, test::box({0, 1}, {0, 1}), {1, 1, 1}, "top"), model::Kinematics::axisymmetric);
    const auto is_inverted = [&](double tip) {
        const auto found = contact(model, drawn(tip));
        return found ? std::optional(found->is_inverted) : std::nullopt;
    };
    EXPECT_EQ(is_inverted(0.5), false);
    EXPECT_EQ(is_inverted(2), true);
    model.kinematics = model::Kinematics::plane_strain;
    model.symmetry_planes[1] = true;
    EXPECT_EQ(is_inverted(0.5), false);
    EXPECT_EQ(is_inverted(2), true);
}

/// The right wall of a block becomes the parabola x = 1 + reach - (y - 0.37)^2 / 5, whose tip lies between nodes.
TEST(Contact, ACurvedWallInAnObstacleIsFoundBetweenNodes) {
    const auto bulged = [](double reach) {
        return [reach](const Point& X) {
            return Point{X[0] + X[0] * (reach - (X[1] - 0.37) * (X[1] - 0.37) / 5), X[1], 0};
        };
    };
    const model::FacetedSurface square{{{1.5, -2, 0}, {3, -2, 0}, {3, 2, 0}, {1.5, 2, 0}},
                                       {{3, 0, -1}, {0, 1, -1}, {1, 2, -1}, {2, 3, -1}}};
    const std::vector<model::Obstacle> obstacles{
        {"plane", model::Plane{{1.5, 0, 0}, {-1, 0, 0}}, 0},
        {"cylinder", model::Cylinder{{11.5, 0.37, 0}, {0, 0, 1}, 10, model::Side::outside}, 0},
        {"sleeve", model::Sphere{{-8.5, 0.37, 0}, 10, model::Side::inside}, 0},
        {"square", square, 0}};
    constexpr double depth = 0.02;  // more than the height of the tip above the points of the subdivision
    for (const model::Obstacle& obstacle : obstacles) {
        model::Case model = test::make_case(test::block(2, test::box({0, 1}, {-1, 1}), {2, 1, 1}, "wall"),
                                            model::Kinematics::plane_strain);
        model.path.contact = model::Contact::solve;
        model.contact.distance = 0.005;
        model.obstacles = {obstacle};
        const ContactFinder finder(model);
        EXPECT_FALSE(contact(finder, model, bulged(0.5 - 1e-6))) << obstacle.name;
        const auto found = contact(finder, model, bulged(0.5 + depth));
        ASSERT_TRUE(found) << obstacle.name;
        EXPECT_FALSE(found->is_inverted);
        EXPECT_NEAR(found->location[1], 0.37, 0.15) << obstacle.name;
        EXPECT_NE(found->text.find("wall touches the obstacle '" + obstacle.name + "'"), std::string::npos)
            << found->text;
        const std::vector<Vector3> away{{depth + 1e-6, 0, 0}}, nearer{{-depth, 0, 0}}, two(2);
        EXPECT_FALSE(finder.find(test::displacement(model, bulged(0.5 + depth)), away)) << obstacle.name;
        EXPECT_TRUE(finder.find(test::displacement(model, bulged(0.5)), nearer)) << obstacle.name;
        EXPECT_THROW((void)finder.find(test::displacement(model, bulged(0.5)), two), std::logic_error);
    }
}

TEST(Contact, InitiallyTouchingWallsAreExcludedAndOthersAreFound) {
    for (const int dimension : {2, 3}) {
        const auto left = test::block(dimension, test::box({0, 1}, {0, 1}, {0, 1}), {1, 2, 2}, "left");
        const auto flush = test::block(dimension, test::box({1, 2}, {0, 1}, {0, 1}), {1, 2, 2}, "flush");
        const auto apart = test::block(dimension, test::box({3, 4}, {0.1, 0.9}, {0.1, 0.9}), {1, 1, 1}, "apart");
        const model::Case model =
            test::make_case(test::beside(test::beside(left, flush), apart),
                            dimension == 2 ? model::Kinematics::plane_strain : model::Kinematics::solid);
        const ContactFinder finder(model);
        for (const double by : {-0.1, 0.0, 1e-9, 0.01})  // of the flush block and the one apart, against the left one
            EXPECT_FALSE(contact(finder, model, [by](const Point& X) {
                return Point{X[0] * (1 - by), X[1], X[2]};
            })) << by;
        std::vector<double> pressed(3 * model.mesh.points.size());  // a small overlap
        for (std::size_t p = left.points.size(); p < left.points.size() + flush.points.size(); ++p)
            pressed[3 * p] = -0.01;
        EXPECT_FALSE(finder.find(pressed));
        const auto found = contact(finder, model, [](const Point& X) {
            return Point{X[0] - (X[0] >= 3 ? 1.01 : 0), X[1], X[2]};
        });
        ASSERT_TRUE(found);
        EXPECT_NE(found->text.find("flush and apart touch"), std::string::npos) << found->text;
    }
}

/// Two squares one above the other that share a node on the right and none on the left: an initially closed slit.
TEST(Contact, AnInitiallyClosedSlitMayOpenAndCloseAgain) {
    test::MeshBuilder builder(2);
    builder.add_block(test::of_dimension(2, test::box({0, 1}, {-1, 0})), 2, 1);
    builder.add_block(test::of_dimension(2, test::box({0, 1}, {1e-9, 1})), 2,
                      1);  // so that the builder does not merge the nodes
    builder.add_block(test::of_dimension(2, test::box({1, 2}, {-1, 0})), 1, 1);
    model::Case model = test::make_case(builder.take(), model::Kinematics::plane_strain);
    const std::vector<Point> built = model.mesh.points;
    for (Point& p : model.mesh.points)
        if (p[1] == 1e-9) p[1] = 0;
    std::vector<Index> tips;
    for (std::size_t p = 0; p < model.mesh.points.size(); ++p)
        if (model.mesh.points[p] == Point{1, 0, 0}) tips.push_back(static_cast<Index>(p));
    ASSERT_EQ(tips.size(), 2u);
    for (Index& node : model.mesh.connectivity)
        if (node == tips[1]) node = tips[0];
    const ContactFinder finder(model);
    for (const double opening : {0.0, 0.1, 1e-12, 0.0}) {
        std::vector<double> u(3 * built.size());
        for (std::size_t p = 0; p < built.size(); ++p)
            if (built[p][1] > 0) u[3 * p + 1] = opening * (1 - built[p][0]);
        EXPECT_FALSE(finder.find(u)) << opening;
    }
}

TEST(Contact, RefusesADisplacementOfAnotherMesh) {
    const model::Case model = test::two_blocks(2, Cells::first_order, model::Kinematics::plane_strain);
    EXPECT_THROW((void)ContactFinder(model).find(std::vector<double>(3)), std::logic_error);
}

}  // namespace
}  // namespace soft::contact
