/// The tables of cell_type.hpp, computed at compile time from the definition of a cell: its corners and the order of its edges
/// and quadrilateral faces. Everything else (mid nodes, facets of second-order cells) follows from these.
#include "mesh/cell_type.hpp"

#include <cstddef>

namespace soft::mesh {
namespace {

using Node = std::array<double, 3>;
using Edge = std::array<int, 2>;
using Quad = std::array<int, 4>;
using FacetCorners = std::array<int, 4>;  ///< unused entries are -1

constexpr int unused = -1;

/// Definition of the node order of a cell shape (shared by first and second order).
template <std::size_t C, std::size_t E, std::size_t Q, std::size_t F>
struct Skeleton {
    std::array<Node, C> corners;
    std::array<Edge, E> edges;           ///< in the order of the mid-edge nodes
    std::array<Quad, Q> quads;           ///< in the order of the mid-face nodes
    std::array<FacetCorners, F> facets;  ///< corners, outward
};

template <std::size_t N, std::size_t F>
struct Tables {
    std::array<Node, N> nodes{};
    std::array<FacetTopology, F> facets{};
};

template <std::size_t K, std::size_t C>
constexpr Node mean(const std::array<Node, C>& corners, const std::array<int, K>& members) {
    Node sum{};
    for (const int m : members)
        for (std::size_t d = 0; d < 3; ++d) sum[d] += corners[static_cast<std::size_t>(m)][d] / static_cast<double>(K);
    return sum;
}

constexpr int corner_count(const FacetCorners& facet) {
    int n = 0;
    for (const int corner : facet) n += corner == unused ? 0 : 1;
    return n;
}

constexpr CellType facet_cell(int corners, int order) {
    if (corners == 2) return order == 1 ? CellType::line2 : CellType::line3;
    if (corners == 3) return order == 1 ? CellType::triangle3 : CellType::triangle6;
    return order == 1 ? CellType::quad4 : CellType::quad9;
}

template <std::size_t C, std::size_t E, std::size_t Q, std::size_t F>
constexpr int edge_node(const Skeleton<C, E, Q, F>& s, int a, int b) {
    for (std::size_t e = 0; e < E; ++e)
        if ((s.edges[e][0] == a && s.edges[e][1] == b) || (s.edges[e][0] == b && s.edges[e][1] == a))
            return static_cast<int>(C + e);
    return unused;
}

/// The mid-face node of the quadrilateral face that has all four corners of the facet.
template <std::size_t C, std::size_t E, std::size_t Q, std::size_t F>
constexpr int quad_node(const Skeleton<C, E, Q, F>& s, const FacetCorners& facet) {
    for (std::size_t q = 0; q < Q; ++q) {
        int common = 0;
        for (const int a : s.quads[q])
            for (const int b : facet) common += a == b ? 1 : 0;
        if (common == 4) return static_cast<int>(C + E + q);
    }
    return unused;
}

template <int order, std::size_t C, std::size_t E, std::size_t Q, std::size_t F>
constexpr FacetTopology make_facet(const Skeleton<C, E, Q, F>& s, const FacetCorners& corners) {
    const int n = corner_count(corners);
    FacetTopology facet{facet_cell(n, order), {}};
    facet.nodes.fill(unused);
    int next = 0;
    for (int i = 0; i < n; ++i) facet.nodes[static_cast<std::size_t>(next++)] = corners[static_cast<std::size_t>(i)];
    if (order == 1) return facet;
    const int edges = n == 2 ? 1 : n;
    for (int i = 0; i < edges; ++i)
        facet.nodes[static_cast<std::size_t>(next++)] =
            edge_node(s, corners[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>((i + 1) % n)]);
    if (n == 4) facet.nodes[static_cast<std::size_t>(next)] = quad_node(s, corners);
    return facet;
}

/// N nodes of the given order: corners, then mid-edge nodes, mid-face nodes and, if N includes it, the centre node.
template <int order, std::size_t N, std::size_t C, std::size_t E, std::size_t Q, std::size_t F>
constexpr Tables<N, F> make_tables(const Skeleton<C, E, Q, F>& s) {
    Tables<N, F> t;
    std::size_t next = 0;
    for (const Node& corner : s.corners) t.nodes[next++] = corner;
    if constexpr (order == 2) {
        for (const Edge& edge : s.edges) t.nodes[next++] = mean(s.corners, edge);
        for (const Quad& quad : s.quads) t.nodes[next++] = mean(s.corners, quad);
        if constexpr (N == C + E + Q + 1) {
            std::array<int, C> all{};
            for (std::size_t i = 0; i < C; ++i) all[i] = static_cast<int>(i);
            t.nodes[next] = mean(s.corners, all);
        }
    }
    for (std::size_t f = 0; f < F; ++f) t.facets[f] = make_facet<order>(s, s.facets[f]);
    return t;
}

constexpr int _ = unused;
constexpr Skeleton<2, 1, 0, 0> line{{{{-1, 0, 0}, {1, 0, 0}}}, {{{0, 1}}}, {}, {}};
constexpr Skeleton<3, 3, 0, 3> triangle{
    {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, 1}, {1, 2}, {2, 0}}}, {}, {{{0, 1, _, _}, {1, 2, _, _}, {2, 0, _, _}}}};
