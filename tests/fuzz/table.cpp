/// Fuzz target: CSV with measured curves, test data and outlines of profiles.
#include "core/table.hpp"

#include <cmath>

#include "fit/test_data.hpp"
#include "geometry/profile.hpp"
#include "target.hpp"

void soft::fuzz::read(std::span<const std::byte> bytes) {
    const std::string_view text = text_of(bytes);
    for (const core::Layout layout : {core::Layout::plain, core::Layout::described})
        for (const core::Decimal decimal : {core::Decimal::either, core::Decimal::comma})
            even_so([&] {
                const core::Table table = core::read_table(text, "fuzz.csv", {.decimal = decimal, .layout = layout});
                require(table.lines.size() == table.rows.size(), "each row has a line");
                for (const auto& row : table.rows) require(row.size() == table.width(), "rows are of one width");
                for (std::size_t column = 0; column < table.width() && column < 8; ++column)
                    even_so([&] {
                        for (const double value : core::numbers(table, column))
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
