#pragma once
/// Cells between copies of a section, layer by layer. Private to the module; meshing/sweep.hpp describes the result. Tested by
/// meshing/sweep_test.
#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace soft::meshing::swept {

using mesh::CellType;
using mesh::Facet;
using mesh::Index;
using mesh::Point;

inline constexpr int none = -1;

/// Local facets of the solid cell that correspond to the swept edges of the section cell and to its two ends.
struct Sides {
    std::array<int, 4> edge;  ///< local facet of the solid for each edge of the section cell, or `none`
    int first, last;
};

inline constexpr Sides hexahedron_sides{{2, 1, 3, 0}, 4, 5};
inline constexpr Sides prism_sides{{2, 3, 4, none}, 0, 1};

/// A wedge whose edge 0 (of the turned section quadrilateral) lies on the axis.
inline constexpr Sides axis_wedge_sides{{none, 1, 3, 0}, 2, 4};

/// Planes are numbered in half layers: 2k is the face between cells, 2k + 1 the middle of a cell.
/// `Path` gives the position of a section node on a plane and which planes coincide for it.
template <class Path>
class Sweep {
public:
    Sweep(const mesh::Mesh& section, Path path, int layers)
        : section_(section),
          path_(path),
          planes_(2 * layers + 1),
          numbers_(section.points.size() * static_cast<std::size_t>(planes_), Index{none}) {
        solid_.region_names = section.region_names;
        first_of_.resize(static_cast<std::size_t>(section.cell_count()));
        pieces_.resize(first_of_.size());
        sides_of_.resize(first_of_.size());
        turned_.resize(first_of_.size());
        // Loop over section cells outside, layers inside: numbers stay local along slender bodies.
        for (Index cell = 0; cell < section.cell_count(); ++cell) {
            first_of_[static_cast<std::size_t>(cell)] = solid_.cell_count();
            for (int layer = 0; layer < layers; ++layer) add(cell, 2 * layer);
        }
        for (const auto& [name, facets] : section.facet_sets) sweep_set(name, facets, layers);
    }

    /// Names the facets at the first or the last plane.
    void name_first(const std::string& name) { name_end(name, 0, &Sides::first); }
    void name_last(const std::string& name) { name_end(name, (planes_ - 1) / 2 - 1, &Sides::last); }

    mesh::Mesh take() {
        for (auto& [name, facets] : solid_.facet_sets) std::sort(facets.begin(), facets.end());
        return std::move(solid_);
    }

private:
    Index node(Index section_node, int plane) {
        const int own = path_.plane(section_.point(section_node), plane);
        Index& number = numbers_[static_cast<std::size_t>(section_node) * static_cast<std::size_t>(planes_) +
                                 static_cast<std::size_t>(own)];
        if (number == none) {
            number = static_cast<Index>(solid_.points.size());
            solid_.points.push_back(path_.position(section_.point(section_node), own));
        }
        return number;
    }

    void add(Index cell, int plane) {
        const Index first = solid_.cell_count();
        add_one(cell, plane);
        pieces_[static_cast<std::size_t>(cell)] = static_cast<int>(solid_.cell_count() - first);
    }

    void add_one(Index cell, int plane) {
        const auto nodes = section_.cell_nodes(cell);
        const auto c = static_cast<std::size_t>(cell);
        std::array<bool, 4> on_axis{};
        const int corners = mesh::topology(section_.cell_type(cell)).vertex_count;
        int touching = 0;
        for (int k = 0; k < corners; ++k) {
            on_axis[k] = path_.is_fixed(section_.point(nodes[k]));
            touching += on_axis[k] ? 1 : 0;
        }
        const std::int32_t region = section_.cell_regions[c];
        if (corners == 3 && touching != 0) {
            add_axis_tetrahedra(nodes, on_axis, plane, region);
        } else if (corners == 3) {
            sides_of_[c] = prism_sides;
            add_prism(nodes, plane, region);
        } else if (touching == 0) {
            sides_of_[c] = hexahedron_sides;
            add_hexahedron(nodes, plane, region);
        } else {
            turned_[c] = axis_edge(on_axis, touching);
            sides_of_[c] = axis_wedge_sides;
            add_axis_wedge(nodes, turned_[c], plane, region);
        }
    }

    static int axis_edge(const std::array<bool, 4>& on_axis, int touching) {
        for (int k = 0; k < 4; ++k)
            if (touching == 2 && on_axis[k] && on_axis[(k + 1) % 4]) return k;
        throw std::logic_error("revolve: a quadrilateral of the section touches the axis other than in one edge");
    }

