#pragma once
/// Remeshes the surface of a body to the requested triangle size: edges are split, collapsed and flipped, points move along the
/// surface (M. Botsch and L. Kobbelt, A remeshing approach to multiresolution modeling, SGP 2004). An operation is rejected if it
/// deviates from the surface of the file by more than a twentieth of the size or inverts a triangle. A bend with a radius below the
/// cell size therefore keeps short edges across it and long ones along it. Creases stay edges; their ends and crossings stay points.
/// Tested by meshing/remesh_test.
#include <array>
#include <functional>
#include <vector>

#include "meshing/body_surface.hpp"

namespace soft::meshing {

/// Requested edge length at a point [m].
using SizeAt = std::function<double(const mesh::Point&)>;

/// Edges of the surface as pairs of point indices, ascending.
using Creases = std::vector<std::array<int, 2>>;

struct Remeshed {
    std::vector<mesh::Point> points;  ///< on the surface of the file; points of creases lie on the creases [m]
    std::vector<std::array<int, 3>> triangles;  ///< normals out of the body
    Creases creases;
};

/// Error(bad_input) "name: ..." if more than `max_points` points would be needed.
[[nodiscard]] Remeshed remesh(const BodySurface& surface, const Creases& creases, const SizeAt& size_m,
                              const SoupOrigin& origin, std::size_t max_points);

}  // namespace soft::meshing
