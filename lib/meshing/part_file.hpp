#pragma once
/// A part of a surface file (STL, OBJ) or of a CAD file (STEP): its closed surface and what was found on reading it.
/// CAD is taken as triangles that turn by 5.6 degrees each (radii come out 0.1 % short at the middle of a triangle).
/// Tested by geometry/part_test.
#include <filesystem>
#include <string>

#include "surface/body_surface.hpp"

namespace soft::meshing {

/// Whether a file of this name is a part: .stl, .obj, .step, .stp in upper or lower case.
[[nodiscard]] bool is_part_file(const std::filesystem::path& path);
[[nodiscard]] bool is_cad_file(const std::filesystem::path& path);

struct Part {
    surface::SoupOrigin origin;
    surface::BodySurface surface;
};
/// Lengths of STEP are what the file says; `unit` ("mm") and its length are of the others. Error(cannot_open); Error(bad_input) that
/// names the file for what surface/body_surface.hpp refuses, CAD without a volume or with several, and more than 2 million facets.
[[nodiscard]] Part read_part(const std::filesystem::path& path, const std::string& unit, double unit_m);
/// The same of the lines of an OBJ file.
[[nodiscard]] Part read_obj(const std::string& lines, const std::string& unit, double unit_m);

}  // namespace soft::meshing
