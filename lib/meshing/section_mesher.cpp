#include "meshing/section_mesher.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "core/error.hpp"
#include "core/units.hpp"
#include "meshing/gmsh_session.hpp"

namespace soft::meshing {
namespace {

using mesh::Index;

constexpr int tag_of(std::size_t number) { return static_cast<int>(number) + 1; }  // gmsh counts from 1

/// The power of two that brings the section near unit size (gmsh's absolute tolerances mean lengths of order one);
/// a power of two changes no digit.
double unit_scale(const Section& section) {
    double largest = 0;
    for (const PlanePoint& p : section.points) largest = std::max({largest, std::abs(p[0]), std::abs(p[1])});
    return largest > 0 ? std::exp2(-std::round(std::log2(largest))) : 1.0;
}

/// Curves along a side and whether each is run from its start (+1) or from its end (-1).
struct Step {
    int curve;
    int sign;
};

std::vector<Step> steps(const Section& section, const std::vector<int>& side) {
    std::vector<Step> result;
    for (std::size_t i = 0; i + 1 < side.size(); ++i) {
        const int c = curve_between(section, {side[i], side[i + 1]});
        result.push_back({c, section.curves[static_cast<std::size_t>(c)].start == side[i] ? 1 : -1});
    }
    return result;
}

void describe(GmshSession& gmsh, const Section& section, double scale) {
    for (std::size_t p = 0; p < section.points.size(); ++p)
        gmsh.add_point(tag_of(p), {section.points[p][0] * scale, section.points[p][1] * scale});
    for (std::size_t c = 0; c < section.curves.size(); ++c) {
        const Curve& curve = section.curves[c];
        if (curve.centre == Curve::straight)
            gmsh.add_line(tag_of(c), {curve.start + 1, curve.end + 1});
        else
            gmsh.add_arc(tag_of(c), {curve.start + 1, curve.centre + 1, curve.end + 1});
        // A cell is two of gmsh's intervals: the ratio of neighbours that makes the last cell `grading` times the first.
        const double ratio = curve.cells > 1 ? std::pow(curve.grading, 0.5 / (curve.cells - 1)) : 1.0;
        gmsh.divide_curve(tag_of(c), {2 * curve.cells + 1, ratio});
    }
    for (std::size_t b = 0; b < section.blocks.size(); ++b) {
        GmshSession::Surface surface;
        for (const auto& side : section.blocks[b].sides) {
            surface.corners.push_back(side.front() + 1);
            for (const Step& step : steps(section, side)) surface.loop.push_back(step.sign * (step.curve + 1));
        }
        gmsh.add_grid(tag_of(b), std::move(surface));
    }
}

using Quad = std::array<std::size_t, 4>;  ///< gmsh node tags

/// What gmsh made, fetched in a few calls.
struct FineMesh {
    std::unordered_map<std::size_t, PlanePoint> nodes;
    std::vector<std::vector<std::size_t>> curves;  ///< node tags from start to end
    std::vector<std::vector<Quad>> blocks;
};

FineMesh fetch(const GmshSession& gmsh, const Section& section, double scale) {
    FineMesh fine;
    const auto [tags, xyz] = gmsh.nodes();
    fine.nodes.reserve(tags.size());
    for (std::size_t i = 0; i < tags.size(); ++i) fine.nodes[tags[i]] = {xyz[3 * i] / scale, xyz[3 * i + 1] / scale};
    for (std::size_t c = 0; c < section.curves.size(); ++c) {
        const auto pairs = gmsh.cells(1, tag_of(c));
        std::vector<std::size_t> chain;
        if (!pairs.empty()) chain.push_back(pairs.front());
        for (std::size_t i = 1; i < pairs.size(); i += 2) chain.push_back(pairs[i]);
        if (chain.size() != static_cast<std::size_t>(2 * section.curves[c].cells + 1))
            throw Error(ExitCode::internal, "section mesh", "gmsh divided curve " + std::to_string(c) + " otherwise");
        fine.curves.push_back(std::move(chain));
    }
    for (std::size_t b = 0; b < section.blocks.size(); ++b) {
        const auto corners = gmsh.cells(2, tag_of(b));
        std::vector<Quad> quads(corners.size() / 4);
        for (std::size_t q = 0; q < quads.size(); ++q)
            for (std::size_t k = 0; k < 4; ++k) quads[q][k] = corners[4 * q + k];
        fine.blocks.push_back(std::move(quads));
    }
    return fine;
}

/// Node tags along a side in its own sense.
std::vector<std::size_t> side_nodes(const Section& section, const FineMesh& fine, const std::vector<int>& side) {
    std::vector<std::size_t> nodes;
    for (const Step& step : steps(section, side)) {
        std::vector<std::size_t> chain = fine.curves[static_cast<std::size_t>(step.curve)];
        if (step.sign < 0) std::reverse(chain.begin(), chain.end());
        nodes.insert(nodes.end(), chain.begin() + (nodes.empty() ? 0 : 1), chain.end());
    }
    return nodes;
}

/// The nodes of a block as a grid; (i, j) runs along side 0 and away from it.
struct Grid {
    std::size_t columns, rows;
    std::vector<std::size_t> tags;
    std::size_t& at(std::size_t i, std::size_t j) { return tags[j * columns + i]; }
    [[nodiscard]] std::size_t at(std::size_t i, std::size_t j) const { return tags[j * columns + i]; }
};

/// Fills the grid from sides 0 and 3 by walking over the linear cells, so nothing depends on the order gmsh gives them.
Grid grid_of(const Section& section, const FineMesh& fine, std::size_t block) {
    const auto& sides = section.blocks[block].sides;
    const auto south = side_nodes(section, fine, sides[0]);
    auto west = side_nodes(section, fine, sides[3]);
    std::reverse(west.begin(), west.end());
    Grid grid{south.size(), west.size(), std::vector<std::size_t>(south.size() * west.size(), 0)};
    const auto& quads = fine.blocks[block];
    const Error unstructured(ExitCode::internal, "section mesh",
                             "gmsh gave block " + std::to_string(block) + " no regular grid");
    if (quads.size() != (grid.columns - 1) * (grid.rows - 1)) throw unstructured;

    std::unordered_map<std::size_t, std::vector<std::size_t>> around;
    for (std::size_t q = 0; q < quads.size(); ++q)
        for (const std::size_t tag : quads[q]) around[tag].push_back(q);
    const auto fourth = [&](std::size_t corner, std::size_t right, std::size_t up) {
        for (const std::size_t q : around[corner]) {
            const Quad& quad = quads[q];
            const auto holds = [&](std::size_t tag) { return std::find(quad.begin(), quad.end(), tag) != quad.end(); };
            if (holds(right) && holds(up))
                for (const std::size_t tag : quad)
                    if (tag != corner && tag != right && tag != up) return tag;
        }
        throw unstructured;
    };
    for (std::size_t i = 0; i < grid.columns; ++i) grid.at(i, 0) = south[i];
    for (std::size_t j = 0; j < grid.rows; ++j) grid.at(0, j) = west[j];
    for (std::size_t j = 0; j + 1 < grid.rows; ++j)
        for (std::size_t i = 0; i + 1 < grid.columns; ++i)
            grid.at(i + 1, j + 1) = fourth(grid.at(i, j), grid.at(i + 1, j), grid.at(i, j + 1));
    return grid;
}

/// Mesh under construction and the numbers it has given to gmsh's nodes.
class SectionBuilder {
public:
    SectionBuilder(const Section& section, const FineMesh& fine) : section_(section), fine_(fine) {
        result_.dimension = 2;
        for (const PlanePoint& p : section.points) snap_m_ = std::max({snap_m_, std::abs(p[0]), std::abs(p[1])});
        snap_m_ *= 1e-13;  // rounding of the interpolation; a node on the axis must have r = 0
    }

