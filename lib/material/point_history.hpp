#pragma once
/// The internal variables of one point of an inelastic rubber as a list of numbers, and what a step does to them. A virgin point has zeros.
/// Tested by material/inelastic_test.
#include <span>

#include "material/catalogue.hpp"

namespace soft::material {

/// Length of the list.
[[nodiscard]] std::size_t history_size(const Inelastic& inelastic);

/// The largest energy W so far.
[[nodiscard]] double largest_energy(std::span<const double> history);
/// H of a step; 0 without viscoelasticity.
[[nodiscard]] SymmetricTensor overstress(const Inelastic& inelastic, const StepCoefficients& step,
                                         std::span<const double> history);

/// Lengths of the step and of the one before; 0 where they are not known or not finite.
struct StepTimes {
    double step_s = 0, last_s = 0;
};

/// A step at one point. Energies per undeformed volume.
struct PointStep {
    SymmetricTensor stress{};        ///< isochoric part of the second Piola-Kirchhoff stress
    double stored_change_J_m3 = 0;   ///< recoverable energy minus that of the elastic law
    double dissipated_J_m3 = 0;      ///< in the step: work of the sum of Q_i, and loss by softening
    double error2 = 0, stress2 = 0;  ///< squares of the estimated error of the stress and of the stress
};

/// The step from `history` to F, the argument of the law. `next` receives the list after the step; empty if not needed.
[[nodiscard]] PointStep advance(const AnyRubber& rubber, const StepCoefficients& step, const StepTimes& times,
                                const Tensor& F, std::span<const double> history, std::span<double> next);

}  // namespace soft::material
