#include "meshing/part_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "soups.hpp"

namespace soft::meshing {
namespace {

using std::numbers::pi;

/// A disc about x from x = 0 to `height`, with a rim of `around` quadrilaterals; inside another body it becomes a cavity.
FacetSoup disc(double height, double radius, std::size_t around) {
    FacetSoup soup;
    for (std::size_t k = 0; k < around; ++k) {
        const double angle = 2 * pi * static_cast<double>(k) / static_cast<double>(around);
        for (const double x : {0.0, height})
            soup.points.push_back({x, radius * std::cos(angle), radius * std::sin(angle)});
    }
    const std::size_t low = soup.points.size(), high = low + 1;
    soup.points.push_back({0, 0, 0});
    soup.points.push_back({height, 0, 0});
    for (std::size_t k = 0; k < around; ++k) {
        const std::size_t a = 2 * k, b = 2 * ((k + 1) % around);
        soup.facets.push_back({low, b, a});
        soup.facets.push_back({high, a + 1, b + 1});
        soup.facets.push_back({a, b, b + 1});
        soup.facets.push_back({a, b + 1, a + 1});
    }
    return soup;
}

/// The outline is a polygon of n corners, so the rim has the area of n chords.
TEST(PartFaces, ADiscHasTwoPlanesAndACylinder) {
    constexpr double n = 64, chord = 2 * 8 * 0.049067674327418015;  // sin(pi / 64)
    const auto faces = part_faces(test::made(disc(5, 8, 64)));
    ASSERT_EQ(faces.size(), 3u);
    const auto rim = std::ranges::find(faces, PartFace::Shape::cylinder, &PartFace::shape);
    ASSERT_NE(rim, faces.end());
    EXPECT_NEAR(rim->radius_m, 8e-3, 1e-9);
    EXPECT_NEAR(rim->direction[0], 1, 1e-9);
    EXPECT_NEAR(rim->centre[0], 2.5e-3, 1e-9);
    EXPECT_NEAR(rim->area_m2, n * chord * 5 * 1e-6, 1e-12);
    EXPECT_FALSE(rim->is_bore);
    for (const PartFace& face : faces) {
        ASSERT_TRUE(face.rule.has_value());
        if (face.shape == PartFace::Shape::cylinder) continue;
        EXPECT_EQ(face.shape, PartFace::Shape::plane);
        ASSERT_TRUE(face.rule->plane.has_value());
        EXPECT_EQ(face.rule->plane->component, 0u);
        EXPECT_NEAR(face.direction[0], face.rule->plane->at_m > 1e-3 ? 1 : -1, 1e-12);
    }
}

TEST(PartFaces, ACylindricalCavityIsABore) {
    FacetSoup hole = disc(4, 3, 48);
    for (mesh::Point& p : hole.points) p[0] += 3;
    const auto faces = part_faces(test::made(test::joined(test::box_soup({0, -9, -9}, {10, 9, 9}), hole)));
    EXPECT_EQ(faces.size(), 9u);
    const auto bore = std::ranges::find(faces, PartFace::Shape::cylinder, &PartFace::shape);
    ASSERT_NE(bore, faces.end());
    EXPECT_TRUE(bore->is_bore);
    EXPECT_NEAR(bore->radius_m, 3e-3, 1e-9);
    for (const PartFace& face : faces) EXPECT_TRUE(face.rule.has_value());
}

TEST(PartFaces, ABallIsCurved) {
    const auto faces = part_faces(test::made(test::ball_soup({0, 0, 0}, 5)));
    ASSERT_EQ(faces.size(), 1u);
    EXPECT_EQ(faces[0].shape, PartFace::Shape::curved);
}

TEST(PartFaces, EachRuleSelectsItsFace) {
    const BodySurface surface =
        test::made(test::joined(test::box_soup({0, 0, 0}, {4, 5, 6}), test::box_soup({1, 1, 1}, {2, 2, 2})));
    const auto faces = part_faces(surface);
    EXPECT_EQ(faces.size(), 12u);
    for (const PartFace& face : faces) {
        ASSERT_TRUE(face.rule.has_value());
        const auto all = named_faces(surface, {*face.rule});
        EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(all.back().facets, true)), face.facets.size());
    }
}

}  // namespace
}  // namespace soft::meshing
