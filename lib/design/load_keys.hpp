#pragma once
/// The kinds of loads, one row each: the key with the magnitude, its value, and the keys beside it. Parsing, stages, errors and the
/// reference read these rows. `load` is the path of a load: "loads.cavity" or "path.stages.vent.loads.cavity". Private to the module.
/// Tested by design/load_test.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "design/schema.hpp"
#include "design/setting.hpp"
#include "model/case.hpp"

namespace soft::design {

/// What a load acts on.
enum class LoadTarget { cavity, face, gravity, obstacle };

/// How a load is converted: the list of the case that it belongs to.
enum class LoadKind { gas, shared_gas, face_pressure, dead_load, motion };

struct LoadForm {
    LoadTarget target;
    LoadKind kind;
    /// Key of the magnitude; its path is the word of the load ("force"), which a load has once. @ in its meaning is the time at which
    /// the value is reached.
    Key magnitude;
    std::string example;                                       ///< a magnitude: "2 N"
    Key along = {};                                            ///< key of the direction, where the load has one
    model::Prescription what = model::Prescription::pressure;  ///< of a gas
    model::DeadLoadKind dead_load = {};                        ///< of a dead load
    bool takes_time_function = true;                           ///< in a dynamic design
    [[nodiscard]] const std::string& word() const { return magnitude.path; }
    /// Its list of levels in a stage; nullptr for a pressure, volume or mass.
    [[nodiscard]] std::vector<double> model::Stage::*levels() const {
        return kind == LoadKind::dead_load ? &model::Stage::dead_loads
               : kind == LoadKind::motion  ? &model::Stage::motions
                                           : nullptr;
    }
};
/// All forms; the first one of a target is the usual one.
[[nodiscard]] std::span<const LoadForm> load_forms();
/// The words of a target: "pressure", "traction", ...
[[nodiscard]] std::vector<std::string> words_of(LoadTarget target);
/// The usual keys of a target's loads: "{pressure}, {traction, along} or {displacement, along}".
[[nodiscard]] std::string form_list(LoadTarget target);
/// The form with this word; the usual one for an empty word.
[[nodiscard]] const LoadForm& form_of(LoadTarget target, std::string_view word);

/// When the value is reached: at the full load, or at the end of a stage.
enum class When { full_load, stage_end };
[[nodiscard]] Key magnitude_key(const std::string& load, const LoadForm& form, When when);
[[nodiscard]] Key along_key(const std::string& load, const LoadForm& form);

/// Keys of a pressure beside its magnitude: acts_on; of a cavity also sealed, plug_thrust, gas.* and, in a dynamic design, `line`.
[[nodiscard]] std::vector<Key> pressure_keys(const std::string& load, LoadTarget target, bool dynamic);
/// The pressure load with the values of those keys.
[[nodiscard]] model::PressureLoad pressure_settings_of(const Values& values, const std::string& load);

}  // namespace soft::design
