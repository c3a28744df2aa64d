#include "meshing/box_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mesh/raise_order.hpp"
#include "meshing/cell_counts.hpp"
#include "meshing/section.hpp"

namespace soft::meshing {
namespace {

using Triple = std::array<int, 3>;

constexpr int nothing = -1;  // no box at this point

/// With more cells the exact number does not matter: there are too many.
constexpr double max_cells_between_planes = 1e5;

/// Planes closer than this share of the extent are merged: their positions are sums that differ by rounding.
constexpr double same_plane = 1e-9;

/// The blocks between the planes of all boxes, before they are divided into cells.
struct Blocks {
    const BoxBody& body;
    std::array<std::vector<double>, 3> planes;
    std::vector<int> top;  ///< the last box that covers each block, or `nothing`; z varies fastest

    [[nodiscard]] int count(std::size_t axis) const { return static_cast<int>(planes[axis].size()) - 1; }
    [[nodiscard]] int box(const Triple& block) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (block[axis] < 0 || block[axis] >= count(axis)) return nothing;
        return top[static_cast<std::size_t>((block[0] * count(1) + block[1]) * count(2) + block[2])];
    }
    [[nodiscard]] bool solid(const Triple& block) const {
        const int found = box(block);
        return found != nothing && body.boxes[static_cast<std::size_t>(found)].fill == Fill::solid;
    }
    [[nodiscard]] double length(std::size_t axis, int block) const {
        const auto b = static_cast<std::size_t>(block);
        return planes[axis][b + 1] - planes[axis][b];
    }
};

std::vector<double> planes_across(const BoxBody& body, std::size_t axis) {
    std::vector<double> all;
    for (const Box& box : body.boxes) all.insert(all.end(), {box.low[axis], box.high[axis]});
    std::ranges::sort(all);
    const double apart = same_plane * (all.back() - all.front());
    std::vector<double> planes;
    for (const double plane : all)
        if (planes.empty() || plane > planes.back() + apart) planes.push_back(plane);
    return planes;
}

int box_on_top(const BoxBody& body, const mesh::Point& point) {
    for (std::size_t b = body.boxes.size(); b-- > 0;) {
        const Box& box = body.boxes[b];
        bool inside = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
            inside = inside && box.low[axis] < point[axis] && point[axis] < box.high[axis];
        if (inside) return static_cast<int>(b);
    }
    return nothing;
}

Blocks blocks_of(const BoxBody& body) {
    if (body.boxes.empty()) throw std::logic_error("body without boxes");
    Blocks blocks{body, {planes_across(body, 0), planes_across(body, 1), planes_across(body, 2)}, {}};
    const auto middle = [&](std::size_t axis, int block) {
        return blocks.planes[axis][static_cast<std::size_t>(block)] + 0.5 * blocks.length(axis, block);
    };
    for (int i = 0; i < blocks.count(0); ++i)
        for (int j = 0; j < blocks.count(1); ++j)
            for (int k = 0; k < blocks.count(2); ++k)
                blocks.top.push_back(box_on_top(body, {middle(0, i), middle(1, j), middle(2, k)}));
    return blocks;
}

/// An edge is re-entrant if three of the four blocks around it are solid.
bool is_reentrant(const Blocks& blocks, Triple block, std::size_t axis, std::size_t other) {
    int solid = 0;
    for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
            Triple around = block;
            around[axis] -= a;
            around[other] -= b;
            solid += blocks.solid(around) ? 1 : 0;
        }
    return solid == 3;
}

/// Whether a re-entrant edge or the rim of a fixed face lies on a plane.
bool is_sharp(const Blocks& blocks, std::size_t axis, int plane) {
    if (plane == 0 && blocks.body.borders[axis][0].fixed) return true;
    if (plane == blocks.count(axis) && blocks.body.borders[axis][1].fixed) return true;
    for (const std::size_t other : {(axis + 1) % 3, (axis + 2) % 3}) {
        const std::size_t along = 3 - axis - other;
        for (int q = 1; q < blocks.count(other); ++q)
            for (int k = 0; k < blocks.count(along); ++k) {
                Triple block{};
                block[axis] = plane;
                block[other] = q;
                block[along] = k;
                if (is_reentrant(blocks, block, axis, other)) return true;
            }
    }
    return false;
}

/// Cells along one axis: start of each cell, end of the last one, and the block each belongs to.
struct Line {
    std::vector<double> at;
    std::vector<int> block;

    [[nodiscard]] int cells() const { return static_cast<int>(block.size()); }
};

