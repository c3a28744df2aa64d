#pragma once
/// Checks of the cavities of a case: closed, oriented, free of self-intersection, volume, minimum wall thickness. The checks (CGAL)
/// apply to the whole actuator with wall, inner faces and plugs; the solver does not need them.
/// Tested by surface/report_test.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::surface {

struct CavityReport {
    std::string name;
    std::size_t triangles = 0;
    bool closed = false;
    bool oriented = false;                     ///< the normals out of the rubber point into the cavity everywhere
    std::optional<mesh::Point> open_location;  ///< where the surface is not closed; all locations in model coordinates
    std::optional<mesh::Point> self_intersection;  ///< where two parts of the surface intersect
    double faceted_volume_m3 = 0;                  ///< of the triangles, by CGAL; 0 unless closed
    double volume_m3 = 0;                          ///< of the second-order surface, by quadrature
    std::optional<double> min_wall_m;
    mesh::Point min_wall_location{};
};

/// One report per cavity, also for defective ones. Plane strain has no closed surface and gives no report.
/// Error(bad_input) if the mesh lacks a face that the cavity names.
[[nodiscard]] std::vector<CavityReport> inspect_cavities(const model::Case& model);

/// As above; Error(bad_input) "cavity: ... near x = 12.3 mm, r = 4.5 mm; remedy" for a cavity surface that is open, intersects
/// itself or has the wrong orientation.
std::vector<CavityReport> check_cavities(const model::Case& model);

}  // namespace soft::surface
