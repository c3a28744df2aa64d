#include "solver/stage_loads.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace soft::solver {

using model::Prescription;

double gas_mass_kg(const model::Gas& gas, double volume_m3, double pressure_Pa) {
    const double compression = std::pow(1.0 + pressure_Pa / gas.ambient_Pa, 1.0 / gas.exponent);
    return gas.ambient_density_kg_m3 * (volume_m3 + gas.dead_volume_m3) * compression;
}

double gas_pressure_Pa(const model::Gas& gas, double volume_m3, double mass_kg) {
    const double compression = mass_kg / (gas.ambient_density_kg_m3 * (volume_m3 + gas.dead_volume_m3));
    return gas.ambient_Pa * (std::pow(compression, gas.exponent) - 1.0);
}

StageStart unloaded(const model::Case& input, const std::vector<double>& undeformed_volumes_m3) {
    const LoadLevels none = fem::no_loads(input);
    StageStart start{none.pressures_Pa, undeformed_volumes_m3, {}, none.dead_loads, none.motions, 0.0};
    for (std::size_t i = 0; i < input.loads.size(); ++i)
        start.masses_kg.push_back(gas_mass_kg(input.loads[i].gas, undeformed_volumes_m3[i], 0.0));
    return start;
}

void require_gas(const model::Case& input, const std::vector<double>& undeformed_volumes_m3) {
    for (const model::Stage& stage : input.path.stages)
        for (std::size_t i = 0; i < input.loads.size(); ++i) {
            if (stage.supplies.at(i).what != Prescription::mass) continue;
            const double content_kg = gas_mass_kg(input.loads[i].gas, undeformed_volumes_m3[i], 0.0);
            if (!(content_kg + stage.supplies[i].value > 0.0))
                throw Error(ExitCode::bad_input, "loads." + input.loads[i].name + ".mass",
                            core::quantity_text(-stage.supplies[i].value, core::Dimension::mass) +
                                " of gas are removed, and the undeformed cavity contains " +
                                core::quantity_text(content_kg, core::Dimension::mass),
                            "remove less, or prescribe a pressure or a volume");
        }
}

StageLoads::StageLoads(const model::Case& input, int stage, StageStart start,
                       const std::vector<double>& undeformed_volumes_m3)
    : start_(std::move(start)), rate_(fem::no_loads(input)) {
    const model::Stage& programme = input.path.stages.at(static_cast<std::size_t>(stage));
    begin_ = {start_.pressures_Pa, start_.dead_loads, start_.motions, start_.time_s};
    rate_.time_s = programme.time_s.value_or(0.0);
    changes_ = programme.time_s.has_value();
    for (std::size_t i = 0; i < input.loads.size(); ++i) {
        const auto& target = programme.supplies.at(i);
        if (target.what == Prescription::pressure) {
            rate_.pressures_Pa[i] = target.value - start_.pressures_Pa[i];
            continue;
        }
        Supply supply{target, input.loads[i].gas, start_.masses_kg[i]};
        double now = start_.masses_kg[i];
        if (target.what == Prescription::mass)
            supply.end = gas_mass_kg(supply.gas, undeformed_volumes_m3[i], 0.0) + target.value;
        if (target.what == Prescription::volume) supply.end = target.value;
        if (target.what == Prescription::volume_ratio) supply.end = target.value * undeformed_volumes_m3[i];
        if (target.what == Prescription::volume || target.what == Prescription::volume_ratio)
            now = start_.volumes_m3[i];
        changes_ = changes_ || supply.end != now;
        free_.push_back(i);
        supplies_.push_back(supply);
    }
    const auto change = [&](std::vector<double>& rates, const std::vector<double>& ends,
                            const std::vector<double>& starts) {
        for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = ends.at(i) - starts[i];
    };
    change(rate_.dead_loads, programme.dead_loads, start_.dead_loads);
    change(rate_.motions, programme.motions, start_.motions);
    for (const auto* rates : {&rate_.pressures_Pa, &rate_.dead_loads, &rate_.motions})
        changes_ = changes_ || std::ranges::any_of(*rates, [](double rate) { return rate != 0.0; });
}

LoadLevels StageLoads::levels(double load_factor, const std::vector<double>& free_pressures_Pa) const {
    LoadLevels levels = fem::moved(begin_, load_factor, rate_);
    for (std::size_t k = 0; k < free_.size(); ++k) levels.pressures_Pa[free_[k]] = free_pressures_Pa.at(k);
    return levels;
}

LoadLevels StageLoads::unit_pressure(std::size_t k) const {
    LoadLevels unit{std::vector(rate_.pressures_Pa.size(), 0.0), std::vector(rate_.dead_loads.size(), 0.0),
                    std::vector(rate_.motions.size(), 0.0), 0.0};
    unit.pressures_Pa[free_.at(k)] = 1.0;
    return unit;
}

SupplyEquation StageLoads::equation(std::size_t k, double volume_m3, double pressure_Pa, double load_factor) const {
    const Supply& supply = supplies_.at(k);
    const bool by_volume =
        supply.target.what == Prescription::volume || supply.target.what == Prescription::volume_ratio;
    if (by_volume) {
        const double begin = start_.volumes_m3[free_[k]], scale = std::max(std::abs(begin), std::abs(supply.end));
        return {(volume_m3 - begin - load_factor * (supply.end - begin)) / scale, 1.0 / scale, 0.0,
                (begin - supply.end) / scale};
    }
    const model::Gas& gas = supply.gas;
    const double begin = start_.masses_kg[free_[k]], growth = supply.end - begin, mass = begin + load_factor * growth;
    const double wanted = gas_pressure_Pa(gas, volume_m3, mass), absolute = wanted + gas.ambient_Pa;
    return {(pressure_Pa - wanted) / gas.ambient_Pa,
            gas.exponent * absolute / ((volume_m3 + gas.dead_volume_m3) * gas.ambient_Pa), 1.0 / gas.ambient_Pa,
            -gas.exponent * absolute * growth / (mass * gas.ambient_Pa)};
}

}  // namespace soft::solver
