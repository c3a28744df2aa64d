#pragma once
/// The edges of a surface that the eye follows. For view/skin.hpp and view/picture.hpp. Tested by view/skin_test.
#include <cstdint>
#include <span>
#include <vector>

#include "view/skin.hpp"

namespace soft::view {

/// Where two faces meet at more than 45 degrees, or one face ends: pairs of vertices, in order.
[[nodiscard]] std::vector<std::array<std::int32_t, 2>> creases(std::span<const Face> faces,
                                                               std::span<const Point> positions);

/// Edges between a face seen from outside and one seen from inside by an eye far away in direction `eye`: pairs of
/// vertices.
[[nodiscard]] std::vector<std::array<std::int32_t, 2>> silhouette(std::span<const Face> faces,
                                                                  std::span<const Point> positions, const Point& eye);

/// Area-weighted normal of a face, twice its area long.
[[nodiscard]] Point face_normal(const Face& face, std::span<const Point> positions);

}  // namespace soft::view
