#include "meshing/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
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

/// Planes at equal angles. Multiples of a quarter turn are exact, so coordinates on cut planes are exactly zero.
struct Circle {
    int half_layers_per_quarter;
    int offset;  ///< plane 0 lies at offset quarter turns
    int period;  ///< planes of a full turn; 0 if the turn is not closed

    [[nodiscard]] bool is_fixed(const Point& p) const { return p[1] == 0.0; }
    [[nodiscard]] int plane(const Point& p, int plane) const {
        if (is_fixed(p)) return 0;
        return period > 0 ? plane % period : plane;
    }
    [[nodiscard]] Point position(const Point& p, int plane) const {
        const int quarters = plane / half_layers_per_quarter + offset;
        const int rest = plane % half_layers_per_quarter;
        const double angle = 0.5 * std::numbers::pi * rest / half_layers_per_quarter;
        double y = p[1] * std::cos(angle), z = rest == 0 ? 0.0 : p[1] * std::sin(angle);
        for (int k = 0; k < (quarters % 4 + 4) % 4; ++k) {
            const double turned = y;
            y = z == 0.0 ? 0.0 : -z;
            z = turned;
        }
        return {p[0], y, z};
    }
};

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

mesh::Mesh revolve(const mesh::Mesh& section, Turn turn, int sectors_per_quarter) {
    const int half_layers = 2 * sectors_per_quarter;
    switch (turn) {
        case Turn::quarter: {
            Sweep sweep{section, Circle{half_layers, 0, 0}, sectors_per_quarter};
            sweep.name_first(symmetry_z_face);
            sweep.name_last(symmetry_y_face);
            return sweep.take();
        }
        case Turn::half: {
            Sweep sweep{section, Circle{half_layers, -1, 0}, 2 * sectors_per_quarter};
            sweep.name_first(symmetry_y_face);
            sweep.name_last(symmetry_y_face);
            return sweep.take();
        }
        case Turn::full: return Sweep{section, Circle{half_layers, 0, 4 * half_layers}, 4 * sectors_per_quarter}.take();
    }
    throw std::logic_error("revolve: unknown turn");
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
