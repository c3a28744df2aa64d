#pragma once
/// How a load goes with time, and what feeds a cavity: the keys `time_function` and `line` of a load, which only a dynamic design
/// has. Private to the module. `load` is the path of the load, "loads.cavity". Tested by design/dynamics_test.
#include <string>

#include "design/collect.hpp"
#include "design/design.hpp"
#include "design/sections.hpp"

namespace soft::design {

/// `written` is the group of the load. Refuses keys that the kind of course does not have.
void add_time_function_keys(Schema& schema, const std::string& load, const Node& written, Examples& examples);
[[nodiscard]] Key line_key(const std::string& load);

/// The default where the schema has no time_function for this load. Refuses a table whose lists do not fit or do not ascend.
[[nodiscard]] model::TimeFunction time_function_of(const Values& values, const std::string& load);
/// nullopt for `none`, and where the schema has no line for this load.
[[nodiscard]] std::optional<model::SupplyLine> line_of(const Values& values, const std::string& load);

}  // namespace soft::design
