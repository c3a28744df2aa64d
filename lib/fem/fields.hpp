#pragma once
/// Fields of a state: stretch and stored energy of the rubber, nodal displacements and pressures. They include the motions
/// prescribed last. Tested by fem/system_test, fem/loads_test.
#include <span>
#include <vector>

#include "fem/contact.hpp"
#include "fem/local_state.hpp"

namespace soft::fem {

/// Stretch and stored energy of the rubber at a state.
struct StretchSummary {
    double p99 = 1;  ///< largest principal stretch exceeded in 1 % of the volume
    double largest = 1;
    double min_jacobian = 1;
    Vector3 max_at_m{};          ///< undeformed position of the largest stretch; x, r, 0 in a section
    double stored_energy_J = 0;  ///< of the modelled part, with that of the contact
    double dissipated_J = 0;     ///< by inelastic materials since the start of the path
    double friction_J = 0;       ///< dissipated by friction since the start of the path
    double max_energy_J_m3 = 0;  ///< per undeformed volume, at an integration point
};

/// Nodal displacements [point x 3] (axisymmetric: x, r, 0), including prescribed ones, and pressures [point] [Pa] (cell values
/// averaged at the nodes; empty without a pressure unknown).
struct NodalFields {
    std::vector<double> displacement_m, pressure_Pa;
};

class Fields {
public:
    /// Both must outlive this object.
    Fields(const Discretization& fe, Contact& contact, LocalState& state) : fe_(fe), contact_(contact), state_(state) {}

    /// Energy stored in the rubber and the contact of the modelled part, and dissipated by the materials and friction so far [J].
    /// Collective, as all members.
    [[nodiscard]] double stored_energy(Vec x);
    [[nodiscard]] StretchSummary stretches(Vec x);
    /// Estimated error of a step in time (InternalVariables::relative_error).
    [[nodiscard]] std::optional<double> error_in_time(Vec x);

    /// The deformed cell with the smallest scaled Jacobian at a node (mesh/quality.hpp), where no quadrature point is, of those below a
    /// bound; -1 if none.
    [[nodiscard]] mesh::Index inverted_at_a_node(Vec x, double below) const;

    /// On rank 0; empty elsewhere.
    [[nodiscard]] NodalFields gather(Vec x) const;
    /// Its displacements alone, in a fraction of the time.
    [[nodiscard]] std::vector<double> gather_displacements(Vec x) const;
    /// The reverse: sets the displacement unknowns of x to the values of a nodal field [point x 3], which rank 0 provides;
    /// pressures, fixed and prescribed components are unchanged.
    void spread(std::span<const double> displacement_m, Vec x) const;

private:
    /// `all`: the unknowns of all ranks.
    [[nodiscard]] std::vector<double> displacements_m(std::span<const double> all) const;

    const Discretization& fe_;
    Contact& contact_;
    LocalState& state_;
};

}  // namespace soft::fem
