#pragma once
/// The state of one step as fields at quadrature points, averaged on cells, and at nodes.
///
/// Quadrature points: F and the stress of the law (material/response.hpp) at the points of the element's quadrature rule. The mixed form
/// uses the pressure unknown: a continuous pressure is the stored one, at interfaces between regions that of each region
/// (post/recovery.hpp); for a pressure that is linear in each cell (quadrilaterals and
/// hexahedra) the result file contains nodal means over the cells, and the linear function of the cell is fitted to them. The fit is
/// exact at the centre node and omits nodes on interfaces between regions; it is second-order accurate, as the pressure itself. In
/// F-bar form the stress of the law at F-bar is referred to F: P = J sigma F^-T.
/// Cells: means over the reference volume.
/// Nodes (region points): a linear function of X (constant if the rule has one point) is fitted by least squares to the values at
/// the quadrature points of each cell and evaluated at the nodes; the nodal value is the volume-weighted mean over the cells of the
/// region. A linear field is reproduced exactly; otherwise the error is of order h^2 in second-order cells and h in first-order
/// cells, also at the boundary. Components of F, P and sigma, J and the energy (clipped at 0) are recovered this way; all other
/// quantities are derived from them.
/// Sources: Zienkiewicz, Taylor, Zhu, The Finite Element Method (2013) 15.4, nodal averaging. Tested by
/// post/step_fields_test.
#include <span>
#include <vector>

#include "material/point_history.hpp"
#include "model/case.hpp"
#include "post/local_state.hpp"
#include "post/region_points.hpp"

namespace soft::post {

/// Nodal values of one step as returned by io::FieldReader.
struct NodalState {
    std::span<const double> displacement_m;  ///< [point, 3]
    std::span<const double> pressure_Pa;     ///< [point], the pressure unknown; empty if the formulation has none
    std::vector<Vector3> shifts = {};        ///< displacement of each obstacle (post/contact_pressure.hpp)
    std::vector<material::PointStep> inelastic = {};  ///< RubberHistory::at_if_known
};

struct StepFields {
    std::vector<LocalState> points;        ///< quadrature points, cell by cell
    std::vector<double> point_volumes_m3;  ///< reference; with 2 pi R (section), per metre depth (plane strain)
    std::vector<std::size_t> first_point;  ///< cell c has points first_point[c] .. first_point[c + 1]
    std::vector<LocalState> cells;         ///< one per cell
    std::vector<LocalState> nodes;         ///< one per region point
    bool stress_is_known =
        true;  ///< false for inelastic rubber without its history: stress and energy are those of the law
};

/// `model` is the solved case, `region_points` = make_region_points(model.mesh). Throws Error(bad_input) for a state that does not
/// match the mesh or formulation, and for an inverted point (det F <= 0), with its cell.
[[nodiscard]] StepFields step_fields(const model::Case& model, const RegionPoints& region_points,
                                     const NodalState& state);

/// False if the law of a region has no energy function.
[[nodiscard]] bool has_energy(const model::Case& model);

}  // namespace soft::post
