#include "meshing/capped.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "meshing/section_mesher.hpp"
#include "meshing/sweep.hpp"

namespace soft::meshing {
namespace {

using mesh::Facet;
using mesh::Index;

constexpr Index removed = -1;

/// Corners of a facet in ascending order, the same for both cells that share it.
std::vector<Index> sorted_corners(const mesh::Mesh& mesh, const Facet& facet) {
    std::vector<Index> nodes = facet_corners(mesh, facet);
    std::ranges::sort(nodes);
    return nodes;
}

std::vector<Facet> sides_of(const mesh::Mesh& mesh, Index cell) {
    std::vector<Facet> sides;
    for (std::size_t f = 0; f < mesh::topology(mesh.cell_type(cell)).facets.size(); ++f)
        sides.push_back({cell, static_cast<int>(f)});
    return sides;
}

/// Numbers in the order of first use.
class Renumbering {
public:
    explicit Renumbering(std::size_t size) : numbers_(size, removed) {}
    Index operator()(Index old) {
        Index& number = numbers_[static_cast<std::size_t>(old)];
        if (number == removed) {
            number = static_cast<Index>(kept_.size());
            kept_.push_back(old);
        }
        return number;
    }
    [[nodiscard]] const std::vector<Index>& kept() const { return kept_; }

private:
    std::vector<Index> numbers_, kept_;
};

/// The planes between the layers of cells.
std::vector<double> planes_m(const Capped& shape) {
    std::vector<double> planes;
    for (int i = 0; i < shape.cap_cells; ++i) planes.push_back(shape.cap_m * i / shape.cap_cells);
    double share = 0;
    for (const double next : shape.shares) {
        planes.push_back(shape.cap_m + (shape.length_m - 2 * shape.cap_m) * share);
        share += next;
    }
    for (int i = shape.cap_cells; i >= 0; --i) planes.push_back(shape.length_m - shape.cap_m * i / shape.cap_cells);
    return planes;
}

/// Maps a block extruded in layers of unit length along the third axis to x.
void lay_along_x(mesh::Mesh& block, const Capped& shape) {
    const std::vector<double> planes = planes_m(shape);
    for (mesh::Point& p : block.points) {
        const std::size_t layer = std::min(static_cast<std::size_t>(p[2]), planes.size() - 2);
        const double x = std::lerp(planes[layer], planes[layer + 1], p[2] - static_cast<double>(layer));
        p = {x, p[0], p[1]};
    }
}

/// Sets the cells of chambers, and of regions that end at the caps, to rubber within the caps.
void close_chambers(mesh::Mesh& block, const Capped& shape, const std::string& chamber) {
    const std::int32_t rubber = region_number(block, rubber_region);
    for (mesh::Index cell = 0; cell < block.cell_count(); ++cell) {
        const std::string& region = region_name(block, cell);
        if (!region.starts_with(chamber) && std::ranges::find(shape.between_caps, region) == shape.between_caps.end())
            continue;
        const auto corners = block.cell_nodes(cell).first(8);
        double x = 0;
        for (const mesh::Index node : corners) x += block.point(node)[0] / static_cast<double>(corners.size());
        if (x < shape.cap_m || x > shape.length_m - shape.cap_m)
            block.cell_regions[static_cast<std::size_t>(cell)] = rubber;
    }
}

}  // namespace

mesh::Mesh hollowed(const mesh::Mesh& block, const std::function<std::string(Index cell)>& cavity) {
    std::vector<Index> cells;                                // new number of each cell, or `removed`
    std::map<std::vector<Index>, std::string> cavity_sides;  // facets of removed cells
    Index remaining = 0;
    for (Index c = 0; c < block.cell_count(); ++c) {
        const std::string name = cavity(c);
        cells.push_back(name.empty() ? remaining++ : removed);
        if (!name.empty())
            for (const Facet& side : sides_of(block, c)) cavity_sides[sorted_corners(block, side)] = name;
    }
    mesh::Mesh result;
    result.dimension = block.dimension;
    Renumbering points(block.points.size()), regions(block.region_names.size());
    for (Index c = 0; c < block.cell_count(); ++c) {
        const Index number = cells[static_cast<std::size_t>(c)];
        if (number == removed) continue;
        std::vector<Index> nodes;
        for (const Index node : block.cell_nodes(c)) nodes.push_back(points(node));
        const Index region = regions(block.cell_regions[static_cast<std::size_t>(c)]);
        add_cell(result, block.cell_type(c), nodes, static_cast<std::int32_t>(region));
        for (const Facet& side : sides_of(block, c))
            if (const auto exposed = cavity_sides.find(sorted_corners(block, side)); exposed != cavity_sides.end())
                result.facet_sets[exposed->second].push_back({number, side.local});
    }
    for (const Index point : points.kept()) result.points.push_back(block.point(point));
    for (const Index region : regions.kept())
        result.region_names.push_back(block.region_names[static_cast<std::size_t>(region)]);
    for (const auto& [name, facets] : block.facet_sets)
        for (const Facet& facet : facets)
            if (const Index number = cells[static_cast<std::size_t>(facet.cell)]; number != removed)
                result.facet_sets[name].push_back({number, facet.local});
    return result;
}

mesh::Mesh capped(const Section& section, const Capped& shape, const std::string& chamber) {
    const int layers = shape.layers();
    mesh::Mesh block =
        extrude(mesh_section(section),
                {static_cast<double>(layers), layers, {shape.low_face}, {shape.high_face}, Extrusion::Along::z});
    lay_along_x(block, shape);
    close_chambers(block, shape, chamber);
    return hollowed(block, [&](mesh::Index cell) {
        const std::string& region = region_name(block, cell);
        return region.starts_with(chamber) ? region : std::string{};
    });
}

}  // namespace soft::meshing
