#include "meshing/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

#include "meshing/section.hpp"
#include "meshing/swept_cells.hpp"

namespace soft::meshing {
namespace {

using mesh::Facet;
using mesh::Index;
using mesh::Point;
using swept::Sweep;

/// A plane through the axis. Those at multiples of a quarter turn are exact, so coordinates on cut planes are exactly zero.
struct TurnedPlane {
    int quarter;  ///< 0 begins at y, -1 at -z
    double angle_rad;
};

struct Circle {
    std::vector<TurnedPlane> planes;
    bool closed;

    [[nodiscard]] bool is_fixed(const Point& p) const { return p[1] == 0.0; }
    [[nodiscard]] int plane(const Point& p, int plane) const {
        if (is_fixed(p)) return 0;
        return closed ? plane % static_cast<int>(planes.size()) : plane;
    }
    [[nodiscard]] Point position(const Point& p, int plane) const {
        const auto [quarter, angle_rad] = planes[static_cast<std::size_t>(plane)];
        double y = p[1] * std::cos(angle_rad), z = angle_rad == 0 ? 0.0 : p[1] * std::sin(angle_rad);
        for (int k = 0; k < (quarter + 4) % 4; ++k) {
            const double turned = y;
            y = z == 0.0 ? 0.0 : -z;
            z = turned;
        }
        return {p[0], y, z};
    }
};

std::vector<int> quarters_of(Turn turn) {
    switch (turn) {
        case Turn::quarter: return {0};
        case Turn::half: return {-1, 0};
        case Turn::full: return {0, 1, 2, 3};
    }
    throw std::logic_error("unknown turn");
}

std::vector<Sectors::Part> parts_of(const Sectors& sectors, int quarter) {
    std::vector<Sectors::Part> parts = quarter == 0 || quarter == 1 ? sectors.upper : sectors.lower;
    if (quarter == 1 || quarter == 2) std::ranges::reverse(parts);
    return parts;
}

Circle circle(const Sectors& sectors, Turn turn) {
    Circle circle{{}, turn == Turn::full};
    const std::vector<int> quarters = quarters_of(turn);
    for (const int quarter : quarters) {
        double begin_rad = 0;
        for (const auto& [angle_rad, cells] : parts_of(sectors, quarter)) {
            for (int i = 0; i < 2 * cells; ++i)
                circle.planes.push_back({quarter, begin_rad + angle_rad * i / (2 * cells)});
            begin_rad += angle_rad;
        }
    }
    if (!circle.closed) circle.planes.push_back({quarters.back() + 1, 0});
    return circle;
}

/// Planes along z from 0 up, or along y from the width down to 0: (x, y, z) and (x, z, -y) are right-handed, so the cells keep a
/// positive orientation.
struct Straight {
    double width_m;
    int half_layers;
    Extrusion::Along along;

    [[nodiscard]] bool is_fixed(const Point&) const { return false; }
    [[nodiscard]] int plane(const Point&, int plane) const { return plane; }
    [[nodiscard]] Point position(const Point& p, int plane) const {
        if (along == Extrusion::Along::z) return {p[0], p[1], width_m * plane / half_layers};
        return {p[0], width_m * (half_layers - plane) / half_layers, p[1]};
    }
};

}  // namespace

Sectors Sectors::even(int per_quarter) { return {{{quarter_rad, per_quarter}}, {{quarter_rad, per_quarter}}}; }

int Sectors::cells(Turn turn) const {
    int sum = 0;
    for (const int quarter : quarters_of(turn))
        for (const Part& part : parts_of(*this, quarter)) sum += part.cells;
    return sum;
}

mesh::Mesh revolve(const mesh::Mesh& section, Turn turn, const Sectors& sectors) {
    Sweep sweep{section, circle(sectors, turn), sectors.cells(turn)};
    if (turn != Turn::full) {
        sweep.name_first(turn == Turn::half ? symmetry_y_face : symmetry_z_face);
        sweep.name_last(symmetry_y_face);
    }
    return sweep.take();
}

mesh::Mesh extrude(const mesh::Mesh& section, const Extrusion& extrusion) {
    const bool upward = extrusion.along == Extrusion::Along::z;
    Sweep sweep{section, Straight{extrusion.width_m, 2 * extrusion.layers, extrusion.along}, extrusion.layers};
    for (const std::string& name : upward ? extrusion.low_faces : extrusion.high_faces) sweep.name_first(name);
    for (const std::string& name : upward ? extrusion.high_faces : extrusion.low_faces) sweep.name_last(name);
    return sweep.take();
}

std::vector<Facet> facets_on_plane(const mesh::Mesh& mesh, int component) {
    std::vector<Facet> facets;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const auto nodes = mesh.cell_nodes(cell);
        int local = 0;
        for (const mesh::FacetTopology& facet : mesh::topology(mesh.cell_type(cell)).facets) {
            const auto members = std::span(facet.nodes).first(static_cast<std::size_t>(mesh::node_count(facet.type)));
            if (std::all_of(members.begin(), members.end(),
                            [&](int n) { return mesh.point(nodes[n])[static_cast<std::size_t>(component)] == 0.0; }))
                facets.push_back({cell, local});
            ++local;
        }
    }
    return facets;
}

}  // namespace soft::meshing
