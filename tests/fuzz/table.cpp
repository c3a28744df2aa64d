/// Fuzz target: CSV with measured curves, test data and outlines of profiles.
#include "table/table.hpp"

#include <cmath>

#include "fit/test_data.hpp"
#include "geometry/profile.hpp"
#include "target.hpp"

void soft::fuzz::read(std::span<const std::byte> bytes) {
    const std::string_view text = text_of(bytes);
    for (const table::Layout layout : {table::Layout::plain, table::Layout::described})
        for (const table::Decimal decimal : {table::Decimal::either, table::Decimal::comma})
            even_so([&] {
                const table::Table table = table::read_table(text, "fuzz.csv", {.decimal = decimal, .layout = layout});
                require(table.lines.size() == table.rows.size(), "each row has a line");
                for (const auto& row : table.rows) require(row.size() == table.width(), "rows are of one width");
                for (std::size_t column = 0; column < table.width() && column < 8; ++column)
                    even_so([&] {
                        for (const double value : table::numbers(table, column))
                            require(std::isfinite(value), "a number is finite");
                    });
            });
    even_so([&] { static_cast<void>(geometry::outline_from(text, "fuzz.csv", geometry::Across::r)); });
    even_so([&] { static_cast<void>(geometry::outline_from(text, "fuzz.csv", geometry::Across::y)); });
    for (const fit::RowOrder order : {fit::RowOrder::path, fit::RowOrder::points})
        even_so([&] {
            for (const double stretch : fit::read_test(text, "fuzz.csv", fit::Mode::uniaxial, {.order = order}).stretch)
                require(stretch > 0 && std::isfinite(stretch), "a stretch is positive");
        });
}
