#pragma once
/// The script of the 3D viewer, embedded into the program at build time (build_viewer.cmake). Internal.
#include <span>
#include <string_view>

namespace soft::view {

struct ViewerBundle {
    std::span<const std::string_view> script, licence;  ///< in pieces, to be concatenated
    std::string_view library;                           ///< "three.js 0.187.0"
    std::string_view missing;                           ///< reason why there is no script; empty if there is one
};
[[nodiscard]] ViewerBundle viewer_bundle() noexcept;

}  // namespace soft::view
