#pragma once
/// What is checked of a dataset before a byte of it is read or memory for it is asked. Internal to the module.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "io/handle.hpp"

namespace soft::io {

/// What stands in messages and what bounds sizes.
struct Origin {
    std::string source;  ///< "case.h5"
    std::size_t image_bytes = 0;
    std::string remedy = "rebuild the case with mesh-gen";
    std::span<char> note = {};  ///< takes the place that is read last; see trial.hpp
};

/// Expected extents, one a dimension; `any` accepts what is there. {}: a scalar.
using Shape = std::vector<std::int64_t>;
inline constexpr std::int64_t any = -1;

/// A dataset under check and how to speak of it.
struct Place {
    hid_t dataset;
    const Origin& origin;
    const std::string& where;  ///< "case.h5:/mesh/cell_regions"

    [[nodiscard]] Error refuse(std::string_view problem) const {
        return {ExitCode::bad_input, where, problem, origin.remedy};
    }
};

[[nodiscard]] std::vector<hsize_t> checked_shape(const Place& place, const Shape& expected);
/// Size in memory, refused beyond 4 GiB.
[[nodiscard]] std::uint64_t checked_bytes(const Place& place, const std::vector<hsize_t>& shape,
                                          std::size_t element_size);
/// The `bytes` must be in the file itself (no external or virtual storage), packed by nothing but gzip, shuffle and
/// Fletcher's checksum, and no more than what is stored can expand to: as many bytes as stored, 1032 times as many
/// when compressed.
void check_storage(const Place& place, std::uint64_t bytes, std::size_t element_size);

/// The innermost message of HDF5's error stack: what failed first. Throws core::out_of_memory() where that was it.
[[nodiscard]] std::string hdf5_reason();

}  // namespace soft::io
