#include "geometry/keys.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "core/units.hpp"
#include "meshing/section.hpp"

namespace soft::geometry {

std::string length_text(double length_m) { return core::quantity_text(length_m, core::Dimension::length); }

design::Key vector_key(std::string path, design::Kind kind, std::string meaning) {
    design::Key key = value_key(std::move(path), kind, {}, std::move(meaning));
    key.max_count = 3;
    return key;
}

mesh::Point point_of(const design::Values& values, const std::string& path) {
    const std::vector<double>& numbers = values.numbers(path);
    if (numbers.size() != 3) throw values.refuse(path, "three values are needed", "use [x, y, z]");
    return {numbers[0], numbers[1], numbers[2]};
}

design::Key file_unit_key(std::string path) {
    return design::choice_key(std::move(path), "mm", {"mm", "cm", "m", "in"},
                              "unit of the coordinates in the file; STEP files define their own");
}

design::Key length_key(std::string_view name, std::string_view fallback, std::string_view meaning) {
    return {.path = "geometry." + std::string{name},
            .kind = design::Kind::length,
            .fallback = std::string{fallback},
            .meaning = std::string{meaning},
            .min = 0,
            .min_open = true};
}

design::Key derived_key(std::string_view name, std::string_view meaning) {
    design::Key key = length_key(name, "auto", meaning);
    key.choices = {"auto"};
    return key;
}

double length_or(const design::Values& values, std::string_view name, double derived_m) {
    const double stated_m = values.number("geometry." + std::string{name});
    return stated_m > 0 ? stated_m : derived_m;
}

std::vector<design::Key> radii_keys(Radii usual, std::string_view inner, std::string_view outer) {
    const auto with_default = [](std::string_view meaning, double usual_m, double ratio, const char* other) {
        return std::string{meaning} + "; auto: " + core::rounded_text(ratio, 3) + " times " + other + ", or " +
               length_text(usual_m) + " if both are auto";
    };
    const double ratio = usual.outer_m / usual.inner_m;
    return {derived_key("inner_radius", with_default(inner, usual.inner_m, 1 / ratio, "outer_radius")),
            derived_key("outer_radius", with_default(outer, usual.outer_m, ratio, "inner_radius"))};
}

Radii radii_of(const design::Values& values, Radii usual) {
    const double ratio = usual.outer_m / usual.inner_m, inner_m = values.number("geometry.inner_radius"),
                 outer_m = values.number("geometry.outer_radius");
    const Radii radii{inner_m > 0   ? inner_m
                      : outer_m > 0 ? outer_m / ratio
                                    : usual.inner_m,
                      outer_m > 0   ? outer_m
                      : inner_m > 0 ? inner_m * ratio
                                    : usual.outer_m};
    if (!(radii.inner_m < radii.outer_m))
        throw values.refuse("geometry.inner_radius", not_smaller(radii.inner_m, "outer_radius", radii.outer_m),
                            smaller_than(radii.outer_m));
    return radii;
}

design::Key size_key() {
    return {
        .path = "mesh.size",
        .kind = design::Kind::length,
        .fallback = "auto",
        .meaning = "target edge length of a cell; auto: from the shape and mesh.quality, the same cells at every scale",
        .min = 0,
        .min_open = true,
        .choices = {"auto"}};
}

design::Key through_wall_key() {
    return {.path = "mesh.through_wall",
            .kind = design::Kind::count,
            .fallback = "auto",
            .meaning = "cells through the wall; auto: from mesh.size if stated, else from the shape and mesh.quality",
            .min = 0,
            .max = 1000,
            .choices = {"auto"}};
}

design::Key sectors_key() {
    // One curved cell over 90 degrees has an area error of more than 1 %, hence at least two. The paper's bellows differs
    // from its axisymmetric curve by 0.9, 0.3 and 0.1 % with 3, 4 and 5 cells (fourth order).
    return {.path = "mesh.sectors",
            .kind = design::Kind::count,
            .fallback = "auto",
            .meaning = "cells around a quarter turn of a solid of revolution; auto: 5 (draft 3, fine 8)",
            .min = 2,
            .max = 1000,
            .choices = {"auto"}};
}

design::Key grading_key(std::string_view fallback) {
    return {.path = "mesh.grading",
            .kind = design::Kind::ratio,
            .fallback = std::string{fallback},
            .meaning =
                "ratio of longest to shortest cell of a part: cells get shorter toward re-entrant edges; 1 = uniform",
            .min = 1,
            .max = 1000};
}

void refuse_too_many_cells(const design::Values& values, double cells) {
    if (cells > max_cells)
        throw values.refuse("mesh.size",
                            "the mesh would have " + core::rounded_text(cells, 2) + " cells (limit 5 million)",
                            "use a larger size");
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
    return length_text(value_m) + " is not smaller than " + std::string{other_name} + " (" + length_text(other_m) + ")";
}

std::string larger_than(double bound_m) { return "use a value above " + length_text(bound_m); }

std::string smaller_than(double bound_m) { return "use a value below " + length_text(bound_m); }

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
