#pragma once
/// Checks one value against its Key: syntax, unit, range, choices, faces. Private to the module. Tested by design/read_test.
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/units.hpp"
#include "design/design.hpp"
#include "design/schema.hpp"
#include "design/tree.hpp"

namespace soft::design {

/// A checked value with its key (concrete path). `list` contains the names for Kind::faces and the values of a list, as written.
struct Item {
    Key key;
    Values::Entry entry;
    std::vector<std::string> list;
};

/// The faces that a value may name, and their aliases.
struct FaceNames {
    std::vector<std::string> faces;
    std::map<std::string, std::string> aliases;
    std::vector<std::string> cavities = {};   ///< cavities whose wall, the face of the same name, exists
    std::vector<std::string> obstacles = {};  ///< no faces; loads and outputs may name them
};

/// Value of a Kind::faces key instead of a face, if the key lists it as a choice.
inline constexpr std::string_view no_face = "none";

/// The face for its name or one of its aliases; empty for anything else.
[[nodiscard]] std::string resolve_face(const FaceNames& names, std::string_view face);
/// All faces, then all aliases: the candidates for "did you mean".
[[nodiscard]] std::vector<std::string> all_names(const FaceNames& names);

/// The dimension of a quantity or ratio; nullopt for other kinds.
[[nodiscard]] std::optional<core::Dimension> dimension_of(Kind kind);
[[nodiscard]] Kind kind_of(core::Dimension dimension);

/// Parses and checks a value. Throws Error(bad_input) with the location of `node`.
[[nodiscard]] Item check_value(const Key& key, const Node& node, const FaceNames& names);

/// The allowed values of a key: "more than 0, at most 10 mm", "mixed | displacement", "any pressure". Used by --explain, --template
/// and errors.
[[nodiscard]] std::string range_text(const Key& key);

}  // namespace soft::design
