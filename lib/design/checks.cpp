#include "design/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"

namespace soft::design {
namespace {

struct QuantityKind {
    Kind kind;
    core::Dimension dimension;
};
constexpr std::array quantity_kinds{QuantityKind{Kind::length, core::Dimension::length},
                                    QuantityKind{Kind::area, core::Dimension::area},
                                    QuantityKind{Kind::volume, core::Dimension::volume},
                                    QuantityKind{Kind::pressure, core::Dimension::pressure},
                                    QuantityKind{Kind::angle, core::Dimension::angle},
                                    QuantityKind{Kind::density, core::Dimension::density},
                                    QuantityKind{Kind::mass, core::Dimension::mass},
                                    QuantityKind{Kind::acceleration, core::Dimension::acceleration},
                                    QuantityKind{Kind::time, core::Dimension::time},
                                    QuantityKind{Kind::rate, core::Dimension::rate},
                                    QuantityKind{Kind::flow_resistance, core::Dimension::flow_resistance},
                                    QuantityKind{Kind::force, core::Dimension::force},
                                    QuantityKind{Kind::moment, core::Dimension::moment},
                                    QuantityKind{Kind::curvature, core::Dimension::curvature},
                                    QuantityKind{Kind::ratio, core::Dimension::ratio}};

template <class T>
T value_or_refuse(const core::Parsed<T>& parsed, const Key& key, const Node& node) {
    if (const auto* refusal = std::get_if<core::Refusal>(&parsed))
        refuse(node.location, key.path, refusal->problem, refusal->remedy);
    return std::get<T>(parsed);
}

std::string bound_text(double value, Kind kind) {
    const auto dimension = dimension_of(kind);
    if (value == 0 || !dimension) return core::rounded_text(value, 9);
    return core::quantity_text(value, *dimension);
}

std::string bounds_text(const Key& key) {
    std::string text;
    if (std::isfinite(key.min)) text = (key.min_open ? "more than " : "at least ") + bound_text(key.min, key.kind);
    if (!std::isfinite(key.max)) return text;
    if (std::isfinite(key.min) && key.min == key.max) return "only " + bound_text(key.min, key.kind);
    return text + (text.empty() ? "at most " : ", at most ") + bound_text(key.max, key.kind);
}

void check_range(const Key& key, double value, const Node& node) {
    const bool low = key.min_open ? value <= key.min : value < key.min;
    if (low || value > key.max)
        refuse(node.location, key.path, core::one_line(core::tidy_quantity(node.text)) + " is out of range",
               "it must be " + bounds_text(key));
}

/// Limits lengths to a plausible range, because meshers and exact predicates fail or take very long outside of it.
void check_size(const Key& key, double length_m, const Node& node) {
    constexpr double max_length_m = 100.0, min_length_m = 1e-8;
    const double size_m = std::abs(length_m);
    if (size_m > max_length_m || (size_m > 0 && size_m < min_length_m))
        refuse(node.location, key.path,
               core::one_line(core::tidy_quantity(node.text)) + " is " +
                   (size_m > max_length_m ? "longer" : "shorter") + " than any length of an actuator",
               "use 10 nm to 100 m; is the unit right?");
}

bool is_word(const Key& key, std::string_view text) {
    return std::find(key.choices.begin(), key.choices.end(), text) != key.choices.end();
}

void check_flag(const Key& key, Item& item, const Node& node) {
    if (node.text != "true" && node.text != "false")
        refuse(node.location, key.path, core::quoted(node.text) + " is neither true nor false", "write true or false");
    item.entry.number = node.text == "true" ? 1 : 0;
}

void check_choice(const Key& key, const Node& node) {
    if (!is_word(key, node.text))
        refuse(node.location, key.path, core::quoted(node.text) + " is not a valid value",
               core::did_you_mean(node.text, key.choices));
}

void check_text(const Key& key, const Node& node) {
    constexpr std::size_t max_line_bytes = 200, max_text_bytes = std::size_t{1} << 17;
    const bool several_lines = key.max_count > 1 && node.text.find('\n') != std::string::npos;
    const std::size_t max_bytes = several_lines ? max_text_bytes : max_line_bytes;
    const bool control = std::any_of(node.text.begin(), node.text.end(), [&](char c) {
        const bool layout = several_lines && (c == '\n' || c == '\r' || c == '\t');
        return !layout && (static_cast<unsigned char>(c) < 0x20 || c == 0x7F);
    });
    if (core::trimmed(node.text).empty())
        refuse(node.location, key.path, "the text is empty", "leave the key out for its default");
    if (control)
        refuse(node.location, key.path, "the text contains a line break or a control character", "write one line");
    if (node.text.size() > max_bytes)
        refuse(node.location, key.path, "the text is longer than " + std::to_string(max_bytes) + " bytes");
}

void check_number(const Key& key, Item& item, const Node& node) {
    if (is_word(key, core::trimmed(node.text))) {  // "auto", "incompressible"
        item.entry.text = core::trimmed(node.text);
        return;
    }
    if (key.kind == Kind::count)
        item.entry.number = static_cast<double>(value_or_refuse(core::parse_count(node.text), key, node));
    else
        item.entry.number = value_or_refuse(core::parse_quantity(node.text, *dimension_of(key.kind)), key, node);
    check_range(key, item.entry.number, node);
    constexpr std::array<std::string_view, 3> sized{"geometry.", "mesh.", "obstacles."};
    if (key.kind == Kind::length &&
        std::ranges::any_of(sized, [&](std::string_view section) { return key.path.starts_with(section); }))
        check_size(key, item.entry.number, node);
    item.entry.text = core::tidy_quantity(node.text);
    item.entry.numbers = {item.entry.number};
}

/// Checks each value of a list like a single value. Entry::number is the first one.
void check_list(const Key& key, Item& item, const Node& node) {
    if (node.items.empty()) refuse(node.location, key.path, "the list is empty", "write " + range_text(key));
    if (node.items.size() > static_cast<std::size_t>(key.max_count))
        refuse(node.location, key.path, std::to_string(node.items.size()) + " values are too many",
               "write at most " + std::to_string(key.max_count));
    std::vector<double> numbers;
    for (const Node& value : node.items) {
        if (value.kind != Node::Kind::scalar)
            refuse(value.location, key.path, "a list of single values is needed here", "write " + range_text(key));
        check_number(key, item, value);
        numbers.push_back(item.entry.number);
        item.list.push_back(item.entry.text);
    }
    item.entry.number = numbers.front();
    item.entry.numbers = std::move(numbers);
    item.entry.text = core::join(item.list);
}

void add_face(const Key& key, Item& item, const Node& node, const FaceNames& names) {
    if (node.kind != Node::Kind::scalar)
        refuse(node.location, key.path, "a face is a single name", "write one name or [name, name]");
    const std::string face = resolve_face(names, node.text);
    if (face.empty())
        refuse(node.location, key.path, "no face is called " + core::quoted(node.text),
               core::did_you_mean(node.text, all_names(names)));
    const bool twice = std::any_of(item.list.begin(), item.list.end(),
                                   [&](const std::string& other) { return resolve_face(names, other) == face; });
    if (twice) refuse(node.location, key.path, "face " + core::quoted(face) + " is named twice");
    item.list.push_back(node.text);
}

}  // namespace

std::optional<core::Dimension> dimension_of(Kind kind) {
    const auto row = std::ranges::find(quantity_kinds, kind, &QuantityKind::kind);
    return row == quantity_kinds.end() ? std::nullopt : std::optional{row->dimension};
}

Kind kind_of(core::Dimension dimension) {
    const auto row = std::ranges::find(quantity_kinds, dimension, &QuantityKind::dimension);
    return row == quantity_kinds.end() ? Kind::ratio : row->kind;
}

std::string resolve_face(const FaceNames& names, std::string_view face) {
    if (std::find(names.faces.begin(), names.faces.end(), face) != names.faces.end()) return std::string{face};
    const auto alias = names.aliases.find(std::string{face});
    return alias == names.aliases.end() ? std::string{} : alias->second;
}

std::vector<std::string> all_names(const FaceNames& names) {
    std::vector<std::string> all = names.faces;
    for (const auto& [alias, face] : names.aliases) all.push_back(alias);
    return all;
}

Item check_value(const Key& key, const Node& node, const FaceNames& names) {
    Item item{key, {.text = node.text, .location = node.location, .given = node.location != default_location}, {}};
    if (key.kind == Kind::faces) {
        if (node.kind == Node::Kind::scalar && is_word(key, node.text)) return item;
        if (node.kind == Node::Kind::list)
            for (const Node& face : node.items) add_face(key, item, face, names);
        else
            add_face(key, item, node, names);
        if (item.list.empty())
            refuse(node.location, key.path, "the list of faces is empty", "name a face or leave the key out");
        item.entry.text = core::join(item.list);
        return item;
    }
    if (node.kind == Node::Kind::empty)
        refuse(node.location, key.path, "has no value",
               "write " + range_text(key) + ", or leave the key out for its default");
    if (key.max_count > 1 && node.kind == Node::Kind::list) {
        check_list(key, item, node);
        return item;
    }
    if (node.kind != Node::Kind::scalar)
        refuse(node.location, key.path, "a single value is needed here", "write " + range_text(key));
    switch (key.kind) {
        case Kind::flag: check_flag(key, item, node); break;
        case Kind::choice: check_choice(key, node); break;
        case Kind::text: check_text(key, node); break;
        case Kind::list:
        case Kind::faces: break;
        default: check_number(key, item, node); break;  // a quantity or a count
    }
    return item;
}

std::string range_text(const Key& key) {
    switch (key.kind) {
        case Kind::flag: return "true | false";
        case Kind::text: return key.max_count > 1 ? "the name of a file, or its lines" : "one line of text";
        case Kind::choice: return core::join(key.choices, " | ");
        case Kind::faces:
            return "a face or [face, face]" + (key.choices.empty() ? "" : " | " + core::join(key.choices, " | "));
        case Kind::list: return "a list";
        default: break;
    }
    std::string text = bounds_text(key);
    const auto dimension = dimension_of(key.kind);
    const std::string noun{dimension ? core::name(*dimension) : "whole number"};
    text = text.empty() ? "any " + noun : noun + " " + text;
    if (key.max_count > 1) text += ", or a list of up to " + std::to_string(key.max_count);
    for (const std::string& word : key.choices) text += " | " + word;
    return text;
}

}  // namespace soft::design
