#pragma once
/// A body's surface in triangles of wanted sizes, as a mesher wants them: edges split, collapsed and flipped, points moved along
/// the surface (M. Botsch and L. Kobbelt, A remeshing approach to multiresolution modeling, SGP 2004), none of it where it would
/// leave the surface of the file by more than a twentieth of the size or turn a triangle over. So a bend that is tighter than a
/// cell is long keeps short edges across it, long ones along it. Creases stay edges, their ends and crossings stay points.
/// Tested by surface/remesh_test.
#include <array>
#include <functional>
#include <vector>

#include "surface/body_surface.hpp"

namespace soft::surface {

/// Wanted length of an edge at a place [m].
using SizeAt = std::function<double(const mesh::Point&)>;

/// Edges of the surface, by the numbers of their points, ascending.
using Creases = std::vector<std::array<int, 2>>;

struct Remeshed {
    std::vector<mesh::Point> points;            ///< on the surface of the file, those of creases on the creases [m]
    std::vector<std::array<int, 3>> triangles;  ///< normals out of the body
    Creases creases;
};

/// Error(bad_input) "name: ..." where more than `most` points would be needed.
[[nodiscard]] Remeshed remesh(const BodySurface& surface, const Creases& creases, const SizeAt& size_m,
                              const SoupOrigin& origin, std::size_t most);

}  // namespace soft::surface
