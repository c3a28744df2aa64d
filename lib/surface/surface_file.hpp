#pragma once
/// A solid's surface as a file for other programs: STL (binary, in mm) or OBJ (text, in mm) by the ending.
/// Tested by surface/body_surface_test.
#include <filesystem>

#include "core/error.hpp"
#include "core/files.hpp"
#include "surface/triangles.hpp"

namespace soft::surface {

/// Error(usage) for a name with another ending.
[[nodiscard]] Error no_surface_file(const std::filesystem::path& path);

/// The bytes of the file; throws no_surface_file.
[[nodiscard]] core::Bytes surface_file(const Triangles& surface, const std::filesystem::path& path);

}  // namespace soft::surface
