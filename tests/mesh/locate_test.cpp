#include "mesh/locate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/raise_order.hpp"
#include "pieces.hpp"

namespace soft::mesh {
namespace {

Mesh bent_mesh(Mesh mesh) {
    for (Point& point : mesh.points) point = mesh.dimension == 2 ? sample::bent_in_plane(point) : sample::bent(point);
    return mesh;
}

Point position(const Mesh& mesh, const Location& found) {
    Point sum{};
    for (std::size_t a = 0; a < found.weights.size(); ++a)
        for (std::size_t i = 0; i < 3; ++i) sum[i] += found.weights[a] * mesh.point(mesh.cell_nodes(found.cell)[a])[i];
    return sum;
}

/// A point inside every cell is found, and the weights reproduce its position.
TEST(Locate, WeightsReproduceThePositionInEveryCellType) {
    for (const Mesh& mesh :
         {sample::triangles_and_quadrilaterals(), bent_mesh(raise_order(sample::triangles_and_quadrilaterals())),
          sample::wedges_and_hexahedra(), bent_mesh(raise_order(sample::wedges_and_hexahedra())), sample::tetrahedra(),
          bent_mesh(raise_order(sample::tetrahedra()))})
        for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
            const std::array<double, 3> xi{0.21, 0.34, mesh.dimension == 3 ? 0.17 : 0.0};
            Point wanted{};
            const auto shapes = shape_values(mesh.cell_type(cell), xi);
            for (std::size_t a = 0; a < shapes.size(); ++a)
                for (std::size_t i = 0; i < 3; ++i)
                    wanted[i] += shapes[a].value * mesh.point(mesh.cell_nodes(cell)[a])[i];
            const auto found = locate(mesh, wanted);
            ASSERT_TRUE(found.has_value()) << cell;
            EXPECT_EQ(found->cell, cell);
            const Point back = position(mesh, *found);
            double sum = 0;
            for (const double weight : found->weights) sum += weight;
            EXPECT_NEAR(sum, 1.0, 1e-12);
            for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back[i], wanted[i], 1e-12) << cell;
        }
}

TEST(Locate, FindsEveryNode) {
    const Mesh mesh = bent_mesh(raise_order(sample::wedges_and_hexahedra()));
    for (const Point& node : mesh.points) {
        const auto found = locate(mesh, node);
        ASSERT_TRUE(found.has_value());
        const Point back = position(mesh, *found);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(back[i], node[i], 1e-12);
    }
}

TEST(Locate, FindsNothingOutsideTheMesh) {
    const Mesh mesh = sample::triangles_and_quadrilaterals();  // the rectangle [0, 2] x [0, 1]
    for (const Point& point : {Point{-0.1, 0.5, 0}, Point{2.1, 0.5, 0}, Point{0.5, 1.1, 0}, Point{9, 9, 0}})
        EXPECT_FALSE(locate(mesh, point).has_value()) << point[0] << " " << point[1];
    EXPECT_TRUE(locate(mesh, {-0.001, 0.5, 0}).has_value());  // within the tolerance
    EXPECT_EQ(mesh.point(nearest_node(mesh, {2.1, 1.2, 0})), (Point{2, 1, 0}));
}

}  // namespace
}  // namespace soft::mesh
