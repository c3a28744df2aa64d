#include "solver/natural_frequencies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "fem/element_levels.hpp"
#include "fem/mass.hpp"
#include "linalg/eigenvalues.hpp"

namespace soft::solver {

namespace {

/// The skew part of K over K that counts as rounding.
constexpr double symmetric = 1e-11;
/// The imaginary part of a w over w that counts as rounding: of equal eigenvalues of an unsymmetric K, half of its digits are lost.
constexpr double damped = 1e-4;
/// Without the law of inertia nothing shows whether one is missing.
constexpr int more_of_unsymmetric = 8;

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
    linalg::Matrix transposed;
    SOFT_PETSC(MatTranspose(K_, MAT_INITIAL_MATRIX, transposed.out()));
    double norm_of_K = 0, norm_of_skew = 0;
    SOFT_PETSC(MatNorm(K_, NORM_FROBENIUS, &norm_of_K));
    SOFT_PETSC(MatAXPY(transposed, -1.0, K_, SAME_NONZERO_PATTERN));
    SOFT_PETSC(MatNorm(transposed, NORM_FROBENIUS, &norm_of_skew));
    std::vector<std::complex<double>> eigenvalues;
    if (norm_of_skew <= symmetric * norm_of_K) {
        SOFT_PETSC(MatAXPY(K_, 0.5, transposed, SAME_NONZERO_PATTERN));
        for (const double value : linalg::lowest_eigenvalues(K_, M_, count_, system_.dofs().pressures))
            eigenvalues.emplace_back(value);
    } else {
        eigenvalues = linalg::nearest_eigenvalues(K_, M_, 2 * count_ + more_of_unsymmetric, system_.dofs().pressures);
    }
    if (std::ssize(eigenvalues) < count_)
        refuse_frequencies("the eigenvalue solver does not converge", "use a smaller number, or another mesh.size");
    std::vector<double> frequencies;
    for (const auto& value : eigenvalues) {
        const std::complex<double> w = std::sqrt(value);
        const bool grows = std::abs(w.imag()) > damped * std::abs(w);
        frequencies.push_back((grows ? -std::abs(w.imag()) : w.real()) / (2.0 * std::numbers::pi));
    }
    std::ranges::sort(frequencies);
    frequencies.resize(static_cast<std::size_t>(count_));
    return frequencies;
}

}  // namespace soft::solver
