#include "mesh/quality.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "core/text.hpp"
#include "mesh/cell_map.hpp"

namespace soft::mesh {
namespace {

std::string location_text(const Point& p) {
    std::string text = "(";
    for (std::size_t i = 0; i < 3; ++i) text += (i > 0 ? ", " : "") + core::rounded_text(1e3 * p[i], 5);
    return text + ") mm";
}

}  // namespace

NodeShapes node_shapes(CellType type) {
    NodeShapes shapes;
    for (const auto& xi : topology(type).nodes) shapes.push_back(shape_values(type, xi));
    return shapes;
}

ScaledJacobian scaled_jacobian(const Mesh& mesh, Index cell, const NodeShapes& shapes) {
    double min = std::numeric_limits<double>::infinity(), max = -min;
    ScaledJacobian result;
    for (const auto& at_node : shapes) {
        const CellMap map = map_cell(mesh, cell, at_node);
        max = std::max(max, map.determinant);
        if (!(map.determinant < min)) continue;
        min = map.determinant;
        result.position_m = map.position;
    }
    if (max > 0) result.value = min / max;
    return result;
}

Quality quality(const Mesh& mesh) {
    std::map<CellType, NodeShapes> tables;
    Quality result;
    double sum = 0;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const CellType type = mesh.cell_type(cell);
        auto table = tables.find(type);
        if (table == tables.end()) table = tables.emplace(type, node_shapes(type)).first;
        const auto [value, position_m] = scaled_jacobian(mesh, cell, table->second);
        sum += value;
        if (value < result.min_scaled_jacobian || cell == 0) result = {value, 0, cell, position_m};
    }
    if (mesh.cell_count() > 0) result.mean_scaled_jacobian = sum / static_cast<double>(mesh.cell_count());
    if (!(result.min_scaled_jacobian > 0))
        throw Error(
            ExitCode::bad_input, "mesh",
            "cell " + std::to_string(result.worst_cell) + " is inverted at " + location_text(result.worst_position_m),
            "use a smaller mesh.size or a smoother shape");
    return result;
}

}  // namespace soft::mesh
