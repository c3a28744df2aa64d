#include "meshing/fine_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "surface/facet_map.hpp"

namespace soft::meshing {
namespace {

/// Sagitta of an arc of 15 degrees over its chord: the angle [rad] of an arc is 8 times this ratio.
constexpr double max_sagitta_ratio = 0.033;
/// Enough for a facet that spans up to 90 degrees of a circle and a deviation of at least 1e-4 of it.
constexpr int max_halvings = 6;

struct Corner {
    int point;
    surface::FacetPoint xi;
};
using Piece = std::array<Corner, 3>;

class Refiner {
public:
    Refiner(const mesh::Mesh& mesh, double deviation_m) : mesh_(mesh), deviation_m_(deviation_m) {}

    /// Adds the facet, divided at its own nodes.
    void add(const mesh::Facet& facet, int number) {
        const surface::FacetMap map = surface::facet_map(mesh_, facet, mesh_.points);
        const auto nodes = facet_nodes(mesh_, facet);
        const auto& reference = mesh::topology(map.type).nodes;
        for (const auto& triangle : surface::facet_division(map.type)) {
            Piece piece;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto a = static_cast<std::size_t>(triangle[k]);
                piece[k] = {node(nodes[a]), {reference[a][0], reference[a][1]}};
            }
            pieces_.push_back(piece);
            facets_.push_back(number);
        }
        shapes_.push_back(map);
    }

    /// Bisects every edge whose chord deviates too much; a piece with one, two or three such edges becomes two, three or four pieces.
    bool halve() {
        std::vector<Piece> pieces;
        std::vector<int> facets;
        bool any = false;
        for (std::size_t p = 0; p < pieces_.size(); ++p) {
            const Piece& old = pieces_[p];
            std::array<Corner, 3> mid;
            std::array<bool, 3> split{};
            for (std::size_t k = 0; k < 3; ++k) split[k] = middle(facets_[p], old[k], old[(k + 1) % 3], mid[k]);
            any = any || split[0] || split[1] || split[2];
            const std::size_t before = pieces.size();
            divide(old, mid, split, pieces);
            facets.insert(facets.end(), pieces.size() - before, facets_[p]);
        }
        pieces_ = std::move(pieces);
        facets_ = std::move(facets);
        return any;
    }

    surface::Triangles take() {
        for (std::size_t p = 0; p < pieces_.size(); ++p) {
            const auto& [a, b, c] = pieces_[p];
            surface_.triangles.push_back({a.point, b.point, c.point});
            surface_.facets.push_back(facets_[p]);
        }
        surface_.model_points = surface_.points;
        return std::move(surface_);
    }

private:
    int node(mesh::Index number) {
        const auto [found, fresh] = nodes_.try_emplace(number, static_cast<int>(surface_.points.size()));
        if (fresh) surface_.points.push_back(mesh_.point(number));
        return found->second;
    }

    /// Whether the edge is bisected, and where. The result for the first of the two facets is reused for the second.
    bool middle(int facet, const Corner& a, const Corner& b, Corner& mid) {
        mid.xi = {(a.xi[0] + b.xi[0]) / 2, (a.xi[1] + b.xi[1]) / 2};
        const auto [found, fresh] = middles_.try_emplace(std::minmax(a.point, b.point), whole);
        if (fresh) {
            const mesh::Point x = shapes_[static_cast<std::size_t>(facet)](mid.xi).x;
            const mesh::Point &p = point(a), &q = point(b);
            Vector3 off{}, along{};
            for (std::size_t d = 0; d < 3; ++d) {
                off[d] = x[d] - (p[d] + q[d]) / 2;
                along[d] = q[d] - p[d];
            }
            const double rounding = 1e-3 * deviation_m_;  // smaller deviations are treated as zero
            const double deviation = norm(off), length = norm(along);
            if (deviation > deviation_m_ || deviation > std::max(max_sagitta_ratio * length, rounding)) {
                found->second = static_cast<int>(surface_.points.size());
                surface_.points.push_back(x);
            }
        }
        mid.point = found->second;
        return mid.point != whole;
    }

    [[nodiscard]] const mesh::Point& point(const Corner& corner) const {
        return surface_.points[static_cast<std::size_t>(corner.point)];
    }

    [[nodiscard]] double distance(const Corner& a, const Corner& b) const {
        const mesh::Point &p = point(a), &q = point(b);
        return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }

    void divide(const Piece& old, const std::array<Corner, 3>& mid, const std::array<bool, 3>& split,
                std::vector<Piece>& pieces) const {
        const auto count = std::count(split.begin(), split.end(), true);
        if (count == 0) {
            pieces.push_back(old);
        } else if (count == 3) {
            for (std::size_t k = 0; k < 3; ++k) pieces.push_back({old[k], mid[k], mid[(k + 2) % 3]});
            pieces.push_back({mid[0], mid[1], mid[2]});
        } else if (count == 1) {
            const auto k = static_cast<std::size_t>(std::find(split.begin(), split.end(), true) - split.begin());
            pieces.push_back({old[k], mid[k], old[(k + 2) % 3]});
            pieces.push_back({mid[k], old[(k + 1) % 3], old[(k + 2) % 3]});
        } else {  // edge k (from a to b, opposite to c) is not split; b-c and c-a are bisected
            const auto k = static_cast<std::size_t>(std::find(split.begin(), split.end(), false) - split.begin());
            const Corner &a = old[k], &b = old[(k + 1) % 3], &c = old[(k + 2) % 3], &bc = mid[(k + 1) % 3],
                         &ca = mid[(k + 2) % 3];
            pieces.push_back({ca, bc, c});
            if (distance(a, bc) <= distance(b, ca)) {
                pieces.push_back({a, b, bc});
                pieces.push_back({a, bc, ca});
            } else {
                pieces.push_back({a, b, ca});
                pieces.push_back({b, bc, ca});
            }
        }
    }

    static constexpr int whole = -1;
    const mesh::Mesh& mesh_;
    double deviation_m_;
    surface::Triangles surface_;
    std::map<mesh::Index, int> nodes_;
    std::map<std::pair<int, int>, int> middles_;
    std::vector<surface::FacetMap> shapes_;
    std::vector<Piece> pieces_;
    std::vector<int> facets_;
};

}  // namespace

surface::Triangles fine_triangles(const mesh::Mesh& mesh, const std::vector<mesh::Facet>& facets, double deviation_m) {
    Refiner refiner(mesh, deviation_m);
    for (std::size_t f = 0; f < facets.size(); ++f) refiner.add(facets[f], static_cast<int>(f));
    for (int time = 0; time < max_halvings && refiner.halve(); ++time) {}
    return refiner.take();
}

}  // namespace soft::meshing
