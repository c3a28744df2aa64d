#include "meshing/body_mesher.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include "core/error.hpp"
#include "mesh/cell_map.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/quality.hpp"
#include "mesh/raise_order.hpp"
#include "meshing/gmsh_session.hpp"
#include "meshing/section_mesher.hpp"
#include "surface/near.hpp"

namespace soft::meshing {
namespace {

using mesh::Index;

constexpr double mm = 1e3;  // gmsh's tolerances assume lengths of order 1

/// The shell number of each triangle of a closed surface, numbered in the order of the first triangles.
std::vector<int> shells_of(const Remeshed& surface) {
    mesh::DisjointSets groups(surface.points.size());
    const auto corner = [](const auto& t, std::size_t k) { return static_cast<std::size_t>(t[k]); };
    for (const auto& t : surface.triangles)
        for (std::size_t k = 1; k < 3; ++k) groups.unite(corner(t, k), corner(t, 0));
    std::map<std::size_t, int> numbers;
    std::vector<int> shells;
    for (const auto& t : surface.triangles)
        shells.push_back(
            numbers.try_emplace(groups.first(corner(t, 0)), static_cast<int>(numbers.size())).first->second);
    return shells;
}

double volume_m3(const Remeshed& surface) {
    BodySurface plain;
    plain.points = surface.points;
    plain.triangles = surface.triangles;
    return plain.volume_m3();
}

/// First-order tetrahedra whose first points are those of the surface; nullopt if gmsh did not fill it.
std::optional<mesh::Mesh> filled(const Remeshed& surface, GmshSession::Filling filling) {
    const auto gmsh = open_gmsh();
    const std::vector<int> shells = shells_of(surface);
    const int count = 1 + *std::ranges::max_element(shells);
    std::vector<int> tags;
    for (int shell = 0; shell < count; ++shell) {
        GmshSession::Nodes nodes;
        std::vector<std::size_t> triangles;
        std::set<int> own;
        for (std::size_t t = 0; t < shells.size(); ++t)
            if (shells[t] == shell)
                for (const int corner : surface.triangles[t]) {
                    own.insert(corner);
                    triangles.push_back(static_cast<std::size_t>(corner) + 1);
                }
        for (const int corner : own) {
            nodes.tags.push_back(static_cast<std::size_t>(corner) + 1);
            for (const double x : surface.points[static_cast<std::size_t>(corner)]) nodes.xyz.push_back(mm * x);
        }
        tags.push_back(shell + 1);
        gmsh->add_triangles(shell + 1, std::move(nodes), std::move(triangles));
    }
    constexpr int volume = 1;
    gmsh->fill(volume, tags, filling);
    mesh::Mesh mesh;
    mesh.region_names = {rubber_region};
    mesh.points = surface.points;
    std::unordered_map<std::size_t, Index> numbers;
    const auto [node_tags, xyz] = gmsh->nodes();
    for (std::size_t n = 0; n < node_tags.size(); ++n) {
        if (node_tags[n] <= surface.points.size()) continue;
        numbers[node_tags[n]] = static_cast<Index>(mesh.points.size());
        mesh.points.push_back({xyz[3 * n] / mm, xyz[3 * n + 1] / mm, xyz[3 * n + 2] / mm});
    }
    const auto cells = gmsh->cells(3, volume);
    std::array<Index, 4> cell{};
    for (std::size_t n = 0; n + 3 < cells.size(); n += 4) {
        for (std::size_t k = 0; k < 4; ++k)
            cell[k] =
                cells[n + k] <= surface.points.size() ? static_cast<Index>(cells[n + k]) - 1 : numbers.at(cells[n + k]);
        add_cell(mesh, mesh::CellType::tet4, cell, 0);
    }
    constexpr double rounding = 1e-9;
    if (mesh.cell_types.empty() ||
        std::abs(mesh::measure(mesh, mesh::Measure::plain) / volume_m3(surface) - 1) > rounding)
        return std::nullopt;
    return mesh;
}

using Edge = std::array<Index, 2>;

/// Target positions of the mid nodes of boundary edges on the surface of the file, by node number.
std::map<Index, mesh::Point> mid_node_targets(const mesh::Mesh& mesh, const Remeshed& remeshed, const BodySurface& body,
                                              const Creases& creases) {
    const surface::NearestOnTriangles on_surface(body.points, body.triangles);
    std::optional<surface::NearestOnSegments> on_lines;
    if (!creases.empty()) on_lines.emplace(body.points, creases);
    std::set<Edge> lines;
    for (const auto& [a, b] : remeshed.creases) lines.insert({a, b});
    std::map<Index, mesh::Point> targets;
    for (const mesh::Facet& facet : boundary_facets(mesh)) {
        const auto nodes = facet_nodes(mesh, facet);  // corners 0 1 2, then the middles of 0-1, 1-2, 2-0
        for (std::size_t k = 0; k < 3; ++k) {
            const Index middle = nodes[3 + k];
            if (targets.contains(middle)) continue;
            const auto [a, b] = std::minmax(nodes[k], nodes[(k + 1) % 3]);
            const mesh::Point& straight = mesh.point(middle);
            targets[middle] = lines.contains({a, b}) ? (*on_lines)(straight).point : on_surface(straight).point;
        }
    }
    return targets;
}

/// Moves mid nodes to their targets, as far as the cells around them stay valid.
void curve(mesh::Mesh& mesh, const std::map<Index, mesh::Point>& targets) {
    constexpr double min_ratio = 0.2;  // quadrature is inaccurate in a cell whose Jacobian varies more than fivefold
    constexpr int rounds = 8;
    std::map<Index, std::vector<Index>> cells;  // around a mid node that moves
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
        for (const Index node : mesh.cell_nodes(cell))
            if (targets.contains(node)) cells[node].push_back(cell);
    const mesh::NodeShapes shapes = mesh::node_shapes(mesh::CellType::tet10);
    const std::vector<mesh::Point> straight = mesh.points;
    std::map<Index, double> shares;
    for (const auto& [node, target] : targets) shares[node] = 1;
    const auto move = [&](Index node) {
        for (std::size_t d = 0; d < 3; ++d) {
            const double from = straight[static_cast<std::size_t>(node)][d];
            mesh.points[static_cast<std::size_t>(node)][d] = from + shares.at(node) * (targets.at(node)[d] - from);
        }
    };
    for (const auto& [node, target] : targets) move(node);
    for (int round = 0; round < rounds; ++round) {
        std::set<Index> back;
        for (const auto& [node, around] : cells)
            for (const Index cell : around)
                if (shares.at(node) > 0 && mesh::scaled_jacobian(mesh, cell, shapes).value < min_ratio)
                    back.insert(node);
        if (back.empty()) return;
        for (const Index node : back) {
            double& share = shares.at(node);
            share = round + 2 < rounds ? 0.5 * share : 0;
            move(node);
        }
    }
}

void name_facets(mesh::Mesh& mesh, const BodySurface& body, const std::vector<NamedFace>& faces) {
    const surface::NearestOnTriangles on_surface(body.points, body.triangles);
    for (const mesh::Facet& facet : boundary_facets(mesh)) {
        const auto nodes = facet_nodes(mesh, facet);
        mesh::Point centre{};
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t d = 0; d < 3; ++d) centre[d] += mesh.point(nodes[k])[d] / 3;
        const auto nearest = static_cast<std::size_t>(on_surface(centre).element);
        for (const NamedFace& face : faces)
            if (face.facets[nearest]) mesh.facet_sets[face.name].push_back(facet);
    }
}

}  // namespace

