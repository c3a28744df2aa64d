#include "io/hdf5_checks.hpp"

#include <algorithm>

#include "core/memory.hpp"
#include "core/text.hpp"

namespace soft::io {
namespace {

/// Deflate expands one byte to at most 1032 bytes (zlib technical notes).
constexpr std::uint64_t max_expansion = 1032;
constexpr std::uint64_t max_dataset = std::uint64_t{1} << 32;
/// HDF5 loads whole chunks into memory. The chunks that this module writes have 1 MiB.
constexpr std::uint64_t max_chunk = std::uint64_t{1} << 26;

std::string shape_text(const Shape& shape) {
    if (shape.empty()) return "a single value";
    std::vector<std::string> words;
    for (const std::int64_t extent : shape) words.push_back(extent == any ? "n" : std::to_string(extent));
    return std::string{"["}.append(core::join(words)).append("]");
}

constexpr std::size_t memory_to_start = std::size_t{16} << 20;
constexpr std::size_t max_for_a_dataset = std::size_t{128} << 20;  // the largest chunk, compressed and decompressed

void check_filters(const DatasetRef& ref, hid_t properties) {
    const int filters = H5Pget_nfilters(properties);
    if (filters < 0 || filters > 3) throw ref.refuse("has too many filters");
    for (int i = 0; i < filters; ++i) {
        unsigned flags = 0;
        unsigned configuration = 0;
        std::size_t values = 0;
        const H5Z_filter_t filter =
            H5Pget_filter2(properties, static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, &configuration);
        if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_FLETCHER32)
            throw ref.refuse("uses a filter other than gzip, shuffle and Fletcher32");
    }
}

}  // namespace

void start_hdf5() {
    static const herr_t started = [] {
        core::require_memory(memory_to_start);
        return H5open();
    }();
    if (started < 0) throw core::out_of_memory();
}

std::string hdf5_reason() {
    struct Found {
        std::string text;
        bool no_memory = false;
    } found;
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned level, const H5E_error2_t* error, void* data) -> herr_t {
            auto& stack = *static_cast<Found*>(data);
            if (level == 0 && error->desc != nullptr) stack.text = error->desc;
            stack.no_memory = stack.no_memory || (error->maj_num == H5E_RESOURCE && error->min_num == H5E_NOSPACE);
            return 0;
        },
        &found);
    // HDF5 may be unable to record a reason if memory is exhausted. If the memory for a dataset is available, the file is at fault.
    if (found.no_memory || found.text.empty()) core::require_memory(max_for_a_dataset);
    return found.text.empty() ? "no reason given" : core::one_line(found.text);
}

std::vector<hsize_t> checked_shape(const DatasetRef& ref, const Shape& expected) {
    const SpaceHandle dataspace{H5Dget_space(ref.dataset)};
    const hid_t space = dataspace.get();
    const int rank = H5Sget_simple_extent_ndims(space);
    const bool simple = H5Sget_simple_extent_type(space) == (expected.empty() ? H5S_SCALAR : H5S_SIMPLE);
    if (!simple || rank != static_cast<int>(expected.size()))
        throw ref.refuse("does not have the shape " + shape_text(expected));
    std::vector<hsize_t> shape(expected.size());
    if (rank > 0) H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    for (std::size_t i = 0; i < shape.size(); ++i)
        if (expected[i] != any && shape[i] != static_cast<hsize_t>(expected[i])) {
            const Shape found(shape.begin(), shape.end());
            throw ref.refuse("has the shape " + shape_text(found) + ", expected " + shape_text(expected));
        }
    return shape;
}

std::uint64_t checked_bytes(const DatasetRef& ref, const std::vector<hsize_t>& shape, std::size_t element_size) {
    std::uint64_t bytes = element_size;
    for (const hsize_t extent : shape) {
        if (extent != 0 && bytes > max_dataset / extent) throw ref.refuse("is declared too large");
        bytes *= extent;
    }
    return bytes;
}

void check_storage(const DatasetRef& ref, std::uint64_t bytes, std::size_t element_size) {
    const PropertiesHandle properties{H5Dget_create_plist(ref.dataset)};
    if (!properties) throw ref.refuse("cannot be read: " + hdf5_reason());
    const std::uint64_t stored = H5Dget_storage_size(ref.dataset);
    if (stored > ref.origin.image_bytes) throw ref.refuse("declares more bytes than the file has");
    switch (H5Pget_layout(properties.get())) {
        case H5D_COMPACT: break;
        case H5D_CONTIGUOUS: {
            if (H5Pget_external_count(properties.get()) != 0) throw ref.refuse("stores its data in another file");
            const haddr_t start = H5Dget_offset(ref.dataset);
            if (bytes > 0 && (start == HADDR_UNDEF || start > ref.origin.image_bytes - stored))
                throw ref.refuse("has no data in the file");
            break;
        }
        case H5D_CHUNKED: {
            check_filters(ref, properties.get());
            std::vector<hsize_t> chunk(H5S_MAX_RANK);
            const int rank = H5Pget_chunk(properties.get(), H5S_MAX_RANK, chunk.data());
            chunk.resize(static_cast<std::size_t>(std::max(rank, 0)));
            if (checked_bytes(ref, chunk, element_size) > max_chunk) throw ref.refuse("has chunks that are too large");
            if (bytes > stored * max_expansion) throw ref.refuse("is declared larger than its stored data can be");
            return;
        }
        default: throw ref.refuse("uses an unsupported storage layout");
    }
    if (bytes > stored) throw ref.refuse("is declared larger than its stored data");
}

}  // namespace soft::io
