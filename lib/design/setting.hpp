#pragma once
/// One declaration per setting: name, unit or words, range, meaning, and the member of a struct that it sets. The default is that of
/// the struct. Parsing, range checks, templates, --explain, --set, the effective design and docs/reference/keys.md derive from it:
///     number("first_step", &SolverSettings::first_step, share, "first step as a share of the full load")
///     choice("newton", &SolverSettings::newton, {{"full", NewtonMethod::full}, ...}, "full: new tangent ...; modified: ...")
/// A member is a double, int, bool or enumerator; an optional<double> or a double may have a word in place of a number (`or_word`).
/// Private to the module. Tested by design/setting_test.
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "design/design.hpp"
#include "design/schema.hpp"

namespace soft::design {

template <class Struct>
struct Setting {
    Key key;  ///< its path is relative to the section
    std::function<void(const Values& values, const std::string& path, Struct& target)> read;
};
template <class Struct>
using Settings = std::vector<Setting<Struct>>;

/// The default of a member as written in a design, in a suitable unit.
[[nodiscard]] std::string default_text(double value, Kind kind);
[[nodiscard]] inline std::string default_text(const std::optional<double>& value, Kind kind) {
    return value ? default_text(*value, kind) : "";
}
[[nodiscard]] inline std::string default_text(const std::vector<double>&, Kind) { return {}; }

/// The default of a key in another unit.
[[nodiscard]] std::string text_in_unit(const Key& key, const std::string& unit);

/// Value at `path`. A word is 0, or no value.
inline void assign(const Values& values, const std::string& path, double& member) { member = values.number(path); }
inline void assign(const Values& values, const std::string& path, int& member) { member = values.count(path); }
inline void assign(const Values& values, const std::string& path, std::vector<double>& member) {
    member = values.numbers(path);
}
inline void assign(const Values& values, const std::string& path, std::optional<double>& member) {
    member = values.numbers(path).empty() ? std::nullopt : std::optional{values.number(path)};
}

template <class Struct, class Member>
[[nodiscard]] Setting<Struct> quantity(std::string name, Member Struct::*member, Kind kind, Range range,
                                       std::string meaning) {
    Key key = value_key(std::move(name), kind, range, std::move(meaning));
    key.fallback = default_text(Struct{}.*member, kind);
    return {std::move(key), [member](const Values& values, const std::string& path, Struct& target) {
                assign(values, path, target.*member);
            }};
}

template <class Struct, class Member>
[[nodiscard]] Setting<Struct> number(std::string name, Member Struct::*member, Range range, std::string meaning) {
    return quantity(std::move(name), member, Kind::ratio, range, std::move(meaning));
}

template <class Struct>
[[nodiscard]] Setting<Struct> count(std::string name, int Struct::*member, Range range, std::string meaning) {
    return quantity(std::move(name), member, Kind::count, range, std::move(meaning));
}

template <class Struct>
[[nodiscard]] Setting<Struct> flag(std::string name, bool Struct::*member, std::string meaning) {
    const std::string fallback = Struct{}.*member ? "true" : "false";
    Key key{.path = std::move(name), .kind = Kind::flag, .fallback = fallback, .meaning = std::move(meaning)};
    return {std::move(key), [member](const Values& values, const std::string& path, Struct& target) {
                target.*member = values.text(path) == "true";
            }};
}

template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

/// A word for each value of a member, not only of an enumeration.
template <class Struct, class Value>
[[nodiscard]] Setting<Struct> choice(std::string name, Value Struct::*member,
                                     const std::type_identity_t<Words<Value>>& words, std::string meaning) {
    Key key = choice_key(std::move(name), {}, {}, std::move(meaning));
    for (const auto& [word, value] : words) {
        key.choices.push_back(word);
        if (value == Struct{}.*member) key.fallback = word;
    }
    return {std::move(key), [member, words](const Values& values, const std::string& path, Struct& target) {
                const auto found = std::ranges::find(words, values.text(path), &Words<Value>::value_type::first);
                if (found != words.end()) target.*member = found->second;
            }};
}

/// Allows `word` in place of a number and makes it the default, which leaves the member 0 or without a value.
template <class Struct>
[[nodiscard]] Setting<Struct> or_word(std::string word, Setting<Struct> setting) {
    setting.key = or_word(std::move(word), std::move(setting.key));
    return setting;
}

/// Writes the default in this unit in place of the usual one of its size.
template <class Struct>
[[nodiscard]] Setting<Struct> in_unit(const std::string& unit, Setting<Struct> setting) {
    setting.key.fallback = text_in_unit(setting.key, unit);
    return setting;
}

template <class Struct>
[[nodiscard]] Setting<Struct> without_default(Setting<Struct> setting) {
    setting.key.fallback.clear();
    return setting;
}

/// The setting of a struct within another.
template <class Outer, class Struct>
[[nodiscard]] Setting<Outer> inside(Struct Outer::*part, Setting<Struct> setting) {
    return {std::move(setting.key),
            [part, read = std::move(setting.read)](const Values& values, const std::string& path, Outer& target) {
                read(values, path, target.*part);
            }};
}

/// The keys of a section: "solver", "loads.cavity.gas".
template <class Struct>
[[nodiscard]] std::vector<Key> keys_of(const Settings<Struct>& settings, const std::string& section) {
    std::vector<Key> keys;
    for (const Setting<Struct>& setting : settings) {
        keys.push_back(setting.key);
        keys.back().path.insert(0, section + ".");
    }
    return keys;
}

/// The struct of a section. A member whose key the design does not have keeps the value of `target`.
template <class Struct>
[[nodiscard]] Struct read_settings(const Settings<Struct>& settings, const Values& values, const std::string& section,
                                   Struct target = {}) {
    for (const Setting<Struct>& setting : settings)
        if (const std::string path = section + "." + setting.key.path; values.has(path))
            setting.read(values, path, target);
    return target;
}

}  // namespace soft::design
