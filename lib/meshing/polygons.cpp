#include "meshing/polygons.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "meshing/section_mesher.hpp"

namespace soft::meshing {
namespace {

using Cell = std::vector<int>;
using CornerPair = std::array<int, 2>;

const PlanePoint& corner(const Polygons& mesh, int number) { return mesh.points[static_cast<std::size_t>(number)]; }

/// Interior angle between two adjacent boundary sides of a cell, from the tangents of the outline.
double angle_between(const Polygons::Side& before, const Polygons::Side& after) {
    constexpr double near = 1e-3;
    const auto direction = [](const Polygons::Side& side, double from, double to) {
        const double span = side.to - side.from;
        return minus(point_at(*side.edge, side.from + to * span), point_at(*side.edge, side.from + from * span));
    };
    const PlanePoint in = direction(before, 1 - near, 1), out = direction(after, 0, near);
    return std::numbers::pi - std::atan2(cross(in, out), dot(in, out));
}

/// Index of the corner at which the cell is flat.
std::optional<std::size_t> flat_corner(const Polygons& mesh, const Cell& cell) {
    constexpr double flat_rad = 140 * std::numbers::pi / 180;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const int here = cell[i];
        const auto before = mesh.boundary.find({cell[(i + cell.size() - 1) % cell.size()], here});
        const auto after = mesh.boundary.find({here, cell[(i + 1) % cell.size()]});
        if (before == mesh.boundary.end() || after == mesh.boundary.end()) continue;
        if (angle_between(before->second, after->second) > flat_rad) return i;
    }
    return std::nullopt;
}

/// Smallest sine of the angles of the straight-sided cell; negative where it is not convex.
double min_sine(const Polygons& mesh, const Cell& cell) {
    double smallest = 1;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const PlanePoint here = corner(mesh, cell[i]);
        const PlanePoint on = minus(corner(mesh, cell[(i + 1) % cell.size()]), here),
                         back = minus(corner(mesh, cell[(i + cell.size() - 1) % cell.size()]), here);
        smallest = std::min(smallest, cross(on, back) / (length(on) * length(back)));
    }
    return smallest;
}

/// Cuts a ring of corners, which starts at the flat one, into a triangle and the rest.
std::array<Cell, 2> cut(const Polygons& mesh, const Cell& ring) {
    const std::size_t last = ring.size() - 1;
    const std::array<Cell, 2> early{Cell{ring[0], ring[1], ring[2]}, [&] {
                                        Cell rest{ring[0]};
                                        rest.insert(rest.end(), ring.begin() + 2, ring.end());
                                        return rest;
                                    }()};
    const std::array<Cell, 2> late{Cell(ring.begin(), ring.end() - 1), Cell{ring[0], ring[last - 1], ring[last]}};
    const auto worst = [&](const std::array<Cell, 2>& pair) {
        return std::min(min_sine(mesh, pair[0]), min_sine(mesh, pair[1]));
    };
    return worst(late) > worst(early) ? late : early;
}

/// Corners of a cell, rotated to start at `first`.
Cell from(const Cell& cell, std::size_t first) {
    Cell turned = cell;
    std::ranges::rotate(turned, turned.begin() + static_cast<std::ptrdiff_t>(first));
    return turned;
}

/// Adds a second cell at each flat corner; true if there was one.
bool divide_once(Polygons& mesh) {
    std::map<CornerPair, std::size_t> owners;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        for (std::size_t i = 0; i < mesh.cells[c].size(); ++i)
            owners[{mesh.cells[c][i], mesh.cells[c][(i + 1) % mesh.cells[c].size()]}] = c;
    std::vector<bool> changed(mesh.cells.size());
    bool any = false;
    const std::size_t count = mesh.cells.size();
    for (std::size_t c = 0; c < count; ++c) {
        const auto flat = changed[c] ? std::nullopt : flat_corner(mesh, mesh.cells[c]);
        if (!flat) continue;
        Cell ring = from(mesh.cells[c], *flat);
        std::size_t other = mesh.cells.size();
        if (ring.size() == 3) {  // merged with the neighbour at its third side
            const auto behind = owners.find({ring[2], ring[1]});
            if (behind == owners.end() || changed[behind->second]) continue;
            other = behind->second;
            const Cell& cell = mesh.cells[other];
            const Cell beyond = from(cell, static_cast<std::size_t>(std::ranges::find(cell, ring[1]) - cell.begin()));
            ring.insert(ring.begin() + 2, beyond.begin() + 1, beyond.end() - 1);
            changed[other] = true;
        }
        changed[c] = any = true;
        auto [one, two] = cut(mesh, ring);
        mesh.cells[c] = std::move(one);
        if (other < count)
            mesh.cells[other] = std::move(two);
        else
            mesh.cells.push_back(std::move(two));
    }
    return any;
}

