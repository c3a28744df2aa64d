#include "solver/natural_frequencies.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "fem/element_levels.hpp"
#include "fem/mass.hpp"
#include "linalg/eigenvalues.hpp"

namespace soft::solver {

namespace {

[[noreturn]] void refuse_frequencies(const std::string& problem, const std::string& remedy) {
    throw Error(ExitCode::bad_input, "path.frequencies", problem, remedy);
}

}  // namespace

NaturalFrequencies::NaturalFrequencies(fem::System& system, int count)
    : system_(system), count_(count), K_(system.make_matrix()), R_(system.make_vector()) {
    const fem::DofMap& dofs = system.dofs();
    const auto method =
        fem::choose_linear(system.input().solver.linear, system.input(), dofs.total, linalg::Symmetry::symmetric)
            .method;
    if (method == model::LinearMethod::krylov || method == model::LinearMethod::jacobian_free)
        refuse_frequencies(
            "natural frequencies need a factorisation of the tangent, but the linear solver is iterative",
            "set solver.linear: mumps-ldlt, or path.frequencies: 0");
    if (!system.has_energy())
        refuse_frequencies("a material has a stress without an energy, so its tangent is not symmetric",
                           "choose another law, or set path.frequencies: 0");
    if (!system.has_symmetric_tangent())
        refuse_frequencies("with friction, the tangent is not symmetric",
                           "set contact.friction: 0 (and that of obstacles), or path.frequencies: 0");
    if (count > dofs.total - dofs.pressures)
        refuse_frequencies(std::to_string(count) + " exceeds the number of displacement unknowns (" +
                               std::to_string(dofs.total - dofs.pressures) + ")",
                           "use a smaller number");
    M_ = fem::consistent_mass(system);
}

std::vector<double> NaturalFrequencies::evaluate(Vec x, const fem::LoadLevels& levels) {
    (void)system_.evaluate(x, levels, R_, K_);
    linalg::Matrix symmetric;
    SOFT_PETSC(MatTranspose(K_, MAT_INITIAL_MATRIX, symmetric.out()));
    SOFT_PETSC(MatAXPY(symmetric, 1.0, K_, SAME_NONZERO_PATTERN));
    SOFT_PETSC(MatScale(symmetric, 0.5));
    auto values = linalg::lowest_eigenvalues(symmetric, M_, count_, system_.dofs().pressures);
    if (values.empty())
        refuse_frequencies("the eigenvalue solver does not converge", "use a smaller number, or another mesh.size");
    for (double& value : values) value = std::copysign(std::sqrt(std::abs(value)), value) / (2.0 * std::numbers::pi);
    return values;
}

}  // namespace soft::solver
