#pragma once
/// Consistency checks of the mesh and the shape of a case. Used after reading (files are untrusted input) and before writing. The
/// effective design is checked where it is read (model::CaseBuilder).
#include <string_view>

#include "core/error.hpp"
#include "mesh/mesh.hpp"
#include "model/shape.hpp"

namespace soft::io {

/// Throws Error (code) with the location in the file ("source:/mesh/facets/cavity[12]") at the first value that is not finite, is out
/// of range, or refers to an object that does not exist.
void check_case(const mesh::Mesh& mesh, const model::Shape& shape, std::string_view source, ExitCode code);

/// True for valid names of HDF5 links and CSV columns: letters, digits, '_', '-', '.', at most 100 characters, no leading '.'.
[[nodiscard]] bool is_name(std::string_view text) noexcept;

}  // namespace soft::io