std::vector<double> shares_between_planes(const Blocks& blocks, std::size_t axis, int b, const Spacing& spacing) {
    const double length_m = blocks.length(axis, b);
    const SharpEnds sharp{is_sharp(blocks, axis, b), is_sharp(blocks, axis, b + 1)};
    if (spacing.growth > 0 && spacing.grading > 1)
        return growing_shares(length_m, spacing.min_cells[axis], spacing, sharp);
    return graded_shares(divisions(length_m, spacing.size_m, spacing.min_cells[axis]), spacing.grading, sharp);
}

Line line_along(const Blocks& blocks, std::size_t axis, const Spacing& spacing) {
    Line line;
    for (int b = 0; b < blocks.count(axis); ++b) {
        const double length_m = blocks.length(axis, b);
        double at = blocks.planes[axis][static_cast<std::size_t>(b)];
        for (const double share : shares_between_planes(blocks, axis, b, spacing)) {
            line.at.push_back(at);
            line.block.push_back(b);
            at += share * length_m;
        }
    }
    line.at.push_back(blocks.planes[axis].back());
    return line;
}

Line mirrored(const Line& line) {
    if (line.at.front() != 0) throw std::logic_error("a body mirrored in y must begin at y = 0");
    Line whole;
    for (std::size_t i = line.at.size(); i-- > 1;) whole.at.push_back(-line.at[i]);
    whole.at.insert(whole.at.end(), line.at.begin(), line.at.end());
    whole.block.assign(line.block.rbegin(), line.block.rend());
    whole.block.insert(whole.block.end(), line.block.begin(), line.block.end());
    return whole;
}

std::array<Line, 3> lines_of(const Blocks& blocks, const Spacing& spacing) {
    std::array<Line, 3> lines;
    for (std::size_t axis = 0; axis < 3; ++axis) lines[axis] = line_along(blocks, axis, spacing);
    if (blocks.body.extent == Extent::mirrored_in_y) lines[1] = mirrored(lines[1]);
    return lines;
}

/// Number of cells between cell i and the next sharp end; 0 if there is none.
int cells_to_sharp_end(int i, int cells, SharpEnds sharp) {
    const int from_low = i, from_high = cells - 1 - i;
    return sharp.low && sharp.high ? std::min(from_low, from_high) : sharp.low ? from_low : sharp.high ? from_high : 0;
}

void scale_to_one(std::vector<double>& shares) {
    double sum = 0;
    for (const double share : shares) sum += share;
    for (double& share : shares) share /= sum;
}

/// Numbers the corners and names the sides of the solid cells.
class GridBuilder {
public:
    GridBuilder(const Blocks& blocks, const Spacing& spacing) : blocks_(blocks), lines_(lines_of(blocks, spacing)) {
        std::size_t corners = 1;
        for (const Line& line : lines_) corners *= line.at.size();
        numbers_.assign(corners, unset);
    }

    mesh::Mesh build() {
        for (int i = 0; i < lines_[0].cells(); ++i)
            for (int j = 0; j < lines_[1].cells(); ++j)
                for (int k = 0; k < lines_[2].cells(); ++k)
                    if (blocks_.solid(block_of({i, j, k}))) add(Triple{i, j, k});
        return std::move(mesh_);
    }

private:
    static constexpr mesh::Index unset = -1;

    /// The block of a cell; outside the grid a block without a box.
    [[nodiscard]] Triple block_of(const Triple& cell) const {
        Triple block{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool inside = cell[axis] >= 0 && cell[axis] < lines_[axis].cells();
            block[axis] = inside ? lines_[axis].block[static_cast<std::size_t>(cell[axis])] : nothing;
        }
        return block;
    }

    mesh::Index node(const Triple& corner) {
        std::size_t grid_index = 0;
        mesh::Point point{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto c = static_cast<std::size_t>(corner[axis]);
            grid_index = grid_index * lines_[axis].at.size() + c;
            point[axis] = lines_[axis].at[c];
        }
        if (numbers_[grid_index] == unset) {
            numbers_[grid_index] = static_cast<mesh::Index>(mesh_.points.size());
            mesh_.points.push_back(point);
        }
        return numbers_[grid_index];
    }

    std::int32_t region(const Triple& cell) {
        return region_number(mesh_, blocks_.body.boxes[static_cast<std::size_t>(blocks_.box(block_of(cell)))].name);
    }

    [[nodiscard]] std::string face_toward(const Triple& neighbour, std::size_t axis, std::size_t side) const {
        const int box = blocks_.box(block_of(neighbour));
        if (box != nothing)
            return blocks_.body.boxes[static_cast<std::size_t>(box)]
                .name;  // hollow, because a solid neighbour has no facet here
        const bool border = neighbour[axis] < 0 || neighbour[axis] >= lines_[axis].cells();
        const bool image = axis == 1 && blocks_.body.extent == Extent::mirrored_in_y;
        const std::string& face = blocks_.body.borders[axis][image ? 1 : side].face;
        return border && !face.empty() ? face : blocks_.body.outside;
    }

