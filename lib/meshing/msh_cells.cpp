#include "meshing/msh_cells.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string_view>

#include "mesh/shape.hpp"

namespace soft::meshing {
namespace {

using Corners = std::vector<int>;

/// Lists of digits, separated by blanks.
std::vector<Corners> corner_lists(std::string_view text) {
    std::vector<Corners> lists(1);
    for (const char c : text)
        if (c == ' ')
            lists.emplace_back();
        else
            lists.back().push_back(c - '0');
    return lists;
}

/// Mid nodes in Gmsh's order, each given by the corners of which it is the mean (reference manual, 'Node ordering').
std::vector<Corners> gmsh_mid_nodes(mesh::Shape shape) {
    switch (shape) {
        case mesh::Shape::line: return corner_lists("01");
        case mesh::Shape::triangle: return corner_lists("01 12 20");
        case mesh::Shape::quadrilateral: return corner_lists("01 12 23 30 0123");
        case mesh::Shape::tetrahedron: return corner_lists("01 12 20 30 23 13");
        case mesh::Shape::hexahedron:
            return corner_lists("01 03 04 12 15 23 26 37 45 47 56 67 0321 0154 0473 1265 2376 4567 01234567");
        case mesh::Shape::wedge: return corner_lists("01 02 03 12 14 25 34 35 45 0143 0352 1254");
    }
    return {};
}

/// The corners of which a node of the reference cell is the mean, ascending.
Corners corners_of(const mesh::CellTopology& cell, std::size_t node) {
    const std::vector<double> values = mesh::vertex_values(cell.type, cell.nodes[node]);
    Corners corners;
    for (std::size_t v = 0; v < values.size(); ++v)
        if (values[v] != 0) corners.push_back(static_cast<int>(v));
    return corners;
}

bool within(const Corners& part, const Corners& whole) {
    return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
}

}  // namespace

std::vector<int> gmsh_node_numbers(const MshType& type) {
    const mesh::CellTopology& cell = mesh::topology(type.cell.value());
    std::vector<Corners> order;
    for (int v = 0; v < cell.vertex_count; ++v) order.push_back({v});
    for (Corners& corners : gmsh_mid_nodes(cell.shape)) order.push_back(std::move(corners));
    order.resize(static_cast<std::size_t>(type.nodes));
    for (Corners& corners : order) std::sort(corners.begin(), corners.end());
    std::vector<int> numbers;
    for (std::size_t n = 0; n < cell.nodes.size(); ++n) {
        const auto found = std::find(order.begin(), order.end(), corners_of(cell, n));
        numbers.push_back(found == order.end() ? missing_node : static_cast<int>(found - order.begin()));
    }
    return numbers;
}

std::vector<Completion> completions(const MshType& type) {
    const mesh::CellTopology& cell = mesh::topology(type.cell.value());
    const std::vector<int> numbers = gmsh_node_numbers(type);
    std::vector<Completion> result;
    for (std::size_t n = 0; n < numbers.size(); ++n) {
        if (numbers[n] != missing_node) continue;
        Completion completion{static_cast<int>(n), {}, corners_of(cell, n)};
        std::vector<int> edges;
        for (std::size_t m = 0; m < numbers.size(); ++m) {
            const Corners corners = corners_of(cell, m);
            if (corners.size() == 2 && within(corners, completion.corners)) edges.push_back(static_cast<int>(m));
        }
        constexpr double corner_weight = -0.25;
        const double rest = 1 - corner_weight * static_cast<double>(completion.corners.size());
        for (const int corner : completion.corners) completion.parts.emplace_back(corner, corner_weight);
        for (const int edge : edges) completion.parts.emplace_back(edge, rest / static_cast<double>(edges.size()));
        result.push_back(std::move(completion));
    }
    return result;
}

std::vector<int> mirrored_order(mesh::CellType type) {
    const mesh::CellTopology& cell = mesh::topology(type);
    std::vector<int> order;
    for (const auto& xi : cell.nodes) {
        const auto found = std::find(cell.nodes.begin(), cell.nodes.end(), std::array<double, 3>{xi[1], xi[0], xi[2]});
        if (found == cell.nodes.end()) throw std::logic_error("mirrored_order: the reference cell is not symmetric");
        order.push_back(static_cast<int>(found - cell.nodes.begin()));
    }
    return order;
}

}  // namespace soft::meshing
