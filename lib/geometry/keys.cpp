#include "geometry/keys.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "core/units.hpp"
#include "meshing/section.hpp"

namespace soft::geometry {

std::string length_text(double length_m) { return core::quantity_text(length_m, core::Dimension::length); }

design::Key length_key(std::string_view name, std::string_view fallback, std::string_view meaning) {
    return {.path = "geometry." + std::string{name},
            .kind = design::Kind::length,
            .fallback = std::string{fallback},
            .meaning = std::string{meaning},
            .min = 0,
            .min_open = true};
}

design::Key size_key(std::string_view fallback) {
    return {.path = "mesh.size",
            .kind = design::Kind::length,
            .fallback = std::string{fallback},
            .meaning = "target edge length of a cell",
            .min = 0,
            .min_open = true};
}

design::Key through_wall_key() {
    return {.path = "mesh.through_wall",
            .kind = design::Kind::count,
            .fallback = "0",
            .meaning = "cells through the wall; 0 = by mesh.size",
            .min = 0,
            .max = 1000};
}

design::Key sectors_key() {
    // One curved cell over 90 degrees misses the circle by more than a per cent of its area, hence at least two. The
    // paper's bellows differs from its axisymmetric curve by 0.9, 0.3 and 0.1 % with 3, 4 and 5 (fourth order).
    return {.path = "mesh.sectors",
            .kind = design::Kind::count,
            .fallback = "5",
            .meaning = "cells around a quarter turn of a solid of revolution",
            .min = 2,
            .max = 1000};
}

design::Key grading_key(std::string_view fallback) {
    return {.path = "mesh.grading",
            .kind = design::Kind::ratio,
            .fallback = std::string{fallback},
            .meaning = "longest over shortest cell of a part: cells get shorter toward re-entrant edges; 1 = even",
            .min = 1,
            .max = 1000};
}

void refuse_too_many_cells(const design::Values& values, double cells) {
    if (cells > most_cells)
        throw values.refuse("mesh.size", "it would take " + core::rounded_text(cells, 2) + " cells", "a larger size");
}

int cells_through_wall(const design::Values& values, double wall_m, int least) {
    const int wished = values.count("mesh.through_wall");
    return wished > 0 ? wished : meshing::divisions(wall_m, values.number("mesh.size"), least);
}

std::vector<std::string> listed(const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(", ", at), text.size());
        names.push_back(text.substr(at, end - at));
        at = end + 2;
    }
    return names;
}

std::string not_smaller(double value_m, std::string_view other_name, double other_m) {
    return length_text(value_m) + " is not smaller than " + std::string{other_name} + " " + length_text(other_m);
}

std::string larger_than(double bound_m) { return "larger than " + length_text(bound_m); }

std::string smaller_than(double bound_m) { return "smaller than " + length_text(bound_m); }

std::string block(std::string_view key, std::string_view lines) {
    std::string text{"  "};
    text.append(key).append(": |\n");
    while (!lines.empty()) {
        const std::size_t end = std::min(lines.find('\n'), lines.size() - 1) + 1;
        text.append("    ").append(lines.substr(0, end));
        lines.remove_prefix(end);
    }
    return text;
}

}  // namespace soft::geometry
