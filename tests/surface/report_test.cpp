#include "surface/report.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "core/error.hpp"
#include "sample_meshes.hpp"
#include "surface/cgal_queries.hpp"
#include "surface/triangles.hpp"

namespace soft::surface {
namespace {

std::string refusal(const model::Case& model) {
    try {
        (void)check_cavities(model);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "";
}

mesh::Index node_at(const model::Case& model, const mesh::Point& p) {
    for (std::size_t i = 0; i < model.mesh.points.size(); ++i) {
        const mesh::Point& q = model.mesh.points[i];
        if (std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) < 1e-9) return static_cast<mesh::Index>(i);
    }
    ADD_FAILURE() << "no node at this point";
    return 0;
}

TEST(CheckCavities, AcceptsAClosedBoxAndReportsItsVolumeAndWall) {
    const auto reports = check_cavities(test::hollow_box(test::Hole::none));
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_EQ(reports[0].name, "cavity");
    EXPECT_TRUE(reports[0].closed);
    EXPECT_TRUE(reports[0].oriented);
    EXPECT_FALSE(reports[0].self_intersection);
    EXPECT_EQ(reports[0].triangles, 6u * 8u);
    EXPECT_NEAR(reports[0].volume_m3, 2.16, 1e-13);
    EXPECT_NEAR(reports[0].faceted_volume_m3, 2.16, 1e-13);
    EXPECT_NEAR(reports[0].min_wall_m.value(), 0.9, 1e-12);  // z = 0.9 .. 1.8
}

TEST(CheckCavities, TheFacetedVolumeOfASphereIsBelowItsVolume) {
    const auto reports = check_cavities(test::sphere_shell(4));
    const double exact = 4 * std::numbers::pi / 3;
    EXPECT_LT(reports.at(0).faceted_volume_m3, exact);
    EXPECT_NEAR(reports[0].faceted_volume_m3, exact, 0.03 * exact);
    EXPECT_NEAR(reports[0].volume_m3, exact, 4e-4 * exact);
}

TEST(CheckCavities, AcceptsAHollowRing) {
    test::Annulus ring;
    ring.centre_r = 5;
    const auto reports = check_cavities(test::annulus_section(ring, 32));
    EXPECT_NEAR(reports.at(0).volume_m3, 10 * std::pow(std::numbers::pi, 2), 1e-3);
    EXPECT_NEAR(reports[0].min_wall_m.value(), 1, 1e-4);
}

TEST(CheckCavities, RefusesAHoleWithItsLocation) {
    model::Case model = test::hollow_box(test::Hole::none);
    std::erase_if(model.mesh.facet_sets["cavity"], [&](const mesh::Facet& facet) {  // the side at x = 2.2
        for (const mesh::Index n : facet_nodes(model.mesh, facet))
            if (model.mesh.point(n)[0] != 2.2) return false;
        return true;
    });
    const std::string text = refusal(model);
    EXPECT_TRUE(text.starts_with("cavity: the cavity surface is open near x = 2200 mm, y = ")) << text;
}

TEST(CheckCavities, RefusesAnOpenSectionWithItsLocation) {
    test::Annulus ball;
    model::Case model = test::annulus_section(ball, 16);
    model.mesh.facet_sets["cavity"].pop_back();  // the last edge ends at the pole (1, 0)
    const std::string text = refusal(model);
    double x_mm = 0, r_mm = 0;
    ASSERT_EQ(std::sscanf(text.c_str(), "cavity: the cavity surface is open near x = %lf mm, r = %lf mm", &x_mm, &r_mm),
              2)
        << text;
    EXPECT_NEAR(x_mm, 1e3 * std::cos(std::numbers::pi / 16), 0.1);
    EXPECT_NEAR(r_mm, 1e3 * std::sin(std::numbers::pi / 16), 0.1);
}

TEST(CheckCavities, RefusesASelfIntersectingSectionWithItsLocation) {
    test::Annulus ring;
    ring.centre_r = 5;
    model::Case model = test::annulus_section(ring, 32);
    // moves a node from the right of the inner circle beyond its left side
    model.mesh.points[static_cast<std::size_t>(node_at(model, {1, 5, 0}))] = {-1.3, 5.01, 0};
    const std::string text = refusal(model);
    EXPECT_TRUE(text.starts_with("cavity: the cavity surface intersects itself near x = ")) << text;
    double x_mm = 0, r_mm = 0;
    ASSERT_EQ(std::sscanf(text.c_str(), "cavity: the cavity surface intersects itself near x = %lf mm, r = %lf mm",
                          &x_mm, &r_mm),
              2);
    EXPECT_NEAR(r_mm, 5000, 250);  // the spike runs along r = 5 through the left side, x = -1
    EXPECT_LT(x_mm, 0);
}

// Oracle: CGAL's search over the triangles of the whole surface.
TEST(CheckSurface, TheOutlineOfASectionIntersectsItselfExactlyIfTheSurfaceDoes) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> shift(-1.2, 1.2);
    for (const double centre_r : {0.0, 1.5, 5.0}) {
        int crossing = 0;
        for (int draw = 0; draw < 60; ++draw) {
            test::Annulus annulus;
            annulus.centre_r = centre_r;
            model::Case model = test::annulus_section(annulus, 12);
            const auto& facets = model.mesh.facet_sets.at("cavity");
            const std::vector<mesh::Index> nodes = facet_nodes(model.mesh, facets[random() % facets.size()]);
            mesh::Point& p = model.mesh.points[static_cast<std::size_t>(nodes[random() % nodes.size()])];
            p = {p[0] + shift(random), p[1] + shift(random), 0};
            Triangles surface = cavity_surface(model, model.cavities[0]);
            ASSERT_FALSE(surface.outline.empty());
            const bool crosses = check_surface(surface).intersecting.has_value();
            surface.outline.clear();
            EXPECT_EQ(crosses, check_surface(surface).intersecting.has_value())
                << "centre " << centre_r << ", " << p[0] << ", " << p[1];
            crossing += crosses ? 1 : 0;
        }
        EXPECT_GT(crossing, 5);
        EXPECT_LT(crossing, 55);
    }
}

TEST(CheckCavities, RefusesASelfIntersectingSolidWithItsLocation) {
    model::Case model = test::sphere_shell(3);
    const mesh::Index node = node_at(model, {1, 0, 0});
    model.mesh.points[static_cast<std::size_t>(node)] = {-1.4, 0.03, 0.05};
    const std::string text = refusal(model);
    double x_mm = 0, y_mm = 0, z_mm = 0;
    ASSERT_EQ(std::sscanf(text.c_str(),
                          "cavity: the cavity surface intersects itself near x = %lf mm, y = %lf mm, z = %lf mm", &x_mm,
                          &y_mm, &z_mm),
              3)
        << text;
    EXPECT_LT(std::hypot(y_mm, z_mm), 500);
}

TEST(CheckCavities, RefusesWallsThatTouch) {
    // two chambers of one cavity that share a plane: their nodes coincide but are not merged
    model::Case left = test::hollow_box(test::Hole::none);
    const auto base = static_cast<mesh::Index>(left.mesh.points.size());
    const mesh::Index cells = left.mesh.cell_count();
    const model::Case right = test::hollow_box(test::Hole::none);
    for (mesh::Point p : right.mesh.points) left.mesh.points.push_back({p[0] + 1.2, p[1], p[2]});
    for (mesh::Index c = 0; c < cells; ++c) {
        std::vector<mesh::Index> nodes;
        for (const mesh::Index n : right.mesh.cell_nodes(c)) nodes.push_back(n + base);
        add_cell(left.mesh, right.mesh.cell_type(c), nodes, 0);
    }
    for (mesh::Facet facet : right.mesh.facet_sets.at("cavity"))
        left.mesh.facet_sets["cavity"].push_back({facet.cell + cells, facet.local});
    EXPECT_NE(refusal(left).find("intersects itself near x = 2200 mm"), std::string::npos) << refusal(left);
}

TEST(CheckCavities, RefusesTheOutsideOfABody) {
    model::Case model = test::sphere_shell(2);
    model.cavities[0].wall = "outer";
    EXPECT_NE(refusal(model).find("wrong orientation"), std::string::npos) << refusal(model);
}

TEST(CheckCavities, RefusesAFaceThatTheMeshLacks) {
    model::Case model = test::sphere_shell(2);
    model.cavities[0].inner_faces = {"end"};
    EXPECT_EQ(refusal(model), "cavity: the mesh has no face 'end'");
}

TEST(InspectCavities, ReportsWhatCheckCavitiesRefuses) {
    model::Case model = test::hollow_box(test::Hole::none);
    model.mesh.facet_sets["cavity"].pop_back();
    const auto reports = inspect_cavities(model);
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_FALSE(reports[0].closed);
    EXPECT_TRUE(reports[0].open_location.has_value());
    EXPECT_TRUE(reports[0].min_wall_m.has_value());
}

}  // namespace
}  // namespace soft::surface
