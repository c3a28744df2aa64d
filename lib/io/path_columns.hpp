#pragma once
/// Stores rows of the path, limit points and bifurcations as columns. Internal to the module.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/columns.hpp"
#include "model/case.hpp"

namespace soft::io {

/// A group with one column per entry of a list member of the rows. A group without columns is not written.
struct ListColumns {
    struct Name {
        std::string name, units;
    };
    std::string group, description;
    std::vector<Name> names;
};

/// Columns of the pressure loads and of the measured cavities; empty unless the case has several.
[[nodiscard]] ListColumns pressure_columns(const model::Case& model);
[[nodiscard]] ListColumns volume_columns(const model::Case& model);
/// One column per output, in the SI unit of its measure.
[[nodiscard]] ListColumns output_columns(const model::Case& model);
/// Half width of the error bar of each output, in its unit, for rows that have error bars.
[[nodiscard]] ListColumns output_error_columns(const model::Case& model);
/// One column per natural frequency.
[[nodiscard]] ListColumns frequency_columns(const model::Case& model);
/// For each parameter one column per quantity: "load_by_geometry.wall", "elongation_by_geometry.wall".
[[nodiscard]] ListColumns derivative_columns(const model::Case& model);
/// Unit of the leading load: "Pa", "N" for a force, or "1" for the load factor.
[[nodiscard]] const char* load_units(const model::Case& model);

[[nodiscard]] bool all_finite(std::span<const double> values);

template <class Pick>
void write_column(hid_t group, const Label& label, std::size_t rows, Pick pick) {
    std::vector<decltype(pick(std::size_t{}))> values(rows);
    for (std::size_t i = 0; i < rows; ++i) values[i] = pick(i);
    using T = typename decltype(values)::value_type;
    write_array<T>(group, label, values);
}

template <class Row>
void write_lists(hid_t parent, const ListColumns& columns, std::span<const Row> rows,
                 std::vector<double> Row::*member) {
    if (columns.names.empty()) return;
    const GroupHandle group = create_group(parent, columns.group, columns.description);
    for (std::size_t k = 0; k < columns.names.size(); ++k)
        write_column(group.get(), {columns.names[k].name, columns.names[k].units, columns.description}, rows.size(),
                     [&](std::size_t i) { return (rows[i].*member)[k]; });
}

template <class Row>
void read_lists(const GroupReader& parent, const ListColumns& columns, std::vector<Row>& rows,
                std::vector<double> Row::*member) {
    if (columns.names.empty()) return;
    const GroupReader group = parent.group(columns.group);
    for (Row& row : rows) (row.*member).reserve(columns.names.size());
    for (const auto& column : columns.names) {
        const auto values = group.array<double>(column.name, {extent(rows.size())});
        for (std::size_t i = 0; i < rows.size(); ++i) (rows[i].*member).push_back(values[i]);
    }
}

}  // namespace soft::io
