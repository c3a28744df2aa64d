#include "meshing/hollow.hpp"

#include <algorithm>
#include <map>

namespace soft::meshing {
namespace {

using mesh::Facet;
using mesh::Index;

constexpr Index removed = -1;

/// Corners of a facet in ascending order, the same for both cells that share it.
std::vector<Index> corners_of(const mesh::Mesh& mesh, const Facet& facet) {
    std::vector<Index> nodes = facet_nodes(mesh, facet);
    nodes.resize(static_cast<std::size_t>(mesh::topology(facet_type(mesh, facet)).vertex_count));
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

}  // namespace

mesh::Mesh hollowed(const mesh::Mesh& block, const std::function<std::string(Index cell)>& cavity) {
    std::vector<Index> cells;                                // new number of each cell, or `removed`
    std::map<std::vector<Index>, std::string> cavity_sides;  // facets of removed cells
    Index remaining = 0;
    for (Index c = 0; c < block.cell_count(); ++c) {
        const std::string name = cavity(c);
        cells.push_back(name.empty() ? remaining++ : removed);
        if (!name.empty())
            for (const Facet& side : sides_of(block, c)) cavity_sides[corners_of(block, side)] = name;
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
            if (const auto exposed = cavity_sides.find(corners_of(block, side)); exposed != cavity_sides.end())
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

}  // namespace soft::meshing
