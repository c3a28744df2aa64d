#pragma once
/// Viscoelastic and softening rubber whose principal axes do not turn, by many small steps: the reference for whole runs. The law is given
/// by its extra stress (principal_law.hpp); W is the integral of that stress along a ray of logarithmic stretches, and the branches follow
/// Simo's midpoint rule Q' = exp(-dt/tau) Q + g exp(-dt/(2 tau)) (S' - S), another one than in lib/material.
#include <functional>
#include <optional>
#include <vector>

#include "inflation_formula.hpp"

namespace soft::verification {

struct InelasticLaw {
    ExtraStress extra_stress;
    std::vector<double> moduli, times_s;
    std::optional<material::Softening> softening = {};
};

/// The law of a material with all its effects.
[[nodiscard]] InelasticLaw inelastic_law_of(const model::Material& material);

class PrincipalHistory {
public:
    explicit PrincipalHistory(const InelasticLaw& law) : law_(&law), overstress_(law.moduli.size(), Triple{}) {}

    /// Principal Cauchy stresses [Pa] of incompressible rubber, up to a pressure, after a step; `keep` accepts it.
    Triple step(const Triple& stretches, double dt_s, bool keep = true);

private:
    const InelasticLaw* law_;
    Triple stress_{};
    std::vector<Triple> overstress_;
    double W_max_ = 0;
};

/// A quantity that changes linearly from its value before to `value` in a time.
struct Ramp {
    double time_s, value;
};

/// Uniaxial Cauchy stress [Pa] at the end of ramps of the stretch, and stretch at the end of ramps of the Cauchy stress [Pa].
[[nodiscard]] double stress_after(const InelasticLaw& law, const std::vector<Ramp>& stretches);
[[nodiscard]] double stretch_after(const InelasticLaw& law, const std::vector<Ramp>& stresses_Pa);

/// Pressure [Pa] of a sphere of radii ratio B/A at the end of each ramp of the ratio of its volume to the undeformed one.
[[nodiscard]] std::vector<double> sphere_pressures_Pa(const InelasticLaw& law, double ratio,
                                                      const std::vector<Ramp>& volume_ratios);

}  // namespace soft::verification
