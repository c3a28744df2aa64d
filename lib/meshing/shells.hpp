#pragma once
/// Converts a triangle soup with shared points to closed shells with normals out of the body (CGAL Polygon Mesh Processing).
/// Private to the module. Tested by meshing/body_surface_test.
#include <string>

#include "meshing/body_surface.hpp"

namespace soft::meshing {

/// `soup` contains triangles only, no two with the same corners. Errors: see body_surface.hpp.
[[nodiscard]] BodySurface closed_shells(const FacetSoup& soup, const SoupOrigin& origin);

/// A count with its noun: "1 facet", "3 facets".
[[nodiscard]] std::string counted(std::size_t count, const std::string& one, const std::string& several);

}  // namespace soft::meshing
