#include "design/path.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "design/materials.hpp"

namespace soft::design {
namespace {

using model::Control;
using model::Prescription;

constexpr const char *controlled_path = "path.controlled", *frequencies_path = "path.frequencies";

class StageReader {
public:
    StageReader(const PathParts& parts, std::span<const Item> items, const Values& values)
        : parts_(parts), items_(items), values_(values) {}

    [[nodiscard]] model::Stage read(const StageEntry& entry, const model::Stage& before) {
        model::Stage stage = before;
        stage.name = entry.name;
        for (const StageLoad& load : entry.loads) set_target(load, stage);
        control(entry, stage);
        stage.until = until(entry);
        time(entry, stage);
        return stage;
    }

    /// Whether any stage uses path.controlled.
    [[nodiscard]] bool uses_controlled() const { return uses_controlled_; }

    [[noreturn]] void refuse_controlled(const std::string& key) const {
        throw values_.refuse(key, core::quoted(values_.text(key)) + " cannot be prescribed by this control",
                             "use control: displacement with an output, or control: volume with a cavity");
    }

private:
    void set_target(const StageLoad& load, model::Stage& stage) const {
        const LoadSlot& slot = parts_.loads.slots[load.index];
        const double value = load.what == Prescription::closed ? 0 : values_.number(load.value);
        if (slot.form->levels() != nullptr)
            (stage.*slot.form->levels())[slot.index] = value / slot.value;
        else
            stage.supplies[slot.index] = {load.what, value};
    }

    /// The key of the stage, or that of the path if the stage inherits it.
    [[nodiscard]] std::string own_or_path(const StageEntry& entry, const char* key) const {
        const std::string own = entry.path + "." + key;
        return values_.text(own) == "path" ? std::string{"path."} + key : own;
    }

    void control(const StageEntry& entry, model::Stage& stage) {
        const std::string key = own_or_path(entry, "control");
        control_setting().read(values_, key, stage);
        stage.controlled.clear();
        if (stage.control == Control::volume) check_volume(key);
        if (stage.control == Control::displacement && parts_.outputs.empty())
            throw values_.refuse(key, "there is no output to prescribe", "add one under outputs, or use auto");
        controlled(entry, stage);
        if (stage.control == Control::volume) check_not_prescribed(key, stage);
    }

    void check_volume(const std::string& key) const {
        if (!has(LoadKind::gas))
            throw values_.refuse(key, "no cavity is loaded, so there is no volume to prescribe", "use auto");
    }

    /// In time the loads are prescribed: no other quantity can be.
    void time(const StageEntry& entry, model::Stage& stage) const {
        const std::string key = entry.path + ".time";
        stage.time_s.reset();
        if (!values_.has(key) || values_.text(key) == "none") return;
        stage.time_s = values_.number(key);
        if (stage.control != Control::automatic && stage.control != Control::pressure)
            throw values_.refuse(own_or_path(entry, "control"), "a stage with a time prescribes its loads",
                                 "use auto; to prescribe the volume, give the load a volume");
        for (const model::Until& end : stage.until)
            if (end.quantity != "steps")
                throw values_.refuse(key, "a stage with a time ends with it, not where " + end.quantity + " is reached",
                                     "omit until, or the time");
    }

    /// A `controlled` of the stage must match its control; that of the path is used only if it matches.
    void controlled(const StageEntry& entry, model::Stage& stage) {
        const std::string key = own_or_path(entry, "controlled");
        const std::string& name = values_.text(key);
        if (name == "first") return;
        const bool output = std::ranges::find(parts_.outputs, name) != parts_.outputs.end();
        const bool cavity = std::ranges::any_of(parts_.entries, [&](const LoadEntry& load) {
            return load.form->kind == LoadKind::gas && load.name == name;
        });
        const bool fits =
            (stage.control == Control::displacement && output) || (stage.control == Control::volume && cavity);
        if (fits) {
            stage.controlled = name;
            uses_controlled_ = uses_controlled_ || key == controlled_path;
        } else if (key != controlled_path) {
            refuse_controlled(key);
        }
    }

    void check_not_prescribed(const std::string& key, const model::Stage& stage) const {
        for (std::size_t i = 0; i < parts_.entries.size(); ++i) {
            if (parts_.entries[i].form->kind != LoadKind::gas) continue;
            const std::string& name = parts_.entries[i].name;
            if (!stage.controlled.empty() && name != stage.controlled) continue;
            const Prescription what = stage.supplies[parts_.loads.slots[i].index].what;
            if (what == Prescription::volume || what == Prescription::volume_ratio)
                throw values_.refuse(key, "the volume of " + core::quoted(name) + " is prescribed by its load already",
                                     "use auto, or give the load a pressure");
            return;  // only the controlled cavity is checked: the named one, or the first
        }
    }

    [[nodiscard]] bool has(LoadKind kind) const {
        return std::ranges::any_of(parts_.entries, [&](const LoadEntry& load) { return load.form->kind == kind; });
    }

