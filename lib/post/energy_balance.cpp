#include "post/energy_balance.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace soft::post {

void EnergyBalance::add(const model::Step& row) {
    const int index = rows_++;
    if (!row.motion && !row.energies) return;
    if (first_ && !row.motion && std::abs(row.max_stretch - 1.0) < min_strain) return;
    moves_ = row.motion.has_value();
    const double friction_J = row.friction_J.value_or(0);
    const Energies now = moves_ ? Energies{row.motion->load_work_J, row.motion->stored_energy_J,
                                           row.motion->kinetic_energy_J, row.motion->damping_work_J + friction_J}
                                : Energies{row.energies->load_work_J, row.energies->stored_J, 0.0,
                                           row.energies->dissipated_J.value_or(0) + friction_J};
    if (!first_) first_ = now;
    const Energies gain{now.work_J - first_->work_J, now.stored_J - first_->stored_J, now.kinetic_J - first_->kinetic_J,
                        now.dissipated_J - first_->dissipated_J};
    for (const double part : {gain.work_J, gain.stored_J, gain.kinetic_J, gain.dissipated_J})
        max_J_ = std::max(max_J_, std::abs(part));
    const double gap_J = std::abs(gain.work_J - gain.stored_J - gain.kinetic_J - gain.dissipated_J);
    if (!(gap_J > gap_J_)) return;
    gap_J_ = gap_J;
    worst_ = gain;
    worst_row_ = index;
}

std::optional<double> EnergyBalance::error() const {
    return max_J_ > 0 ? std::optional{gap_J_ / max_J_} : std::nullopt;
}

std::string EnergyBalance::problem() const {
    const double error = this->error().value_or(0);
    if (!(error > max_energy_error)) return "";
    const auto mJ = [](double energy_J) { return core::rounded_text(1e3 * energy_J, 4) + " mJ"; };
    const std::string what = "the energies do not balance: at row " + std::to_string(worst_row_) +
                             " the loads have done " + mJ(worst_.work_J) + " of work, the rubber stores " +
                             mJ(worst_.stored_J);
    const std::string off = ", a difference of " + core::rounded_text(100 * error, 2) + " % of the largest energy";
    if (moves_)
        return what + ", " + mJ(worst_.kinetic_J) + " are kinetic and " + mJ(worst_.dissipated_J) +
               " are dissipated by damping and friction" + off +
               "; use a smaller dynamics.accuracy or dynamics.step (with generalized-alpha or hht also a "
               "spectral_radius nearer to 1, for less damping)";
    const std::string lost = worst_.dissipated_J > 0
                                 ? ", " + mJ(worst_.dissipated_J) + " are set free by snaps or dissipated by friction"
                                 : "";
    return what + lost + off +
           ": the rows do not lie on one equilibrium path; use a smaller solver.residual_tolerance or solver.step_accuracy, or another "
           "mesh.size";
}

}  // namespace soft::post
