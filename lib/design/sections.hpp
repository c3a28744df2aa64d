#pragma once
/// The sections of a design whose keys depend on the document: supports and outputs (loads: loads.hpp; path: path.hpp; material:
/// materials.hpp). Each section adds its keys to the schema and is converted to a typed value from the checked items.
/// Private to the module.
#include <map>
#include <span>
#include <string>
#include <vector>

#include "design/collect.hpp"
#include "design/design.hpp"

namespace soft::design {

/// Example values of required keys by key path, for errors and templates.
using Examples = std::map<std::string, std::string>;

void add_support_keys(Schema& schema, const Node& root);
void add_output_keys(Schema& schema, const Node& root, const Node& defaults);

[[nodiscard]] std::vector<model::Support> supports_of(std::span<const Item> items, const FaceNames& faces,
                                                      const Values& values);
[[nodiscard]] std::vector<Design::OutputRequest> outputs_of(std::span<const Item> items, const FaceNames& faces,
                                                            const Values& values);

/// Members of the group at `path`; empty without such a group.
[[nodiscard]] const std::vector<Member>& members_of(const Node& root, std::string_view path);
/// The part of `path` between `prefix` and `suffix`, such as <name> of "loads.<name>.pressure"; empty if they do not match.
[[nodiscard]] std::string name_between(const std::string& path, std::string_view prefix, std::string_view suffix);
/// Rejects a direction (axis | x | y | z | r | normal; gravity also with a minus) that the coordinates of the model do not have.
void check_direction(const Values& values, const std::string& path);
/// The same for the direction (axis | x | y | z) of an obstacle.
void check_obstacle_direction(const Values& values, const std::string& path);

}  // namespace soft::design