    void add(std::size_t block) {
        const Grid grid = grid_of(section_, fine_, block);
        const Index first = result_.cell_count();
        const std::int32_t own_region = region(section_.blocks[block].region);
        for (std::size_t j = 0; j + 2 < grid.rows; j += 2)
            for (std::size_t i = 0; i + 2 < grid.columns; i += 2) add_quad(grid, i, j, own_region);
        name_sides(block, first, static_cast<Index>(grid.columns / 2), static_cast<Index>(grid.rows / 2));
    }

    mesh::Mesh take() { return std::move(result_); }

private:
    Index number(std::size_t tag) {
        const auto [entry, fresh] = numbers_.try_emplace(tag, static_cast<Index>(result_.points.size()));
        if (fresh) {
            const PlanePoint p = fine_.nodes.at(tag);
            const auto snapped = [this](double value) { return std::abs(value) < snap_m_ ? 0.0 : value; };
            result_.points.push_back({snapped(p[0]), snapped(p[1]), 0.0});
        }
        return entry->second;
    }

    std::int32_t region(const std::string& name) {
        auto& names = result_.region_names;
        const auto found = std::ranges::find(names, name);
        const auto place = found - names.begin();
        if (found == names.end()) names.push_back(name);
        return static_cast<std::int32_t>(place);
    }

