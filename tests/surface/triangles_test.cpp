#include "surface/triangles.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "sample_meshes.hpp"
#include "surface/cgal_queries.hpp"

namespace soft::surface {
namespace {

TEST(CavitySurface, OfARevolvedSectionHasTheVolumeOfTheRevolvedOutline) {
    // tube r = 1, x = 0 .. 3: its outline is straight, so the faceted volume is exactly that of the cylinder
    test::MeshBuilder builder(2);
    builder.add_block([](double u, double v, double) { return mesh::Point{3 * u, 1 + v, 0}; }, 6, 2);
    builder.name_facets("cavity", [](const mesh::Point& p) { return p[1] == 1; });
    model::Case model = test::make_case(builder.take(), model::Kinematics::axisymmetric);
    model.cavities[0].openings = {{.face = "left", .area_m2 = std::numbers::pi, .direction = {-1, 0, 0}},
                                  {.face = "right", .area_m2 = std::numbers::pi, .direction = {1, 0, 0}}};
    const SurfaceChecks checks = check_surface(cavity_surface(model, model.cavities[0]));
    EXPECT_TRUE(checks.closed);
    EXPECT_TRUE(checks.outward);
    EXPECT_FALSE(checks.intersecting);
    EXPECT_NEAR(checks.volume_m3, 3 * std::numbers::pi, 1e-12);
}

TEST(CavitySurface, ClosesDeclaredOpeningsOnly) {
    model::Case model = test::hollow_box(test::Hole::to_the_right);
    EXPECT_FALSE(check_surface(cavity_surface(model, model.cavities[0])).closed);
    model.cavities[0].openings = {{.face = "outer", .area_m2 = 1.8, .direction = {-1, 0, 0}}};  // wrong direction
    EXPECT_FALSE(check_surface(cavity_surface(model, model.cavities[0])).closed);
    model.cavities[0].openings = {{.face = "outer", .area_m2 = 1.8, .direction = {1, 0, 0}}};
    const SurfaceChecks checks = check_surface(cavity_surface(model, model.cavities[0]));
    EXPECT_TRUE(checks.closed);
    EXPECT_NEAR(checks.volume_m3, 4.32, 1e-13);
}

TEST(CavitySurface, OfAQuarterIsMirroredToTheWhole) {
    model::Case model = test::quarter_box(test::Hole::to_the_right);
    model.cavities[0].openings = {{.face = "outer", .area_m2 = 1.8, .direction = {1, 0, 0}}};
    const SurfaceChecks checks = check_surface(cavity_surface(model, model.cavities[0]));
    EXPECT_TRUE(checks.closed);
    EXPECT_TRUE(checks.outward);
    EXPECT_NEAR(checks.volume_m3, 4.32, 1e-13);
}

TEST(CavitySurface, OfHalfASectionIsMirroredAtItsPlane) {
    test::MeshBuilder builder(2);  // quarter circle x >= 0 of a ball
    builder.add_block(
        [](double u, double v, double) {
            const double angle = (1 - u) * std::numbers::pi / 2, radius = 1 + v;
            return mesh::Point{u == 0 ? 0 : radius * std::cos(angle), u == 1 ? 0 : radius * std::sin(angle), 0};
        },
        8, 1);
    builder.name_facets("cavity", [](const mesh::Point& p) { return std::hypot(p[0], p[1]) < 1.1; });
    model::Case model = test::make_case(builder.take(), model::Kinematics::axisymmetric);
    model.symmetry_planes = {true, false, false};
    model.model_fraction = 0.5;
    const SurfaceChecks checks = check_surface(cavity_surface(model, model.cavities[0]));
    EXPECT_TRUE(checks.closed);
    EXPECT_TRUE(checks.outward);
    EXPECT_NEAR(checks.volume_m3, 4 * std::numbers::pi / 3, 0.01 * 4);
}

TEST(CheckSurface, TwoBodiesConnectedAtAPointAreNotClosed) {
    Triangles surface;  // two closed tetrahedra that share the origin
    surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    surface.model_points = surface.points;
    surface.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}};
    surface.facets.assign(8, 0);
    const SurfaceChecks checks = check_surface(surface);
    EXPECT_FALSE(checks.closed);
    EXPECT_TRUE(checks.open_location.has_value());
}

}  // namespace
}  // namespace soft::surface
