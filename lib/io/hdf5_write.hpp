#pragma once
/// Writes typed datasets with units and descriptions. Internal to the module. All functions throw Error (internal) if HDF5 fails.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/handle.hpp"

namespace soft::io {

/// Name, units and description of a dataset. The latter two are stored as attributes of the dataset. Units "1": dimensionless.
struct Label {
    std::string name;
    std::string_view units;
    std::string_view description;
};

/// double, int64, int32 and uint8, little endian in the file.
template <class T>
[[nodiscard]] hid_t file_type();
template <class T>
[[nodiscard]] hid_t memory_type();
template <>
hid_t file_type<double>();
template <>
hid_t file_type<std::int64_t>();
template <>
hid_t file_type<std::int32_t>();
template <>
hid_t file_type<std::uint8_t>();
template <>
hid_t memory_type<double>();
template <>
hid_t memory_type<std::int64_t>();
template <>
hid_t memory_type<std::int32_t>();
template <>
hid_t memory_type<std::uint8_t>();

/// Creates an empty file in memory.
[[nodiscard]] FileHandle create_memory_file();
/// Opens a copy of the image in memory for writing. The handle is empty if HDF5 cannot open it.
[[nodiscard]] FileHandle open_memory_copy(std::span<const std::byte> hdf5);
/// Flushes the file and returns a copy of its bytes.
[[nodiscard]] std::vector<std::byte> memory_image(hid_t file);

[[nodiscard]] GroupHandle create_group(hid_t parent, const std::string& name, std::string_view description);

/// Row-major; `shape` defaults to one dimension. Large arrays are chunked, shuffled and compressed.
template <class T>
void write_array(hid_t parent, const Label& label, std::span<const T> values, std::vector<hsize_t> shape = {});
void write_number(hid_t parent, const Label& label, double value);
void write_text(hid_t parent, const Label& label, std::string_view text);
void write_texts(hid_t parent, const Label& label, std::span<const std::string> texts);

void write_attribute(hid_t object, const char* name, std::string_view text);
void write_attribute(hid_t object, const char* name, std::int64_t value);
void write_attribute(hid_t object, const char* name, std::span<const std::int64_t> values);

/// A dataset [0, row shape ...] of doubles that append_row() extends.
[[nodiscard]] DatasetHandle create_rows(hid_t parent, const Label& label, const std::vector<hsize_t>& row_shape);
void append_row(hid_t dataset, std::span<const double> row);

}  // namespace soft::io
