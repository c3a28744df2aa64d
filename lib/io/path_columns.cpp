#include "io/path_columns.hpp"

#include <algorithm>
#include <cmath>

namespace soft::io {

ListColumns pressure_columns(const model::Case& model) {
    ListColumns columns{"pressures", "of each load, above ambient", {}};
    if (model.loads.size() > 1)
        for (const model::PressureLoad& load : model.loads) columns.names.push_back({load.name, "Pa"});
    return columns;
}

ListColumns volume_columns(const model::Case& model) {
    ListColumns columns{"volumes", "enclosed by each loaded cavity, whole actuator", {}};
    const auto cavities = model::measured_cavities(model);
    if (cavities.size() > 1)
        for (const model::Cavity* cavity : cavities) columns.names.push_back({cavity->name, "m3"});
    return columns;
}

ListColumns output_columns(const model::Case& model) {
    ListColumns columns{"outputs", "what is measured, by name: displacements and angles", {}};
    for (const model::Output& output : model.outputs)
        columns.names.push_back({output.name, output.measure == model::Measure::displacement ? "m" : "rad"});
    return columns;
}

ListColumns output_error_columns(const model::Case& model) {
    ListColumns columns = output_columns(model);
    columns.group = "output_errors";
    columns.description = "half width of the discretisation error of each output at equal load";
    return columns;
}

const char* load_units(const model::Case& model) {
    return model::leading_load(model) == model::LeadingLoad::load_factor ? "1" : "Pa";
}

bool all_finite(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace soft::io
