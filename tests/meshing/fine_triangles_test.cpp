#include "meshing/fine_triangles.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "../surface/sample_meshes.hpp"
#include "surface/cgal_queries.hpp"

namespace soft::meshing {
namespace {

TEST(FineTriangles, StayWithinTheRequestedDeviationOfACurvedBody) {
    const model::Case shell = surface::test::sphere_shell(4);
    for (const double deviation_m : {1e-2, 1e-3}) {
        const surface::Triangles triangles = fine_triangles(shell.mesh, boundary_facets(shell.mesh), deviation_m);
        const surface::SurfaceChecks checks = surface::check_surface(triangles);
        EXPECT_TRUE(checks.closed);
        EXPECT_FALSE(checks.intersecting);
        // the triangles lie on average 2/3 of the deviation inside; second-order facets of a 22-degree grid are spheres to 1e-4
        const double exact = 4.0 / 3 * std::numbers::pi * 7;
        EXPECT_NEAR(checks.volume_m3, exact, 4 * std::numbers::pi * 5 * deviation_m + 5e-3);
    }
}

TEST(FineTriangles, AddNoPointsToFlatFacets) {
    const model::Case box = surface::test::hollow_box(surface::test::Hole::none);
    const surface::Triangles triangles = fine_triangles(box.mesh, boundary_facets(box.mesh), 1e-6);
    EXPECT_EQ(triangles.triangles.size(), 8 * boundary_facets(box.mesh).size());
    EXPECT_NEAR(surface::check_surface(triangles).volume_m3, 3.4 * 3.1 * 3.8 - 1.2 * 1.0 * 1.8, 1e-12);
}

}  // namespace
}  // namespace soft::meshing
