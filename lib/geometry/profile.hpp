#pragma once
/// Outlines that people write as a table, for the families revolved and extruded.
///
/// Columns: x and r (extruded: x and y) with a unit of length in their headings (x_mm, r_mm), and tag. Each row is a point of
/// the outline; its tag names the face of the edge that starts there. The last point is joined to the first; a last row
/// that repeats the first and has no tag is left out. The solid lies on the left. Optional columns:
///   curve         line (or empty), arc or spline: how the edge goes on from this row
///   via_x, via_r  of an arc: a point on it between its ends, in the unit of their headings
///   loop          a number or word; rows of another loop go round a hole
/// Rows of a spline that follow each other with the same tag are one smooth curve. (Columns rather than a second file: a
/// fault then has one place, its row, and a spreadsheet holds the whole shape.) Tested by geometry/profile_test.
#include <string>
#include <string_view>
#include <vector>

#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "meshing/outline.hpp"

namespace soft::geometry {

/// r: of a body of revolution, r >= 0, edges on the axis are tagged `axis`. y: of a section drawn out along z.
enum class Across { r, y };

inline constexpr const char* profile_key = "geometry.profile";

/// Table -> sound outline. `source` names it in errors (bad_input, "source:line: ...").
[[nodiscard]] meshing::Outline outline_from(std::string_view text, std::string_view source, Across across);

/// The outline in the file that `geometry.profile` names, or, where that has several lines, in these themselves; errors start with the place of the key.
[[nodiscard]] meshing::Outline outline_of_file(const std::string& file, std::string_view place, Across across);

/// Their tags, each once, in the order of the rows.
[[nodiscard]] std::vector<std::string> tags_of(const meshing::Outline& outline);

/// What the two families have in common: outline with its sizes, cavities (that of the tag `cavity`, and those that
/// geometry.cavities makes of several tags) without openings, planes of symmetry.
[[nodiscard]] Body body_of_profile(const design::Values& values, Across across);

/// The longest cells: without mesh.size by the extents of the section.
[[nodiscard]] CellSize profile_cells(const meshing::Outline& outline, const design::Values& values);

/// Keys mesh.* of both.
[[nodiscard]] std::vector<design::Key> profile_mesh_keys();
[[nodiscard]] design::Key file_key(Across across);

}  // namespace soft::geometry
