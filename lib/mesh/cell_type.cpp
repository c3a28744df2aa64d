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

constexpr auto line2 = make_tables<1, 2>(line);
constexpr auto line3 = make_tables<2, 3>(line);
constexpr auto triangle3 = make_tables<1, 3>(triangle);
constexpr auto triangle6 = make_tables<2, 6>(triangle);
constexpr auto quad4 = make_tables<1, 4>(quad);
constexpr auto quad9 = make_tables<2, 9>(quad);
constexpr auto tet4 = make_tables<1, 4>(tet);
constexpr auto tet10 = make_tables<2, 10>(tet);
constexpr auto hex8 = make_tables<1, 8>(hex);
constexpr auto hex27 = make_tables<2, 27>(hex);
constexpr auto wedge6 = make_tables<1, 6>(wedge_skeleton);
constexpr auto wedge18 = make_tables<2, 18>(wedge_skeleton);

template <std::size_t N, std::size_t F>
constexpr CellTopology make_topology(CellType type, Shape shape, std::string_view name, int dimension, int order,
                                     int vertex_count, const Tables<N, F>& tables) {
    return {type, shape, name, dimension, order, static_cast<int>(N), vertex_count, tables.nodes, tables.facets};
}

constexpr std::array<CellTopology, 12> topologies{
    make_topology(CellType::line2, Shape::line, "line2", 1, 1, 2, line2),
    make_topology(CellType::line3, Shape::line, "line3", 1, 2, 2, line3),
    make_topology(CellType::triangle3, Shape::triangle, "triangle3", 2, 1, 3, triangle3),
    make_topology(CellType::triangle6, Shape::triangle, "triangle6", 2, 2, 3, triangle6),
    make_topology(CellType::quad4, Shape::quadrilateral, "quad4", 2, 1, 4, quad4),
    make_topology(CellType::quad9, Shape::quadrilateral, "quad9", 2, 2, 4, quad9),
    make_topology(CellType::tet4, Shape::tetrahedron, "tet4", 3, 1, 4, tet4),
    make_topology(CellType::tet10, Shape::tetrahedron, "tet10", 3, 2, 4, tet10),
    make_topology(CellType::hex8, Shape::hexahedron, "hex8", 3, 1, 8, hex8),
    make_topology(CellType::hex27, Shape::hexahedron, "hex27", 3, 2, 8, hex27),
    make_topology(CellType::wedge6, Shape::wedge, "wedge6", 3, 1, 6, wedge6),
    make_topology(CellType::wedge18, Shape::wedge, "wedge18", 3, 2, 6, wedge18),
};

constexpr std::size_t position(CellType type) noexcept {
    switch (type) {
        case CellType::line2: return 0;
        case CellType::line3: return 1;
        case CellType::triangle3: return 2;
        case CellType::triangle6: return 3;
        case CellType::quad4: return 4;
        case CellType::quad9: return 5;
        case CellType::tet4: return 6;
        case CellType::tet10: return 7;
        case CellType::hex8: return 8;
        case CellType::hex27: return 9;
        case CellType::wedge6: return 10;
        case CellType::wedge18: return 11;
    }
    return 0;
}

}  // namespace

const CellTopology& topology(CellType type) noexcept { return topologies[position(type)]; }

std::optional<CellType> cell_type_from_vtk(int vtk) noexcept {
    for (const CellTopology& t : topologies)
        if (static_cast<int>(t.type) == vtk) return t.type;
    return std::nullopt;
}

}  // namespace soft::mesh