mesh::Mesh mesh_inside(const MeshedBody& body, const SizeAt& size_m) {
    constexpr std::size_t max_points =
        200000;  // on the surface: more give over a million tetrahedra, too many to solve
    constexpr int attempts = 3;
    const Creases creases = creases_of(body.surface, body.faces);
    double factor = 1;
    for (int attempt = 0; attempt < attempts; ++attempt, factor *= 0.7) {
        const Remeshed remeshed = remesh(
            body.surface, creases, [&](const mesh::Point& p) { return factor * size_m(p); }, body.origin, max_points);
        for (const auto filling : {GmshSession::Filling::delaunay, GmshSession::Filling::hxt}) {
            std::optional<mesh::Mesh> mesh;
            try {
                mesh = filled(remeshed, filling);
            } catch (const Error& error) {  // gmsh failed; it may succeed with other triangles
                if (error.code() != ExitCode::internal) throw;
            }
            if (!mesh) continue;
            mesh::Mesh second = raise_order(*mesh);
            curve(second, mid_node_targets(second, remeshed, body.surface, creases));
            name_facets(second, body.surface, body.faces);
            return second;
        }
    }
    throw Error(ExitCode::bad_input, body.origin.name, "gmsh finds no tetrahedra inside the surface",
                "use another mesh.size, or remove very sharp edges and gaps narrower than a cell in the CAD program");
}

}  // namespace soft::meshing