/// Mid points of sides, created on first use.
class Middles {
public:
    explicit Middles(const Polygons& mesh) : mesh_(mesh) {}

    /// Mid point of a side; new points are appended to `points`.
    struct Middle {
        int number;
        std::optional<double> share;  ///< on the outline
    };
    const Middle& operator()(int a, int b, std::vector<PlanePoint>& points) {
        const auto [entry, fresh] = found_.try_emplace({std::min(a, b), std::max(a, b)});
        if (!fresh) return entry->second;
        entry->second.number = static_cast<int>(points.size());
        const auto side = mesh_.boundary.find({a, b});
        if (side == mesh_.boundary.end()) {
            const PlanePoint &p = corner(mesh_, a), &q = corner(mesh_, b);
            points.push_back({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])});
        } else {
            const auto [share, position] = boundary_middle(mesh_, {a, b});
            entry->second.share = share;
            points.push_back(position);
        }
        return entry->second;
    }

private:
    const Polygons& mesh_;
    std::map<CornerPair, Middle> found_;
};

}  // namespace

BoundaryMiddle boundary_middle(const Polygons& mesh, const CornerPair& ends) {
    constexpr int halvings = 50;
    const Polygons::Side& side = mesh.boundary.at(ends);
    double low = side.from, high = side.to;
    for (int k = 0; k < halvings; ++k) {
        const double share = 0.5 * (low + high);
        const PlanePoint p = point_at(*side.edge, share);
        const bool nearer_to_start = length(minus(p, corner(mesh, ends[0]))) < length(minus(p, corner(mesh, ends[1])));
        (nearer_to_start ? low : high) = share;
    }
    const double share = 0.5 * (low + high);
    return {share, point_at(*side.edge, share)};
}

void divide_flat_corners(Polygons& mesh) {
    constexpr int passes = 4;  // a cell with three sides on the boundary needs two
    for (int pass = 0; pass < passes && divide_once(mesh); ++pass) {}
}

Polygons into_quadrilaterals(const Polygons& mesh) {
    Polygons result;
    result.points = mesh.points;
    Middles middles{mesh};
    for (const Cell& cell : mesh.cells) {
        Cell halves;
        PlanePoint centre{};
        for (std::size_t i = 0; i < cell.size(); ++i) {
            const int a = cell[i], b = cell[(i + 1) % cell.size()];
            const auto& [number, share] = middles(a, b, result.points);
            halves.push_back(number);
            for (std::size_t d = 0; d < 2; ++d)
                centre[d] += corner(result, number)[d] / static_cast<double>(cell.size());
            if (!share) continue;
            const Polygons::Side& side = mesh.boundary.at({a, b});
            result.boundary[{a, number}] = {side.edge, side.from, *share};
            result.boundary[{number, b}] = {side.edge, *share, side.to};
        }
        const int middle = static_cast<int>(result.points.size());
        result.points.push_back(centre);
        for (std::size_t i = 0; i < cell.size(); ++i)
            result.cells.push_back({cell[i], halves[i], middle, halves[(i + cell.size() - 1) % cell.size()]});
    }
    return result;
}

mesh::Mesh second_order(const Polygons& polygons) {
    mesh::Mesh mesh;
    mesh.dimension = 2;
    mesh.region_names = {rubber_region};
    std::vector<PlanePoint> points = polygons.points;
    Middles middles{polygons};
    for (const Cell& cell : polygons.cells) {
        std::vector<mesh::Index> nodes(cell.begin(), cell.end());
        PlanePoint centre{};
        for (std::size_t i = 0; i < cell.size(); ++i) {
            const int half = middles(cell[i], cell[(i + 1) % cell.size()], points).number;
            nodes.push_back(half);
            for (std::size_t d = 0; d < 2; ++d)  // transfinite interpolation of the sides
                centre[d] += 0.5 * points[static_cast<std::size_t>(half)][d] - 0.25 * corner(polygons, cell[i])[d];
        }
        const bool quadrilateral = cell.size() == 4;
        if (quadrilateral) {
            nodes.push_back(static_cast<mesh::Index>(points.size()));
            points.push_back(centre);
        }
        add_cell(mesh, quadrilateral ? mesh::CellType::quad9 : mesh::CellType::triangle6, nodes, 0);
    }
    for (const PlanePoint& p : points) mesh.points.push_back({p[0], p[1], 0.0});
    for (const mesh::Facet& facet : boundary_facets(mesh)) {
        const auto ends = facet_nodes(mesh, facet);
        const auto side = polygons.boundary.find({static_cast<int>(ends[0]), static_cast<int>(ends[1])});
        if (side == polygons.boundary.end()) continue;
        for (const std::string& face : side->second.edge->faces) mesh.facet_sets[face].push_back(facet);
    }
    return mesh;
}

}  // namespace soft::meshing
