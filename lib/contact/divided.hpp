#pragma once
/// Subdivision of curved facets into flat pieces, in any configuration, for intersection tests. A second-order edge is divided into
/// 4 segments, a quadrilateral into 4 x 4 quadrilaterals of two triangles, a triangle into 4 x 4 triangles; the deviation of the
/// chords from the curved facet is 1/16 of its sagitta. If that exceeds the thickness of a wall (stretched tenfold or more), the fine
/// division decides whether the two sides intersect: 64 segments or 16 x 16 pieces, with 1/4096 or 1/256 of the sagitta. The medium one
/// has 6 segments or 6 x 6 pieces.
/// Neighbours are conforming: both use the same points of their common reference edge.
/// Tested by contact/contact_test.
#include <map>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "surface/cgal_queries.hpp"
#include "surface/facet_map.hpp"

namespace soft::contact {

/// How facets of a type are divided.
struct Division {
    std::vector<surface::FacetPoint> xi;     ///< reference coordinates of the points
    std::vector<double> N;                   ///< [point][node]
    std::vector<std::array<int, 3>> pieces;  ///< point indices (two for a segment), oriented as the facet
    std::size_t corners;                     ///< per piece: 2 or 3
};

enum class Fineness { coarse, medium, fine };
[[nodiscard]] Division divide(mesh::CellType facet, Fineness fineness = Fineness::coarse);

/// Cone that contains the normals of a facet: directions within `angle` [rad] of the axis. Angle pi if it contains all directions.
struct NormalCone {
    Vector3 axis{};
    double angle = 0;
};

/// A configuration of a set of facets.
struct DividedShape {
    std::vector<mesh::Point> points;  ///< facet by facet
    std::vector<surface::Box> boxes;  ///< bounding box of each facet's points
};

class DividedFacets {
public:
    DividedFacets(const mesh::Mesh& mesh, std::span<const mesh::Facet> facets, Fineness fineness = Fineness::coarse);
    DividedFacets(const DividedFacets&) = delete;  // entries point into the map
    DividedFacets& operator=(const DividedFacets&) = delete;

    [[nodiscard]] std::size_t size() const { return facets_.size(); }
    [[nodiscard]] const mesh::Facet& facet(std::size_t f) const { return facets_[f].facet; }
    [[nodiscard]] mesh::CellType type(std::size_t f) const { return facets_[f].type; }
    [[nodiscard]] std::span<const mesh::Index> nodes(std::size_t f) const {
        return std::span{facets_[f].nodes}.first(static_cast<std::size_t>(mesh::node_count(facets_[f].type)));
    }
    [[nodiscard]] const Division& division(std::size_t f) const { return *facets_[f].division; }

    /// `positions`: one per mesh point.
    [[nodiscard]] DividedShape shape(std::span<const mesh::Point> positions) const;

    /// Points of a facet in a shape, in the order of its division.
    [[nodiscard]] std::span<const mesh::Point> points(const DividedShape& shape, std::size_t f) const {
        return std::span{shape.points}.subspan(facets_[f].first_point, facets_[f].division->xi.size());
    }

private:
    struct Entry {
        mesh::Facet facet;
        mesh::CellType type;
        std::array<mesh::Index, 9> nodes;
        const Division* division;
        std::size_t first_point;
    };
    std::map<mesh::CellType, Division> divisions_;
    std::vector<Entry> facets_;
};

/// Corners of a piece; the third is zero for a segment.
[[nodiscard]] std::array<mesh::Point, 3> piece_corners(std::span<const mesh::Point> points,
                                                       const std::array<int, 3>& piece);

[[nodiscard]] surface::Box box_of(std::span<const mesh::Point> points);
[[nodiscard]] inline bool overlap(const surface::Box& a, const surface::Box& b) {
    for (std::size_t d = 0; d < 3; ++d)
        if (a.high[d] < b.low[d] || b.high[d] < a.low[d]) return false;
    return true;
}

}  // namespace soft::contact
