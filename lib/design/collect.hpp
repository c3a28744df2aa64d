#pragma once
/// Checks a tree against a schema: rejects unknown keys, checks every value, fills in defaults. Private to the module.
#include <map>
#include <span>
#include <string>
#include <vector>

#include "design/checks.hpp"
#include "design/schema.hpp"
#include "design/tree.hpp"

namespace soft::design {

/// Keys with concrete paths, in output order. `names` lists the allowed members of sections with user-defined members
/// ("loads" -> cavity, end, ...), for "did you mean".
struct Schema {
    std::vector<Key> keys;
    std::map<std::string, std::vector<std::string>> names;
    FaceNames faces;
    bool dynamic = false;  ///< dynamic design: loads have a time function
};

/// The checked items in the order of schema.keys. Throws the first error in document order; missing keys are reported after all
/// others. `examples` contains example values of required keys for errors ("material.mu" -> "0.1644 MPa").
[[nodiscard]] std::vector<Item> collect(const Node& root, const Schema& schema, std::string_view source,
                                        const std::map<std::string, std::string>& examples);

/// The canonical tree of `items`: sections in the order of section_notes(); empty sections are written as {}.
[[nodiscard]] Node tree_of(std::span<const Item> items);

}  // namespace soft::design
