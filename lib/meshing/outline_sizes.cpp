#include "meshing/outline_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace soft::meshing {
namespace {

/// Maximum turn of a cell along an edge: two quadratic sides per quarter turn have an error of 5e-5.
constexpr double max_turn_rad = std::numbers::pi / 4;

class Seeds {
public:
    Seeds(const Outline& outline, const SizeRequest& request)
        : outline_(outline), request_(request), pieces_(pieces_of(outline)) {
        for (std::size_t p = 0; p < pieces_.size(); ++p) add_wall(p);
        for (const Loop& loop : outline.loops)
            for (std::size_t e = 0; e < loop.size(); ++e) {
                add_bend(loop[e]);
                add_corner(loop[(e + loop.size() - 1) % loop.size()], loop[e]);
            }
    }
    std::vector<SizeSeed> take() { return std::move(seeds_); }

private:
    void add(PlanePoint position, double size_m) {
        if (size_m < request_.size_m) seeds_.push_back({position, size_m});
    }

    /// Adds sizes from the wall thickness along the normal, at positions at most two cell lengths apart. An adjacent side is not an
    /// opposite face: otherwise cells toward the tip of a wedge would become arbitrarily small.
    void add_wall(std::size_t number) {
        const OutlinePiece& piece = pieces_[number];
        const PlanePoint along = minus(piece.end, piece.start);
        const double piece_m = length(along);
        constexpr double min_step = 1e-3;  // relative to the side: limits the time for very large through_wall
        const PlanePoint inward{-along[1] / piece_m, along[0] / piece_m};
        const auto size_at = [&](double share) {
            const PlanePoint at{piece.start[0] + share * along[0], piece.start[1] + share * along[1]};
            const auto thickness_m = to_opposite(number, at, inward);
            const double size_m =
                thickness_m ? std::min(*thickness_m / request_.through_wall, request_.size_m) : request_.size_m;
            add(at, size_m);
            return size_m;
        };
        constexpr double middle = 0.5;  // the only position on a side shorter than two cells
        if (piece_m < 2 * size_at(middle)) return;
        for (double share = min_step; share < 1;) share += std::max(2 * size_at(share) / piece_m, min_step);
    }

    /// Whether the piece lies on the axis or a symmetry plane, beyond which the wall continues.
    [[nodiscard]] bool is_cut(const OutlinePiece& piece) const {
        const auto& faces = outline_.loops[piece.loop][piece.edge].faces;
        return std::ranges::any_of(faces, [](const std::string& face) {
            return face == axis_face || face == symmetry_x_face || face == symmetry_y_face;
        });
    }

    [[nodiscard]] std::optional<double> to_opposite(std::size_t number, PlanePoint from, PlanePoint inward) const {
        const OutlinePiece& own = pieces_[number];
        if (is_cut(own)) return std::nullopt;
        double nearest_m = std::numeric_limits<double>::infinity();
        std::optional<std::size_t> hit;
        for (std::size_t p = 0; p < pieces_.size(); ++p) {
            if (p == number) continue;
            const PlanePoint along = minus(pieces_[p].end, pieces_[p].start), to = minus(pieces_[p].start, from);
            const double across = cross(inward, along);
            if (across == 0) continue;
            const double distance_m = cross(to, along) / across, share = cross(to, inward) / across;
            if (distance_m <= 0 || share < 0 || share > 1 || distance_m >= nearest_m) continue;
            nearest_m = distance_m;
            hit = p;
        }
        if (!hit || are_neighbours(own, pieces_[*hit])) return std::nullopt;
        return is_cut(pieces_[*hit]) ? 2 * nearest_m : nearest_m;
    }

    [[nodiscard]] bool are_neighbours(const OutlinePiece& a, const OutlinePiece& b) const {
        if (a.loop != b.loop) return false;
        const std::size_t edges = outline_.loops[a.loop].size();
        return (a.edge + 1) % edges == b.edge || (b.edge + 1) % edges == a.edge;
    }

