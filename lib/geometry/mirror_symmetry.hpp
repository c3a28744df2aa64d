#pragma once
/// Decides from a design whether half of a shape that is symmetric about y = 0 suffices. Tested by geometry/segment_test.
#include <span>
#include <string>

#include "design/design.hpp"

namespace soft::geometry {

/// The first key whose load, support, output, fibres or path may break the symmetry about y = 0 or needs a face that the half y >= 0
/// does not have; empty if there is none. `faces`: the faces of the half. Cautious: obstacles, points, and reactions always count.
[[nodiscard]] std::string find_asymmetry(const design::Values& values, std::span<const std::string> faces);

}  // namespace soft::geometry
