#include "mesh/quality.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "core/text.hpp"
#include "mesh/cell_map.hpp"

namespace soft::mesh {
namespace {

/// Shapes at the reference nodes, one entry a sample.
using Samples = std::vector<std::vector<ShapeValue>>;

Samples samples_of(CellType type) {
    Samples samples;
    for (const auto& xi : topology(type).nodes) samples.push_back(shape_values(type, xi));
    return samples;
}

struct Range {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();
    Point min_at{};
};

Range range_of(const Mesh& mesh, Index cell, const Samples& samples) {
    Range range;
    for (const auto& shapes : samples) {
        const CellMap map = map_cell(mesh, cell, shapes);
        range.most = std::max(range.most, map.determinant);
        if (map.determinant < range.least) {
            range.least = map.determinant;
            range.min_at = map.position;
        }
    }
    return range;
}

/// A cell whose largest determinant is not positive is inside out everywhere: its quotient would read as sound.
double scaled(const Range& range) { return range.most > 0 ? range.least / range.most : -1.0; }

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
        if (value < result.min_scaled_jacobian || cell == 0) result = {value, 0, cell, range.min_at};
    }
    if (mesh.cell_count() > 0) result.mean_scaled_jacobian = sum / static_cast<double>(mesh.cell_count());
    if (!(result.min_scaled_jacobian > 0))
        throw Error(ExitCode::bad_input, "mesh",
                    "cell " + std::to_string(result.worst_cell) + " is turned inside out at " +
                        location_text(result.worst_place_m),
                    "a smaller mesh.size or a gentler shape");
    return result;
}

}  // namespace soft::mesh
