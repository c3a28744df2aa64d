#pragma once
/// Fields as XML files of VTK: .vtu (UnstructuredGrid with reference positions; displacement_m is the displacement) and .pvd, which
/// lists a time series. Points are region points (post/region_points.hpp), so that jumps at material interfaces are
/// preserved. Numbers are doubles in base64. Source: the VTK file formats document (VTK 9). Tested by view/vtu_test and
/// tests/pipeline/paraview.sh.
#include <filesystem>
#include <span>
#include <string>

#include "model/case.hpp"
#include "model/named_array.hpp"
#include "post/region_points.hpp"

namespace soft::view {

/// The .vtu file as text; in addition to the given arrays, the cells have the array `region`, the index of their region.
[[nodiscard]] std::string vtu_text(const mesh::Mesh& mesh, const post::RegionPoints& region_points,
                                   std::span<const model::NamedArray> at_points,
                                   std::span<const model::NamedArray> at_cells);

struct SeriesEntry {
    double time = 0;
    std::string file;  ///< relative to the .pvd
};
[[nodiscard]] std::string pvd_text(std::span<const SeriesEntry> entries);

}  // namespace soft::view
