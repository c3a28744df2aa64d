#pragma once
/// Force and moment that a face exerts on its supports or prescribed motions: the outputs `force` and `moment` (model::Measure).
///   r_a = external - internal - contact forces at node a, including those at constrained (fixed or prescribed) components; 0 at a free node
///   f_ai = s_ai r_ai: s = 1 in a component i that the face constrains, 1/k where k faces do so, 0 where only other faces do
///   force = n sum_a f_a . d,     moment = n sum_a ((x_a - c) x f_a) . d = n sum_a (d x (x_a - c)) . f_a
/// over the nodes a of the face; d direction, x_a deformed position, c centroid of the undeformed whole face, n copies of the
/// face in the whole actuator (model/face_symmetry.hpp). The forces of all constrained faces together are therefore the resultant of
/// the loads, to the accuracy of the equilibrium.
/// Derived here. Tested by fem/reaction_test and the verification suite (group Reactions).
#include <vector>

#include "fem/contact.hpp"
#include "fem/loads.hpp"
#include "fem/local_state.hpp"

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
    /// On rank 0: the nodes with their positions, and the dead forces at them per unit level, component by component.
    SurfaceCell at_nodes;
    std::vector<std::vector<double>> plugs, dead_loads;
};

[[nodiscard]] Reaction make_reaction(const Discretization& fe, const Loads& loads, const model::Output& output);

/// What a reaction is evaluated from; `state` has been read and the levels prescribed.
struct LoadedState {
    const Discretization& fe;
    const Loads& loads;
    Contact& contact;
    const LocalState& state;
};
/// The force or moment; adds its derivatives by x and the motions to `slopes`, and by the other levels to `by_levels` (nullptr if not
/// needed). Those of this rank only: the caller sums them, and multiplies them and the value by `copies`.
[[nodiscard]] double own_value(const Reaction& reaction, const LoadedState& at, Slopes& slopes, LoadLevels* by_levels);

}  // namespace soft::fem
