#include "surface/volume.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sample_meshes.hpp"

namespace soft::surface {
namespace {

double volume(const model::Case& model) {
    return enclosed_volume_m3(model, cavity_facets(model, model.cavities.front()), model.mesh.points);
}

std::vector<mesh::Point> moved(const model::Case& model, const std::function<mesh::Point(const mesh::Point&)>& map) {
    std::vector<mesh::Point> positions;
    for (const mesh::Point& p : model.mesh.points) positions.push_back(map(p));
    return positions;
}

TEST(EnclosedVolume, OfABoxIsLengthTimesWidthTimesHeight) {
    EXPECT_NEAR(volume(test::hollow_box(test::Hole::none)), 1.2 * 1.0 * 1.8, 1e-13);
}

TEST(EnclosedVolume, ClosesAnOpeningWithAFlatPlug) {
    EXPECT_NEAR(volume(test::hollow_box(test::Hole::to_the_right)), 2.4 * 1.0 * 1.8, 1e-13);
}

TEST(EnclosedVolume, OfAQuarterModelIsThatOfTheWhole) {
    EXPECT_NEAR(volume(test::quarter_box(test::Hole::none)), 1.2 * 1.0 * 1.8, 1e-13);
    EXPECT_NEAR(volume(test::quarter_box(test::Hole::to_the_right)), 2.4 * 1.0 * 1.8, 1e-13);
}

TEST(EnclosedVolume, IsTranslationInvariant) {
    const model::Case model = test::hollow_box(test::Hole::to_the_right);
    const auto facets = cavity_facets(model, model.cavities.front());
    const auto far = moved(model, [](const mesh::Point& p) { return mesh::Point{p[0] + 7, p[1] - 3, p[2] + 11}; });
    EXPECT_NEAR(enclosed_volume_m3(model, facets, far), 4.32, 1e-11);
}

TEST(EnclosedVolume, OfAnOpeningAwayFromTheSymmetryPlaneIsClosedByAFlatPlug) {
    model::Case model = test::hollow_box(test::Hole::to_the_right);
    for (mesh::Point& p : model.mesh.points) p[0] += 7;
    model.symmetry_planes = {true, false, false};
    EXPECT_NEAR(volume(model), 4.32, 1e-11);
}

TEST(EnclosedVolume, ScalesWithTheDeterminantOfALinearMap) {
    const model::Case model = test::hollow_box(test::Hole::to_the_right);
    const auto facets = cavity_facets(model, model.cavities.front());
    const auto sheared = moved(model, [](const mesh::Point& p) {
        return mesh::Point{1.5 * p[0] + 0.3 * p[1], 1.2 * p[1] - 0.2 * p[2], 0.8 * p[2] + 0.1 * p[0]};
    });
    const double determinant = 1.5 * (1.2 * 0.8) - 0.3 * (0 * 0.8 + 0.2 * 0.1);
    EXPECT_NEAR(enclosed_volume_m3(model, facets, sheared), 4.32 * determinant, 1e-12);
}

TEST(EnclosedVolume, OfAQuarterModelFollowsASymmetricDeformation) {
    const model::Case model = test::quarter_box(test::Hole::to_the_right);
    const auto stretched = moved(model, [](const mesh::Point& p) {
        return mesh::Point{2 * p[0], 1.5 * p[1], 0.5 * p[2]};
    });
    EXPECT_NEAR(enclosed_volume_m3(model, cavity_facets(model, model.cavities.front()), stretched), 4.32 * 1.5, 1e-12);
}

TEST(EnclosedVolume, OfASphereConvergesWithFourthOrder) {
    const double exact = 4 * std::numbers::pi / 3;
    const double coarse = volume(test::sphere_shell(2)) - exact, fine = volume(test::sphere_shell(4)) - exact;
    EXPECT_LT(std::abs(coarse), 5e-3 * exact);
    EXPECT_LT(std::abs(fine), 4e-4 * exact);
    EXPECT_GT(std::log2(std::abs(coarse / fine)), 3.5);
}

TEST(EnclosedVolume, OfARevolvedHalfCircleIsThatOfTheBall) {
    test::Annulus ball;
    ball.shift = {0.3, 0};
    EXPECT_NEAR(volume(test::annulus_section(ball, 24)), 4 * std::numbers::pi / 3, 1e-5);
}

TEST(EnclosedVolume, OfARevolvedCircleFollowsPappusTheorem) {
    test::Annulus ring;
    ring.centre_r = 5;
    ring.shift = {0.2, -0.4};
    EXPECT_NEAR(volume(test::annulus_section(ring, 48)), 2 * std::numbers::pi * 4.6 * std::numbers::pi, 1e-4);
}

TEST(Rims, OfAQuarterModelEndAtTheSymmetryPlanes) {
    const model::Case closed = test::quarter_box(test::Hole::none), open = test::quarter_box(test::Hole::to_the_right);
    EXPECT_TRUE(rims(closed, cavity_facets(closed, closed.cavities.front())).empty());
    const auto chains = rims(open, cavity_facets(open, open.cavities.front()));
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_EQ(chains[0].size(), 2u);
}

TEST(Rims, EachOpeningHasOneRim) {
    model::Case model = test::hollow_box(test::Hole::none);
    auto& wall = model.mesh.facet_sets["cavity"];
    std::erase_if(wall, [&](const mesh::Facet& facet) {  // both ends along z, which share no node
        double z = 0;
        for (const mesh::Index n : facet_nodes(model.mesh, facet)) z += model.mesh.point(n)[2] / 9;
        return std::abs(z) > 0.8;
    });
    EXPECT_EQ(rims(model, wall).size(), 2u);
    EXPECT_NEAR(enclosed_volume_m3(model, wall, model.mesh.points), 1.2 * 1.0 * 1.8, 1e-13);
}

}  // namespace
}  // namespace soft::surface
