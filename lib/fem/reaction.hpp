#pragma once
/// Force and moment that a face exerts on its supports or prescribed motions: the outputs `force` and `moment` (model::Measure).
///   r_a = external - internal forces at node a, including those at constrained (fixed or prescribed) components; 0 at a free node
///   f_ai = s_ai r_ai: s = 1 in a component i that the face constrains, 1/k where k faces do so, 0 where only other faces do
///   force = n sum_a f_a . d,     moment = n sum_a ((x_a - c) x f_a) . d = n sum_a (d x (x_a - c)) . f_a
/// over the nodes a of the face; d direction, x_a deformed position, c centroid of the undeformed whole face, n copies of the
/// face in the whole actuator (model/face_symmetry.hpp). The forces of all constrained faces together are therefore the resultant of
/// the loads, to the accuracy of the equilibrium.
/// Derived here. Tested by fem/reaction_test and the verification suite (group Reactions).
#include <span>
#include <vector>

#include "fem/cavity.hpp"
#include "math/tensor.hpp"

namespace soft::fem {

struct Reaction {
    model::Measure measure = model::Measure::force;
    Vector3 direction{};  ///< its part that does not cancel by symmetry
    Vector3 centre{};
    double copies = 1;
    std::vector<mesh::Index> nodes;                ///< of the face, ascending
    std::vector<Vector3> shares;                   ///< [node] s, by component
    std::vector<std::vector<std::size_t>> cells;   ///< [group] this rank's cells with such a node
    std::vector<std::vector<std::size_t>> facets;  ///< [pressure load] the same
    /// On rank 0: the nodes with their positions, and the dead forces at them per unit level, component-major.
    SurfaceCell at_nodes;
    std::vector<std::vector<double>> plugs, tractions, body_forces;

    [[nodiscard]] bool has(mesh::Index node) const { return share_of(node) != nullptr; }
    [[nodiscard]] const Vector3* share_of(mesh::Index node) const;  ///< nullptr for a node that is not on the face
};

[[nodiscard]] Reaction make_reaction(const model::Case& input, const model::Output& output);

/// The entries of `forces` at the reaction's nodes, component-major.
[[nodiscard]] std::vector<double> at_nodes_of(const Reaction& reaction, const NodalForces& forces, int dimension);

/// Nodal forces of a cell, a facet or dead loads, and their derivatives.
struct NodeForces {
    std::span<const mesh::Index> nodes;
    int dimension;
    std::span<const double> x;      ///< positions, component-major
    std::span<const double> force;  ///< the forces first, component-major; further entries (pressures) are ignored
    std::span<const double>
        stiffness;  ///< d force / d unknowns, row-major, as many columns as `slope`; empty: constant
};
/// Returns the contribution of `forces` to the output and adds `sign` times its derivative by the unknowns to `slope`, unless
/// that is empty.
double add_share(const Reaction& reaction, const NodeForces& forces, double sign, std::span<double> slope);

}  // namespace soft::fem
