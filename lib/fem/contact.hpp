#pragma once
/// Contact (contact/potential.hpp) on the unknowns: each block acts on the displacements of the nodes of two facets, or of one facet and
/// of an obstacle. The displacement of an obstacle has indices like a node: -1 where it is fixed, those of a prescribed motion where it
/// moves with a load. Each rank computes the blocks of its facets. Tested by fem/contact_test and the verification suite (group Contact).
#include <functional>

#include "contact/potential.hpp"
#include "fem/local_state.hpp"

namespace soft::fem {

class Contact {
public:
    Contact(const Discretization& fe, LocalState& state, contact::Potential& potential);

    /// Calls add(unknowns, block) for this rank's blocks at the state last read. The summary is that of all ranks. Collective.
    contact::Summary evaluate(contact::Wanted wanted,
                              const std::function<void(std::span<const PetscInt>, const contact::Block&)>& add);
    /// The same at x, without blocks, under the levels last prescribed.
    [[nodiscard]] contact::Summary measure(Vec x);

    /// While contact rests, nothing acts and nothing is computed.
    void set_resting(bool rests) { rests_ = rests; }
    [[nodiscard]] bool rests() const { return rests_; }
    /// Whether something touches at x, under the levels last prescribed, even if contact rests.
    [[nodiscard]] bool touches(Vec x);

    [[nodiscard]] bool has_friction() const { return potential_.has_friction(); }
    /// See contact::Potential. Starts a step at x, under the levels last prescribed, from the friction there. Collective, as the others.
    void start_friction(Vec x);
    /// The same from friction_start(): what the present step has started from, of all ranks; empty without friction. False if that
    /// does not fit.
    [[nodiscard]] bool start_friction(Vec x, std::span<const double> from);
    [[nodiscard]] std::vector<double> friction_start() const;

    /// True where nothing can ever touch.
    [[nodiscard]] bool is_empty() const { return potential_.is_empty(); }
    [[nodiscard]] double distance_m() const { return potential_.distance_m(); }
    /// Displacement of each obstacle at x, under the levels last prescribed. Collective.
    [[nodiscard]] std::span<const Vector3> shifts(Vec x);
    /// Current position of a node of the free facets, at the state of the last evaluation.
    [[nodiscard]] const mesh::Point& position(mesh::Index node) const {
        return positions_[static_cast<std::size_t>(node)];
    }

    /// See contact::Potential; the same on every rank. Prescribes the levels of the end. Collective.
    [[nodiscard]] double share_without_crossing(Vec from, const LoadLevels& levels, Vec to,
                                                const LoadLevels& levels_to);
    /// Whether a sample point passes through an obstacle between two states (contact::Potential), also while contact rests. Collective;
    /// prescribes the levels of the end.
    [[nodiscard]] bool passes_through_obstacle(Vec from, const LoadLevels& levels, Vec to, const LoadLevels& levels_to);

    /// Unknowns of pairs of facets whose blocks the pattern of a matrix must contain.
    [[nodiscard]] const std::vector<std::vector<PetscInt>>& couplings() const noexcept { return couplings_; }
    /// Sets the couplings to the pairs that are in contact or nearly so at the state last read; none without contact.
    void couple();
    void couple(Vec x);  ///< at x, under the levels last prescribed

private:
    void read_positions();
    [[nodiscard]] bool is_own(mesh::Index cell) const {
        return fe_.dofs.cell_rank[static_cast<std::size_t>(cell)] == fe_.rank;
    }

    /// From a configuration to the one in positions_ and shifts_.
    struct Motion {
        std::vector<mesh::Point> positions;
        std::vector<Vector3> shifts;
        bool is_harmless = false;
    };
    [[nodiscard]] Motion motion(Vec from, const LoadLevels& levels, Vec to, const LoadLevels& levels_to);

    const Discretization& fe_;
    LocalState& state_;
    contact::Potential& potential_;
    bool rests_ = false;
    std::vector<mesh::Point> positions_;
    std::vector<std::array<PetscInt, 3>> obstacle_dofs_;
    std::vector<Vector3> shifts_;
    std::vector<std::vector<PetscInt>> couplings_;
};

}  // namespace soft::fem
