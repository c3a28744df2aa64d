#pragma once
/// A tree against a schema: every key known, every value checked, defaults filled in. Private to the module.
#include <map>
#include <span>
#include <string>
#include <vector>

#include "design/checks.hpp"
#include "design/schema.hpp"
#include "design/tree.hpp"

namespace soft::design {

/// Keys with concrete paths in the order in which they are written out. `names` are what may stand below a section
/// whose members are free ("loads" -> cavity, end, ...), for "did you mean".
struct Schema {
    std::vector<Key> keys;
    std::map<std::string, std::vector<std::string>> names;
    FaceNames faces;
    bool dynamic = false;  ///< loads have a time_function in time
};

/// In the order of schema.keys. The first fault in document order is thrown, missing keys after those.
/// `examples` shows what a missing required key may look like ("material.mu" -> "0.1644 MPa").
[[nodiscard]] std::vector<Item> collect(const Node& root, const Schema& schema, std::string_view source,
                                        const std::map<std::string, std::string>& examples);

/// The canonical tree of `items`: sections in the order of section_notes(), empty ones written as {}.
[[nodiscard]] Node tree_of(std::span<const Item> items);

}  // namespace soft::design
