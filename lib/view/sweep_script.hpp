#pragma once
/// The script of the report of a sweep, embedded into the program at build time (embed_script.cmake). Internal.
#include <span>
#include <string_view>

namespace soft::view {

[[nodiscard]] std::span<const std::string_view> sweep_script() noexcept;  ///< in pieces, to be concatenated

}  // namespace soft::view
