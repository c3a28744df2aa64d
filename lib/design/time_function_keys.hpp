#pragma once
/// The keys `time_function` (load over time) of a load in a dynamic design. `load` is the path of the load, "loads.cavity". Private to
/// the module. Tested by design/dynamics_test.
#include <string>

#include "design/collect.hpp"
#include "design/design.hpp"
#include "design/sections.hpp"

namespace soft::design {

/// Adds the keys of the time function. `written` is the group of the load. Rejects keys that the kind of time function does not have.
void add_time_function_keys(Schema& schema, const std::string& load, const Node& written, Examples& examples);

/// The time function of a load; the default if the schema has none. Rejects a table whose lists have different lengths or whose times
/// are not ascending.
[[nodiscard]] model::TimeFunction time_function_of(const Values& values, const std::string& load);

}  // namespace soft::design
