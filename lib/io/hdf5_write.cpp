#include "io/hdf5_write.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "core/error.hpp"
#include "io/hdf5_checks.hpp"

namespace soft::io {
namespace {

/// For smaller arrays HDF5's chunk index needs more space than compression saves.
constexpr hsize_t compress_from_bytes = 4096;
constexpr hsize_t chunk_bytes = hsize_t{1} << 20;
/// Higher levels compress floating-point data little better, and the default level 6 is several times slower.
constexpr unsigned gzip_level = 1;
constexpr std::size_t memory_growth = std::size_t{1} << 22;

template <class Status>
Status check(Status status, std::string_view what) {
    if (status < 0)
        throw Error(ExitCode::internal, "HDF5", std::string{what} + " failed while writing: " + hdf5_reason());
    return status;
}

/// Disables object time stamps, which would make the files of two runs differ.
PropertiesHandle without_times(hid_t property_class) {
    PropertiesHandle properties{check(H5Pcreate(property_class), "H5Pcreate")};
    check(H5Pset_obj_track_times(properties.get(), false), "H5Pset_obj_track_times");
    return properties;
}

void describe(hid_t dataset, const Label& label) {
    write_attribute(dataset, "units", label.units);
    write_attribute(dataset, "description", label.description);
}

TypeHandle text_type(std::size_t length, H5T_cset_t characters) {
    TypeHandle type{check(H5Tcopy(H5T_C_S1), "H5Tcopy")};
    check(H5Tset_size(type.get(), std::max<std::size_t>(length, 1)), "H5Tset_size");
    check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "H5Tset_strpad");
    check(H5Tset_cset(type.get(), characters), "H5Tset_cset");
    return type;
}

/// Chunks of about chunk_bytes that contain whole rows of the first dimension. Longer rows are divided along the second dimension.
std::vector<hsize_t> chunk_shape(const std::vector<hsize_t>& shape, std::size_t element_size) {
    std::vector<hsize_t> chunk = shape;
    const auto bytes_from = [&](std::size_t dimension) {
        return std::accumulate(chunk.begin() + static_cast<std::ptrdiff_t>(dimension), chunk.end(),
                               hsize_t{element_size}, std::multiplies<>{});
    };
    for (hsize_t& extent : chunk) extent = std::max<hsize_t>(extent, 1);
    const hsize_t row = bytes_from(1);
    chunk[0] = std::clamp<hsize_t>(chunk_bytes / row, 1, chunk[0]);
    if (chunk.size() > 1 && row > chunk_bytes) chunk[1] = std::max<hsize_t>(chunk_bytes / bytes_from(2), 1);
    return chunk;
}

void compress(hid_t properties, const std::vector<hsize_t>& chunk) {
    check(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), "H5Pset_chunk");
    check(H5Pset_shuffle(properties), "H5Pset_shuffle");
    check(H5Pset_deflate(properties, gzip_level), "H5Pset_deflate");
}

DatasetHandle create_dataset(hid_t parent, const Label& label, hid_t type, hid_t space, hid_t properties) {
    DatasetHandle dataset{
        check(H5Dcreate2(parent, label.name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), "H5Dcreate2")};
    describe(dataset.get(), label);
    return dataset;
}

void write_raw_attribute(hid_t object, const char* name, hid_t type, hid_t memory, hid_t space, const void* data) {
    const AttributeHandle attribute{
        check(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), "H5Acreate2")};
    check(H5Awrite(attribute.get(), memory, data), "H5Awrite");
}

SpaceHandle scalar_space() { return SpaceHandle{check(H5Screate(H5S_SCALAR), "H5Screate")}; }

