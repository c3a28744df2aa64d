#include "design/tree.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace soft::design {
namespace {

constexpr std::size_t max_document_bytes = std::size_t{1} << 20;
constexpr int max_nodes = 100000;
constexpr std::size_t max_depth = 16;

/// Converts marks of yaml-cpp (from 0) to locations (line and column from 1).
struct SourceLocations {
    std::string source;
    bool numbered;  // false: a fragment, which has a single location
    DocumentKind kind = {};
    [[nodiscard]] std::string a_kind() const { return "a " + std::string{kind.noun}; }
    [[nodiscard]] std::string at(int line, int column) const {
        if (!numbered) return source;
        return source + ":" + std::to_string(std::max(line, 0) + 1) + ":" + std::to_string(std::max(column, 0) + 1);
    }
    [[nodiscard]] std::string at(const YAML::Mark& mark) const { return at(mark.line, mark.column); }
};

/// Builds the tree from parser events. yaml-cpp's own nodes would hide duplicate keys and expand aliases.
class TreeBuilder final : public YAML::EventHandler {
public:
    TreeBuilder(const SourceLocations& locations, std::string_view text) : locations_(locations), text_(text) {}

    Node take() { return std::move(root_); }

    void OnDocumentStart(const YAML::Mark& mark) override {
        if (++documents_ > 1)
            refuse(locations_.at(mark), "", "a second document starts here",
                   "keep one " + std::string{locations_.kind.noun} + " a file");
    }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        check(mark, "", anchor);
        add(Node{}, mark);
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse_anchor(mark); }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        check(mark, tag, anchor);
        // An escape such as "\n" can produce control characters that check_characters rejects in the text; names appear in messages,
        // tables and paths. Line breaks of a block scalar are allowed here; keys that take a single line reject them (checks.cpp).
        std::string visible = value;
        const bool is_block = value.find('\n') != std::string::npos && begins_block(mark);
        std::ranges::replace_if(
            visible, [&](char c) { return c == '\t' || (is_block && c == '\n'); }, ' ');
        if (core::one_line(visible, visible.size()) != visible)
            refuse(locations_.at(mark), "", "a control character in " + core::quoted(value),
                   "write letters and blanks");
        Node node;
        node.kind = Node::Kind::scalar;
        node.text = value;
        add(std::move(node), mark);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(Node::Kind::list, mark, tag, anchor);
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(Node::Kind::map, mark, tag, anchor);
    }
    void OnMapEnd() override { close(); }

private:
    struct Frame {
        Node node;
        std::optional<Member> waiting;  // a key that has no value yet
    };

    [[noreturn]] void refuse_anchor(const YAML::Mark& mark) const {
        refuse(locations_.at(mark), "", "anchors and aliases are not part of " + locations_.a_kind(),
               "write the value out");
    }

    /// Whether the scalar at this mark is written below "|" or ">".
    [[nodiscard]] bool begins_block(const YAML::Mark& mark) const {
        std::size_t at = 0;
        for (int line = 0; line < mark.line && at < text_.size(); ++line)
            at = std::min(text_.find('\n', at), text_.size() - 1) + 1;
        at += static_cast<std::size_t>(std::max(mark.column, 0));
        return at < text_.size() && (text_[at] == '|' || text_[at] == '>');
    }

    void check(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
        if (anchor != 0) refuse_anchor(mark);
        const bool ordinary = tag.empty() || tag == "?" || tag == "!";  // plain and quoted scalars
        if (!ordinary)
            refuse(locations_.at(mark), "", "tags are not part of " + locations_.a_kind(),
                   "leave out " + core::quoted(tag));
        if (++nodes_ > max_nodes)
            refuse(locations_.at(mark), "", "more than " + std::to_string(max_nodes) + " values",
                   "is this the right file?");
    }

    void open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
        check(mark, tag, anchor);
        if (stack_.size() >= max_depth)
            refuse(locations_.at(mark), "", "nested more than " + std::to_string(max_depth) + " levels deep");
        if (expects_key()) refuse(locations_.at(mark), "", "a group cannot be a key", "write key: value");
        Frame frame;
        frame.node.kind = kind;
        frame.node.location = locations_.at(mark);
        stack_.push_back(std::move(frame));
    }

    void close() {
        Node node = std::move(stack_.back().node);
        stack_.pop_back();
        attach(std::move(node));
    }

    [[nodiscard]] bool expects_key() const {
        return !stack_.empty() && stack_.back().node.kind == Node::Kind::map && !stack_.back().waiting;
    }

    void add(Node node, const YAML::Mark& mark) {
        node.location = locations_.at(mark);
        if (!expects_key()) return attach(std::move(node));
        if (node.kind != Node::Kind::scalar || node.text.empty())
            refuse(node.location, "", "a key is missing before ':'", "write key: value");
        const Frame& frame = stack_.back();
        if (const Member* first = find_member(frame.node, node.text))
            refuse(node.location, "", "key " + core::quoted(node.text) + " is written twice",
                   "the first is at " + first->location);
        stack_.back().waiting = Member{node.text, node.location, {}};
    }

    void attach(Node node) {
        if (stack_.empty()) {
            root_ = std::move(node);
            return;
        }
        Frame& frame = stack_.back();
        if (frame.node.kind == Node::Kind::list) {
            frame.node.items.push_back(std::move(node));
            return;
        }
        frame.waiting->value = std::move(node);
        frame.node.members.push_back(std::move(*frame.waiting));
        frame.waiting.reset();
    }

    const SourceLocations& locations_;
    std::string_view text_;
    Node root_;
    std::vector<Frame> stack_;
    int nodes_ = 0;
    int documents_ = 0;
};

