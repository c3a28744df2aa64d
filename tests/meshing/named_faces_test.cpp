#include "meshing/named_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "soups.hpp"
#include "surface/facet_map.hpp"

namespace soft::meshing {
namespace {

/// Sum of the facets' areas [m^2].
double area_m2(const BodySurface& surface, const NamedFace& face) {
    BodySurface part;
    part.points = surface.points;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        if (face.facets[t]) part.triangles.push_back(surface.triangles[t]);
    return part.area_m2();
}

FaceRule rule(std::string name) { return {std::move(name), {}, {}, {}, {}}; }

/// A block of 10 x 20 x 30 mm with a hole of 4 x 4 mm along z, 20 mm deep, from the side z = 0; one shell.
BodySurface drilled_block() {
    FacetSoup soup = test::joined(test::box_soup({0, 0, 0}, {10, 20, 30}), test::box_soup({3, 8, 0}, {7, 12, 20}));
    // Replaces the sides z = 0 of both (the first two facets of each box) by the ring between their rims.
    soup.facets.erase(soup.facets.begin() + 12, soup.facets.begin() + 14);
    soup.facets.erase(soup.facets.begin(), soup.facets.begin() + 2);
    const std::array<std::size_t, 4> outer{0, 1, 3, 2}, inner{8, 9, 11, 10};
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        soup.facets.push_back({outer[k], inner[k], outer[next]});
        soup.facets.push_back({inner[k], inner[next], outer[next]});
    }
    return test::made(soup);
}

TEST(NamedFaces, EachShellIsAFace) {
    const BodySurface hollow =
        test::made(test::joined(test::box_soup({0, 0, 0}, {10, 10, 10}), test::box_soup({2, 2, 2}, {4, 4, 4})));
    const auto faces = named_faces(hollow, {});
    ASSERT_EQ(faces.size(), 2u);
    EXPECT_EQ(faces[0].name, "outer");
    EXPECT_NEAR(area_m2(hollow, faces[0]), 6e-4, 1e-15);
    EXPECT_EQ(faces[1].name, "cavity");
    EXPECT_NEAR(area_m2(hollow, faces[1]), 24e-6, 1e-16);
}

TEST(NamedFaces, PlaneBoxAndDirectionRulesSelectTheExpectedAreas) {
    const BodySurface block = drilled_block();
    std::vector<FaceRule> rules{rule("rim"), rule("inside"), rule("up"), rule("up_at_the_top")};
    rules[0].plane = FaceRule::Plane{2, 0};
    rules[1].box = FaceRule::Box{{2e-3, 7e-3, 0}, {8e-3, 13e-3, 21e-3}};
    rules[2].direction = FaceRule::Direction{{0, 0, 5}, 0.1};
    rules[3].direction = rules[2].direction;
    rules[3].plane = FaceRule::Plane{2, 30e-3};
    const auto faces = named_faces(block, rules);
    ASSERT_EQ(faces.size(), 5u);
    EXPECT_NEAR(area_m2(block, faces[1]), (200 - 16) * 1e-6, 1e-15);         // the side of the block without the hole
    EXPECT_NEAR(area_m2(block, faces[2]), (4 * 4 * 20 + 16) * 1e-6, 1e-15);  // the hole's walls and bottom
    EXPECT_NEAR(area_m2(block, faces[3]), 200e-6, 1e-15);  // the bottom of the hole faces down, out of the rubber
    EXPECT_NEAR(area_m2(block, faces[4]), 200e-6, 1e-15);
}

TEST(NamedFaces, AFloodEndsAtSharpEdgesOrAtTheGivenFaces) {
    const BodySurface block = drilled_block();
    std::vector<FaceRule> rules{rule("rim"), rule("bottom"), rule("chamber")};
    rules[0].plane = FaceRule::Plane{2, 0};
    rules[1].flood = FaceRule::Flood{{5e-3, 10e-3, 19e-3}, {}};
    rules[2].flood = FaceRule::Flood{{5e-3, 10e-3, 19e-3}, {"rim"}};
    const auto faces = named_faces(block, rules);
    EXPECT_NEAR(area_m2(block, faces[2]), 16e-6, 1e-15);
    EXPECT_NEAR(area_m2(block, faces[3]), (4 * 4 * 20 + 16) * 1e-6, 1e-15);
    EXPECT_THROW(static_cast<void>(named_faces(block, {rules[2]})), std::logic_error);
}

TEST(NamedFaces, SmoothBendsAreNotSharpAndFaceBoundariesAreCreases) {
    const BodySurface ball = test::made(test::ball_soup({0, 0, 0}, 10, 48));
    EXPECT_TRUE(creases_of(ball, {}).empty());
    FaceRule half = rule("half");
    half.box = FaceRule::Box{{0, -1, -1}, {1, 1, 1}};
    const auto faces = named_faces(ball, {half});
    EXPECT_NEAR(area_m2(ball, faces[1]) / ball.area_m2(), 0.5, 1e-9);
    EXPECT_EQ(creases_of(ball, faces).size(), 48u);  // the equator
    EXPECT_EQ(creases_of(test::made(test::box_soup({0, 0, 0}, {1, 1, 1})), {}).size(), 12u);
}

}  // namespace
}  // namespace soft::meshing
