#pragma once
/// The path of a design: control, end criteria and stages. Private to the module. Tested by design/path_test.
#include <span>
#include <string>
#include <vector>

#include "design/loads.hpp"
#include "design/setting.hpp"

namespace soft::design {

/// A stage as written. A design without stages has a single one with an empty name, which applies all loads.
struct StageEntry {
    std::string name;
    std::string path;  ///< "path.stages.inflate"; "path" for the single unnamed stage
    std::vector<StageLoad> loads;
};

/// The settings of a path other than its stages, and the control of a stage.
[[nodiscard]] const Settings<model::PathSettings>& path_settings();
[[nodiscard]] const Setting<model::Stage>& control_setting();

/// Replaces an empty `until` of a stage by the word `none`, so that it can be stored in a flat list of values.
void fill_empty_until(Node& root);

/// Adds the keys of the path; call fill_empty_until first. The outputs and loads of the tree determine what can be controlled and
/// what can end the path.
[[nodiscard]] std::vector<StageEntry> add_path_keys(Schema& schema, const Node& root, std::span<const LoadEntry> loads);

/// Inputs of path_of. `loads` is the result of loads_of(entries).
struct PathParts {
    std::span<const StageEntry> stages;
    std::span<const LoadEntry> entries;
    const Loads& loads;
    std::span<const std::string> outputs;  ///< names
};
/// The path settings. Rejects controls and end criteria that do not match the loads and outputs, and loads that no stage names.
[[nodiscard]] model::PathSettings path_of(const PathParts& parts, std::span<const Item> items, const Values& values);
/// Warnings of loads whose stated value acts in no stage, because each stage states its own.
[[nodiscard]] std::vector<std::string> unused_values(const PathParts& parts, const Values& values);

}  // namespace soft::design
