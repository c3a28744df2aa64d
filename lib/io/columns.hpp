#pragma once
/// Conversion between lists of structs and columns. Internal to the module.
#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "core/text.hpp"
#include "io/hdf5_read.hpp"
#include "io/hdf5_write.hpp"

namespace soft::io {

/// One column of a list of structs.
template <class List, class Pick>
[[nodiscard]] auto column(const List& list, Pick pick) {
    std::vector<std::decay_t<decltype(pick(*list.begin()))>> values;
    values.reserve(list.size());
    for (const auto& entry : list) values.push_back(pick(entry));
    return values;
}

/// The same for a member that is an array of three, in row-major order.
template <class T, class List, class Pick>
[[nodiscard]] std::vector<T> rows_of_three(const List& list, Pick pick) {
    std::vector<T> values;
    values.reserve(list.size() * 3);
    for (const auto& entry : list)
        for (const auto value : pick(entry)) values.push_back(static_cast<T>(value));
    return values;
}

/// Row `row` of the result of rows_of_three.
template <class T>
[[nodiscard]] std::array<T, 3> triple(const auto& values, std::size_t row) {
    return {static_cast<T>(values[3 * row]), static_cast<T>(values[3 * row + 1]), static_cast<T>(values[3 * row + 2])};
}

template <class T>
void write_list(hid_t group, const Label& label, const std::vector<T>& values, std::vector<hsize_t> shape = {}) {
    write_array<T>(group, label, values, std::move(shape));
}

[[nodiscard]] inline std::int64_t extent(std::size_t size) { return static_cast<std::int64_t>(size); }

/// Reads a list of enumerators given by their names in a table.
template <class Enum, std::size_t size>
[[nodiscard]] std::vector<Enum> read_words(const GroupReader& group, const std::string& name,
                                           const std::array<Named<Enum>, size>& table, std::int64_t expected) {
    std::vector<Enum> values;
    for (const std::string& word : group.texts(name, expected)) {
        const auto value = value_of(table, word);
        if (!value)
            throw group.refuse(name + "[" + std::to_string(values.size()) + "]",
                               core::quoted(word) + " is not a known value");
        values.push_back(*value);
    }
    return values;
}

}  // namespace soft::io
