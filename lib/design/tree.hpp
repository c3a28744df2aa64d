#pragma once
/// A YAML document as a plain tree that remembers where everything stood. Only what designs need: maps with plain
/// keys, lists, single values; anchors, aliases, tags and further documents are refused. For this room and for sweep.
/// Tested by design/tree_test.
#include <string>
#include <string_view>
#include <vector>

namespace soft::design {

struct Member;

struct Node {
    enum class Kind { empty, scalar, list, map };
    Kind kind = Kind::empty;
    std::string text;         ///< of a scalar
    std::string place;        ///< "designs/tube.yaml:7:9" (line and column from 1), "--set geometry.wall" or "default"
    std::string note;         ///< comment that write_yaml puts behind it; never read
    std::vector<Node> items;  ///< of a list
    std::vector<Member> members;  ///< of a map, in document order, keys unique
};

struct Member {
    std::string key;
    std::string place;  ///< of the key
    Node value;
};

inline constexpr std::string_view place_default = "default";  ///< place of what the user did not write

/// What a document is, for its errors.
struct DocumentKind {
    std::string_view noun = "design";
    std::string_view example = "see `mesh-gen --template` for a design";
};

/// Throws Error(bad_input) "source:line:column: problem; remedy". At most 1 MiB, 20000 nodes, 16 levels.
[[nodiscard]] Node parse_yaml(std::string_view text, std::string_view source, const DocumentKind& kind = {});

/// A fragment that is not in a file: every place in it and in its errors is `place`.
[[nodiscard]] Node parse_fragment(std::string_view text, std::string_view place);

/// nullptr if `map` is no map or lacks the key; find_path takes "geometry.end_disc.length".
[[nodiscard]] const Node* find(const Node& map, std::string_view key);
[[nodiscard]] const Node* find_path(const Node& root, std::string_view path);
[[nodiscard]] Node* find_path(Node& root, std::string_view path);
[[nodiscard]] const Member* find_member(const Node& map, std::string_view key);

/// Puts `value` at `path`, making the maps on the way; places of new keys are that of the value. A single value or a
/// list on the way is refused with Error(bad_input).
void put(Node& root, std::string_view path, Node value);

[[nodiscard]] Node scalar_node(std::string text, std::string_view place);

/// Block style, two blanks a level, flow lists, notes behind `#` from `note_column` on; reads back to the same tree.
[[nodiscard]] std::string write_yaml(const Node& root, std::size_t note_column = 0);

/// Error(bad_input) "place: path: problem; remedy"; the path is left out where the place ends with it already.
[[noreturn]] void refuse(std::string_view place, std::string_view path, std::string_view problem,
                         std::string_view remedy = {});

}  // namespace soft::design
