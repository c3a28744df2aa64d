#pragma once
/// Adds fields for ParaView to a copy of the file: /VTKHDF/PointData and /VTKHDF/CellData (format: lib/io/README.md).
/// Tested by io/vtk_fields_test and tests/pipeline/paraview.sh.
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "model/named_array.hpp"

namespace soft::io {

/// A copy of `image` (case or result) with point and cell arrays added to its mesh. Everything else is unchanged, including the
/// steps of an unfinished path. Arrays of an earlier copy are replaced. Throws Error(bad_input) as read_case_file does, and
/// Error(internal) for arrays whose size does not match the mesh.
[[nodiscard]] std::vector<std::byte> with_vtk_fields(std::span<const std::byte> image, std::string_view source,
                                                     std::span<const model::NamedArray> at_points,
                                                     std::span<const model::NamedArray> at_cells);

}  // namespace soft::io
