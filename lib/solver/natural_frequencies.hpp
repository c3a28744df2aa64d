#pragma once
/// Natural frequencies of small vibrations about an equilibrium state:
///   K phi = (2 pi f)^2 M phi,     K = dR/dx at the state and its load levels, M = consistent mass (fem/mass.hpp).
/// The loads are held: a pressure stays constant, as behind a large source, so that the stiffness of a trapped gas and a prescribed
/// volume are not included; prescribed displacements are fixed. An eigenvalue -w^2 < 0 is an unstable direction with exp(w t), returned
/// as the negative frequency -w / 2 pi. A follower pressure on a surface with a free rim makes K unsymmetric: two eigenvalues may meet and
/// become complex, w = a + i b, and the vibration grows with exp(|b| t) (flutter); each of the two is returned as -|b| / 2 pi. A model of a part
/// (half, quarter, axisymmetric) has only the vibrations with its symmetry.
/// Tested by solver/natural_frequencies_test and the verification (motions).
#include <vector>

#include "fem/system.hpp"

namespace soft::solver {

class NaturalFrequencies {
public:
    /// Throws Error (bad_input) for a material without density or without an energy, for more frequencies than displacement unknowns, and
    /// where the linear solver of the case does not factorise the tangent.
    NaturalFrequencies(fem::System& system, int count);

    /// The `count` lowest frequencies [Hz] about the state x, ascending. Prescribes the levels' motions. Throws Error (bad_input) if the
    /// eigenvalue solver does not converge.
    [[nodiscard]] std::vector<double> evaluate(Vec x, const fem::LoadLevels& levels);

private:
    fem::System& system_;
    int count_;
    linalg::Matrix M_, K_;
    linalg::Vector R_;
};

}  // namespace soft::solver
