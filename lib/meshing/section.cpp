#include "meshing/section.hpp"
#include "meshing/cell_counts.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace soft::meshing {
namespace {

/// Twice the area of the polygon through the points of the sides; its sign gives the orientation.
double turning(const Section& section, const std::array<std::vector<int>, 4>& sides) {
    double sum = 0;
    for (const auto& side : sides)
        for (std::size_t i = 0; i + 1 < side.size(); ++i) {
            const PlanePoint& a = section.points[static_cast<std::size_t>(side[i])];
            const PlanePoint& b = section.points[static_cast<std::size_t>(side[i + 1])];
            sum += a[0] * b[1] - b[0] * a[1];
        }
    return sum;
}

int cells_along(const Section& section, const std::vector<int>& side) {
    int cells = 0;
    for (std::size_t i = 0; i + 1 < side.size(); ++i)
        cells += section.curves[static_cast<std::size_t>(curve_between(section, {side[i], side[i + 1]}))].cells;
    return cells;
}

}  // namespace

int add_point(Section& section, PlanePoint point) {
    section.points.push_back(point);
    return static_cast<int>(section.points.size()) - 1;
}

int add_line(Section& section, Ends ends, int cells, std::vector<std::string> faces) {
    return add_arc(section, ends, Curve::straight, cells, std::move(faces));
}

int add_graded_line(Section& section, Ends ends, int cells, double grading, std::vector<std::string> faces) {
    const int line = add_line(section, ends, cells, std::move(faces));
    section.curves.back().grading = grading;
    return line;
}

int add_arc(Section& section, Ends ends, int centre, int cells, std::vector<std::string> faces) {
    section.curves.push_back({ends.start, ends.end, centre, cells, std::move(faces)});
    return static_cast<int>(section.curves.size()) - 1;
}

int add_block(Section& section, std::array<std::vector<int>, 4> sides, std::string region) {
    if (turning(section, sides) < 0) {
        std::reverse(sides.begin(), sides.end());
        for (auto& side : sides) std::reverse(side.begin(), side.end());
    }
    section.blocks.push_back({std::move(sides), std::move(region)});
    return static_cast<int>(section.blocks.size()) - 1;
}

int curve_between(const Section& section, Ends ends) {
    const auto found = std::find_if(section.curves.begin(), section.curves.end(), [&](const Curve& c) {
        return (c.start == ends.start && c.end == ends.end) || (c.start == ends.end && c.end == ends.start);
    });
    if (found == section.curves.end())
        throw std::logic_error("section: no curve joins points " + std::to_string(ends.start) + " and " +
                               std::to_string(ends.end));
    return static_cast<int>(found - section.curves.begin());
}

double cell_count(const Section& section) {
    double cells = 0;
    for (const Block& block : section.blocks)
        cells += static_cast<double>(cells_along(section, block.sides[0])) * cells_along(section, block.sides[1]);
    return cells;
}

int divisions(double length_m, double size_m, int min_cells) {
    constexpr double max_cells = 100000;  // far more than can be solved, and safe to convert to int
    constexpr double rounding = 1e-9;     // so that halves round to the same number in millimetres and in metres
    return cell_count([&] {
        return std::max(min_cells, static_cast<int>(std::lround(std::min(length_m / size_m + rounding, max_cells))));
    });
}

Section rectangle(const Rectangle& shape) {
    Section s;
    const int a = add_point(s, {0, 0});
    const int b = add_point(s, {shape.length_m, 0});
    const int c = add_point(s, {shape.length_m, shape.height_m});
    const int d = add_point(s, {0, shape.height_m});
    add_line(s, {a, b}, shape.cells_along, shape.bottom);
    add_line(s, {b, c}, shape.cells_across, shape.right);
    add_line(s, {c, d}, shape.cells_along, shape.top);
    add_line(s, {d, a}, shape.cells_across, shape.left);
    add_block(s, {{{a, b}, {b, c}, {c, d}, {d, a}}});
    return s;
}

void add_quarter_ring(Section& section, const QuarterRing& ring) {
    const auto at = [&](double x, double r) { return add_point(section, {ring.origin_m + ring.sign * x, r}); };
    const int centre = at(0, 0);
    const int a = at(ring.inner_m, 0), b = at(ring.outer_m, 0), c = at(0, ring.outer_m), d = at(0, ring.inner_m);
    add_graded_line(section, {a, b}, ring.through, ring.grading, {ring.low});
    add_arc(section, {b, c}, centre, ring.around, {ring.outer});
    add_graded_line(section, {c, d}, ring.through, 1 / ring.grading, {ring.high});
    add_arc(section, {d, a}, centre, ring.around, {ring.inner});
    add_block(section, {{{a, b}, {b, c}, {c, d}, {d, a}}}, ring.region);
}

void check(const Section& section) {
    for (std::size_t b = 0; b < section.blocks.size(); ++b) {
        const auto& sides = section.blocks[b].sides;
        const std::string location = "section: block " + std::to_string(b);
        for (std::size_t k = 0; k < 4; ++k)
            if (sides[k].size() < 2 || sides[k].back() != sides[(k + 1) % 4].front())
                throw std::logic_error(location + ": side " + std::to_string(k) + " does not connect to the next");
        for (std::size_t k = 0; k < 2; ++k) {
            const int one = cells_along(section, sides[k]), other = cells_along(section, sides[k + 2]);
            if (one != other)
                throw std::logic_error(location + ": opposite sides have " + std::to_string(one) + " and " +
                                       std::to_string(other) + " cells");
        }
    }
}

}  // namespace soft::meshing
