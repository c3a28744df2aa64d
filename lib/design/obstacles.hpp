#pragma once
/// The sections `contact` and `obstacles` of a design. The shapes of obstacles come from FamilyKeys::obstacles.
/// Private to the module. Tested by design/obstacle_test.
#include <span>
#include <vector>

#include "design/collect.hpp"
#include "design/design.hpp"

namespace soft::design {

inline constexpr std::string_view obstacles_section = "obstacles";

/// Adds the keys of `contact` and of every obstacle, and the names of the obstacles to Schema::faces. Rejects an obstacle without a
/// shape or with several, and a name that a face has or that is reserved.
void add_obstacle_keys(Schema& schema, const Node& root, std::span<const ObstacleKeys> shapes);

[[nodiscard]] std::vector<Key> contact_keys();
/// The keys of an obstacle called `name` with this shape.
[[nodiscard]] std::vector<Key> obstacle_keys(const std::string& name, const ObstacleKeys& shape);

[[nodiscard]] model::ContactSettings contact_of(const Values& values);
/// The obstacles, in the order of the design.
[[nodiscard]] std::vector<Design::ObstacleRequest> obstacles_of(std::span<const Item> items,
                                                                std::span<const ObstacleKeys> shapes,
                                                                const Values& values);

}  // namespace soft::design
