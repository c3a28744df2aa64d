#pragma once
/// Integrals over a facet in the kinematics of a case: area, force of a follower pressure, and the volume it sweeps.
///   f_a = - int N_a n da   force per unit pressure, n out of the rubber on the DEFORMED facet, so a positive
///                          pressure pushes into the rubber (inflates a cavity);
///   K_ab = df_a/dx_b       consistent load stiffness (full square; the facet alone is not symmetric);
///   V = the facet's share of the enclosed volume [m^3]: -1/3 int x.n da (solid), int pi r^2 dx (axisymmetric),
///       -1/2 int x.n ds per unit depth (plane strain); sums to the volume over a closed wall; dV = exact derivative.
/// x current positions, component-major (dimension x nodes). Axisymmetric integrals carry 2 pi r.
/// Source: divergence theorem and Nanson's formula. Tested by model/facet_integrals_test.
#include <span>
#include <vector>

#include "mesh/cell_type.hpp"
#include "model/case.hpp"

namespace soft::model {

struct ReferenceFacet {
    mesh::CellType type;
    int dimension = 0;  ///< space dimension: 2 for lines, 3 for surfaces
    int nodes = 0;
    int points = 0;
    std::vector<double> weight;  ///< [point]
    std::vector<double> N;       ///< [point][node]
    std::vector<double> dN_dxi;  ///< [point][direction][node]
    [[nodiscard]] int dofs() const noexcept { return dimension * nodes; }
};

/// The table of a line, triangle or quadrilateral; the reference has static lifetime. Throws std::logic_error for any other cell.
[[nodiscard]] const ReferenceFacet& reference_facet(mesh::CellType type);

/// Adds f (dofs) and, if `stiffness` is not empty, df/dx (dofs x dofs, row-major).
void pressure_force(const ReferenceFacet& facet, Kinematics kinematics, std::span<const double> x,
                    std::span<double> force, std::span<double> stiffness);

/// Returns V and adds dV/dx to `gradient`.
double swept_volume(const ReferenceFacet& facet, Kinematics kinematics, std::span<const double> x,
                    std::span<double> gradient);

/// Adds int N_a dA over the UNDEFORMED facet to `weights` [node] and returns the area of the facet (includes 2 pi R).
double facet_area(const ReferenceFacet& facet, Kinematics kinematics, std::span<const double> X,
                  std::span<double> weights);

/// The facets of a face. Throws Error (bad_input, "loads") if the mesh does not have it.
[[nodiscard]] const std::vector<mesh::Facet>& facets_of(const mesh::Mesh& mesh, const std::string& face);

/// Nodes of a face with int N_a dA over the undeformed face; their sum is its area. Ascending by node.
struct FaceWeights {
    std::vector<mesh::Index> nodes;
    std::vector<double> weights_m2;
    double area_m2 = 0;
};
/// Errors as above.
[[nodiscard]] FaceWeights face_weights(const mesh::Mesh& mesh, Kinematics kinematics, const std::string& face);

/// Cap of an opening in a solid: returns the contribution V = 1/6 int c.(y x dy) of the cone from the apex c to one edge of the opening's
/// rim to the enclosed volume. y: positions of the edge's nodes (component-major), oriented so that the normal of the whole loop
/// points out of the cavity. Adds dV/dy to `gradient` and dV/dc to `apex_gradient`.
double cap_volume(const ReferenceFacet& edge, std::span<const double> y, std::span<const double, 3> apex,
                  std::span<double> gradient, std::span<double, 3> apex_gradient);

}  // namespace soft::model
