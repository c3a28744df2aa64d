#include <algorithm>

#include "design/tree.hpp"

namespace soft::design {
namespace {

bool is_plain_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view{"_ .+-/^%()"}.find(c) != std::string_view::npos;
}

/// Whether a text needs no quotes. Words with a special meaning in YAML, such as true, stay plain: all values are read as text.
bool may_stay_plain(std::string_view text) {
    if (text.empty() || text == "~" || text == "null" || text == "Null" || text == "NULL") return false;
    const char first = text.front();
    const bool safe_start = is_plain_character(first) && first != ' ' && first != '%' &&
                            (first != '-' || (text.size() > 1 && text[1] != ' ' && text[1] != '-'));
    return safe_start && text.back() != ' ' && text != "..." &&
           std::all_of(text.begin(), text.end(), is_plain_character);
}

std::string scalar_text(std::string_view text) {
    if (may_stay_plain(text)) return std::string{text};
    std::string quoted{"\""};
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if (c == '\n')
            quoted += "\\n";
        else if (c == '\t')
            quoted += "\\t";
        else
            quoted += c;
    }
    quoted += '"';
    return quoted;
}

std::string list_text(const Node& list) {
    std::string text{"["};
    for (const Node& item : list.items) {
        if (text.size() > 1) text += ", ";
        text += item.kind == Node::Kind::list ? list_text(item) : scalar_text(item.text);
    }
    text += ']';
    return text;
}

/// Whether a text can be written as a block scalar without changes.
bool is_block(std::string_view text) {
    return text.find('\n') != std::string_view::npos && text.back() == '\n' && text.front() != ' ' &&
           text.front() != '\n' && !text.ends_with("\n\n") &&
           std::ranges::all_of(text, [](char c) { return c == '\n' || static_cast<unsigned char>(c) >= 0x20; });
}

void write_block(std::string_view block, std::size_t indent, std::string& text) {
    while (!block.empty()) {
        const std::size_t end = block.find('\n') + 1;
        text.append(end > 1 ? indent : 0, ' ').append(block.substr(0, end));
        block.remove_prefix(end);
    }
}

void finish_line(std::string& line, const std::string& note, std::size_t note_column, std::string& text) {
    if (!note.empty()) {
        line.resize(std::max(line.size() + 2, note_column), ' ');
        line.append("# ").append(note);
    }
    text.append(line).append("\n");
}

void write_map(const Node& map, std::size_t indent, std::size_t note_column, std::string& text) {
    for (const Member& member : map.members) {
        const Node& value = member.value;
        std::string line(indent, ' ');
        line.append(scalar_text(member.key)).append(":");
        const bool block = value.kind == Node::Kind::scalar && is_block(value.text);
        if (value.kind == Node::Kind::scalar) line.append(" ").append(block ? "|" : scalar_text(value.text));
        if (value.kind == Node::Kind::list) line.append(" ").append(list_text(value));
        if (value.kind == Node::Kind::map && value.members.empty()) line.append(" {}");
        finish_line(line, value.note, note_column, text);
        if (block) write_block(value.text, indent + 2, text);
        if (value.kind == Node::Kind::map) write_map(value, indent + 2, note_column, text);
    }
}

}  // namespace

std::string write_yaml(const Node& root, std::size_t note_column) {
    std::string text;
    write_map(root, 0, note_column, text);
    return text;
}

}  // namespace soft::design
