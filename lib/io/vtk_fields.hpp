#pragma once
/// Fields for ParaView in a copy of the file: /VTKHDF/PointData and /VTKHDF/CellData (schema: lib/io/README.md).
/// Tested by io/vtk_fields_test and tests/pipeline/paraview.sh.
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "solution/named_array.hpp"

namespace soft::io {

/// `image` (case or result) with these arrays, one value a point and one a cell, in its mesh; everything else as it
/// was, a path that is being computed included. Arrays of an earlier copy are replaced. Throws Error(bad_input) as
/// read_case does, Error(internal) for arrays that do not fit the mesh.
[[nodiscard]] std::vector<std::byte> with_vtk_fields(std::span<const std::byte> image, std::string_view source,
                                                     std::span<const solution::NamedArray> at_points,
                                                     std::span<const solution::NamedArray> at_cells);

}  // namespace soft::io
