#include "meshing/capped.hpp"

#include <algorithm>

#include "meshing/hollow.hpp"
#include "meshing/regions.hpp"
#include "meshing/section_mesher.hpp"
#include "meshing/sweep.hpp"

namespace soft::meshing {
namespace {

/// Maps a block extruded in layers of unit length along the third axis to x, with the layer lengths of caps and chambers.
void lay_along_x(mesh::Mesh& block, const Capped& shape) {
    const double cap = shape.cap_cells, along = shape.along_cells;
    for (mesh::Point& p : block.points) {
        const double t = p[2];
        const double x = t <= cap           ? shape.cap_m * t / cap
                         : t <= cap + along ? shape.cap_m + (shape.length_m - 2 * shape.cap_m) * (t - cap) / along
                                            : shape.length_m - shape.cap_m * (2 * cap + along - t) / cap;
        p = {x, p[0], p[1]};
    }
}

/// Sets the cells of chambers, and of regions that end at the caps, to rubber within the caps.
void close_chambers(mesh::Mesh& block, const Capped& shape, const std::string& chamber) {
    const std::int32_t rubber = region_number(block, rubber_region);
    for (mesh::Index cell = 0; cell < block.cell_count(); ++cell) {
        const std::string& region = region_of(block, cell);
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

mesh::Mesh capped(const Section& section, const Capped& shape, const std::string& chamber) {
    const int layers = 2 * shape.cap_cells + shape.along_cells;
    mesh::Mesh block =
        extrude(mesh_section(section),
                {static_cast<double>(layers), layers, {shape.low_face}, {shape.high_face}, Extrusion::Along::z});
    lay_along_x(block, shape);
    close_chambers(block, shape, chamber);
    return hollowed(block, [&](mesh::Index cell) {
        const std::string& region = region_of(block, cell);
        return region.starts_with(chamber) ? region : std::string{};
    });
}

}  // namespace soft::meshing