    /// Section node and half layer (0, 1, 2) of one node of the solid cell, in VTK order.
    struct Entry {
        int node, plane;
    };
    template <std::size_t N>
    static constexpr std::array<Entry, N> zipped(const std::array<int, N>& nodes, const std::array<int, N>& planes) {
        std::array<Entry, N> entries{};
        for (std::size_t i = 0; i < N; ++i) entries[i] = {nodes[i], planes[i]};
        return entries;
    }
    template <std::size_t N>
    void emit(CellType type, const std::array<Entry, N>& entries, std::span<const Index> nodes, int plane,
              std::int32_t region) {
        std::array<Index, N> cell{};
        for (std::size_t i = 0; i < N; ++i) cell[i] = node(nodes[entries[i].node], plane + entries[i].plane);
        add_cell(solid_, type, cell, region);
    }

    void add_hexahedron(std::span<const Index> q, int plane, std::int32_t region) {
        constexpr std::array<Entry, 27> entries{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 2}, {1, 2}, {2, 2},
                                                 {3, 2}, {4, 0}, {5, 0}, {6, 0}, {7, 0}, {4, 2}, {5, 2},
                                                 {6, 2}, {7, 2}, {0, 1}, {1, 1}, {2, 1}, {3, 1}, {7, 1},
                                                 {5, 1}, {4, 1}, {6, 1}, {8, 0}, {8, 2}, {8, 1}}};
        emit(CellType::hex27, entries, q, plane, region);
    }

    void add_prism(std::span<const Index> t, int plane, std::int32_t region) {
        constexpr std::array<int, 18> nodes{0, 1, 2, 0, 1, 2, 3, 4, 5, 3, 4, 5, 0, 1, 2, 3, 4, 5};
        constexpr std::array<int, 18> planes{0, 0, 0, 2, 2, 2, 0, 0, 0, 2, 2, 2, 1, 1, 1, 1, 1, 1};
        emit(CellType::wedge18, zipped(nodes, planes), t, plane, region);
    }

    /// p = the quadrilateral rotated so that p0, p1 lie on the axis: triangles (p0, p3, p3') and (p1, p2, p2').
    void add_axis_wedge(std::span<const Index> q, int turn, int plane, std::int32_t region) {
        std::array<Index, 9> p{};
        for (int k = 0; k < 4; ++k) {
            p[k] = q[(k + turn) % 4];
            p[k + 4] = q[4 + (k + turn) % 4];
        }
        p[8] = q[8];
        constexpr std::array<int, 18> nodes{0, 3, 3, 1, 2, 2, 7, 3, 7, 5, 2, 5, 4, 6, 6, 8, 6, 8};
        constexpr std::array<int, 18> planes{0, 0, 2, 0, 0, 2, 0, 1, 2, 0, 1, 2, 0, 0, 2, 0, 1, 2};
        emit(CellType::wedge18, zipped(nodes, planes), p, plane, region);
    }

    using Corner = Entry;  ///< corner of a triangle on a plane

    /// The mid node between two corners of a tetrahedron. A corner on the axis lies on all planes.
    Entry between(Corner a, Corner b, const std::array<bool, 4>& on_axis) const {
        if (a.node == b.node) return {a.node, 1};
        const int middle = a.node + b.node == 1 ? 3 : a.node + b.node == 3 ? 4 : 5;  // of edges 01, 12, 20
        if (on_axis[a.node]) return {middle, b.plane};
        if (on_axis[b.node]) return {middle, a.plane};
        return {middle, (a.plane + b.plane) / 2};
    }

    void add_tetrahedron(std::span<const Index> t, const std::array<Corner, 4>& corners,
                         const std::array<bool, 4>& on_axis, int plane, std::int32_t region) {
        std::array<Entry, 10> entries{};
        std::copy(corners.begin(), corners.end(), entries.begin());
        constexpr std::array<std::array<std::size_t, 2>, 6> edges{{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};
        for (std::size_t e = 0; e < edges.size(); ++e)
            entries[4 + e] = between(corners[edges[e][0]], corners[edges[e][1]], on_axis);
        emit(CellType::tet10, entries, t, plane, region);
    }

    /// A triangle revolved about one of its edges gives a tetrahedron; about a corner a pyramid, which becomes two tetrahedra. Their
    /// common side meets the base along the diagonal from the smallest number, as split_into_simplices chooses it for the adjacent
    /// wedge.
    void add_axis_tetrahedra(std::span<const Index> t, const std::array<bool, 4>& on_axis, int plane,
                             std::int32_t region) {
        const auto only = [&](bool wanted) {
            return static_cast<int>(std::find(on_axis.begin(), on_axis.begin() + 3, wanted) - on_axis.begin());
        };
        const bool by_edge = std::count(on_axis.begin(), on_axis.begin() + 3, true) == 2;
        const int apex = only(!by_edge), b = (apex + 1) % 3, c = (apex + 2) % 3;
        const auto add = [&](const std::array<Corner, 4>& corners) {
            add_tetrahedron(t, corners, on_axis, plane, region);
        };
        if (by_edge) return add({{{b, 0}, {c, 0}, {apex, 0}, {apex, 2}}});
        const std::array<Corner, 4> base{{{b, 0}, {c, 0}, {c, 2}, {b, 2}}};
        const auto number = [&](const Corner& corner) {
            return node(t[static_cast<std::size_t>(corner.node)], plane + corner.plane);
        };
        const auto smallest = std::min_element(base.begin(), base.end(), [&](const Corner& one, const Corner& other) {
            return number(one) < number(other);
        });
        if ((smallest - base.begin()) % 2 == 0) {
            add({{{apex, 0}, base[0], base[1], base[2]}});
            add({{{apex, 0}, base[0], base[2], base[3]}});
        } else {
            add({{{apex, 0}, base[0], base[1], base[3]}});
            add({{{apex, 0}, base[1], base[2], base[3]}});
        }
    }

    /// Facets of the tetrahedra of a cell in one layer whose corners are all among `nodes`.
    void find_sides(Index cell, int layer, const std::vector<Index>& nodes, std::vector<Facet>& found) const {
        const auto c = static_cast<std::size_t>(cell);
        for (int piece = 0; piece < pieces_[c]; ++piece) {
            const Index solid = first_of_[c] + layer * pieces_[c] + piece;
            int local = 0;
            for (const mesh::FacetTopology& side : mesh::topology(CellType::tet10).facets) {
                const auto corners = std::span(side.nodes).first(3);
                if (std::all_of(corners.begin(), corners.end(), [&](int n) {
                        return std::find(nodes.begin(), nodes.end(),
                                         solid_.cell_nodes(solid)[static_cast<std::size_t>(n)]) != nodes.end();
                    }))
                    found.push_back({solid, local});
                ++local;
            }
        }
    }

    [[nodiscard]] bool is_of_tetrahedra(Index cell) const {
        return solid_.cell_type(first_of_[static_cast<std::size_t>(cell)]) == CellType::tet10;
    }

    void sweep_set(const std::string& name, const std::vector<Facet>& facets, int layers) {
        std::vector<Facet> swept;
        for (const Facet& facet : facets) {
            const auto c = static_cast<std::size_t>(facet.cell);
            if (is_of_tetrahedra(facet.cell)) {
                const auto ends = mesh::facet_nodes(section_, facet);
                if (path_.is_fixed(section_.point(ends[0])) && path_.is_fixed(section_.point(ends[1]))) continue;
                for (int layer = 0; layer < layers; ++layer)
                    find_sides(facet.cell, layer,
                               {node(ends[0], 2 * layer), node(ends[1], 2 * layer), node(ends[0], 2 * layer + 2),
                                node(ends[1], 2 * layer + 2)},
                               swept);
                continue;
            }
            const int edges = static_cast<int>(mesh::topology(section_.cell_type(facet.cell)).facets.size());
            const int edge = (facet.local - turned_[c] + edges) % edges;
            const int local = sides_of_[c].edge[edge];
            if (local == none) continue;
            for (int layer = 0; layer < layers; ++layer) swept.push_back({first_of_[c] + layer, local});
        }
        if (!swept.empty()) solid_.facet_sets[name] = std::move(swept);
    }

    void name_end(const std::string& name, int layer, int Sides::*side) {
        auto& set = solid_.facet_sets[name];
        for (std::size_t c = 0; c < first_of_.size(); ++c) {
            const auto cell = static_cast<Index>(c);
            if (!is_of_tetrahedra(cell)) {
                set.push_back({first_of_[c] + layer, sides_of_[c].*side});
                continue;
            }
            std::vector<Index> corners;
            for (std::size_t k = 0; k < 3; ++k)
                corners.push_back(
                    node(section_.cell_nodes(cell)[k], side == &Sides::first ? 2 * layer : 2 * layer + 2));
            find_sides(cell, layer, corners, set);
        }
    }

    const mesh::Mesh& section_;
    Path path_;
    int planes_;
    std::vector<Index> numbers_;  ///< solid node of (section node, plane)
    mesh::Mesh solid_;
    std::vector<Index> first_of_;  ///< first solid cell of each section cell; the others of all layers follow
    std::vector<int> pieces_;      ///< solid cells per layer: 1, or tetrahedra at the axis
    std::vector<Sides> sides_of_;
    std::vector<int> turned_;  ///< number of corners by which an axis quadrilateral was rotated
};

}  // namespace soft::meshing::swept