    [[nodiscard]] std::vector<model::Until> until(const StageEntry& entry) const {
        const std::string own = entry.path + ".until";
        if (values_.has(own) && values_.text(own) == "none") return {};
        const std::string section = (values_.has(own) ? "path.until" : own) + ".";
        std::vector<model::Until> ends;
        for (const Item& item : items_) {
            const std::string quantity = name_between(item.key.path, section, "");
            if (quantity.empty()) continue;
            check_end(item, quantity, section == "path.until.");
            ends.push_back({quantity, item.entry.number});
        }
        return ends;
    }

    void check_end(const Item& item, const std::string& quantity, bool of_path) const {
        if (of_path && item.entry.number == 0)
            throw values_.refuse(item.key.path, "0 is where the path starts", "write the value at which the path ends");
        if (quantity == "volume_ratio" && !has(LoadKind::gas))
            throw values_.refuse(item.key.path, "no cavity is loaded, so there is no volume", "use pressure or steps");
        if (quantity == "pressure" && parts_.loads.pressures.empty())
            throw values_.refuse(item.key.path, "no load is a pressure", "use an output or steps");
    }

    const PathParts& parts_;
    std::span<const Item> items_;
    const Values& values_;
    bool uses_controlled_ = false;
};

model::Stage unloaded(const Loads& loads) {
    model::Stage stage;
    for (const LoadSlot& slot : loads.slots)
        if (slot.form->levels() != nullptr)
            (stage.*slot.form->levels()).push_back(0);
        else if (slot.form->kind != LoadKind::shared_gas)
            stage.supplies.emplace_back();
    return stage;
}

void check_all_named(const PathParts& parts, const Values& values) {
    for (std::size_t i = 0; i < parts.entries.size(); ++i) {
        const LoadEntry& load = parts.entries[i];
        const bool named = std::ranges::any_of(parts.stages, [&](const StageEntry& stage) {
            return std::ranges::find(stage.loads, i, &StageLoad::index) != stage.loads.end();
        });
        if (!named && load.form->kind != LoadKind::shared_gas)
            throw values.refuse(load.value, "no stage names this load, so it would never act",
                                "name it in one of path.stages, or take it out");
    }
}

void check_times(const PathParts& parts, const model::PathSettings& path, const Values& values) {
    const auto timed = [](const model::Stage& stage) { return stage.time_s.has_value(); };
    const auto count = std::ranges::count_if(path.stages, timed);
    if (count == 0) return;
    for (std::size_t i = 0; i < parts.stages.size(); ++i)
        if (!timed(path.stages[i]))
            throw values.refuse(parts.stages[i].path + ".time", "other stages have a time, this one has none",
                                "give every stage a time, or none");
    if (path.modulus == model::Modulus::instantaneous)
        throw values.refuse("path.modulus", "it describes paths without times, and these stages have a time",
                            "leave it out, or the times");
    if (path.branch == model::Branch::follow)
        throw values.refuse("path.branch", "a path in time has no branches", "use stay, or stages without times");
    if (path.frequencies > 0)
        throw values.refuse(frequencies_path, "a path in time has no natural frequencies",
                            "use 0, or stages without times");
}

void check_frequencies(const Values& values) {
    require_density(values, frequencies_path);
    const std::string& linear = values.text("solver.linear");
    if (linear == "krylov" || linear == "jacobian-free")
        throw values.refuse(
            frequencies_path,
            "natural frequencies need a factorisation of the tangent, which solver.linear: " + linear + " avoids",
            "use solver.linear: auto or mumps-ldlt, or path.frequencies: 0");
}

}  // namespace

model::PathSettings path_of(const PathParts& parts, std::span<const Item> items, const Values& values) {
    check_all_named(parts, values);
    model::PathSettings path = read_settings(path_settings(), values, "path");
    StageReader reader{parts, items, values};
    model::Stage before = unloaded(parts.loads);
    for (int cycle = 1; cycle <= path.cycles; ++cycle)
        for (const StageEntry& entry : parts.stages) {
            path.stages.push_back(reader.read(entry, before));
            path.stages.back().cycle = cycle;
            before = path.stages.back();
        }
    if (path.cycles > 1 && parts.stages.front().name.empty())
        throw values.refuse("path.repeat", "the path has no stages that could be repeated",
                            "add path.stages, for example {inflate: {...}, vent: {...}}");
    check_times(parts, path, values);
    if (values.text(controlled_path) != "first" && !reader.uses_controlled()) reader.refuse_controlled(controlled_path);
    if (path.frequencies > 0) check_frequencies(values);
    return path;
}

std::vector<std::string> unused_values(const PathParts& parts, const Values& values) {
    const auto quantity = [](const std::string& path) { return path.substr(path.rfind('.')); };
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i < parts.entries.size(); ++i) {
        const std::string& own = parts.entries[i].value;
        const auto acts = [&](const StageLoad& load) {
            return load.index == i && quantity(load.value) == quantity(own) &&
                   (load.what == Prescription::closed || values.number(load.value) == values.number(own));
        };
        const auto is_full = [&](const StageEntry& stage) { return std::ranges::any_of(stage.loads, acts); };
        if (parts.entries[i].form->kind != LoadKind::shared_gas && std::ranges::none_of(parts.stages, is_full))
            warnings.push_back(own + ": acts in no stage, as each states another value; change path.stages");
    }
    return warnings;
}

}  // namespace soft::design
