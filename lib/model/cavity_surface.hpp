#pragma once
/// The surface of a cavity as facets, and the rims of its openings.
/// Tested by surface/volume_test and fem/system_test.
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/case.hpp"

namespace soft::model {

/// The facets of the cavity's wall and of its closed inner faces, each once.
/// Throws Error(bad_input) if the mesh has no such face or the face is empty.
[[nodiscard]] std::vector<mesh::Facet> cavity_facets(const Case& model, const Cavity& cavity);

/// Edge that belongs to exactly one facet of a facet set: its nodes in the order of a line cell, in the orientation of the facet.
using RimEdge = std::vector<mesh::Index>;

/// Rims of a facet set of a solid, one per connected chain of edges, without the edges that lie on symmetry planes in the
/// reference configuration.
[[nodiscard]] std::vector<std::vector<RimEdge>> rims(const Case& model, std::span<const mesh::Facet> facets);

/// The symmetry planes x, y, z = 0 that cut a rim.
[[nodiscard]] std::array<bool, 3> planes_through(const Case& model, std::span<const RimEdge> rim);

}  // namespace soft::model
