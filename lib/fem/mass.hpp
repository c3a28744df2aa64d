#pragma once
/// Mass matrix of the displacement unknowns; from undeformed density and volume, so it is constant.
///   consistent: M_ab = int density N_a N_b dV for each component, by a rule exact for straight cells
///   lumped:     M_a = M_aa x (mass of the cell) / (sum of the cell's M_aa): positive in cells of any order, where row sums
///               vanish or turn negative in second-order ones
/// Pressure unknowns have no mass; fixed and prescribed components have no row. Collective.
/// Source: Hinton, Rock and Zienkiewicz, Earthquake Engineering and Structural Dynamics 4 (1976) 245 (lumping).
/// Tested by fem/mass_test.
#include "fem/system.hpp"

namespace soft::fem {

/// Has the pattern of System::make_matrix, so that multiples of it can be added to a tangent; rows of pressure unknowns
/// exist and are zero. Throws Error (bad_input) for a material without density.
[[nodiscard]] linalg::Matrix consistent_mass(const System& system);

/// Diagonal; 0 at pressure unknowns. The same errors.
[[nodiscard]] linalg::Vector lumped_mass(const System& system);

/// 1 at displacement unknowns, 0 at pressure unknowns.
[[nodiscard]] linalg::Vector displacement_mask(const System& system);

}  // namespace soft::fem
