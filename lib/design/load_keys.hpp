#pragma once
/// The keys of a load, in `loads` and in a stage. `load` is the path of the load: "loads.cavity" or
/// "path.stages.vent.loads.cavity". Private to the module.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "design/schema.hpp"
#include "model/case.hpp"

namespace soft::design {

/// A key that prescribes the gas in a cavity; a cavity load has exactly one of them.
struct SupplyWord {
    std::string_view name;  ///< last part of the key: "volume_ratio"
    model::Prescription what;
};
[[nodiscard]] std::span<const SupplyWord> supply_words();

/// When the value is reached: at the full load, or at the end of a stage.
enum class When { full_load, stage_end };

[[nodiscard]] Key supply_key(const std::string& load, const SupplyWord& word, When when);
[[nodiscard]] Key shares_key(const std::string& load, std::vector<std::string> cavities);
[[nodiscard]] Key sealed_key(const std::string& load, std::string fallback);
[[nodiscard]] Key plug_thrust_key(const std::string& load);
[[nodiscard]] Key shape_key(const std::string& load);
[[nodiscard]] std::vector<Key> gas_keys(const std::string& load);  ///< the defaults are those of model::Gas

[[nodiscard]] Key traction_key(const std::string& load, When when);
[[nodiscard]] Key force_key(const std::string& load, When when);
[[nodiscard]] Key traction_along_key(const std::string& load);
[[nodiscard]] Key acceleration_key(const std::string& load, When when);
[[nodiscard]] Key gravity_along_key(const std::string& load, std::string fallback);
[[nodiscard]] Key displacement_key(const std::string& load, When when);
[[nodiscard]] Key motion_along_key(const std::string& load);

inline constexpr double adiabatic_exponent = 1.4;  ///< ratio of the specific heats of air

}  // namespace soft::design
