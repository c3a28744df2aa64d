#include "design/collect.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/obstacles.hpp"

namespace soft::design {
namespace {

using CheckedItems = std::map<std::string, Item>;

std::string child(const std::string& path, const std::string& key) { return path.empty() ? key : path + "." + key; }

/// Names that are allowed directly below `path`, in schema order.
std::vector<std::string> known_below(const Schema& schema, const std::string& path) {
    const std::string prefix = path.empty() ? "" : path + ".";
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    const auto first_part = [&](const std::string& below) {
        return below.substr(prefix.size(), below.find('.', prefix.size()) - prefix.size());
    };
    for (const Key& key : schema.keys)
        if (key.path.starts_with(prefix)) add(first_part(key.path));
    for (const auto& [section, members] : schema.names) {
        if (section != path && section.starts_with(prefix)) add(first_part(section));
        if (section != path) continue;
        for (const std::string& member : members) add(member);
    }
    return names;
}

bool is_group(const Schema& schema, const std::string& path) {
    const bool inside = std::any_of(schema.keys.begin(), schema.keys.end(),
                                    [&](const Key& key) { return key.path.starts_with(path + "."); });
    return inside || schema.names.contains(path);
}

void check_group(const Schema& schema, const Node& node, const std::string& path, CheckedItems& checked) {
    const std::vector<std::string> known = known_below(schema, path);
    if (node.kind == Node::Kind::empty) return;  // "solver:" with nothing below it
    if (node.kind != Node::Kind::map)
        refuse(node.location, path, "a group of keys is needed here",
               path.empty()    ? "write family: ..., material: ..."
               : known.empty() ? "write {name: {...}}"
                               : "write {key: value}; known: " + core::join(known));
    for (const Member& member : node.members) {
        if (member.key.find('.') != std::string::npos)
            refuse(member.location, child(path, member.key), "a key contains a dot",
                   "write nested groups; dots are for --set");
        const std::string below = child(path, member.key);
        const auto key =
            std::find_if(schema.keys.begin(), schema.keys.end(), [&](const Key& k) { return k.path == below; });
        if (key != schema.keys.end())
            checked.insert_or_assign(below, check_value(*key, member.value, schema.faces));
        else if (is_group(schema, below))
            check_group(schema, member.value, below, checked);
        else
            refuse(member.location, below, "unknown key", core::did_you_mean(member.key, known));
    }
}

/// Location of the innermost existing key that encloses `path`; otherwise the top of the document.
std::string location_for_missing(const Node& root, std::string path, std::string_view source) {
    const Node* node = &root;
    std::string location = std::string{source} + ":1:1";
    while (true) {
        const auto dot = path.find('.');
        const Member* member = dot == std::string::npos ? nullptr : find_member(*node, path.substr(0, dot));
        if (member == nullptr || member->location == default_location) return location;
        location = member->location;
        node = &member->value;
        path.erase(0, dot + 1);
    }
}

}  // namespace

std::vector<Item> collect(const Node& root, const Schema& schema, std::string_view source,
                          const std::map<std::string, std::string>& examples) {
    CheckedItems checked;
    check_group(schema, root, "", checked);
    std::vector<Item> items;
    for (const Key& key : schema.keys) {
        if (const auto found = checked.find(key.path); found != checked.end()) {
            items.push_back(found->second);
            continue;
        }
        if (key.fallback.empty()) {
            const auto example = examples.find(key.path);
            const std::string name = key.path.substr(key.path.rfind('.') + 1);
            refuse(location_for_missing(root, key.path, source), key.path, "missing (" + key.meaning + ")",
                   "add " + name + ": " + (example == examples.end() ? range_text(key) : example->second));
        }
        const bool list = key.max_count > 1 && key.fallback.starts_with('[');
        const Node fallback =
            list ? parse_fragment(key.fallback, default_location) : scalar_node(key.fallback, default_location);
        items.push_back(check_value(key, fallback, schema.faces));
    }
    return items;
}

Node tree_of(std::span<const Item> items) {
    Node root;
    root.kind = Node::Kind::map;
    const auto add_empty = [&](const std::string& path) {
        Node empty;
        empty.kind = Node::Kind::map;
        put(root, path, std::move(empty));
    };
    for (const Item& item : items) {
        Node value = scalar_node(item.entry.text, item.entry.location);
        if (item.list.size() == 1) value.text = item.list.front();
        if (item.list.size() > 1) {
            value.kind = Node::Kind::list;
            for (const std::string& name : item.list) value.items.push_back(scalar_node(name, item.entry.location));
        }
        put(root, item.key.path, std::move(value));
    }
    if (find_path(root, "path.until") == nullptr) add_empty("path.until");
    Node sorted;
    sorted.kind = Node::Kind::map;
    for (const SectionNote& section : section_notes()) {
        if (find(root, section.name) == nullptr) {
            if (section.name == "names" || section.name == "materials" || section.name == obstacles_section)
                continue;  // few designs have any
            add_empty(section.name);
        }
        sorted.members.push_back(*find_member(root, section.name));
    }
    return sorted;
}

}  // namespace soft::design
