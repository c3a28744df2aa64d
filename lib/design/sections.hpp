#pragma once
/// The parts of a design whose keys depend on what is written: material (constants of its law), supports, loads,
/// outputs and path. Each adds its keys to the schema from the tree, and is made typed from the checked items.
/// Private to the room.
#include <map>
#include <span>
#include <string>
#include <vector>

#include "design/collect.hpp"
#include "design/design.hpp"

namespace soft::design {

/// Examples of required values by key path, for the error that misses them and for templates.
using Examples = std::map<std::string, std::string>;

/// Throws Error(bad_input) for a law that is unknown or missing and for a material given by name.
void add_material_keys(Schema& schema, const Node& root, std::string_view source, Examples& examples);
void add_support_keys(Schema& schema, const Node& root);
/// `defaults` are the family's; a pressure in them is an example and never used silently.
void add_load_keys(Schema& schema, const Node& root, const Node& defaults, std::string_view source, Examples& examples);
/// After add_output_keys, whose names it takes as ends of the path.
void add_path_keys(Schema& schema, const Node& root);
void add_output_keys(Schema& schema, const Node& root, const Node& defaults);

[[nodiscard]] model::Material material_of(const Values& values);
[[nodiscard]] std::vector<model::Support> supports_of(std::span<const Item> items, const FaceNames& faces,
                                                      const Values& values);
[[nodiscard]] std::vector<model::PressureLoad> loads_of(std::span<const Item> items, const FaceNames& faces,
                                                        const Values& values);
[[nodiscard]] std::vector<Design::OutputRequest> outputs_of(std::span<const Item> items, const FaceNames& faces,
                                                            const Values& values);
[[nodiscard]] model::PathSettings path_of(std::span<const Item> items, const Values& values);
[[nodiscard]] model::SolverSettings solver_of(const Values& values);

inline constexpr std::string_view cavity_name = "cavity";  ///< the load target that encloses a volume

}  // namespace soft::design
