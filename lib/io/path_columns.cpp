#include "io/path_columns.hpp"

#include <algorithm>
#include <cmath>

namespace soft::io {

ListColumns pressure_columns(const model::Case& model) {
    ListColumns columns{"pressures", "pressure of each load, above ambient", {}};
    if (model.loads.size() > 1)
        for (const model::PressureLoad& load : model.loads) columns.names.push_back({load.name, "Pa"});
    return columns;
}

ListColumns volume_columns(const model::Case& model) {
    ListColumns columns{"volumes", "volume enclosed by each loaded cavity, whole actuator", {}};
    const auto cavities = model::measured_cavities(model);
    if (cavities.size() > 1)
        for (const model::Cavity* cavity : cavities) columns.names.push_back({cavity->name, "m3"});
    return columns;
}

ListColumns output_columns(const model::Case& model) {
    ListColumns columns{"outputs", "measured outputs, by name", {}};
    for (const model::Output& output : model.outputs)
        columns.names.push_back({output.name, std::string{model::unit_of(output.measure).SI}});
    return columns;
}

ListColumns output_error_columns(const model::Case& model) {
    ListColumns columns = output_columns(model);
    columns.group = "output_errors";
    columns.description = "half width of the discretisation error of each output at equal load";
    return columns;
}

ListColumns frequency_columns(const model::Case& model) {
    ListColumns columns{"frequencies", "natural frequency of small vibrations about the state; negative: unstable", {}};
    for (int k = 1; k <= model.path.frequencies; ++k) columns.names.push_back({std::to_string(k), "Hz"});
    return columns;
}

ListColumns derivative_columns(const model::Case& model) {
    ListColumns columns{"derivatives",
                        "derivative by a number of the design at a fixed position along the path, in SI units of both",
                        {}};
    for (const model::DesignParameter& parameter : model.parameters) {
        columns.names.push_back({"load_by_" + parameter.key, "SI"});
        for (const model::Output& output : model.outputs)
            columns.names.push_back({output.name + "_by_" + parameter.key, "SI"});
    }
    return columns;
}

const char* load_units(const model::Case& model) {
    switch (model::leading_load(model)) {
        case model::LeadingLoad::pressure:
        case model::LeadingLoad::traction: return "Pa";
        case model::LeadingLoad::force: return "N";
        case model::LeadingLoad::load_factor: break;
    }
    return "1";
}

bool all_finite(std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace soft::io
