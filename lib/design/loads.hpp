#pragma once
/// The loads of a design: gas in a cavity, a pressure, a dead traction or a prescribed motion of a face, gravity.
/// Private to the module. Tested by design/load_test, design/cavity_test.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "design/collect.hpp"
#include "design/design.hpp"
#include "design/sections.hpp"

namespace soft::design {

enum class LoadKind { gas, shared_gas, face_pressure, traction, gravity, motion };

/// A load as it is written, in `loads` or in a stage.
struct LoadEntry {
    std::string path;   ///< "loads.cavity", "loads.cavities.left", "path.stages.vent.loads.cavity"
    std::string place;  ///< of its key
    std::string name;   ///< resolved: of the cavity or the face; "gravity"
    LoadKind kind = LoadKind::gas;
    model::Prescription what = model::Prescription::pressure;
    std::string value = {};  ///< path of the key that says how much: "loads.cavity.pressure"
};

/// `defaults` are the family's; a value in them is an example and never used silently. Returns the loads in the order in
/// which they stand; those under an unknown name are left out, for collect() to refuse.
[[nodiscard]] std::vector<LoadEntry> add_load_keys(Schema& schema, const Node& root, const Node& defaults,
                                                   std::string_view source, Examples& examples);

/// The same for the loads of a stage, each of which must be one of `loads`; `stage` is its path. `index` is into `loads`.
struct StageLoad {
    std::size_t index;
    model::Prescription what;
    std::string value;
};
[[nodiscard]] std::vector<StageLoad> add_stage_load_keys(Schema& schema, const Node& root, const std::string& stage,
                                                         std::span<const LoadEntry> loads);

/// Where an entry has gone: into which list of the case, and its value at the full load (SI).
struct LoadSlot {
    LoadKind kind;
    std::size_t index;
    double value;
};
struct Loads {
    std::vector<model::PressureLoad> pressures;
    std::vector<Design::TractionRequest> tractions;
    std::vector<Design::BodyForceRequest> body_forces;
    std::vector<Design::MotionRequest> motions;
    std::vector<LoadSlot> slots;  ///< one for each entry
};
/// In the order of `entries`. Refuses loads of 0, two loads on one face, and gas that cannot be shared.
[[nodiscard]] Loads loads_of(std::span<const LoadEntry> entries, const Values& values);

}  // namespace soft::design
