#include "io/hdf5_read.hpp"

#include <hdf5_hl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "core/text.hpp"
#include "io/case_check.hpp"
#include "io/hdf5_checks.hpp"
#include "io/hdf5_write.hpp"

namespace soft::io {
namespace {

constexpr hsize_t max_links = 10000;
constexpr std::size_t max_attribute_bytes = std::size_t{1} << 16;

template <class T>
constexpr std::string_view type_words = "";
template <>
constexpr std::string_view type_words<double> = "64-bit little-endian floats";
template <>
constexpr std::string_view type_words<std::int64_t> = "64-bit little-endian integers";
template <>
constexpr std::string_view type_words<std::int32_t> = "32-bit little-endian integers";
template <>
constexpr std::string_view type_words<std::uint8_t> = "unsigned bytes";

template <class T>
std::vector<T> allocate(const DatasetRef& ref, std::uint64_t count) {
    try {
        return std::vector<T>(static_cast<std::size_t>(count));
    } catch (const std::bad_alloc&) {
        throw Error(ExitCode::io_error, ref.location, "needs more memory than is available");
    }
}

template <class T>
void require_type(const DatasetRef& ref) {
    const TypeHandle type{H5Dget_type(ref.dataset)};
    if (H5Tequal(type.get(), file_type<T>()) <= 0) throw ref.refuse("does not hold " + std::string{type_words<T>});
}

/// Fixed length, padded with zeros. Variable-length text is rejected: HDF5 would follow pointers in the untrusted file.
void require_plain_text(const DatasetRef& ref, hid_t type) {
    const bool plain = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
                       H5Tget_strpad(type) != H5T_STR_SPACEPAD && H5Tget_size(type) > 0;
    if (!plain) throw ref.refuse("is not text of fixed length");
}

std::string unpadded(std::string_view text) { return std::string{text.substr(0, text.find('\0'))}; }

}  // namespace

FileHandle open_image(std::span<const std::byte> hdf5, const Origin& origin) {
    // With these flags HDF5 neither writes to nor frees the buffer, although it takes a void*.
    void* bytes = const_cast<std::byte*>(hdf5.data());  // NOLINT(*-const-cast)
    FileHandle file{H5LTopen_file_image(bytes, hdf5.size(), H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE)};
    if (!file) throw Error(ExitCode::bad_input, origin.source, "HDF5 cannot open it: " + hdf5_reason(), origin.remedy);
    return file;
}

GroupReader::GroupReader(GroupHandle group, std::string path, const Origin& origin)
    : group_(std::move(group)), path_(std::move(path)), origin_(&origin) {}

GroupReader::GroupReader(hid_t file, const Origin& origin)
    : GroupReader(GroupHandle{H5Gopen2(file, "/", H5P_DEFAULT)}, "", origin) {
    if (!group_) throw refuse("", "HDF5 cannot open the root group: " + hdf5_reason());
    if (!has_attribute("format") || text_attribute("format") != "soft-actuator")
        throw Error(ExitCode::bad_input, origin.source, "an HDF5 file, but not a soft-actuator file",
                    "expected a case from mesh-gen or a result from solve");
    const std::int64_t version = integer_attribute("format_version", 1)[0];
    if (version < format_version)
        throw Error(ExitCode::bad_input, origin.source,
                    "an older release wrote it (format " + std::to_string(version) + ", this program reads " +
                        std::to_string(format_version) + ")",
                    "generate the case again with mesh-gen, and solve it again");
    if (version > format_version)
        throw Error(ExitCode::bad_input, origin.source,
                    "a newer release wrote it (format " + std::to_string(version) + ", this program reads " +
                        std::to_string(format_version) + ")",
                    "use the same release of mesh-gen, solve and postprocess");
}

Error GroupReader::refuse(std::string_view item, std::string_view problem) const {
    return {ExitCode::bad_input, location_of(item), problem, origin_->remedy};
}

std::string GroupReader::location_of(std::string_view item) const {
    return origin_->source + ":" + path_ + "/" + std::string{item};
}

void GroupReader::require_finite(std::span<const double> values, const std::string& name) const {
    const auto bad = std::find_if_not(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
    if (bad != values.end())
        throw refuse(name + "[" + std::to_string(bad - values.begin()) + "]", "is not a finite number");
}

Error GroupReader::unknown_word(const std::string& name, const std::string& word) const {
    return refuse(name, core::quoted(word) + " is not a known value");
}

bool GroupReader::has(const std::string& name) const {
    const htri_t found = H5Lexists(group_.get(), name.c_str(), H5P_DEFAULT);
    if (found < 0) throw refuse(name, "cannot be looked up: " + hdf5_reason());
    return found > 0;
}

void GroupReader::note(const std::string& name) const {
    if (origin_->note.empty()) return;
    const std::string location = location_of(name).substr(0, origin_->note.size() - 1);
    *std::ranges::copy(location, origin_->note.begin()).out = '\0';
}

void GroupReader::require_hard_link(const std::string& name) const {
    note(name);
    H5L_info_t info{};
    const bool found = H5Lget_info(group_.get(), name.c_str(), &info, H5P_DEFAULT) >= 0;
    // has() is called only after a failure, because each lookup costs time.
    if (!found && !has(name)) throw refuse(name, "is missing");
    if (!found || info.type != H5L_TYPE_HARD)
        throw refuse(name, "is a soft or external link; only hard links are allowed");
}

GroupReader GroupReader::group(const std::string& name) const {
    require_hard_link(name);
    GroupHandle opened{H5Gopen2(group_.get(), name.c_str(), H5P_DEFAULT)};
    if (!opened) throw refuse(name, "cannot be opened as a group: " + hdf5_reason());
    return {std::move(opened), path_ + "/" + name, *origin_};
}

std::vector<std::string> GroupReader::names() const {
    H5G_info_t info{};
    if (H5Gget_info(group_.get(), &info) < 0) throw refuse("", "cannot be listed: " + hdf5_reason());
    if (info.nlinks > max_links) throw refuse("", "has too many members");
    std::vector<std::string> found;
    const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
        auto& names = *static_cast<std::vector<std::string>*>(list);
        if (names.size() >= max_links) return -1;
        names.emplace_back(name);
        return 0;
    };
    hsize_t position = 0;
    if (H5Literate(group_.get(), H5_INDEX_NAME, H5_ITER_INC, &position, collect, &found) < 0)
        throw refuse("", "cannot be listed: " + hdf5_reason());
    for (const std::string& name : found)
        if (!is_name(name)) throw refuse("", core::quoted(name) + " is not a valid name");
    return found;
}

DatasetHandle GroupReader::open_dataset(const std::string& name) const {
    require_hard_link(name);
    DatasetHandle dataset{H5Dopen2(group_.get(), name.c_str(), H5P_DEFAULT)};
    if (!dataset) throw refuse(name, "cannot be opened as a dataset: " + hdf5_reason());
    return dataset;
}

template <class T>
std::vector<T> GroupReader::array(const std::string& name, const Shape& shape) const {
    const DatasetHandle dataset = open_dataset(name);
    const std::string location = location_of(name);
    const DatasetRef ref{dataset.get(), *origin_, location};
    require_type<T>(ref);
    const std::uint64_t bytes = checked_bytes(ref, checked_shape(ref, shape), sizeof(T));
    check_storage(ref, bytes, sizeof(T));
    auto values = allocate<T>(ref, bytes / sizeof(T));
    if (!values.empty() && H5Dread(dataset.get(), memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
        throw ref.refuse("cannot be read: " + hdf5_reason());
    if constexpr (std::is_floating_point_v<T>) require_finite(values, name);
    return values;
}

template std::vector<double> GroupReader::array(const std::string&, const Shape&) const;
template std::vector<std::int64_t> GroupReader::array(const std::string&, const Shape&) const;
template std::vector<std::int32_t> GroupReader::array(const std::string&, const Shape&) const;
template std::vector<std::uint8_t> GroupReader::array(const std::string&, const Shape&) const;

double GroupReader::number(const std::string& name) const { return array<double>(name, {})[0]; }

int GroupReader::to_int(const std::string& item, std::int64_t value, int min) const {
    if (value < min || value > std::numeric_limits<int>::max())
        throw refuse(item, std::to_string(value) + " is out of range");
    return static_cast<int>(value);
}

std::vector<std::uint8_t> GroupReader::flags(const std::string& name, const Shape& shape) const {
    auto values = array<std::uint8_t>(name, shape);
    if (std::any_of(values.begin(), values.end(), [](std::uint8_t value) { return value > 1; }))
        throw refuse(name, "contains values other than 0 and 1");
    return values;
}

/// The fixed-length elements of a text dataset, padding included, and their width.
GroupReader::TextBytes GroupReader::text_bytes(const std::string& name, const Shape& shape) const {
    const DatasetHandle dataset = open_dataset(name);
    const std::string location = location_of(name);
    const DatasetRef ref{dataset.get(), *origin_, location};
    const TypeHandle type{H5Dget_type(dataset.get())};
    require_plain_text(ref, type.get());
    const std::size_t width = H5Tget_size(type.get());
    const std::uint64_t bytes = checked_bytes(ref, checked_shape(ref, shape), width);
    check_storage(ref, bytes, width);
    TextBytes text{allocate<char>(ref, bytes), width};
    if (bytes > 0 && H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.characters.data()) < 0)
        throw ref.refuse("cannot be read: " + hdf5_reason());
    return text;
}

std::string GroupReader::text(const std::string& name) const {
    const TextBytes read = text_bytes(name, {});
    return unpadded({read.characters.data(), read.width});
}

std::vector<std::string> GroupReader::texts(const std::string& name, std::int64_t expected) const {
    const TextBytes read = text_bytes(name, {expected});
    std::vector<std::string> list;
    for (std::size_t at = 0; at < read.characters.size(); at += read.width)
        list.push_back(unpadded({read.characters.data() + at, read.width}));
    return list;
}

DatasetHandle GroupReader::checked_rows(const std::string& name, const Shape& shape) const {
    DatasetHandle dataset = open_dataset(name);
    const std::string location = location_of(name);
    const DatasetRef ref{dataset.get(), *origin_, location};
    require_type<double>(ref);
    check_storage(ref, checked_bytes(ref, checked_shape(ref, shape), sizeof(double)), sizeof(double));
    return dataset;
}

std::vector<double> GroupReader::row(hid_t dataset, const std::string& name, std::int64_t row,
                                     std::size_t length) const {
    const SpaceHandle space{H5Dget_space(dataset)};
    std::vector<hsize_t> count(H5S_MAX_RANK);
    const int rank = H5Sget_simple_extent_dims(space.get(), count.data(), nullptr);
    if (rank < 1) throw refuse(name, "has no rows");
    count.resize(static_cast<std::size_t>(rank));
    std::vector<hsize_t> start(count.size(), 0);
    start[0] = static_cast<hsize_t>(row);
    count[0] = 1;
    std::vector<double> values(length);
    const hsize_t size = length;
    const SpaceHandle memory{H5Screate_simple(1, &size, nullptr)};
    if (H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) < 0 ||
        H5Dread(dataset, H5T_NATIVE_DOUBLE, memory.get(), space.get(), H5P_DEFAULT, values.data()) < 0)
        throw refuse(name + "[" + std::to_string(row) + "]", "cannot be read: " + hdf5_reason());
    require_finite(values, name);
    return values;
}

bool GroupReader::has_attribute(const char* name) const { return H5Aexists(group_.get(), name) > 0; }

std::string GroupReader::text_attribute(const char* name) const {
    const AttributeHandle attribute = open_attribute(name);
    const std::string location = location_of(name);
    const DatasetRef ref{H5I_INVALID_HID, *origin_, location};
    const TypeHandle type{H5Aget_type(attribute.get())};
    require_plain_text(ref, type.get());
    const std::size_t width = H5Tget_size(type.get());
    const SpaceHandle space{H5Aget_space(attribute.get())};
    // Attributes are stored in an object header, which cannot exceed 64 KiB.
    if (H5Sget_simple_extent_npoints(space.get()) != 1 || width > max_attribute_bytes)
        throw ref.refuse("is not a single text of at most 64 KiB");
    std::vector<char> characters(width);
    if (H5Aread(attribute.get(), type.get(), characters.data()) < 0)
        throw ref.refuse("cannot be read: " + hdf5_reason());
    return unpadded({characters.data(), characters.size()});
}

std::vector<std::int64_t> GroupReader::integer_attribute(const char* name, std::size_t expected) const {
    const AttributeHandle attribute = open_attribute(name);
    const TypeHandle type{H5Aget_type(attribute.get())};
    const SpaceHandle space{H5Aget_space(attribute.get())};
    if (H5Tequal(type.get(), H5T_STD_I64LE) <= 0 ||
        H5Sget_simple_extent_npoints(space.get()) != static_cast<hssize_t>(expected))
        throw refuse(name, "is not " + std::to_string(expected) + " 64-bit integers");
    std::vector<std::int64_t> values(expected);
    if (H5Aread(attribute.get(), H5T_NATIVE_INT64, values.data()) < 0)
        throw refuse(name, "cannot be read: " + hdf5_reason());
    return values;
}

AttributeHandle GroupReader::open_attribute(const char* name) const {
    if (!has_attribute(name)) throw refuse(name, "the attribute is missing");
    AttributeHandle attribute{H5Aopen(group_.get(), name, H5P_DEFAULT)};
    if (!attribute) throw refuse(name, "cannot be opened: " + hdf5_reason());
    return attribute;
}

}  // namespace soft::io