    void add_quad(const Grid& grid, std::size_t i, std::size_t j, std::int32_t own_region) {
        constexpr std::array<std::array<std::size_t, 2>, 9> vtk{
            {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}}};
        std::array<Index, 9> nodes{};
        for (std::size_t k = 0; k < 9; ++k) nodes[k] = number(grid.at(i + vtk[k][0], j + vtk[k][1]));
        add_cell(result_, mesh::CellType::quad9, nodes, own_region);
    }

    void name_sides(std::size_t block, Index first, Index columns, Index rows) {
        const auto& sides = section_.blocks[block].sides;
        for (int k = 0; k < 4; ++k) {
            Index place = 0;
            for (const Step& step : steps(section_, sides[static_cast<std::size_t>(k)])) {
                const Curve& curve = section_.curves[static_cast<std::size_t>(step.curve)];
                for (int n = 0; n < curve.cells; ++n, ++place) {
                    const std::array<Index, 4> cell{place, place * columns + columns - 1, rows * columns - 1 - place,
                                                    (rows - 1 - place) * columns};
                    for (const std::string& face : curve.faces)
                        result_.facet_sets[face].push_back({first + cell[static_cast<std::size_t>(k)], k});
                }
            }
        }
    }

    const Section& section_;
    const FineMesh& fine_;
    double snap_m_ = 0;
    std::unordered_map<std::size_t, Index> numbers_;
    mesh::Mesh result_;
};

/// gmsh takes points nearer to each other than 1e-8 of unit size for one and ends the program; so short an edge is a slip anyway.
void refuse_short_curves(const Section& section) {
    constexpr double min_share = 1e-6;
    const auto [low_x, high_x] = std::ranges::minmax(section.points, {}, [](const PlanePoint& p) { return p[0]; });
    const auto [low_y, high_y] = std::ranges::minmax(section.points, {}, [](const PlanePoint& p) { return p[1]; });
    const double extent_m = std::max(high_x[0] - low_x[0], high_y[1] - low_y[1]);
    for (const Curve& curve : section.curves) {
        const double edge_m = length(minus(section.points[static_cast<std::size_t>(curve.end)],
                                           section.points[static_cast<std::size_t>(curve.start)]));
        if (!(edge_m >= min_share * extent_m))
            throw Error(ExitCode::bad_input, "geometry",
                        "an edge of the section is " + core::quantity_text(edge_m, core::Dimension::length) +
                            " long, less than a millionth of the section's " +
                            core::quantity_text(extent_m, core::Dimension::length),
                        "enlarge the wall, fillet, land or angle that makes it so short, or leave it out");
    }
}

FineMesh run_gmsh(const Section& section) {
    refuse_short_curves(section);
    const double scale = unit_scale(section);
    GmshSession gmsh;
    describe(gmsh, section, scale);
    gmsh.mesh();
    return fetch(gmsh, section, scale);
}

}  // namespace

mesh::Mesh mesh_section(const Section& section) {
    check(section);
    const FineMesh fine = run_gmsh(section);
    SectionBuilder builder{section, fine};
    for (std::size_t b = 0; b < section.blocks.size(); ++b) builder.add(b);
    return builder.take();
}

}  // namespace soft::meshing
