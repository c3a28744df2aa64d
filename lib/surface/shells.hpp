#pragma once
/// Triangles that share points -> closed sheets with their normals out of the body (CGAL Polygon Mesh Processing).
/// Private to the module. Tested by surface/body_surface_test.
#include <string>

#include "surface/body_surface.hpp"

namespace soft::surface {

/// Triangles only, no two with the same corners. Refuses what body_surface.hpp says.
[[nodiscard]] BodySurface closed_shells(const FacetSoup& soup, const SoupOrigin& origin);

/// "1 facet", "3 facets"
[[nodiscard]] std::string counted(std::size_t count, const std::string& one, const std::string& several);

}  // namespace soft::surface
