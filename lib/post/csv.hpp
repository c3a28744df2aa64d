#pragma once
/// The curve as comma-separated text, lines ended by '\n'. Numbers are the shortest text that reads back to the same
/// double. Tested by post/csv_test.
#include <span>
#include <string>

#include "post/curve.hpp"

namespace soft::post {

/// Columns on demand are left out unless show_also has shown them. `comments` precede the header, each behind "# "; a line break inside one starts a new comment line.
[[nodiscard]] std::string csv_text(const Curve& curve, std::span<const std::string> comments = {});

}  // namespace soft::post
