#pragma once
/// Tables of the words of a choice and their enumerators, used for the key and for the typed value. Private to the module.
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

/// The words of a table, for Key::choices.
template <class Enum, std::size_t count>
[[nodiscard]] std::vector<std::string> words_of(const std::array<Word<Enum>, count>& table) {
    std::vector<std::string> words;
    for (const Word<Enum>& word : table) words.emplace_back(word.name);
    return words;
}

/// The word of an enumerator, for Key::fallback.
template <class Enum, std::size_t count>
[[nodiscard]] std::string word_for(const std::array<Word<Enum>, count>& table, Enum value) {
    return std::string{std::ranges::find(table, value, &Word<Enum>::value)->name};
}

/// The enumerator of a word; `name` must be in the table.
template <class Enum, std::size_t count>
[[nodiscard]] Enum value_of_word(const std::array<Word<Enum>, count>& table, std::string_view name) {
    return std::ranges::find(table, name, &Word<Enum>::name)->value;
}

}  // namespace soft::design
