#pragma once
/// The case with a smaller and a larger value of a number of the design, for derivatives by it (solver/sensitivities.hpp). The cells stay:
/// the generator of the family runs with both values, and its mesh must have the same cells and faces as that of the case; only the nodes
/// move. Numbers of materials and loads move nothing. A value at the end of its range is varied to one side only. The relative change is 1e-7 where
/// no node moves, else 1e-6, or 1e-5 where the positions of the nodes are not accurate enough (gmsh computes those on curves by iteration).
/// Tested by geometry/variations_test and pipeline/sensitivities.
#include <span>
#include <string>
#include <vector>

#include "design/design.hpp"
#include "geometry/build.hpp"

namespace soft::geometry {

struct Variations {
    std::vector<model::Variation> variations;
    std::vector<std::string> notes;  ///< numbers of "all" that are left out, and why
};

/// Throws Error (bad_input) for a case without outputs, a motion in time, and friction, whose rows depend on the rows before.
void require_differentiable(const model::Case& model);

/// `keys`: numbers of design.parameters, or "all". `source` names the design in errors. Throws Error (usage) for a key that is not a
/// number of the design, Error (bad_input) for one with which the cells change, and as require_differentiable.
[[nodiscard]] Variations make_variations(const design::Design& design, const Built& built,
                                         std::span<const std::string> keys, std::string_view source);

}  // namespace soft::geometry
