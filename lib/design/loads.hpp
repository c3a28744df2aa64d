#pragma once
/// The loads of a design: a pressure on a cavity or a face, or a dead traction on a face. Private to the room.
/// Held by design/load_test.
#include <span>
#include <string_view>
#include <vector>

#include "design/collect.hpp"
#include "design/design.hpp"
#include "design/sections.hpp"

namespace soft::design {

/// `defaults` are the family's; a value in them is an example and never used silently.
void add_load_keys(Schema& schema, const Node& root, const Node& defaults, std::string_view source, Examples& examples);

struct Loads {
    std::vector<model::PressureLoad> pressures;
    std::vector<Design::TractionRequest> tractions;
};
/// In the order of `items`. Refuses loads of 0 and two loads on one face.
[[nodiscard]] Loads loads_of(std::span<const Item> items, const FaceNames& faces, const Values& values);

}  // namespace soft::design
