#pragma once
/// Checks of a dataset before it is read or memory is allocated for it. Internal to the module.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "io/handle.hpp"

namespace soft::io {

/// Version of the file format, which README.md describes. Files of other versions are rejected.
inline constexpr std::int64_t format_version = 2;

/// Origin of the data, for messages and size limits.
struct Origin {
    std::string source;  ///< "case.h5"
    std::size_t image_bytes = 0;
    std::string remedy = "rebuild the case with mesh-gen";
    std::span<char> note = {};  ///< receives the location of the object that is being read; see subprocess_read.hpp
};

/// Expected extents, one per dimension; `any` accepts every extent. {}: a scalar.
using Shape = std::vector<std::int64_t>;
inline constexpr std::int64_t any = -1;

/// A dataset being checked, with its location for messages.
struct DatasetRef {
    hid_t dataset;
    const Origin& origin;
    const std::string& location;  ///< "case.h5:/mesh/cell_regions"

    [[nodiscard]] Error refuse(std::string_view problem) const {
        return {ExitCode::bad_input, location, problem, origin.remedy};
    }
};

[[nodiscard]] std::vector<hsize_t> checked_shape(const DatasetRef& ref, const Shape& expected);
/// Size in memory [bytes]. Throws Error (bad_input) if it exceeds 4 GiB.
[[nodiscard]] std::uint64_t checked_bytes(const DatasetRef& ref, const std::vector<hsize_t>& shape,
                                          std::size_t element_size);
/// Throws Error (bad_input) unless the data are in the file itself (no external or virtual storage), use no filters other than
/// gzip, shuffle and Fletcher32, and `bytes` is at most the stored size, or 1032 times the stored size if compressed.
void check_storage(const DatasetRef& ref, std::uint64_t bytes, std::size_t element_size);

/// The innermost message of HDF5's error stack, i.e. the first failure. Throws core::out_of_memory() if memory was the cause.
[[nodiscard]] std::string hdf5_reason();

}  // namespace soft::io