FileHandle memory_file(std::span<const std::byte> hdf5) {
    const PropertiesHandle access{check(H5Pcreate(H5P_FILE_ACCESS), "H5Pcreate")};
    check(H5Pset_fapl_core(access.get(), memory_growth, false), "H5Pset_fapl_core");
    // H5Fget_file_image of HDF5 1.10.8 corrupts newer superblocks: it clears the status flags without updating the checksum.
    check(H5Pset_libver_bounds(access.get(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V110), "H5Pset_libver_bounds");
    // The name is not a path, since there is no backing store. It must be unique: HDF5 treats two open memory files of the same name
    // as the same file.
    const std::string name = "soft-actuator-" + std::to_string(access.get());
    if (hdf5.empty()) return FileHandle{H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get())};
    // HDF5 takes a void* but only copies from it.
    void* bytes = const_cast<std::byte*>(hdf5.data());  // NOLINT(*-const-cast)
    check(H5Pset_file_image(access.get(), bytes, hdf5.size()), "H5Pset_file_image");
    return FileHandle{H5Fopen(name.c_str(), H5F_ACC_RDWR, access.get())};
}

}  // namespace

template <>
hid_t file_type<double>() {
    return H5T_IEEE_F64LE;
}
template <>
hid_t file_type<std::int64_t>() {
    return H5T_STD_I64LE;
}
template <>
hid_t file_type<std::int32_t>() {
    return H5T_STD_I32LE;
}
template <>
hid_t file_type<std::uint8_t>() {
    return H5T_STD_U8LE;
}
template <>
hid_t memory_type<double>() {
    return H5T_NATIVE_DOUBLE;
}
template <>
hid_t memory_type<std::int64_t>() {
    return H5T_NATIVE_INT64;
}
template <>
hid_t memory_type<std::int32_t>() {
    return H5T_NATIVE_INT32;
}
template <>
hid_t memory_type<std::uint8_t>() {
    return H5T_NATIVE_UINT8;
}

FileHandle create_memory_file() {
    FileHandle file = memory_file({});
    check(file.get(), "H5Fcreate");
    return file;
}

FileHandle open_memory_copy(std::span<const std::byte> hdf5) { return memory_file(hdf5); }

std::vector<std::byte> memory_image(hid_t file) {
    check(H5Fflush(file, H5F_SCOPE_GLOBAL), "H5Fflush");
    const auto size = check(H5Fget_file_image(file, nullptr, 0), "H5Fget_file_image");
    std::vector<std::byte> bytes(static_cast<std::size_t>(size));
    check(H5Fget_file_image(file, bytes.data(), bytes.size()), "H5Fget_file_image");
    return bytes;
}

GroupHandle create_group(hid_t parent, const std::string& name, std::string_view description) {
    const PropertiesHandle properties = without_times(H5P_GROUP_CREATE);
    GroupHandle group{
        check(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), "H5Gcreate2")};
    write_attribute(group.get(), "description", description);
    return group;
}

template <class T>
void write_array(hid_t parent, const Label& label, std::span<const T> values, std::vector<hsize_t> shape) {
    if (shape.empty()) shape = {values.size()};
    const hsize_t count = std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<>{});
    if (count != values.size()) throw Error(ExitCode::internal, label.name, "shape and number of values differ");
    const PropertiesHandle properties = without_times(H5P_DATASET_CREATE);
    if (count * sizeof(T) >= compress_from_bytes) compress(properties.get(), chunk_shape(shape, sizeof(T)));
    const SpaceHandle space{
        check(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), "H5Screate_simple")};
    const DatasetHandle dataset = create_dataset(parent, label, file_type<T>(), space.get(), properties.get());
    if (count > 0)
        check(H5Dwrite(dataset.get(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "H5Dwrite");
}

template void write_array(hid_t, const Label&, std::span<const double>, std::vector<hsize_t>);
template void write_array(hid_t, const Label&, std::span<const std::int64_t>, std::vector<hsize_t>);
template void write_array(hid_t, const Label&, std::span<const std::int32_t>, std::vector<hsize_t>);
template void write_array(hid_t, const Label&, std::span<const std::uint8_t>, std::vector<hsize_t>);

void write_number(hid_t parent, const Label& label, double value) {
    const PropertiesHandle properties = without_times(H5P_DATASET_CREATE);
    const DatasetHandle dataset =
        create_dataset(parent, label, file_type<double>(), scalar_space().get(), properties.get());
    check(H5Dwrite(dataset.get(), memory_type<double>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &value), "H5Dwrite");
}

void write_text(hid_t parent, const Label& label, std::string_view text) {
    const TypeHandle type = text_type(text.size(), H5T_CSET_UTF8);
    const PropertiesHandle properties = without_times(H5P_DATASET_CREATE);
    const DatasetHandle dataset = create_dataset(parent, label, type.get(), scalar_space().get(), properties.get());
    const std::string padded = text.empty() ? std::string(1, '\0') : std::string{text};
    check(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), "H5Dwrite");
}

