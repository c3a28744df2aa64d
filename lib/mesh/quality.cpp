#include "mesh/quality.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "core/text.hpp"
#include "mesh/cell_map.hpp"

namespace soft::mesh {
namespace {

/// Shape functions at the reference nodes, one entry per node.
using Samples = std::vector<std::vector<ShapeValue>>;

Samples samples_of(CellType type) {
    Samples samples;
    for (const auto& xi : topology(type).nodes) samples.push_back(shape_values(type, xi));
    return samples;
}

struct Range {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    Point min_position_m{};
};

Range range_of(const Mesh& mesh, Index cell, const Samples& samples) {
    Range range;
    for (const auto& shapes : samples) {
        const CellMap map = map_cell(mesh, cell, shapes);
        range.max = std::max(range.max, map.determinant);
        if (map.determinant < range.min) {
            range.min = map.determinant;
            range.min_position_m = map.position;
        }
    }
    return range;
}

/// -1 for a cell that is inverted everywhere: its quotient would be positive and look valid.
double scaled(const Range& range) { return range.max > 0 ? range.min / range.max : -1.0; }

std::string location_text(const Point& p) {
    std::string text = "(";
    for (std::size_t i = 0; i < 3; ++i) text += (i > 0 ? ", " : "") + core::rounded_text(1e3 * p[i], 5);
    return text + ") mm";
}

}  // namespace

Quality quality(const Mesh& mesh) {
    std::map<CellType, Samples> tables;
    Quality result;
    double sum = 0;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        const CellType type = mesh.cell_type(cell);
        auto table = tables.find(type);
        if (table == tables.end()) table = tables.emplace(type, samples_of(type)).first;
        const Range range = range_of(mesh, cell, table->second);
        const double value = scaled(range);
        sum += value;
        if (value < result.min_scaled_jacobian || cell == 0) result = {value, 0, cell, range.min_position_m};
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
