#pragma once
/// The curve as comma-separated text with '\n' line ends. Numbers are the shortest text that reads back to the same double.
/// Tested by post/csv_test.
#include <span>
#include <string>

#include "post/curve.hpp"

namespace soft::post {

/// Columns on demand are omitted unless show_also has enabled them. `comments` precede the header, each after "# "; a line break in a
/// comment starts a new comment line.
[[nodiscard]] std::string csv_text(const Curve& curve, std::span<const std::string> comments = {});

}  // namespace soft::post
