#pragma once
/// Fields as XML files of VTK: .vtu (UnstructuredGrid, reference positions; displacement_m moves them) and .pvd, which
/// lists a series in time. Points are region points (fields/region_points.hpp), so that jumps between rubbers stay
/// sharp. Numbers are doubles in base64. Source: the VTK file formats document (VTK 9). Tested by view/vtu_test and
/// tests/pipeline/paraview.sh.
#include <filesystem>
#include <span>
#include <string>

#include "fields/region_points.hpp"
#include "model/case.hpp"
#include "solution/named_array.hpp"

namespace soft::view {

/// The .vtu file as text; besides the arrays the cells carry `region`, the number of their region.
[[nodiscard]] std::string vtu_text(const mesh::Mesh& mesh, const fields::RegionPoints& places,
                                   std::span<const solution::NamedArray> at_points,
                                   std::span<const solution::NamedArray> at_cells);

struct SeriesEntry {
    double time = 0;
    std::string file;  ///< relative to the .pvd
};
[[nodiscard]] std::string pvd_text(std::span<const SeriesEntry> entries);

}  // namespace soft::view
