#pragma once
/// The parts of a design whose keys depend on what is written: supports and outputs (loads: loads.hpp; path: path.hpp;
/// material: materials.hpp). Each adds its keys to the schema from the tree, and is made typed from the checked items.
/// Private to the module.
#include <map>
#include <span>
#include <string>
#include <vector>

#include "design/collect.hpp"
#include "design/design.hpp"

namespace soft::design {

/// Examples of required values by key path, for the error that misses them and for templates.
using Examples = std::map<std::string, std::string>;

void add_support_keys(Schema& schema, const Node& root);
void add_output_keys(Schema& schema, const Node& root, const Node& defaults);

[[nodiscard]] std::vector<model::Support> supports_of(std::span<const Item> items, const FaceNames& faces,
                                                      const Values& values);
[[nodiscard]] std::vector<Design::OutputRequest> outputs_of(std::span<const Item> items, const FaceNames& faces,
                                                            const Values& values);

/// Members of the group at `path`; none where there is no such group.
[[nodiscard]] const std::vector<Member>& members_of(const Node& root, std::string_view path);
/// Middle of "loads.<name>.pressure"; empty if the path is no such.
[[nodiscard]] std::string name_between(const std::string& path, std::string_view prefix, std::string_view suffix);
/// Refuses a direction (axis | x | y | z | r | normal, with a minus for gravity) that the model's coordinates do not have.
void check_direction(const Values& values, const std::string& path);

}  // namespace soft::design
