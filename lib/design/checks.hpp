#pragma once
/// One value against its Key: parsing, units, range, choices, faces. Private to the module. Tested by design/read_test.
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "design/design.hpp"
#include "design/schema.hpp"
#include "design/tree.hpp"

namespace soft::design {

/// A checked value with its key (concrete path). `list` holds the names for Kind::faces and the values of a list, as written.
struct Item {
    Key key;
    Values::Entry entry;
    std::vector<std::string> list;
};

/// Faces a value may name, and other names for them.
struct FaceNames {
    std::vector<std::string> faces;
    std::map<std::string, std::string> aliases;
    std::vector<std::string> cavities = {};  ///< those of which the wall, a face of the same name, is there
};

/// What a Kind::faces value may say instead of a face, where its key lists it as a choice.
inline constexpr std::string_view no_face = "none";

/// The face itself for a face or one of its other names; empty for anything else.
[[nodiscard]] std::string resolve_face(const FaceNames& names, std::string_view face);
/// Faces first, then other names: what "did you mean" searches.
[[nodiscard]] std::vector<std::string> all_names(const FaceNames& names);

/// Throws Error(bad_input) with the place of `node`.
[[nodiscard]] Item check_value(const Key& key, const Node& node, const FaceNames& names);

/// "more than 0, at most 10 mm", "mixed | displacement", "any pressure": for --explain, --template and errors.
[[nodiscard]] std::string range_text(const Key& key);

}  // namespace soft::design
