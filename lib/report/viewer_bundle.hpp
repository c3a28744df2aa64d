#pragma once
/// The script of the moving body, put into the program when it is built (build_viewer.cmake). Internal.
#include <span>
#include <string_view>

namespace soft::report {

struct ViewerBundle {
    std::span<const std::string_view> script, licence;  ///< in pieces, to be joined
    std::string_view library;                           ///< "three.js 0.187.0"
    std::string_view missing;                           ///< why there is no script; empty where there is one
};
[[nodiscard]] ViewerBundle viewer_bundle() noexcept;

}  // namespace soft::report
