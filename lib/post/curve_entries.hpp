#pragma once
/// The columns of a curve and how they read its steps. Private to the module. Tested by post/curve_test and post/motion_test.
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "model/path.hpp"
#include "post/curve.hpp"

namespace soft::post {

using Value = std::optional<double>;

/// A column and how it reads a step. An optional column is part of the curve only if there are steps and all of them have a value.
struct Entry {
    Column column;
    std::function<Value(const model::Step&)> value_SI;
    std::function<Value(const model::Step&)> slope_SI = [](const model::Step&) { return std::nullopt; };
    bool is_optional = false;
};

/// In the order of the table; `steps` is where the values are read from.
[[nodiscard]] std::vector<Entry> entries_of(const model::Case& model, std::span<const model::Step> steps);

}  // namespace soft::post
