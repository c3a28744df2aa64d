#pragma once
/// The loads of a design: gas in a cavity; pressure, dead traction or prescribed displacement of a face; displacement of an obstacle;
/// gravity.
/// Private to the module. Tested by design/load_test, design/cavity_test.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "design/collect.hpp"
#include "design/design.hpp"
#include "design/load_keys.hpp"
#include "design/sections.hpp"

namespace soft::design {

/// A load as written in `loads` or in a stage.
struct LoadEntry {
    std::string path;        ///< "loads.cavity", "loads.cavities.left", "path.stages.vent.loads.cavity"
    std::string location;    ///< of its key
    std::string name;        ///< resolved name of the cavity or face, of the obstacle, or "gravity"
    std::string value = {};  ///< path of the key with the magnitude: "loads.cavity.pressure"
    const LoadForm* form = nullptr;
};

/// Adds the keys of all loads and returns the loads in document order, gravity last. Loads with an unknown name are skipped;
/// collect() rejects them. `defaults` is that of the family; its values are only used as examples in errors, never as default values.
[[nodiscard]] std::vector<LoadEntry> add_load_keys(Schema& schema, const Node& root, const Node& defaults,
                                                   std::string_view source, Examples& examples);

/// The same for the loads of the stage with path `stage`, each of which must be one of `loads`. `index` refers to `loads`.
struct StageLoad {
    std::size_t index;
    model::Prescription what;
    std::string value;
};
[[nodiscard]] std::vector<StageLoad> add_stage_load_keys(Schema& schema, const Node& root, const std::string& stage,
                                                         std::span<const LoadEntry> loads);

/// Where an entry is stored: the index in the list of the case, and its value at the full load (SI).
struct LoadSlot {
    const LoadForm* form;
    std::size_t index;
    double value;
};
struct Loads {
    std::vector<model::PressureLoad> pressures;
    std::vector<Design::DeadLoadRequest> dead_loads;
    std::vector<Design::MotionRequest> motions;
    std::vector<LoadSlot> slots;  ///< one for each entry
};
/// Converts the entries, in their order. Rejects loads of 0, two loads on one face, and gas that cannot be shared.
[[nodiscard]] Loads loads_of(std::span<const LoadEntry> entries, const Values& values);

}  // namespace soft::design
