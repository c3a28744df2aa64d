#pragma once
/// Outlines given as a table, for the families revolved and extruded.
///
/// Columns: x and r (extruded: x and y) with a unit of length in their headings (x_mm, r_mm), and tag. Each row is a point of
/// the outline; its tag names the face of the edge that starts there. The last point is connected to the first; a last row
/// that repeats the first and has no tag is ignored. The solid lies on the left. Optional columns:
///   curve         line (or empty), arc or spline: shape of the edge that starts at this row
///   via_x, via_r  for an arc: a point on it between its ends, in the unit of the headings
///   loop          a number or word; the rows of each further loop surround a hole
/// Consecutive spline rows with the same tag form one smooth curve. The optional data are columns rather than a second file, so
/// that an error refers to one row and one spreadsheet contains the whole shape. Tested by geometry/profile_test.
#include <string>
#include <string_view>
#include <vector>

#include "geometry/cell_size.hpp"
#include "geometry/family.hpp"
#include "meshing/outline.hpp"

namespace soft::geometry {

/// r: section of a body of revolution, r >= 0, edges on the axis are tagged `axis`. y: section that is extruded along z.
enum class Across { r, y };

inline constexpr const char* profile_key = "geometry.profile";

/// Table -> valid outline. `source` names the table in errors (bad_input, "source:line: ...").
[[nodiscard]] meshing::Outline outline_from(std::string_view text, std::string_view source, Across across);

/// The outline in the file that the key names, or in the value itself if that has several lines. Errors start with `location`, that
/// of the key in the design.
[[nodiscard]] meshing::Outline outline_of_file(const std::string& file, std::string_view location, Across across,
                                               std::string_view key = profile_key);

/// The tags of the edges, each once, in the order of the rows.
[[nodiscard]] std::vector<std::string> tags_of(const meshing::Outline& outline);

/// The common part of the two families: outline with cell sizes, symmetry planes, and cavities without openings (from the tag
/// `cavity` and from geometry.cavities, which combines several tags).
[[nodiscard]] Body body_of_profile(const design::Values& values, Across across);

/// The largest cell size: mesh.size, or derived from the extents of the section.
[[nodiscard]] CellSize profile_cells(const meshing::Outline& outline, const design::Values& values);

/// Keys mesh.* of both families.
[[nodiscard]] std::vector<design::Key> profile_mesh_keys();
[[nodiscard]] design::Key file_key(Across across);

}  // namespace soft::geometry
