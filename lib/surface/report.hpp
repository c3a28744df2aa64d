#pragma once
/// Is each cavity of a case a sound vessel? Closed, oriented, free of self-intersection, its volume, its thinnest wall.
/// The checks see the whole actuator with wall, inner faces and plugs (CGAL); nothing here is needed to solve.
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
    bool oriented = false;                         ///< normals of the rubber point into the cavity everywhere
    std::optional<mesh::Point> open_place;         ///< where it is not closed; places are in model coordinates
    std::optional<mesh::Point> self_intersection;  ///< where two parts of the surface meet
    double faceted_volume_m3 = 0;                  ///< of the triangles, by CGAL; 0 unless closed
    double volume_m3 = 0;                          ///< of the second-order surface, by quadrature
    std::optional<double> min_wall_m;
    mesh::Point min_wall_place{};
};

/// One report a cavity, whatever it finds. Plane strain has no closed surface: no report.
/// Error(bad_input) where the mesh lacks a face that the cavity names.
[[nodiscard]] std::vector<CavityReport> inspect_cavities(const model::Case& model);

/// As above; Error(bad_input) "cavity: ... near x = 12.3 mm, r = 4.5 mm; remedy" for one that is open, meets
/// itself, or is inside out.
std::vector<CavityReport> check_cavities(const model::Case& model);

}  // namespace soft::surface
