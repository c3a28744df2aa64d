#include "io/vtk_fields.hpp"

#include <string>

#include "io/hdf5_read.hpp"
#include "io/hdf5_write.hpp"
#include "io/image.hpp"

namespace soft::io {
namespace {

void write_arrays(hid_t parent, const char* name, std::int64_t rows, std::span<const model::NamedArray> arrays) {
    if (H5Lexists(parent, name, H5P_DEFAULT) > 0 && H5Ldelete(parent, name, H5P_DEFAULT) < 0)
        throw Error(ExitCode::internal, name, "HDF5 cannot remove the group: " + hdf5_reason());
    const GroupHandle group = create_group(parent, name, "fields of one step, for ParaView");
    for (const model::NamedArray& array : arrays) {
        std::vector<hsize_t> shape{static_cast<hsize_t>(rows)};
        if (array.components > 1) shape.push_back(static_cast<hsize_t>(array.components));
        write_array<double>(group.get(), {array.name, array.units, array.description}, array.values, shape);
    }
}

}  // namespace

std::vector<std::byte> with_vtk_fields(std::span<const std::byte> image, std::string_view source,
                                       std::span<const model::NamedArray> at_points,
                                       std::span<const model::NamedArray> at_cells) {
    const ImageParts parts = split_image(image, source);
    const Origin origin{std::string{source}, image.size()};
    const FileHandle file = open_memory_copy(parts.hdf5);
    if (!file) throw Error(ExitCode::bad_input, source, "HDF5 cannot open it: " + hdf5_reason(), origin.remedy);
    const GroupReader mesh = GroupReader{file.get(), origin}.group("VTKHDF");
    const auto points = mesh.array<std::int64_t>("NumberOfPoints", {1})[0];
    const auto cells = mesh.array<std::int64_t>("NumberOfCells", {1})[0];
    const GroupHandle group{H5Gopen2(file.get(), "VTKHDF", H5P_DEFAULT)};
    write_arrays(group.get(), "PointData", points, at_points);
    write_arrays(group.get(), "CellData", cells, at_cells);
    std::vector<std::byte> copy = memory_image(file.get());
    seal(copy);
    for (const auto& step : parts.steps) {
        const auto record = make_record(RecordKind::step, step);
        copy.insert(copy.end(), record.begin(), record.end());
    }
    return copy;
}

}  // namespace soft::io
