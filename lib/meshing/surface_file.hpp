#pragma once
/// Writes the surface of a solid for other programs: STL (binary, in mm) or OBJ (text, in mm), selected by the extension.
/// Tested by meshing/body_surface_test.
#include <filesystem>

#include "core/error.hpp"
#include "core/files.hpp"
#include "surface/triangles.hpp"

namespace soft::meshing {

/// The Error(usage) for a name with another extension.
[[nodiscard]] Error surface_format_error(const std::filesystem::path& path);

/// The bytes of the file; throws surface_format_error.
[[nodiscard]] core::Bytes surface_file(const surface::Triangles& surface, const std::filesystem::path& path);

}  // namespace soft::meshing
