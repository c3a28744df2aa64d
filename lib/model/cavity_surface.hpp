#pragma once
/// The surface of a cavity as facets, and the rims of its openings.
/// Tested by surface/volume_test and assembly/system_test.
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::model {

/// The cavity's wall together with its closed inner faces, each facet once.
/// Error(bad_input) where the mesh has no face of that name.
[[nodiscard]] std::vector<mesh::Facet> cavity_facets(const Case& model, const Cavity& cavity);

/// Edge of a facet set that no other facet of the set shares: its nodes in the order of a line cell, run through as the
/// facet runs through it.
using RimEdge = std::vector<mesh::Index>;

/// Rims of a facet set of a solid, one a connected chain; those on symmetry planes are left out. Judged in the
/// reference configuration.
[[nodiscard]] std::vector<std::vector<RimEdge>> rims(const Case& model, std::span<const mesh::Facet> facets);

/// Nodes this near to a symmetry plane or the axis lie on it: a fraction of the mesh's extent, far above rounding and
/// far below any cell.
inline constexpr double plane_tolerance = 1e-9;
[[nodiscard]] double extent_m(const mesh::Mesh& mesh);

}  // namespace soft::model
