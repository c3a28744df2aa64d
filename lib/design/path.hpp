#pragma once
/// The path of a design: how it is controlled, where it ends, and its stages. Private to the module. Tested by design/path_test.
#include <span>
#include <string>
#include <vector>

#include "design/loads.hpp"

namespace soft::design {

/// A stage as it is written; a design without stages has one, with an empty name, that brings all loads to their values.
struct StageEntry {
    std::string name;
    std::string path;  ///< "path.stages.inflate"; of the one stage "path"
    std::vector<StageLoad> loads;
};

/// An empty `until` of a stage becomes the word `none`, so that a flat list of values can hold it.
void name_empty_ends(Node& root);

/// After name_empty_ends. Reads outputs and loads of the tree for what may be controlled or end the path.
[[nodiscard]] std::vector<StageEntry> add_path_keys(Schema& schema, const Node& root, std::span<const LoadEntry> loads);

/// Everything the tree says of the path; `loads` and `entries` belong together.
struct PathParts {
    std::span<const StageEntry> stages;
    std::span<const LoadEntry> entries;
    const Loads& loads;
    std::span<const std::string> outputs;  ///< names
};
/// Refuses controls and ends that the loads and outputs do not have, and loads that no stage names.
[[nodiscard]] model::PathSettings path_of(const PathParts& parts, std::span<const Item> items, const Values& values);

}  // namespace soft::design
