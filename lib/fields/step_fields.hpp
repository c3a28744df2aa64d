#pragma once
/// The state of one step as fields: at integration points, averaged on cells, and at nodes.
///
/// Integration points: F and the law's own stress (material/response.hpp) at the points of the element's rule. In mixed
/// form with the pressure unknown: where it is continuous it is the stored one; where it is linear in each cell
/// (quadrilaterals and hexahedra) the result file holds means over the cells at a node, and the cell's linear function
/// is fitted to them, exact at its centre node, interfaces between regions left out: second-order accurate as the
/// pressure itself. In F-bar form the law's stress at F-bar, put on F: P = J sigma F^-T.
/// Cells: means over the reference volume.
/// Nodes (region points): in each cell the linear function of X (constant where the rule has one point) nearest to the
/// values at its points in the sense of least squares over the cell, taken at the nodes, then the mean over the
/// region's cells at the node, weighted by their volume. A linear field is met exactly; otherwise the error is of order
/// h^2 in second-order cells, h in first-order ones, at the boundary too. Components of F, P and sigma, J and the
/// energy (not below 0) are carried in this way, everything else is derived from them.
/// Sources: Zienkiewicz, Taylor, Zhu, The Finite Element Method (2013) 15.4, nodal averaging. Held by
/// fields/step_fields_test.
#include <span>
#include <vector>

#include "fields/local_state.hpp"
#include "fields/region_points.hpp"
#include "model/case.hpp"

namespace soft::fields {

/// Nodal values of one step as io::FieldReader gives them.
struct NodalState {
    std::span<const double> displacement_m;  ///< [point, 3]
    std::span<const double> pressure_Pa;     ///< [point], the pressure unknown; empty where the formulation has none
};

struct StepFields {
    std::vector<LocalState> points;        ///< integration points, cell by cell
    std::vector<double> point_volumes_m3;  ///< reference; of a section 2 pi R included, of plane strain per metre depth
    std::vector<std::size_t> first_point;  ///< cell c has points first_point[c] .. first_point[c + 1]
    std::vector<LocalState> cells;         ///< one a cell
    std::vector<LocalState> nodes;         ///< one a region point
};

/// `model` is the case as it was solved, `places` = region_points(model.mesh). Throws Error(bad_input) for a state that
/// does not fit the mesh or formulation, and for an inverted point (det F <= 0), with its cell.
[[nodiscard]] StepFields step_fields(const model::Case& model, const RegionPoints& places, const NodalState& state);

/// False where a region's law is a stress without an energy.
[[nodiscard]] bool has_energy(const model::Case& model);

}  // namespace soft::fields
