#include "mesh/refine.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "mesh/arcs.hpp"
#include "mesh/shape.hpp"
#include "mesh/shared_nodes.hpp"

namespace soft::mesh {
namespace {

using Xi = std::array<double, 3>;
using ChildCorners = std::vector<Xi>;  ///< corners of a child in reference coordinates of the parent

Xi middle(const Xi& a, const Xi& b) { return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])}; }

/// Midpoints of edges of the parent, given by their end nodes; two equal ends give the corner itself.
ChildCorners between(const CellTopology& cell, std::initializer_list<std::array<int, 2>> ends) {
    ChildCorners corners;
    for (const auto& [a, b] : ends)
        corners.push_back(middle(cell.nodes[static_cast<std::size_t>(a)], cell.nodes[static_cast<std::size_t>(b)]));
    return corners;
}

/// One child of half the parent's size at each corner, then the children that fill the middle of simplices and wedges.
std::vector<ChildCorners> children_of(const CellTopology& cell) {
    std::vector<ChildCorners> children;
    for (int k = 0; k < cell.vertex_count; ++k) {
        ChildCorners corners;
        for (int v = 0; v < cell.vertex_count; ++v)
            corners.push_back(middle(cell.nodes[static_cast<std::size_t>(v)], cell.nodes[static_cast<std::size_t>(k)]));
        children.push_back(std::move(corners));
    }
    switch (cell.shape) {
        case Shape::triangle: children.push_back(between(cell, {{0, 1}, {1, 2}, {2, 0}})); break;
        case Shape::
            tetrahedron:  // Bey's order, with corners 0 and 2 of the second and fourth swapped for a positive orientation
            children.push_back(between(cell, {{0, 1}, {0, 2}, {0, 3}, {1, 3}}));
            children.push_back(between(cell, {{1, 2}, {0, 2}, {0, 1}, {1, 3}}));
            children.push_back(between(cell, {{0, 2}, {0, 3}, {1, 3}, {2, 3}}));
            children.push_back(between(cell, {{1, 3}, {1, 2}, {0, 2}, {2, 3}}));
            break;
        case Shape::wedge:  // the middle triangle, below and above half height
            for (const int layer : {0, 3}) {
                ChildCorners corners = between(cell, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}});
                for (Xi& corner : corners)
                    corner[2] = 0.5 * (corner[2] + cell.nodes[static_cast<std::size_t>(layer)][2]);
                children.push_back(std::move(corners));
            }
            break;
        case Shape::line:
        case Shape::quadrilateral:
        case Shape::hexahedron: break;
    }
    return children;
}

/// A node of the children.
struct ChildNode {
    Xi xi;
    std::vector<CornerWeight> weights;
    std::vector<ShapeValue> shapes;  ///< of the parent, at xi
    int parent_node = -1;            ///< the parent's node at this position; -1: none
    bool inside = false;             ///< in the interior of the parent: not shared with neighbours
};

/// Subdivision of a cell type. All coordinates are multiples of 1/4, so equal positions compare equal.
struct Pattern {
    std::vector<ChildNode> nodes;
    std::vector<std::vector<int>> children;  ///< indices into nodes, in the node order of the type
    std::vector<std::vector<Facet>> facets;  ///< child facets of each facet of the parent; `cell` is the child's number
};

/// Index of the node at xi; appends it if it is new.
int find_or_add_node(Pattern& pattern, const CellTopology& cell, const Xi& xi) {
    for (std::size_t p = 0; p < pattern.nodes.size(); ++p)
        if (pattern.nodes[p].xi == xi) return static_cast<int>(p);
    ChildNode child_node{xi, corner_weights(cell.type, xi), shape_values(cell.type, xi)};
    const auto own = std::find(cell.nodes.begin(), cell.nodes.end(), xi);
    if (own != cell.nodes.end()) child_node.parent_node = static_cast<int>(own - cell.nodes.begin());
    child_node.inside = child_node.weights.size() == static_cast<std::size_t>(cell.vertex_count);
    pattern.nodes.push_back(std::move(child_node));
    return static_cast<int>(pattern.nodes.size()) - 1;
}

bool is_on_facet(const ChildNode& node, const FacetTopology& side) {
    const auto end = side.nodes.begin() + topology(side.type).vertex_count;
    return std::all_of(node.weights.begin(), node.weights.end(), [&](const CornerWeight& part) {
        return std::find(side.nodes.begin(), end, part.corner) != end;
    });
}

/// The facets of the children on a facet of the parent.
std::vector<Facet> pieces_of(const Pattern& pattern, const CellTopology& cell, const FacetTopology& side) {
    std::vector<Facet> pieces;
    for (std::size_t child = 0; child < pattern.children.size(); ++child)
        for (std::size_t local = 0; local < cell.facets.size(); ++local) {
            const FacetTopology& own = cell.facets[local];
            const auto end = own.nodes.begin() + topology(own.type).vertex_count;
            if (std::all_of(own.nodes.begin(), end, [&](int node) {
                    const int index = pattern.children[child][static_cast<std::size_t>(node)];
                    return is_on_facet(pattern.nodes[static_cast<std::size_t>(index)], side);
                }))
                pieces.push_back({static_cast<Index>(child), static_cast<int>(local)});
        }
    return pieces;
}

