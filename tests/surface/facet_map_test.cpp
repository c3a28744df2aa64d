#include "surface/facet_map.hpp"

#include <gtest/gtest.h>

namespace soft::surface {
namespace {

using mesh::CellType;
constexpr std::array facet_types{CellType::line2,     CellType::line3, CellType::triangle3,
                                 CellType::triangle6, CellType::quad4, CellType::quad9};

/// A facet whose nodes are the images of its reference nodes.
template <class Map>
FacetMap image_of(CellType type, Map map) {
    FacetMap facet{type, {}};
    std::size_t a = 0;
    for (const auto& xi : mesh::topology(type).nodes) facet.nodes[a++] = map(xi[0], xi[1]);
    return facet;
}

TEST(FacetMap, HitsItsNodes) {
    for (const CellType type : facet_types) {
        const FacetMap facet = image_of(type, [](double u, double v) {
            return mesh::Point{1 + u - v * v, 2 * v + u * v, u * u};
        });
        std::size_t a = 0;
        for (const auto& xi : mesh::topology(type).nodes) {
            const mesh::Point x = facet({xi[0], mesh::dimension(type) == 1 ? 0 : xi[1]}).x;
            for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(x[d], facet.nodes[a][d], 1e-15);
            ++a;
        }
    }
}

TEST(FacetMap, ReproducesAQuadraticMapWithItsTangents) {
    const auto map = [](double u, double v) { return mesh::Point{1 + u - v * v, 2 * v + u * v, u * u - v}; };
    for (const CellType type : {CellType::triangle6, CellType::quad9}) {
        const auto at = image_of(type, map)({0.3, 0.2});
        const mesh::Point x = map(0.3, 0.2);
        const Vector t1{1, 0.2, 0.6}, t2{-0.4, 2.3, -1};
        for (std::size_t d = 0; d < 3; ++d) {
            EXPECT_NEAR(at.x[d], x[d], 1e-14);
            EXPECT_NEAR(at.t1[d], t1[d], 1e-14);
            EXPECT_NEAR(at.t2[d], t2[d], 1e-14);
        }
    }
}

TEST(FacetRule, IntegratesTheFifthDegreeExactly) {
    double line = 0, square = 0, triangle = 0;
    for (const auto& [xi, w] : facet_rule(mesh::Shape::line)) line += w * (std::pow(xi[0], 4) + std::pow(xi[0], 5));
    for (const auto& [xi, w] : facet_rule(mesh::Shape::quadrilateral))
        square += w * std::pow(xi[0], 4) * (std::pow(xi[1], 4) + xi[1]);
    for (const auto& [xi, w] : facet_rule(mesh::Shape::triangle))
        triangle += w * std::pow(xi[0], 2) * std::pow(xi[1], 3);
    EXPECT_NEAR(line, 2 / 5.0, 1e-15);
    EXPECT_NEAR(square, 4 / 25.0, 1e-15);
    EXPECT_NEAR(triangle, 2.0 * 6.0 / 5040.0, 1e-17);  // 2! 3! / (2 + 3 + 2)!
}

}  // namespace
}  // namespace soft::surface