/// Location of a byte, for errors that are detected before parsing.
std::string location_of_byte(std::string_view text, std::size_t offset, const SourceLocations& locations) {
    const std::string_view before = text.substr(0, offset);
    const auto line = std::count(before.begin(), before.end(), '\n');
    const auto start = before.rfind('\n');
    const std::size_t column = start == std::string_view::npos ? offset : offset - start - 1;
    return locations.at(static_cast<int>(line), static_cast<int>(column));
}

void check_characters(std::string_view text, const SourceLocations& locations) {
    if (text.size() > max_document_bytes)
        refuse(locations.source, "", "the " + std::string{locations.kind.noun} + " is longer than 1 MiB",
               "is this the right file?");
    const auto is_control = [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F;
    };
    const auto control = std::find_if(text.begin(), text.end(), is_control);
    const auto invalid = core::first_invalid_utf8(text);
    const auto offset = std::min(static_cast<std::size_t>(control - text.begin()), invalid.value_or(text.size()));
    if (offset == text.size()) return;
    const bool is_utf8 = !invalid || offset < *invalid;
    refuse(location_of_byte(text, offset, locations), "", is_utf8 ? "a control character" : "not UTF-8 text",
           "write " + locations.a_kind() + " as YAML; is this the right file?");
}

Node parse(std::string_view text, const SourceLocations& locations) {
    check_characters(text, locations);
    // yaml-cpp 0.7 accepts an unclosed quote at the end of the file. The appended document end makes it an error.
    std::istringstream stream{std::string{text} + "\n...\n"};
    TreeBuilder builder{locations, text};
    try {
        YAML::Parser parser{stream};
        while (parser.HandleNextDocument(builder)) {}
    } catch (const YAML::Exception& error) {
        const std::string location = error.mark.is_null() ? locations.source : locations.at(error.mark);
        refuse(location, "", "not YAML: " + core::one_line(error.msg), locations.kind.example);
    }
    return builder.take();
}

}  // namespace

Node parse_yaml(std::string_view text, std::string_view source, const DocumentKind& kind) {
    return parse(text, {std::string{source}, true, kind});
}

Node parse_fragment(std::string_view text, std::string_view location) {
    return parse(text, {std::string{location}, false});
}

const Member* find_member(const Node& map, std::string_view key) {
    const auto member =
        std::find_if(map.members.begin(), map.members.end(), [&](const Member& m) { return m.key == key; });
    return member == map.members.end() ? nullptr : &*member;
}

const Node* find(const Node& map, std::string_view key) {
    const Member* member = find_member(map, key);
    return member == nullptr ? nullptr : &member->value;
}

const Node* find_path(const Node& root, std::string_view path) {
    const Node* node = &root;
    while (node != nullptr) {
        const auto dot = path.find('.');
        node = find(*node, path.substr(0, dot));
        if (dot == std::string_view::npos) return node;
        path.remove_prefix(dot + 1);
    }
    return nullptr;
}

Node* find_path(Node& root, std::string_view path) {
    // NOLINTNEXTLINE(*-const-cast): the root is not const
    return const_cast<Node*>(find_path(std::as_const(root), path));
}

void require_known_keys(const Node& map, const std::vector<std::string>& known, const std::string& path) {
    for (const Member& member : map.members)
        if (std::ranges::find(known, member.key) == known.end())
            refuse(member.location, path.empty() ? member.key : path + "." + member.key, "unknown key",
                   core::did_you_mean(member.key, known));
}

void put(Node& root, std::string_view path, Node value) {
    Node* node = &root;
    const std::string location = value.location;
    std::string_view rest = path;
    while (true) {
        if (node->kind == Node::Kind::empty) node->kind = Node::Kind::map;
        const auto dot = rest.find('.');
        const std::string key{rest.substr(0, dot)};
        const std::string done{path.substr(0, path.size() - std::min(path.size(), rest.size() + 1))};
        if (node->kind == Node::Kind::list && dot == std::string_view::npos) {
            const auto index = core::parse_count(key);
            const auto* number = std::get_if<long>(&index);
            const auto size = static_cast<long>(node->items.size());
            if (number == nullptr || *number < 1 || *number > size || key.front() == '0')
                refuse(location, path,
                       core::quoted(done) + " is a list of " + core::counted(static_cast<int>(size), "value"),
                       "write " + done + ".1" + (size > 1 ? " to ." + std::to_string(size) : "") +
                           ", or all of it: " + done + "=[...]");
            node->items[static_cast<std::size_t>(*number) - 1] = std::move(value);
            return;
        }
        if (node->kind != Node::Kind::map)
            refuse(location, path, core::quoted(done) + " is a single value", "give all of it: " + done + "={...}");
        if (find_member(*node, key) == nullptr) {
            node->members.push_back({key, location, {}});
            node->members.back().value.location = location;
        }
        const auto member =
            std::find_if(node->members.begin(), node->members.end(), [&](const Member& m) { return m.key == key; });
        if (dot == std::string_view::npos) {
            member->value = std::move(value);
            return;
        }
        node = &member->value;
        rest.remove_prefix(dot + 1);
    }
}

Node scalar_node(std::string text, std::string_view location) {
    Node node;
    node.kind = Node::Kind::scalar;
    node.text = std::move(text);
    node.location = location;
    return node;
}

void refuse(std::string_view location, std::string_view path, std::string_view problem, std::string_view remedy) {
    std::string where{location};
    const bool named = path.empty() || location == "--set " + std::string{path};
    if (!named) where.append(where.empty() ? "" : ": ").append(core::one_line(path));
    throw Error(ExitCode::bad_input, where, problem, remedy);
}

}  // namespace soft::design
