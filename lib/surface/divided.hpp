#pragma once
/// Curved facets as many small straight pieces, in any configuration: for questions about crossings. A second-order edge is
/// cut into 4 segments, a side into 4 x 4 quadrilaterals of two triangles (4 x 4 triangles); their chords stray from the
/// curved facet by 1/16 of its rise. Where that is more than a wall is thick (one that is stretched tenfold and more), the
/// fine division tells whether its two sides cross: 64 segments or 16 x 16, 1/4096 or 1/256 of the rise. Neighbours match: equal points of the reference edge are points of both.
/// Tested by surface/contact_test.
#include <map>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "surface/cgal_queries.hpp"
#include "surface/facet_map.hpp"

namespace soft::surface {

/// How facets of a type are divided.
struct Division {
    std::vector<FacetPoint> xi;              ///< of the points
    std::vector<double> N;                   ///< [point][node]
    std::vector<std::array<int, 3>> pieces;  ///< points; of a segment the first two. Oriented as the facet
    std::size_t corners;                     ///< of a piece: 2 or 3
};

enum class Fineness { coarse, fine };
[[nodiscard]] Division divide(mesh::CellType facet, Fineness fineness = Fineness::coarse);

/// The directions of a facet's normals: within this angle of the axis. Angle pi where they go all ways.
struct NormalCone {
    Vector axis{};
    double angle = 0;
};

/// A configuration of a set of facets.
struct DividedShape {
    std::vector<mesh::Point> points;  ///< facet by facet
    std::vector<Box> boxes;           ///< of the pieces of each facet
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

    /// `positions`: one a mesh point.
    [[nodiscard]] DividedShape shape(std::span<const mesh::Point> positions) const;

    /// Points of a facet in a shape, in the order of its division.
    [[nodiscard]] std::span<const mesh::Point> points(const DividedShape& shape, std::size_t f) const {
        return std::span{shape.points}.subspan(facets_[f].first_point, facets_[f].division->xi.size());
    }
    /// Of a coarse division.
    [[nodiscard]] NormalCone normals(const DividedShape& shape, std::size_t f) const;

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

/// Corners of a piece.
[[nodiscard]] std::array<mesh::Point, 3> piece_corners(std::span<const mesh::Point> points,
                                                       const std::array<int, 3>& piece);

[[nodiscard]] Box box_of(std::span<const mesh::Point> points);
[[nodiscard]] inline bool overlap(const Box& a, const Box& b) {
    for (std::size_t d = 0; d < 3; ++d)
        if (a.high[d] < b.low[d] || b.high[d] < a.low[d]) return false;
    return true;
}

}  // namespace soft::surface
