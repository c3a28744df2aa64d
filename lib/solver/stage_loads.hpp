#pragma once
/// The loads of one stage as functions of its load factor lambda in [0, 1], and the equations of its free supplies: the
/// pressure loads whose pressure p is an unknown because their volume, mass or amount of gas is prescribed.
///   level(lambda) = start + lambda (end - start) for every pressure, dead load and motion
///   volume:        V - V(lambda) = 0                                     divided by the larger of the two volumes of the stage
///   mass, closed:  p - P(V, m(lambda)) = 0,  P = a [(m / (rho (V + D)))^n - 1]      divided by a
/// a ambient pressure, rho ambient density, D dead volume, n exponent of the gas (model::Gas); a closed supply has a constant
/// mass. Source: polytropic change of an ideal gas. Tested by solver/stage_loads_test.
#include <vector>

#include "fem/system.hpp"
#include "model/checkpoint.hpp"

namespace soft::solver {

using fem::LoadLevels;
using model::StageStart;

/// Mass of the gas in volume V at gauge pressure p [kg], and the gauge pressure of a mass [Pa].
[[nodiscard]] double gas_mass_kg(const model::Gas& gas, double volume_m3, double pressure_Pa);
[[nodiscard]] double gas_pressure_Pa(const model::Gas& gas, double volume_m3, double mass_kg);

/// Throws Error (bad_input) for a stage that removes all gas of the undeformed cavities, or more.
void require_gas(const model::Case& input, const std::vector<double>& undeformed_volumes_m3);

/// The unloaded body: the start of the first stage.
[[nodiscard]] StageStart unloaded(const model::Case& input, const std::vector<double>& undeformed_volumes_m3);

/// The dimensionless equation of a supply and its derivatives.
struct SupplyEquation {
    double value = 0;
    double by_volume = 0, by_pressure = 0, by_load_factor = 0;
};

class StageLoads {
public:
    /// `undeformed_volumes_m3` and the lists of `start` have one entry per pressure load (0 for one on a face).
    StageLoads(const model::Case& input, int stage, StageStart start, const std::vector<double>& undeformed_volumes_m3);

    /// Indices of the loads whose pressure is unknown, ascending.
    [[nodiscard]] const std::vector<std::size_t>& free_supplies() const noexcept { return free_; }
    /// Levels at a state, with its free pressures.
    [[nodiscard]] LoadLevels levels(double load_factor, const std::vector<double>& free_pressures_Pa) const;
    /// d levels / d load factor; 0 for the free pressures.
    [[nodiscard]] const LoadLevels& rate() const noexcept { return rate_; }
    /// d levels / d pressure of the free supply `k`.
    [[nodiscard]] LoadLevels unit_pressure(std::size_t k) const;
    /// False for a stage in which nothing changes.
    [[nodiscard]] bool changes() const noexcept { return changes_; }
    /// `k`: index among the free supplies.
    [[nodiscard]] SupplyEquation equation(std::size_t k, double volume_m3, double pressure_Pa,
                                          double load_factor) const;
    [[nodiscard]] const StageStart& start() const noexcept { return start_; }

private:
    struct Supply {
        model::SupplyTarget target;
        model::Gas gas;
        double end = 0;  ///< volume [m^3] or mass [kg] at load factor 1
    };
    StageStart start_;
    LoadLevels begin_, rate_;
    std::vector<std::size_t> free_;
    std::vector<Supply> supplies_;  // of the free ones
    bool changes_ = false;
};

}  // namespace soft::solver
