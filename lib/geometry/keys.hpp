#pragma once
/// Keys that several families share, and texts for their error messages.
#include <string>
#include <string_view>
#include <vector>

#include "design/design.hpp"
#include "mesh/mesh.hpp"

namespace soft::geometry {

/// design::Key::most of a key that names a file or contains its lines.
inline constexpr int several_lines = 2;

/// A YAML block scalar below `geometry`: "  key: |" and the indented lines.
[[nodiscard]] std::string block(std::string_view key, std::string_view lines);

/// A positive length under "geometry."
[[nodiscard]] design::Key length_key(std::string_view name, std::string_view fallback, std::string_view meaning);

/// A length under "geometry." that is derived from others unless stated; its default is the word auto.
[[nodiscard]] design::Key derived_key(std::string_view name, std::string_view meaning);
/// Its value: `derived_m` if the design leaves it at auto.
[[nodiscard]] double length_or(const design::Values& values, std::string_view name, double derived_m);

/// Keys geometry.inner_radius and outer_radius. If one is stated, the other follows from the ratio of the defaults; if none is, both
/// have their defaults `usual`. Throws values.refuse(...) if the inner radius is not smaller.
struct Radii {
    double inner_m, outer_m;
};
[[nodiscard]] std::vector<design::Key> radii_keys(Radii usual, std::string_view inner, std::string_view outer);
[[nodiscard]] Radii radii_of(const design::Values& values, Radii usual);

/// mesh.size and mesh.through_wall, in every family.
[[nodiscard]] design::Key size_key();
[[nodiscard]] design::Key through_wall_key();

/// mesh.sectors, for bodies of revolution.
[[nodiscard]] design::Key sectors_key();

/// mesh.grading, for bodies made of boxes (box_grid.hpp) and of outlines (outline_sizes.hpp).
[[nodiscard]] design::Key grading_key(std::string_view fallback);

/// Throws Error above 5 million cells, so that a typing error in mesh.size does not exhaust the memory.
inline constexpr double max_cells = 5e6;
void refuse_too_many_cells(const design::Values& values, double cells);

/// A list of three lengths or numbers.
[[nodiscard]] design::Key vector_key(std::string path, design::Kind kind, std::string meaning);
/// Its value. Throws values.refuse(...) for a list of another length.
[[nodiscard]] mesh::Point point_of(const design::Values& values, const std::string& path);

/// Unit of the coordinates in a surface or mesh file.
[[nodiscard]] design::Key file_unit_key(std::string path);

/// "12 mm"
[[nodiscard]] std::string length_text(double length_m);
/// The names in a value of Kind::faces, or "none"; face names contain neither blanks nor commas.
[[nodiscard]] std::vector<std::string> listed(const std::string& text);

/// "12 mm is not smaller than outer_radius (10 mm)"
[[nodiscard]] std::string not_smaller(double value_m, std::string_view other_name, double other_m);

/// "use a value above 3 mm"
[[nodiscard]] std::string larger_than(double bound_m);

/// "use a value below 3 mm"
[[nodiscard]] std::string smaller_than(double bound_m);

}  // namespace soft::geometry
