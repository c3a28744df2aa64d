#pragma once
/// Feature edges, silhouette and shading of a surface, for view/skin.hpp and view/picture.hpp. Tested by view/skin_test.
#include <cstdint>
#include <span>
#include <vector>

#include "view/camera.hpp"
#include "view/skin.hpp"

namespace soft::view {

/// Edges at which the normals of two faces differ by more than 45 degrees, or that do not belong to exactly two faces: sorted pairs of
/// vertices.
[[nodiscard]] std::vector<std::array<std::int32_t, 2>> creases(std::span<const Face> faces,
                                                               std::span<const Point> positions);

/// Edges between a front-facing and a back-facing face for an eye at infinity in direction `eye`: pairs of vertices.
[[nodiscard]] std::vector<std::array<std::int32_t, 2>> silhouette(std::span<const Face> faces,
                                                                  std::span<const Point> positions, const Point& eye);

/// Normal of a face with the length of twice its area.
[[nodiscard]] Point face_normal(const Face& face, std::span<const Point> positions);

/// Smooth shading with discontinuities at the feature edges. Light at the corners of each face, 0 to 1: Lambert's law for a lamp to the upper left of the eye. The normal at a corner is
/// the mean over the faces at that vertex whose normals differ by less than 45 degrees. Back faces are lit in the same way.
[[nodiscard]] std::vector<std::array<double, 4>> corner_light(std::span<const Face> faces,
                                                              std::span<const Point> positions, const Screen& screen);

}  // namespace soft::view