Pattern pattern_of(CellType type) {
    const CellTopology& cell = topology(type);
    Pattern pattern;
    for (const ChildCorners& corners : children_of(cell)) {
        std::vector<int> child;
        for (const Xi& node : cell.nodes) {
            const std::vector<double> weights = vertex_values(type, node);
            Xi xi{};
            for (std::size_t v = 0; v < weights.size(); ++v)
                for (std::size_t d = 0; d < 3; ++d) xi[d] += weights[v] * corners[v][d];
            child.push_back(find_or_add_node(pattern, cell, xi));
        }
        pattern.children.push_back(std::move(child));
    }
    for (const FacetTopology& side : cell.facets) pattern.facets.push_back(pieces_of(pattern, cell, side));
    return pattern;
}

Point position(const std::vector<Point>& nodes, const std::vector<ShapeValue>& shapes) {
    Point X{};
    for (std::size_t a = 0; a < nodes.size(); ++a)
        for (std::size_t d = 0; d < 3; ++d) X[d] += shapes[a].value * nodes[a][d];
    return X;
}

/// Subdivision and node positions of a cell type.
struct Cutting {
    Pattern pattern;
    ArcMap arcs;
};

class Refinement {
public:
    Refinement(const Mesh& mesh, Curve curve) : coarse_(&mesh), curve_(curve) {
        for (const CellType type : mesh.cell_types)
            if (!cuttings_.contains(type)) cuttings_.emplace(type, Cutting{pattern_of(type), ArcMap(type)});
        Mesh& fine = result_.mesh;
        fine.dimension = mesh.dimension;
        fine.points = mesh.points;
        fine.region_names = mesh.region_names;
        fine.point_sets = mesh.point_sets;
        for (Index p = 0; p < static_cast<Index>(mesh.points.size()); ++p) {
            result_.nodes.push_back(p);
            result_.weights.push_back(1);
            result_.offsets.push_back(p + 1);
        }
    }

    Refined run() {
        for (Index c = 0; c < coarse_->cell_count(); ++c) cut(c);
        const Index children = Index{1} << coarse_->dimension;
        for (const auto& [name, facets] : coarse_->facet_sets) {
            auto& set = result_.mesh.facet_sets[name];
            for (const Facet& facet : facets) {
                const Pattern& pattern = cuttings_.at(coarse_->cell_type(facet.cell)).pattern;
                for (const Facet& piece : pattern.facets[static_cast<std::size_t>(facet.local)])
                    set.push_back({children * facet.cell + piece.cell, piece.local});
            }
        }
        return std::move(result_);
    }

private:
    void cut(Index c) {
        const Cutting& cutting = cuttings_.at(coarse_->cell_type(c));
        const auto nodes = coarse_->cell_nodes(c);
        std::vector<Point> positions;
        for (const Index node : nodes) positions.push_back(coarse_->point(node));
        std::vector<Index> numbers, child_nodes;
        for (const ChildNode& child_node : cutting.pattern.nodes) {
            const auto next = static_cast<Index>(result_.mesh.points.size());
            const Index number = child_node.parent_node >= 0 ? nodes[static_cast<std::size_t>(child_node.parent_node)]
                                 : child_node.inside         ? next
                                                             : shared_.number(nodes, child_node.weights, next);
            if (number == next) {
                result_.mesh.points.push_back(curve_ == Curve::circle ? cutting.arcs(positions, child_node.xi)
                                                                      : position(positions, child_node.shapes));
                add_parents(nodes, child_node.shapes);
            }
            numbers.push_back(number);
        }
        for (const std::vector<int>& child : cutting.pattern.children) {
            child_nodes.clear();
            for (const int index : child) child_nodes.push_back(numbers[static_cast<std::size_t>(index)]);
            add_cell(result_.mesh, coarse_->cell_type(c), child_nodes,
                     coarse_->cell_regions[static_cast<std::size_t>(c)]);
        }
    }

    void add_parents(std::span<const Index> nodes, const std::vector<ShapeValue>& shapes) {
        for (std::size_t a = 0; a < nodes.size(); ++a)
            if (shapes[a].value != 0) {
                result_.nodes.push_back(nodes[a]);
                result_.weights.push_back(shapes[a].value);
            }
        result_.offsets.push_back(static_cast<Index>(result_.nodes.size()));
    }

    const Mesh* coarse_;
    Curve curve_;
    std::map<CellType, Cutting> cuttings_;
    SharedNodes shared_;
    Refined result_;
};

}  // namespace

Mesh refine(const Mesh& mesh, int times, Curve curve) {
    if (times < 0) throw std::logic_error("refine: the number of refinements is negative");
    Mesh result = mesh;
    for (int i = 0; i < times; ++i) result = refine_once(result, curve).mesh;
    return result;
}

Refined refine_once(const Mesh& mesh, Curve curve) { return Refinement(mesh, curve).run(); }

std::vector<double> prolong(const Refined& refined, std::span<const double> field, int components) {
    const auto count = static_cast<std::size_t>(components);
    const Index coarse_points =
        refined.nodes.empty() ? 0 : *std::max_element(refined.nodes.begin(), refined.nodes.end()) + 1;
    if (field.size() != count * static_cast<std::size_t>(coarse_points))
        throw std::logic_error("prolong: the size of the field does not match the coarse mesh");
    const std::size_t points = refined.offsets.size() - 1;
    std::vector<double> result(count * points);
    for (std::size_t p = 0; p < points; ++p)
        for (auto k = static_cast<std::size_t>(refined.offsets[p]);
             k < static_cast<std::size_t>(refined.offsets[p + 1]); ++k)
            for (std::size_t i = 0; i < count; ++i)
                result[count * p + i] +=
                    refined.weights[k] * field[count * static_cast<std::size_t>(refined.nodes[k]) + i];
    return result;
}

}  // namespace soft::mesh
