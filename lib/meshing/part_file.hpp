#pragma once
/// A part from a surface file (STL, OBJ) or a CAD file (STEP): its closed surface and the findings on reading it.
/// CAD faces become triangles that turn by 5.6 degrees each (radii are 0.1 % too small at the middle of a triangle).
/// Tested by geometry/part_test.
#include <filesystem>
#include <string>

#include "meshing/body_surface.hpp"

namespace soft::meshing {

/// Whether the file name is that of a part: .stl, .obj, .step, .stp in upper or lower case.
[[nodiscard]] bool is_part_file(const std::filesystem::path& path);
[[nodiscard]] bool is_cad_file(const std::filesystem::path& path);

struct Part {
    SoupOrigin origin;
    BodySurface surface;
};
/// STEP files define their own unit; `unit` ("mm") and its length apply to the other formats. Throws Error(cannot_open), and
/// Error(bad_input) with the file for surfaces that meshing/body_surface.hpp rejects, CAD with no or several solids, and more than
/// 2 million facets.
[[nodiscard]] Part read_part(const std::filesystem::path& path, const std::string& unit, double unit_m);
/// The same for the lines of an OBJ file.
[[nodiscard]] Part read_obj(const std::string& lines, const std::string& unit, double unit_m);

}  // namespace soft::meshing