    void add_bend(const OutlineEdge& edge) {
        const auto line = polyline(edge);
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            const PlanePoint before = minus(line[i], line[i - 1]), after = minus(line[i + 1], line[i]);
            const double turn_rad =
                std::abs(std::atan2(cross(before, after), before[0] * after[0] + before[1] * after[1]));
            const double bend_m = 0.5 * (length(before) + length(after));
            if (turn_rad > 0) add(line[i], bend_m * max_turn_rad / turn_rad);
        }
        double edge_m = 0;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) edge_m += length(minus(line[i + 1], line[i]));
        add(line.front(), edge_m);
        add(line.back(), edge_m);
    }

    void add_corner(const OutlineEdge& before, const OutlineEdge& after) {
        const auto in = polyline(before), out = polyline(after);
        const PlanePoint arriving = minus(in[in.size() - 1], in[in.size() - 2]), leaving = minus(out[1], out[0]);
        const double turn_rad =
            std::atan2(cross(arriving, leaving), arriving[0] * leaving[0] + arriving[1] * leaving[1]);
        constexpr double blunt_rad = 10 * std::numbers::pi / 180;  // blunter corners hardly increase the strain
        if (turn_rad < -blunt_rad || is_fixed(before) != is_fixed(after))
            add(out.front(), request_.size_m / request_.grading);
    }

    [[nodiscard]] bool is_fixed(const OutlineEdge& edge) const {
        return std::ranges::any_of(edge.faces, [&](const std::string& face) {
            return std::ranges::find(request_.fixed, face) != request_.fixed.end();
        });
    }

    const Outline& outline_;
    const SizeRequest& request_;
    std::vector<OutlinePiece> pieces_;
    std::vector<SizeSeed> seeds_;
};

}  // namespace

std::function<double(PlanePoint)> cell_sizes(const Outline& outline, const SizeRequest& request) {
    return shorter_at([size_m = request.size_m](PlanePoint) { return size_m; }, Seeds{outline, request}.take());
}

std::function<double(PlanePoint)> shorter_at(std::function<double(PlanePoint)> size_m, std::vector<SizeSeed> seeds) {
    std::ranges::stable_sort(seeds, {}, &SizeSeed::size_m);
    return [size_m = std::move(size_m), seeds = std::move(seeds)](PlanePoint position) {
        double shortest_m = size_m(position);
        for (const SizeSeed& seed :
             seeds) {  // called a million times by gmsh: skip seeds that are too far or too large
            const double reach_m = (shortest_m - seed.size_m) / size_growth;
            if (reach_m <= 0) break;
            const PlanePoint to = minus(position, seed.position);
            if (std::abs(to[0]) > reach_m || std::abs(to[1]) > reach_m) continue;
            shortest_m = std::min(shortest_m, seed.size_m + size_growth * length(to));
        }
        return shortest_m;
    };
}

double expected_cells(const Outline& outline) {
    // Integrates the density of cells over the section, and that of their sides along its boundary.
    constexpr int grid = 100;
    const auto pieces = pieces_of(outline);
    const double extent = extent_m(outline);
    PlanePoint low = pieces.front().start;
    double sides = 0;
    for (const OutlinePiece& piece : pieces) {
        const PlanePoint middle{0.5 * (piece.start[0] + piece.end[0]), 0.5 * (piece.start[1] + piece.end[1])};
        sides += length(minus(piece.end, piece.start)) / outline.size_m(middle);
        for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], piece.start[d]);
    }
    double cells = 0;
    const double step_m = extent / grid;
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const PlanePoint point{low[0] + (i + 0.5) * step_m, low[1] + (j + 0.5) * step_m};
            if (!is_inside(pieces, point)) continue;
            const double size_m = outline.size_m(point);
            cells += step_m * step_m / (size_m * size_m);
        }
    return std::max(cells, sides);
}

}  // namespace soft::meshing