    void add(const Triple& cell) {
        constexpr std::array<Triple, 8> corners{
            // VTK's order
            {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
        std::array<mesh::Index, 8> nodes{};
        for (std::size_t n = 0; n < 8; ++n)
            nodes[n] = node({cell[0] + corners[n][0], cell[1] + corners[n][1], cell[2] + corners[n][2]});
        const mesh::Index number = mesh_.cell_count();
        mesh::add_cell(mesh_, mesh::CellType::hex8, nodes, region(cell));
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t side = 0; side < 2; ++side) {  // as topology(hex8) numbers them: -x, +x, -y, +y, -z, +z
                Triple neighbour = cell;
                neighbour[axis] += side == 0 ? -1 : 1;
                if (!blocks_.solid(block_of(neighbour)))
                    mesh_.facet_sets[face_toward(neighbour, axis, side)].push_back(
                        {number, static_cast<int>(2 * axis + side)});
            }
    }

    const Blocks& blocks_;
    std::array<Line, 3> lines_;
    std::vector<mesh::Index> numbers_;  ///< node numbers of the grid corners that belong to a cell
    mesh::Mesh mesh_;
};

}  // namespace

std::vector<double> graded_shares(int cells, double grading, SharpEnds sharp) {
    const int farthest = sharp.low && sharp.high ? (cells - 1) / 2 : cells - 1;
    std::vector<double> shares;
    for (int i = 0; i < cells; ++i)
        shares.push_back(farthest > 0
                             ? std::pow(grading, static_cast<double>(cells_to_sharp_end(i, cells, sharp)) / farthest)
                             : 1.0);
    scale_to_one(shares);
    return shares;
}

std::vector<double> growing_shares(double length_m, int min_cells, const Spacing& spacing, SharpEnds sharp) {
    constexpr double rounding = 1e-9;
    const bool any = sharp.low || sharp.high;
    const double shortest_m = any ? spacing.size_m / spacing.grading : spacing.size_m;
    const double stretch = sharp.low != sharp.high ? spacing.one_sided_stretch : spacing.stretch;
    const bool few = cell_count([&] { return length_m <= (1 + rounding) * stretch * shortest_m ? 1 : 0; }) == 1;
    if (few) return graded_shares(min_cells, 1, sharp);
    const auto length_of = [&](int i, int cells) {
        return std::min(spacing.size_m, shortest_m * std::pow(spacing.growth, cells_to_sharp_end(i, cells, sharp)));
    };
    const int enough = cell_count([&] {
        for (int cells = divisions(length_m, spacing.size_m, min_cells);; ++cells) {
            double sum_m = 0;
            for (int i = 0; i < cells; ++i) sum_m += length_of(i, cells);
            if (sum_m >= (1 - rounding) * length_m) return cells;
        }
    });
    std::vector<double> lengths_m;
    for (int i = 0; i < enough; ++i) lengths_m.push_back(length_of(i, enough));
    scale_to_one(lengths_m);
    return lengths_m;
}

double cells_of_boxes(const BoxBody& body, const Spacing& spacing) {
    const Blocks blocks = blocks_of(body);
    std::array<std::vector<double>, 3> counts;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int b = 0; b < blocks.count(axis); ++b) {
            const double length_m = blocks.length(axis, b);
            const double many = divisions(length_m, spacing.size_m, spacing.min_cells[axis]);
            counts[axis].push_back(many >= max_cells_between_planes
                                       ? many
                                       : static_cast<double>(shares_between_planes(blocks, axis, b, spacing).size()));
        }
    const auto cells = [&](std::size_t axis, int block) { return counts[axis][static_cast<std::size_t>(block)]; };
    double sum = 0;
    for (int i = 0; i < blocks.count(0); ++i)
        for (int j = 0; j < blocks.count(1); ++j)
            for (int k = 0; k < blocks.count(2); ++k)
                if (blocks.solid({i, j, k})) sum += cells(0, i) * cells(1, j) * cells(2, k);
    return body.extent == Extent::mirrored_in_y ? 2 * sum : sum;
}

mesh::Mesh mesh_of_boxes(const BoxBody& body, const Spacing& spacing) {
    const Blocks blocks = blocks_of(body);
    return mesh::raise_order(GridBuilder{blocks, spacing}.build());
}

}  // namespace soft::meshing