constexpr Skeleton<4, 4, 1, 4> quad{{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}},
                                    {{{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
                                    {{{0, 1, 2, 3}}},
                                    {{{0, 1, _, _}, {1, 2, _, _}, {2, 3, _, _}, {3, 0, _, _}}}};
constexpr Skeleton<4, 6, 0, 4> tet{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                   {{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}},
                                   {},
                                   {{{0, 1, 3, _}, {1, 2, 3, _}, {2, 0, 3, _}, {0, 2, 1, _}}}};
constexpr std::array<Quad, 6> hex_faces{
    {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
constexpr Skeleton<8, 12, 6, 6> hex{
    {{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}},
    {{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}},
    hex_faces,
    hex_faces};
constexpr Skeleton<6, 9, 3, 5> wedge_skeleton{
    {{{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
    {{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}},
    {{{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
    {{{0, 2, 1, _}, {3, 4, 5, _}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}}};

template <const auto& skeleton, int order, std::size_t N>
constexpr auto tables = make_tables<order, N>(skeleton);

template <const auto& skeleton, int order, std::size_t N>
constexpr CellTopology make_topology(CellType type, Shape shape, std::string_view name, int dimension) {
    const auto& table = tables<skeleton, order, N>;
    return {type,
            shape,
            name,
            dimension,
            order,
            static_cast<int>(N),
            static_cast<int>(skeleton.corners.size()),
            table.nodes,
            table.facets};
}

/// First and second order of each shape follow each other (with_order).
constexpr std::array<CellTopology, 12> topologies{
    make_topology<line, 1, 2>(CellType::line2, Shape::line, "line2", 1),
    make_topology<line, 2, 3>(CellType::line3, Shape::line, "line3", 1),
    make_topology<triangle, 1, 3>(CellType::triangle3, Shape::triangle, "triangle3", 2),
    make_topology<triangle, 2, 6>(CellType::triangle6, Shape::triangle, "triangle6", 2),
    make_topology<quad, 1, 4>(CellType::quad4, Shape::quadrilateral, "quad4", 2),
    make_topology<quad, 2, 9>(CellType::quad9, Shape::quadrilateral, "quad9", 2),
    make_topology<tet, 1, 4>(CellType::tet4, Shape::tetrahedron, "tet4", 3),
    make_topology<tet, 2, 10>(CellType::tet10, Shape::tetrahedron, "tet10", 3),
    make_topology<hex, 1, 8>(CellType::hex8, Shape::hexahedron, "hex8", 3),
    make_topology<hex, 2, 27>(CellType::hex27, Shape::hexahedron, "hex27", 3),
    make_topology<wedge_skeleton, 1, 6>(CellType::wedge6, Shape::wedge, "wedge6", 3),
    make_topology<wedge_skeleton, 2, 18>(CellType::wedge18, Shape::wedge, "wedge18", 3),
};

/// Index in `topologies` by VTK's number.
constexpr auto positions = [] {
    std::array<std::size_t, 33> found{};
    for (std::size_t i = 0; i < topologies.size(); ++i) found[static_cast<std::size_t>(topologies[i].type)] = i;
    return found;
}();

}  // namespace

const CellTopology& topology(CellType type) noexcept { return topologies[positions[static_cast<std::size_t>(type)]]; }

CellType with_order(CellType type, int order) noexcept {
    return topologies[positions[static_cast<std::size_t>(type)] / 2 * 2 + static_cast<std::size_t>(order) - 1].type;
}

std::array<double, 3> reference_centre(CellType type) noexcept {
    const CellTopology& cell = topology(type);
    std::array<double, 3> centre{};
    for (const auto& corner : cell.nodes.first(static_cast<std::size_t>(cell.vertex_count)))
        for (std::size_t d = 0; d < 3; ++d) centre[d] += corner[d] / cell.vertex_count;
    return centre;
}

std::optional<CellType> cell_type_from_vtk(int vtk) noexcept {
    for (const CellTopology& t : topologies)
        if (static_cast<int>(t.type) == vtk) return t.type;
    return std::nullopt;
}

}  // namespace soft::mesh
