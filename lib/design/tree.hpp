#pragma once
/// A YAML document as a tree with the source location of every node. The supported subset is maps with plain keys, lists and single
/// values; anchors, aliases, tags and multiple documents are rejected. Used by the modules design and sweep. Tested by
/// design/tree_test.
#include <string>
#include <string_view>
#include <vector>

namespace soft::design {

struct Member;

struct Node {
    enum class Kind { empty, scalar, list, map };
    Kind kind = Kind::empty;
    std::string text;         ///< of a scalar
    std::string location;     ///< "designs/tube.yaml:7:9" (line and column from 1), "--set geometry.wall" or "default"
    std::string note;         ///< comment that write_yaml appends; not set by parsing
    std::vector<Node> items;  ///< of a list
    std::vector<Member> members;  ///< of a map, in document order, keys unique
};

struct Member {
    std::string key;
    std::string location;  ///< location of the key
    Node value;
};

inline constexpr std::string_view default_location = "default";  ///< location of values that the user did not write

/// Kind of a document, for its errors.
struct DocumentKind {
    std::string_view noun = "design";
    std::string_view example = "see `mesh-gen --template` for a design";
};

/// Parses a document of at most 1 MiB, 100000 nodes and 16 levels. Throws Error(bad_input) "source:line:column: problem; remedy".
[[nodiscard]] Node parse_yaml(std::string_view text, std::string_view source, const DocumentKind& kind = {});

/// Parses a fragment that is not in a file: every location in it and in its errors is `location`.
[[nodiscard]] Node parse_fragment(std::string_view text, std::string_view location);

/// nullptr if `map` is not a map or lacks the key; the path of find_path is of the form "geometry.end_disc.length".
[[nodiscard]] const Node* find(const Node& map, std::string_view key);
[[nodiscard]] const Node* find_path(const Node& root, std::string_view path);
[[nodiscard]] Node* find_path(Node& root, std::string_view path);
[[nodiscard]] const Member* find_member(const Node& map, std::string_view key);

/// Throws Error (bad_input) for a key of the map that is not among `known`; `path` is that of the map, empty for the root.
void require_known_keys(const Node& map, const std::vector<std::string>& known, const std::string& path);

/// Sets the value at `path` and creates missing maps; new keys get the location of the value. The values of a list have the paths
/// "material.mu.1", ... Throws Error(bad_input) if an enclosing node is a single value, or for a number that the list does not have.
void put(Node& root, std::string_view path, Node value);

[[nodiscard]] Node scalar_node(std::string text, std::string_view location);

/// Writes block style with two blanks per level, flow lists, and notes as comments in column `note_column`; parsing gives the same
/// tree.
[[nodiscard]] std::string write_yaml(const Node& root, std::size_t note_column = 0);

/// Throws Error(bad_input) "location: path: problem; remedy"; the path is omitted if the location is already "--set path".
[[noreturn]] void refuse(std::string_view location, std::string_view path, std::string_view problem,
                         std::string_view remedy = {});

}  // namespace soft::design
