#pragma once
/// Limit points, bifurcations and first contacts of a path, as lines of text and as JSON. Tested by pipeline/reports.sh.
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/case.hpp"
#include "model/path.hpp"

namespace soft::cli {

/// The JSON of a point: step, load, volume and outputs, in the units of the tool.
using PointJson = std::function<nlohmann::ordered_json(const model::LimitPoint&)>;

/// Adds the arrays `limit_points`, `bifurcations` (with modes, mode_stored) and `events` (first contacts, with obstacle, location_mm,
/// text).
void add_events(nlohmann::ordered_json& json, const model::PathEnd& end, const model::Case& model,
                const PointJson& point_json);

/// "12.3 kPa, elongation 92.5 mm, volume 55.3 mL"
[[nodiscard]] std::string location_text(const model::LimitPoint& point, const model::Case& model);
/// Adds load, volume and outputs in SI units.
void add_point(nlohmann::ordered_json& json, const model::LimitPoint& point, const model::Case& model);

/// The first few limit points ("limit point at 44.339 kPa, elongation 13.44 mm, volume 45.7 mL") before row `steps`, where the summary
/// line names one; all bifurcations ("bifurcation at 26.1 kPa, ...: another branch intersects the path ..."); the first few first
/// contacts ("first contact at 1.37 kPa, ...: the actuator touches itself at x = 12.3 mm, r = 4.5 mm of the undeformed part").
[[nodiscard]] std::vector<std::string> event_lines(const model::PathEnd& end, int steps, const model::Case& model);

}  // namespace soft::cli