void write_texts(hid_t parent, const Label& label, std::span<const std::string> texts) {
    std::size_t width = 1;
    for (const std::string& text : texts) width = std::max(width, text.size());
    std::string padded;
    for (const std::string& text : texts) padded.append(text).append(width - text.size(), '\0');
    const TypeHandle type = text_type(width, H5T_CSET_UTF8);
    const hsize_t count = texts.size();
    const SpaceHandle space{check(H5Screate_simple(1, &count, nullptr), "H5Screate_simple")};
    const PropertiesHandle properties = without_times(H5P_DATASET_CREATE);
    const DatasetHandle dataset = create_dataset(parent, label, type.get(), space.get(), properties.get());
    if (count > 0) check(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), "H5Dwrite");
}

void write_attribute(hid_t object, const char* name, std::string_view text) {
    // ASCII if possible: the VTKHDF reader compares the type of the attribute `Type` including the character set.
    const bool ascii = std::all_of(text.begin(), text.end(), [](char c) { return c > 0; });
    const TypeHandle type = text_type(text.size(), ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
    const std::string padded = text.empty() ? std::string(1, '\0') : std::string{text};
    write_raw_attribute(object, name, type.get(), type.get(), scalar_space().get(), padded.data());
}

void write_attribute(hid_t object, const char* name, std::int64_t value) {
    write_raw_attribute(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, scalar_space().get(), &value);
}

void write_attribute(hid_t object, const char* name, std::span<const std::int64_t> values) {
    const hsize_t count = values.size();
    const SpaceHandle space{check(H5Screate_simple(1, &count, nullptr), "H5Screate_simple")};
    write_raw_attribute(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, space.get(), values.data());
}

DatasetHandle create_rows(hid_t parent, const Label& label, const std::vector<hsize_t>& row_shape) {
    std::vector<hsize_t> shape{0};
    shape.insert(shape.end(), row_shape.begin(), row_shape.end());
    std::vector<hsize_t> limit = shape;
    limit[0] = H5S_UNLIMITED;
    std::vector<hsize_t> chunk = chunk_shape(shape, sizeof(double));
    chunk[0] = 1;  // each row is written once; larger chunks would be compressed again at every step
    const PropertiesHandle properties = without_times(H5P_DATASET_CREATE);
    compress(properties.get(), chunk);
    const SpaceHandle space{
        check(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), limit.data()), "H5Screate_simple")};
    return create_dataset(parent, label, H5T_IEEE_F64LE, space.get(), properties.get());
}

void append_row(hid_t dataset, std::span<const double> row) {
    SpaceHandle space{check(H5Dget_space(dataset), "H5Dget_space")};
    std::vector<hsize_t> shape(static_cast<std::size_t>(check(H5Sget_simple_extent_ndims(space.get()), "rank")));
    check(H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr), "shape");
    std::vector<hsize_t> start(shape.size(), 0);
    start[0] = shape[0]++;
    check(H5Dset_extent(dataset, shape.data()), "H5Dset_extent");
    space = SpaceHandle{check(H5Dget_space(dataset), "H5Dget_space")};
    std::vector<hsize_t> count = shape;
    count[0] = 1;
    check(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), "selection");
    const hsize_t length = row.size();
    const SpaceHandle memory{check(H5Screate_simple(1, &length, nullptr), "H5Screate_simple")};
    check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, memory.get(), space.get(), H5P_DEFAULT, row.data()), "H5Dwrite");
}

}  // namespace soft::io
