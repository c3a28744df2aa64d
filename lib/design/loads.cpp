#include "design/loads.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "design/load_keys.hpp"
#include "design/load_names.hpp"
#include "design/materials.hpp"
#include "design/time_function_keys.hpp"

namespace soft::design {
namespace {

using model::Prescription;

[[noreturn]] void refuse_no_loads(const Schema& schema, const Node& root, const Node& defaults,
                                  std::string_view source) {
    const auto& usual = members_of(defaults, "loads");
    const std::string example =
        !usual.empty() && usual.front().key != cavities_group ? usual.front().key + ": {pressure: 30 kPa}"
        : schema.faces.cavities.size() == 1                   ? std::string{cavity_name} + ": {pressure: 30 kPa}"
        : schema.faces.cavities.size() > 1 ? "cavities: {" + schema.faces.cavities.front() + ": {pressure: 30 kPa}}"
                                           : "face: {pressure: 30 kPa}";
    const Member* section = find_member(root, "loads");
    refuse(section == nullptr ? std::string{source} + ":1:1" : section->location, "loads",
           "missing (what drives the actuator)", "add loads: {" + example + "}");
}

/// The values of the family's default loads, as examples for errors about missing values.
void take_examples(const std::vector<Member>& members, const std::string& path, Examples& examples) {
    for (const Member& member : members) {
        const std::string below = path + "." + member.key;
        if (member.value.kind == Node::Kind::scalar) examples[below] = member.value.text;
        take_examples(member.value.members, below, examples);
    }
}

/// The single key among `words` that determines the kind of load; a second one is rejected.
std::string_view only_one_of(const NamedLoad& load, std::span<const std::string> words) {
    std::string_view found;
    for (const Member& member : load.member->value.members) {
        if (std::ranges::find(words, member.key) == words.end()) continue;
        if (!found.empty())
            refuse(member.location, load.path + "." + member.key, "the load has a " + std::string{found} + " already",
                   "keep one of " + core::join(words) + "; --set takes a whole load too: " + load.path + "={" +
                       member.key + ": ...}");
        found = member.key;
    }
    return found;
}

void refuse_keys(const NamedLoad& load, std::span<const std::string> words, std::string_view problem,
                 std::string_view remedy) {
    for (const Member& member : load.member->value.members)
        if (std::ranges::find(words, member.key) != words.end())
            refuse(member.location, load.path + "." + member.key, problem, remedy);
}

std::vector<std::string> supply_names() {
    std::vector<std::string> names;
    for (const SupplyWord& word : supply_words()) names.emplace_back(word.name);
    return names;
}

const SupplyWord& supply_word(std::string_view name) {
    const auto words = supply_words();
    return *std::ranges::find(words, name.empty() ? "pressure" : name, &SupplyWord::name);
}

LoadEntry entry_of(const NamedLoad& load, LoadKind kind, std::string_view value) {
    return {load.path, load.member->location,  load.name,
            kind,      Prescription::pressure, load.path + "." + std::string{value}};
}

LoadEntry add_cavity(Schema& schema, const NamedLoad& load, const Node& defaults) {
    refuse_keys(load, std::vector<std::string>{"traction", "force", "displacement"}, "a cavity is loaded by a pressure",
                "write pressure");
    refuse_keys(load, std::vector<std::string>{"along"}, "a pressure acts along the normal of the deformed face",
                "leave it out");
    std::vector<std::string> words = supply_names();
    words.emplace_back("shares");
    const std::string_view value = only_one_of(load, words);
    schema.names[load.path] = words;
    if (value == "shares") {
        std::vector<std::string> own = {"sealed", "plug_thrust", "gas", "acts_on", "time_function", "line"};
        refuse_keys(load, own, "a cavity that shares its gas has no supply of its own", "leave it out");
        schema.keys.push_back(shares_key(load.path, schema.faces.cavities));
        return entry_of(load, LoadKind::shared_gas, value);
    }
    const SupplyWord& word = supply_word(value);
    schema.keys.push_back(supply_key(load.path, word, When::full_load));
    const Node* sealed = find_path(defaults, load.path + ".sealed");
    schema.keys.push_back(sealed_key(load.path, sealed == nullptr ? "true" : sealed->text));
    schema.keys.push_back(plug_thrust_key(load.path));
    schema.keys.push_back(shape_key(load.path));
    for (Key& key : gas_keys(load.path)) schema.keys.push_back(std::move(key));
    if (schema.dynamic) schema.keys.push_back(line_key(load.path));
    LoadEntry entry = entry_of(load, LoadKind::gas, word.name);
    entry.what = word.what;
    return entry;
}

LoadEntry add_gravity(Schema& schema, const NamedLoad& load) {
    schema.keys.push_back(acceleration_key(load.path, When::full_load));
    schema.keys.push_back(gravity_along_key(load.path, ""));
    return entry_of(load, LoadKind::gravity, "acceleration");
}

/// Whether a traction load is given as the total force on the face.
bool is_force(const LoadEntry& load) { return load.value.ends_with(".force"); }

/// Adds a pressure, a traction, a force or a prescribed displacement. Each kind has its own keys; keys of other kinds are rejected.
LoadEntry add_face(Schema& schema, const NamedLoad& load) {
    refuse_keys(load, std::vector<std::string>{"volume", "volume_ratio", "mass", "valve", "shares", "gas", "line"},
                "a face encloses no gas", "write pressure; only a cavity takes this");
    refuse_keys(load, std::vector<std::string>{"sealed", "plug_thrust"}, "a face has no openings to seal",
                "leave it out");
    const std::vector<std::string> words = {"pressure", "traction", "force", "displacement"};
    const std::string_view value = only_one_of(load, words);
    schema.names[load.path] = words;
    if (value == "traction" || value == "force") {
        schema.keys.push_back(value == "force" ? force_key(load.path, When::full_load)
                                               : traction_key(load.path, When::full_load));
        schema.keys.push_back(traction_along_key(load.path));
        return entry_of(load, LoadKind::traction, value);
    }
    if (value == "displacement") {
        schema.keys.push_back(displacement_key(load.path, When::full_load));
        schema.keys.push_back(motion_along_key(load.path));
        return entry_of(load, LoadKind::motion, value);
    }
    refuse_keys(load, std::vector<std::string>{"along"}, "a pressure acts along the normal of the deformed face",
                "leave it out, or write traction in place of pressure");
    schema.keys.push_back(supply_key(load.path, supply_words().front(), When::full_load));
    schema.keys.push_back(shape_key(load.path));
    return entry_of(load, LoadKind::face_pressure, "pressure");
}

Key stage_key(const LoadEntry& load, const std::string& path, const SupplyWord& word) {
    switch (load.kind) {
        case LoadKind::gas:
        case LoadKind::shared_gas:
        case LoadKind::face_pressure: return supply_key(path, word, When::stage_end);
        case LoadKind::traction:
            return is_force(load) ? force_key(path, When::stage_end) : traction_key(path, When::stage_end);
        case LoadKind::gravity: return acceleration_key(path, When::stage_end);
        case LoadKind::motion: return displacement_key(path, When::stage_end);
    }
    return {};
}

void refuse_zero(const LoadEntry& entry, double value, const Values& values) {
    const bool ratio = entry.what == Prescription::volume_ratio, closed = entry.what == Prescription::closed;
    if (closed || value != (ratio ? 1.0 : 0.0)) return;
    const std::string what = entry.value.substr(entry.value.rfind('.') + 1);
    throw values.refuse(entry.value, ratio ? "1 is where the path starts" : "a load of 0 gives no path",
                        "write the " + what + " at full load, for example " +
                            (ratio                              ? "3"
                             : entry.what == Prescription::mass ? "50 mg"
                             : entry.kind == LoadKind::gravity  ? "9.81 m/s^2"
                             : entry.kind == LoadKind::motion   ? "10 mm"
                             : is_force(entry)                  ? "2 N"
                                                                : "30 kPa"));
}

model::PressureLoad pressure_load(const LoadEntry& entry, const Values& values) {
    model::PressureLoad load;
    load.name = entry.name;
    load.targets = {entry.name};
    load.shape = values.text(entry.path + ".acts_on") == "undeformed" ? model::LoadShape::undeformed
                                                                      : model::LoadShape::deformed;
    load.time_function = time_function_of(values, entry.path);
    load.line = line_of(values, entry.path);
    if (entry.kind != LoadKind::gas) return load;
    load.sealed = values.text(entry.path + ".sealed") == "true";
    load.plug_thrust = values.text(entry.path + ".plug_thrust") == "true";
    if (!load.sealed && !load.plug_thrust)
        throw values.refuse(entry.path + ".plug_thrust", "the openings have no plugs, as sealed is false",
                            "leave it out, or sealed: true");
    const std::string gas = entry.path + ".gas.";
    load.gas = {.ambient_Pa = values.number(gas + "ambient"),
                .ambient_density_kg_m3 = values.number(gas + "density"),
                .dead_volume_m3 = values.number(gas + "dead_volume"),
                .exponent = values.text(gas + "process") == "adiabatic" ? adiabatic_exponent : 1.0};
    return load;
}

void share_gas(const LoadEntry& entry, std::span<const LoadEntry> entries, Loads& loads, const Values& values) {
    const std::string& other = values.text(entry.value);
    const std::string path = entry.value;
    if (other == entry.name)
        throw values.refuse(path, "a cavity cannot share its own gas",
                            "name another cavity, or write pressure in place of shares");
    const auto owner = std::ranges::find(entries, other, &LoadEntry::name);
    if (owner == entries.end())
        throw values.refuse(path, "cavity " + core::quoted(other) + " has no load", "add it under loads.cavities");
    if (owner->kind == LoadKind::shared_gas)
        throw values.refuse(path, core::quoted(other) + " itself shares the gas of another cavity",
                            "write shares: " + values.text(owner->value));
    std::ranges::find(loads.pressures, other, &model::PressureLoad::name)->targets.push_back(entry.name);
}

LoadSlot add_load(const LoadEntry& entry, double value, Loads& loads, const Values& values) {
    switch (entry.kind) {
        case LoadKind::gas:
        case LoadKind::face_pressure:
            loads.pressures.push_back(pressure_load(entry, values));
            return {entry.kind, loads.pressures.size() - 1, value};
        case LoadKind::shared_gas: break;
        case LoadKind::traction:
            check_direction(values, entry.path + ".along");
            loads.tractions.push_back({entry.name, value, values.text(entry.path + ".along"),
                                       time_function_of(values, entry.path),
                                       is_force(entry) ? Design::Spread::whole_face : Design::Spread::per_area});
            return {entry.kind, loads.tractions.size() - 1, value};
        case LoadKind::gravity:
            require_density(values, entry.value);
            loads.body_forces.push_back(
                {entry.name, value, values.text(entry.path + ".along"), time_function_of(values, entry.path)});
            return {entry.kind, loads.body_forces.size() - 1, value};
        case LoadKind::motion:
            check_direction(values, entry.path + ".along");
            loads.motions.push_back({entry.name, value, values.text(entry.path + ".along")});
            return {entry.kind, loads.motions.size() - 1, value};
    }
    return {entry.kind, 0, value};
}

}  // namespace

std::vector<LoadEntry> add_load_keys(Schema& schema, const Node& root, const Node& defaults, std::string_view source,
                                     Examples& examples) {
    take_examples(members_of(defaults, "loads"), "loads", examples);
    const bool none = std::ranges::all_of(members_of(root, "loads"), [](const Member& load) {
        return load.key == cavities_group && load.value.kind != Node::Kind::scalar && load.value.members.empty();
    });
    if (none) refuse_no_loads(schema, root, defaults, source);
    add_load_names(schema, "loads");
    std::vector<LoadEntry> entries;
    for (const NamedLoad& load : named_loads(root, "loads", schema.faces)) {
        if (!schema.dynamic)
            refuse_keys(load, std::vector<std::string>{"time_function", "line"},
                        "a static path has no time function and no supply line",
                        "add dynamics: {duration: 1 s}, or leave it out");
        switch (load.target) {
            case LoadTarget::cavity: entries.push_back(add_cavity(schema, load, defaults)); break;
            case LoadTarget::gravity: entries.push_back(add_gravity(schema, load)); break;
            case LoadTarget::face: entries.push_back(add_face(schema, load)); break;
        }
        const LoadKind kind = entries.back().kind;
        if (schema.dynamic && kind != LoadKind::shared_gas && kind != LoadKind::motion)
            add_time_function_keys(schema, load.path, load.member->value, examples);
        examples.try_emplace(entries.back().path + ".pressure", "30 kPa");
        examples.try_emplace(entries.back().path + ".acceleration", "9.81 m/s^2");
        examples.try_emplace(entries.back().path + ".along", kind == LoadKind::gravity ? "-x" : "y");
    }
    return entries;
}

std::vector<StageLoad> add_stage_load_keys(Schema& schema, const Node& root, const std::string& stage,
                                           std::span<const LoadEntry> loads) {
    const std::string section = stage + ".loads";
    add_load_names(schema, section);
    std::vector<std::string> known;
    for (const LoadEntry& load : loads) known.push_back(load.name);
    std::vector<StageLoad> found;
    for (const NamedLoad& load : named_loads(root, section, schema.faces)) {
        const auto own = std::ranges::find(loads, load.name, &LoadEntry::name);
        if (own == loads.end())
            refuse(load.member->location, load.path, core::quoted(load.name) + " is not one of the loads",
                   "a stage can change these loads: " + core::join(known));
        const auto index = static_cast<std::size_t>(own - loads.begin());
        if (std::ranges::find(found, index, &StageLoad::index) != found.end())
            refuse(load.member->location, load.path, core::quoted(load.name) + " is written twice",
                   "keep one of its names");
        if (own->kind == LoadKind::shared_gas)
            refuse(load.member->location, load.path, "the cavity shares the gas of another cavity",
                   "change the load of that cavity");
        const std::vector<std::string> words = supply_names();
        const std::string_view written = own->kind == LoadKind::gas ? only_one_of(load, words) : std::string_view{};
        const SupplyWord& word = supply_word(written);
        schema.keys.push_back(stage_key(*own, load.path, word));
        if (own->kind == LoadKind::gas) schema.names[load.path] = words;
        found.push_back({index, word.what, schema.keys.back().path});
    }
    return found;
}

Loads loads_of(std::span<const LoadEntry> entries, const Values& values) {
    Loads loads;
    std::vector<std::string> loaded;
    bool has_varying_load = false;
    for (const LoadEntry& entry : entries) {
        const bool sharing = entry.kind == LoadKind::shared_gas, closed = entry.what == Prescription::closed;
        const double value = sharing || closed ? 0 : values.number(entry.value);
        if (!sharing) refuse_zero(entry, value, values);
        if (std::ranges::find(loaded, entry.name) != loaded.end())
            throw values.refuse(entry.value, "face " + core::quoted(entry.name) + " is loaded twice",
                                "keep one of its names");
        loaded.push_back(entry.name);
        loads.slots.push_back(add_load(entry, value, loads, values));
        has_varying_load = has_varying_load || !(sharing || closed);
    }
    for (const LoadEntry& entry : entries)
        if (entry.kind == LoadKind::shared_gas) share_gas(entry, entries, loads, values);
    if (!has_varying_load && !entries.empty())
        throw values.refuse(entries.front().value, "closed valves alone do not load the actuator", "add another load");
    return loads;
}

}  // namespace soft::design
