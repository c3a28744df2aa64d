#include "material/point_history.hpp"

#include <algorithm>

#include "material/response.hpp"

namespace soft::material {

namespace {

/// The list: the largest energy; with viscoelasticity also S_inf, the strain, the rate of S_inf, then each Q.
constexpr std::size_t energy_at = 0, stress_at = 1, strain_at = 7, rate_at = 13, overstress_at = 19, components = 6;

SymmetricTensor sum_of_branches(std::span<const double> history, std::size_t branches) {
    SymmetricTensor sum{};
    for (std::size_t i = 0; i < branches; ++i)
        for (std::size_t c = 0; c < components; ++c) sum[c] += history[overstress_at + components * i + c];
    return sum;
}

}  // namespace

std::size_t history_size(const Inelastic& inelastic) {
    return inelastic.moduli.empty() ? 1 : overstress_at + components * inelastic.moduli.size();
}

double largest_energy(std::span<const double> history) { return history[energy_at]; }

SymmetricTensor overstress(const Inelastic& inelastic, const StepCoefficients& step, std::span<const double> history) {
    SymmetricTensor H{};
    const double *S = &history[stress_at], *Q = S + (overstress_at - stress_at);
    for (std::size_t i = 0; i < inelastic.moduli.size(); ++i, Q += components) {
        const double decay = step.decay[i], share = step.share[i];
        for (std::size_t c = 0; c < components; ++c) H[c] += decay * Q[c] - share * S[c];
    }
    return H;
}

PointStep advance(const AnyRubber& rubber, const StepCoefficients& step, const StepTimes& times, const Tensor& F,
                  std::span<const double> history, std::span<double> next) {
    const Inelastic& inelastic = *inelastic_of(rubber);
    const Softening* softening = inelastic.softening ? &*inelastic.softening : nullptr;
    const double scale = inelastic.scale(), before = history[energy_at];
    const double of_energy = step.is_elastic ? step.factor : scale;
    const double W = std::visit([&](const auto& r) { return isochoric_energy(r, F); }, rubber);
    const double W_max = std::max(W, before);
    PointStep result;
    result.stored_change_J_m3 = of_energy * (softening != nullptr ? softening->energy(W, W_max) : W) - W;
    if (softening != nullptr && W_max > before)
        result.dissipated_J_m3 = of_energy * (softening->dissipated(W_max) - softening->dissipated(before));
    if (!next.empty()) next[energy_at] = W_max;
    const Tensor P = std::visit(
        [&](const auto& r) {
            return isochoric_stress(r, F, {scale, softening, before});
        },
        rubber);
    const SymmetricTensor S = second_piola(F, P);
    result.stress = S;
    const std::size_t branches = inelastic.moduli.size();
    if (branches == 0) return result;
    const SymmetricTensor E = green_strain(F);
    SymmetricTensor change{}, error{}, overstress{}, middle{};
    const double mean_step_s = 0.5 * (times.step_s + times.last_s);
    for (std::size_t c = 0; c < components; ++c) {
        const double change_of_S = S[c] - history[stress_at + c];
        const double rate = times.step_s > 0 ? change_of_S / times.step_s : 0.0;
        const double curvature = mean_step_s > 0 ? (rate - history[rate_at + c]) / mean_step_s : 0.0;
        change[c] = E[c] - history[strain_at + c];
        for (std::size_t i = 0; i < branches; ++i) {
            const std::size_t at = overstress_at + components * i + c;
            const double Q = step.decay[i] * history[at] + step.share[i] * change_of_S;
            overstress[c] += Q;
            middle[c] += step.half_decay[i] * history[at] + 0.5 * step.half_share[i] * change_of_S;
            error[c] += step.error[i] * curvature;
            if (!next.empty()) next[at] = Q;
        }
        result.stress[c] += overstress[c];
        if (next.empty()) continue;
        next[stress_at + c] = S[c];
        next[strain_at + c] = E[c];
        next[rate_at + c] = rate;
    }
    if (!step.is_elastic)  // Simpson's rule: within a step Q_i is not linear
        result.dissipated_J_m3 += (contract(sum_of_branches(history, branches), change) +
                                   4.0 * contract(middle, change) + contract(overstress, change)) /
                                  6.0;
    result.error2 = contract(error, error);
    result.stress2 = contract(result.stress, result.stress);
    return result;
}

}  // namespace soft::material
