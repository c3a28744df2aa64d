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

TEST(FacetMap, InterpolatesItsNodes) {
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
        const Vector3 t1{1, 0.2, 0.6}, t2{-0.4, 2.3, -1};
        for (std::size_t d = 0; d < 3; ++d) {
            EXPECT_NEAR(at.x[d], x[d], 1e-14);
            EXPECT_NEAR(at.t1[d], t1[d], 1e-14);
            EXPECT_NEAR(at.t2[d], t2[d], 1e-14);
        }
    }
}

}  // namespace
}  // namespace soft::surface
