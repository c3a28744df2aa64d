#include "design/loads.hpp"

#include <algorithm>

#include "core/text.hpp"
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

/// The single word of the load; a second one is rejected.
std::string_view only_word(const NamedLoad& load, std::span<const std::string> words) {
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

/// Keys that a load cannot have.
struct ForeignKeys {
    std::vector<std::string> keys;
    std::string_view problem, remedy;
};

void refuse_keys(const NamedLoad& load, const ForeignKeys& foreign) {
    for (const Member& member : load.member->value.members)
        if (std::ranges::find(foreign.keys, member.key) != foreign.keys.end())
            refuse(member.location, load.path + "." + member.key, foreign.problem, foreign.remedy);
}

/// The words of a target that this one does not have.
std::vector<std::string> words_of_other(LoadTarget other, LoadTarget own) {
    std::vector<std::string> words = words_of(other);
    const std::vector<std::string> known = words_of(own);
    std::erase_if(words, [&](const std::string& word) { return std::ranges::find(known, word) != known.end(); });
    return words;
}

void refuse_foreign_keys(const NamedLoad& load, const LoadForm& form) {
    constexpr std::string_view normal = "a pressure acts along the normal of the deformed face";
    if (load.target == LoadTarget::cavity) {
        refuse_keys(load, {words_of_other(LoadTarget::face, load.target), "a cavity is loaded by a pressure",
                           "write pressure"});
        refuse_keys(load, {{"along"}, normal, "leave it out"});
    }
    if (form.kind == LoadKind::shared_gas)
        refuse_keys(load, {{"sealed", "plug_thrust", "gas", "acts_on", "time_function", "line"},
                           "a cavity that shares its gas has no supply of its own",
                           "leave it out"});
    if (load.target == LoadTarget::face) {
        std::vector<std::string> of_gas = words_of_other(LoadTarget::cavity, load.target);
        of_gas.insert(of_gas.end(), {"gas", "line"});
        refuse_keys(load, {of_gas, "a face encloses no gas", "write pressure; only a cavity takes this"});
        refuse_keys(load, {{"sealed", "plug_thrust"}, "a face has no openings to seal", "leave it out"});
    }
    if (load.target == LoadTarget::obstacle)
        refuse_keys(load, {{"pressure", "traction", "force"}, "an obstacle is moved", "write displacement"});
    if (form.kind == LoadKind::face_pressure)
        refuse_keys(load, {{"along"}, normal, "leave it out, or write traction in place of pressure"});
}

/// Adds the keys of a load; keys of other kinds are rejected.
LoadEntry add_load_keys_of(Schema& schema, const NamedLoad& load, const Node& defaults) {
    const std::vector<std::string> words = words_of(load.target);
    const LoadForm& form = form_of(load.target, only_word(load, words));
    refuse_foreign_keys(load, form);
    if (load.target != LoadTarget::gravity) schema.names[load.path] = words;
    schema.keys.push_back(magnitude_key(load.path, form, When::full_load));
    if (form.kind == LoadKind::shared_gas) schema.keys.back().choices = schema.faces.cavities;
    if (!form.along.path.empty()) schema.keys.push_back(along_key(load.path, form));
    if (form.kind == LoadKind::gas || form.kind == LoadKind::face_pressure)
        for (Key& key : pressure_keys(load.path, load.target, schema.dynamic)) {
            const Node* usual = key.path.ends_with(".sealed") ? find_path(defaults, key.path) : nullptr;
            if (usual != nullptr) key.fallback = usual->text;
            schema.keys.push_back(std::move(key));
        }
    return {load.path, load.member->location, load.name, load.path + "." + form.word(), &form};
}

void refuse_zero(const LoadEntry& entry, double value, const Values& values) {
    const bool ratio = entry.form->what == Prescription::volume_ratio,
               closed = entry.form->what == Prescription::closed;
    if (closed || value != (ratio ? 1.0 : 0.0)) return;
    throw values.refuse(entry.value, ratio ? "1 is where the path starts" : "a load of 0 gives no path",
                        "write the " + entry.form->word() + " at full load, for example " + entry.form->example);
}

model::PressureLoad pressure_load(const LoadEntry& entry, const Values& values) {
    model::PressureLoad load = pressure_settings_of(values, entry.path);
    load.name = entry.name;
    load.targets = {entry.name};
    load.time_function = time_function_of(values, entry.path);
    if (!load.sealed && !load.plug_thrust)
        throw values.refuse(entry.path + ".plug_thrust", "the openings have no plugs, as sealed is false",
                            "leave it out, or sealed: true");
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
    if (owner->form->kind == LoadKind::shared_gas)
        throw values.refuse(path, core::quoted(other) + " itself shares the gas of another cavity",
                            "write shares: " + values.text(owner->value));
    std::ranges::find(loads.pressures, other, &model::PressureLoad::name)->targets.push_back(entry.name);
}

/// An obstacle moves continuously from where the design places it.
model::TimeFunction obstacle_time_function(const LoadEntry& entry, const Values& values) {
    auto time_function = time_function_of(values, entry.path);
    const bool is_table = time_function.kind == model::TimeFunctionKind::table;
    if (time_function.kind == model::TimeFunctionKind::step || (is_table && time_function.shares.front() != 0))
        throw values.refuse(entry.path + ".time_function", "an obstacle cannot jump away from its place",
                            is_table ? "begin the shares with 0" : "use a ramp, a sine or a table");
    return time_function;
}

LoadSlot add_load(const LoadEntry& entry, double value, Loads& loads, const Values& values) {
    switch (entry.form->kind) {
        case LoadKind::gas:
        case LoadKind::face_pressure:
            loads.pressures.push_back(pressure_load(entry, values));
            return {entry.form, loads.pressures.size() - 1, value};
        case LoadKind::shared_gas: break;
        case LoadKind::dead_load:
            if (entry.form->target == LoadTarget::gravity)
                require_density(values, entry.value);
            else
                check_direction(values, entry.path + ".along");
            loads.dead_loads.push_back({entry.name, entry.form->dead_load, value, values.text(entry.path + ".along"),
                                        time_function_of(values, entry.path)});
            return {entry.form, loads.dead_loads.size() - 1, value};
        case LoadKind::motion:
            loads.motions.push_back({entry.name, value, values.text(entry.path + ".along")});
            if (entry.form->target == LoadTarget::obstacle) {
                check_obstacle_direction(values, entry.path + ".along");
                loads.motions.back().time_function = obstacle_time_function(entry, values);
            } else {
                check_direction(values, entry.path + ".along");
            }
            return {entry.form, loads.motions.size() - 1, value};
    }
    return {entry.form, 0, value};
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
            refuse_keys(load, {{"time_function", "line"},
                               "a static path has no time function and no supply line",
                               "add dynamics: {duration: 1 s}, or leave it out"});
        const LoadEntry& entry = entries.emplace_back(add_load_keys_of(schema, load, defaults));
        if (schema.dynamic && entry.form->takes_time_function)
            add_time_function_keys(schema, load.path, load.member->value, examples);
        examples.try_emplace(entry.value, entry.form->example);
        examples.try_emplace(entry.path + ".along", entry.form->target == LoadTarget::gravity ? "-x" : "y");
    }
    // The order of the dead loads is that in which their forces are summed.
    std::ranges::stable_partition(entries,
                                  [](const LoadEntry& entry) { return entry.form->target != LoadTarget::gravity; });
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
        if (own->form->kind == LoadKind::shared_gas)
            refuse(load.member->location, load.path, "the cavity shares the gas of another cavity",
                   "change the load of that cavity");
        const bool gas = own->form->kind == LoadKind::gas;
        std::vector<std::string> words = words_of(load.target);
        std::erase(words, "shares");
        const LoadForm& form = gas ? form_of(load.target, only_word(load, words)) : *own->form;
        schema.keys.push_back(magnitude_key(load.path, form, When::stage_end));
        if (gas) schema.names[load.path] = words;
        found.push_back({index, form.what, schema.keys.back().path});
    }
    return found;
}

Loads loads_of(std::span<const LoadEntry> entries, const Values& values) {
    Loads loads;
    std::vector<std::string> loaded;
    bool has_varying_load = false;
    for (const LoadEntry& entry : entries) {
        const bool sharing = entry.form->kind == LoadKind::shared_gas,
                   closed = entry.form->what == Prescription::closed;
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
        if (entry.form->kind == LoadKind::shared_gas) share_gas(entry, entries, loads, values);
    if (!has_varying_load && !entries.empty())
        throw values.refuse(entries.front().value, "closed valves alone do not load the actuator", "add another load");
    return loads;
}

}  // namespace soft::design
