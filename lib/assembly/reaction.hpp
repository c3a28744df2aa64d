#pragma once
/// Force and moment with which a face pushes on what holds or moves it: the outputs `force` and `moment` (model::Measure).
///   r_a = external - internal forces at node a, those at held and moved components among them; 0 where the node is free
///   f_ai = s_ai r_ai: s = 1 in a component i that the face holds or moves, 1/k where k faces do so, 0 where others alone do
///   force = n sum_a f_a . d,     moment = n sum_a ((x_a - c) x f_a) . d = n sum_a (d x (x_a - c)) . f_a
/// over the nodes a of the face; d direction, x_a deformed position, c centroid of the undeformed whole face, n copies of the
/// face in the whole actuator (model/face_symmetry.hpp). So the forces of all held faces together are the resultant of
/// the loads, as exactly as the equations are solved.
/// Derived here. Tested by assembly/reaction_test and the verification suite (group Reactions).
#include <span>
#include <vector>

#include "assembly/cavity.hpp"
#include "core/tensor.hpp"

namespace soft::assembly {

struct Reaction {
    model::Measure measure = model::Measure::force;
    Vector3 direction{};  ///< what of it does not cancel
    Vector3 centre{};
    double copies = 1;
    std::vector<mesh::Index> nodes;                ///< of the face, ascending
    std::vector<Vector3> shares;                   ///< [node] s, by component
    std::vector<std::vector<std::size_t>> cells;   ///< [group] this rank's with such a node
    std::vector<std::vector<std::size_t>> facets;  ///< [pressure load] the same
    /// On rank 0: the nodes with their places, and per unit level the dead forces at them, component-major.
    SurfaceCell at_nodes;
    std::vector<std::vector<double>> plugs, tractions, body_forces;

    [[nodiscard]] bool has(mesh::Index node) const { return share_of(node) != nullptr; }
    [[nodiscard]] const Vector3* share_of(mesh::Index node) const;  ///< nullptr of a node that the face does not have
};

[[nodiscard]] Reaction make_reaction(const model::Case& input, const model::Output& output);

/// The entries of `forces` at the reaction's nodes, component-major.
[[nodiscard]] std::vector<double> at_nodes_of(const Reaction& reaction, const NodalForces& forces, int dimension);

/// Forces of a cell or facet at its nodes, or dead ones, and how they change.
struct NodeForces {
    std::span<const mesh::Index> nodes;
    int dimension;
    std::span<const double> x;      ///< positions, component-major
    std::span<const double> force;  ///< first the forces, component-major; what follows (pressures) is left out
    std::span<const double>
        stiffness;  ///< d force / d unknowns, row-major, as many columns as `slope`; empty: constant
};
/// Returns the share of `forces` in the output and adds `sign` times its derivative by the unknowns to `slope`, where that
/// is not empty.
double add_share(const Reaction& reaction, const NodeForces& forces, double sign, std::span<double> slope);

}  // namespace soft::assembly
