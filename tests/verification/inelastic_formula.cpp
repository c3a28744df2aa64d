#include "inelastic_formula.hpp"

#include <algorithm>
#include <cmath>

namespace soft::verification {

namespace {

constexpr int steps_per_ramp = 3000;

/// 4-point Gauss-Legendre rule on [0, 1].
constexpr std::array<double, 4> nodes{0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263};
constexpr std::array<double, 4> weights{0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269};

double energy(const ExtraStress& extra_stress, const Triple& l) {
    constexpr int intervals = 4;
    double sum = 0;
    for (int k = 0; k < intervals; ++k)
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const double share = (k + nodes[i]) / intervals;
            const Triple there{std::pow(l[0], share), std::pow(l[1], share), std::pow(l[2], share)};
            const Triple pull = extra_stress(there);
            for (std::size_t a = 0; a < 3; ++a) sum += weights[i] / intervals * pull[a] * std::log(l[a]);
        }
    return sum;
}

Triple uniaxial(double l) { return {l, 1 / std::sqrt(l), 1 / std::sqrt(l)}; }

/// Calls visit(value, dt) for every small step.
template <class Visit>
void for_each_step(const std::vector<Ramp>& ramps, double from, Visit&& visit) {
    for (const auto& [time_s, value] : ramps) {
        for (int k = 1; k <= steps_per_ramp; ++k)
            visit(from + (value - from) * k / steps_per_ramp, time_s / steps_per_ramp, k == steps_per_ramp);
        from = value;
    }
}

}  // namespace

InelasticLaw inelastic_law_of(const model::Material& material) {
    const material::Inelastic& inelastic = material.inelastic.value();
    return {extra_stress_of(material), inelastic.moduli, inelastic.times_s, inelastic.softening};
}

Triple PrincipalHistory::step(const Triple& l, double dt_s, bool keep) {
    const Triple pull = law_->extra_stress(l);
    const double mean = (pull[0] + pull[1] + pull[2]) / 3;
    double eta = 1, W_max = W_max_;
    if (law_->softening) {
        const double W = energy(law_->extra_stress, l);
        W_max = std::max(W, W_max_);
        const auto& [r, m_Pa, beta] = *law_->softening;
        eta = 1 - std::erf((W_max - W) / (m_Pa + beta * W_max)) / r;
    }
    Triple S{}, total{};
    std::vector<Triple> overstress = overstress_;
    for (std::size_t a = 0; a < 3; ++a) {
        S[a] = eta * (pull[a] - mean) / (l[a] * l[a]);
        total[a] = S[a];
        for (std::size_t i = 0; i < overstress.size(); ++i) {
            const double z = dt_s / law_->times_s[i];
            overstress[i][a] =
                std::exp(-z) * overstress[i][a] + law_->moduli[i] * std::exp(-0.5 * z) * (S[a] - stress_[a]);
            total[a] += overstress[i][a];
        }
        total[a] *= l[a] * l[a];
    }
    if (keep) {
        stress_ = S;
        overstress_ = std::move(overstress);
        W_max_ = W_max;
    }
    return total;
}

double stress_after(const InelasticLaw& law, const std::vector<Ramp>& stretches) {
    PrincipalHistory point(law);
    double stress_Pa = 0;
    for_each_step(stretches, 1.0, [&](double l, double dt_s, bool) {
        const Triple s = point.step(uniaxial(l), dt_s);
        stress_Pa = s[0] - s[1];
    });
    return stress_Pa;
}

double stretch_after(const InelasticLaw& law, const std::vector<Ramp>& stresses_Pa) {
    PrincipalHistory point(law);
    double stretch = 1;
    for_each_step(stresses_Pa, 0.0, [&](double wanted_Pa, double dt_s, bool) {
        const auto missing = [&](double l) {
            const Triple s = point.step(uniaxial(l), dt_s, false);
            return s[0] - s[1] - wanted_Pa;
        };
        double a = stretch, b = stretch + 1e-4, at_a = missing(a), at_b = missing(b);
        for (int i = 0; i < 20 && std::abs(at_b) > 1e-9 * (1 + std::abs(wanted_Pa)) && at_a != at_b; ++i) {  // secant
            const double next = b - at_b * (b - a) / (at_b - at_a);
            a = b;
            at_a = at_b;
            b = next;
            at_b = missing(b);
        }
        stretch = b;
        point.step(uniaxial(stretch), dt_s);
    });
    return stretch;
}

std::vector<double> sphere_pressures_Pa(const InelasticLaw& law, double ratio, const std::vector<Ramp>& volume_ratios) {
    // Gauss points through the wall, in the undeformed radius R/A; dr/r = dR R^2/r^3.
    constexpr int intervals = 8;
    std::vector<double> pressures(volume_ratios.size(), 0.0);
    for (int k = 0; k < intervals; ++k)
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const double width = (ratio - 1) / intervals, R = 1 + width * (k + nodes[i]);
            PrincipalHistory point(law);
            std::size_t ramp = 0;
            for_each_step(volume_ratios, 1.0, [&](double volume_ratio, double dt_s, bool ends) {
                const double r3 = R * R * R + volume_ratio - 1, l = std::cbrt(r3) / R;
                const Triple s = point.step({1 / (l * l), l, l}, dt_s);
                if (ends) pressures[ramp++] += width * weights[i] * 2 * (s[1] - s[0]) * R * R / r3;
            });
        }
    return pressures;
}

}  // namespace soft::verification
