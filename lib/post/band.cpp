#include "post/band.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace soft::post {

Band read_band(const table::Table& table, const Curve& curve) {
    const auto column = [&](const char* name) {
        return std::ranges::find(table.headings, name, &table::Heading::name) - table.headings.begin();
    };
    const auto end = static_cast<std::ptrdiff_t>(table.headings.size());
    const auto sampled = column("band_sampled"), linear = column("band_linear");
    if (sampled == end && linear == end)
        throw Error(ExitCode::bad_input, table.source, "has no column band_linear or band_sampled",
                    "give a table that scripts/uncertainty has written");
    Band band{read_measured(table, curve, {}), 0,
              table::numbers(table, static_cast<std::size_t>(sampled != end ? sampled : linear)), sampled != end};
    for (std::size_t row = 0; row < band.half.size(); ++row)
        if (band.half[row] < 0)
            throw Error(ExitCode::bad_input, table.source + ":" + std::to_string(table.lines[row]),
                        "the band is less than 0 wide");
    const auto load = std::ranges::find(curve.columns, Source::load, &Column::source);
    band.load = static_cast<std::size_t>(load - curve.columns.begin());
    if (load == curve.columns.end() || band.points.find(band.load) == nullptr)
        throw Error(ExitCode::bad_input, table.source, "does not have the load that its band belongs to");
    return band;
}

}  // namespace soft::post
