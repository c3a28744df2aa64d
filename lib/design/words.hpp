#pragma once
/// Words of a choice and the enumerators they mean: one table each, for the key and for the typed value. Private to the module.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace soft::design {

template <class Enum>
struct Word {
    std::string_view name;
    Enum value;
};

/// For Key::choices.
template <class Enum, std::size_t count>
[[nodiscard]] std::vector<std::string> words_of(const std::array<Word<Enum>, count>& table) {
    std::vector<std::string> words;
    for (const Word<Enum>& word : table) words.emplace_back(word.name);
    return words;
}

/// For Key::fallback.
template <class Enum, std::size_t count>
[[nodiscard]] std::string word_for(const std::array<Word<Enum>, count>& table, Enum value) {
    return std::string{std::ranges::find(table, value, &Word<Enum>::value)->name};
}

/// Of a checked choice: `name` is in the table.
template <class Enum, std::size_t count>
[[nodiscard]] Enum meant_by(const std::array<Word<Enum>, count>& table, std::string_view name) {
    return std::ranges::find(table, name, &Word<Enum>::name)->value;
}

}  // namespace soft::design
