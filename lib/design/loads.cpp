#include "design/loads.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/sections.hpp"

namespace soft::design {
namespace {

bool has_cavity(const FaceNames& faces) { return resolve_face(faces, cavity_name) == cavity_name; }

[[noreturn]] void refuse_no_loads(const Schema& schema, const Node& root, const Node& defaults, std::string_view source) {
    const auto& usual = members_of(defaults, "loads");
    const std::string target = !usual.empty()              ? usual.front().key
                               : has_cavity(schema.faces) ? std::string{cavity_name}
                                                          : "face";
    const Member* section = find_member(root, "loads");
    refuse(section == nullptr ? std::string{source} + ":1:1" : section->place, "loads",
           "missing (what drives the actuator)", "add loads: {" + target + ": {pressure: 30 kPa}}");
}

/// A load is a pressure or a traction; each kind has keys that mean nothing for the other.
void refuse_mixed_kinds(const Member& load, bool on_cavity) {
    const std::string path = "loads." + load.key + ".";
    const Member* traction = find_member(load.value, "traction");
    const auto present = [&](const char* key) { return find_member(load.value, key); };
    if (traction != nullptr && on_cavity)
        refuse(traction->place, path + "traction", "a cavity is loaded by a pressure", "write pressure");
    if (traction != nullptr && present("pressure") != nullptr)
        refuse(traction->place, path + "traction", "the load has a pressure already", "keep one of pressure and traction");
    if (const Member* along = present("along"); along != nullptr && traction == nullptr)
        refuse(along->place, path + "along", "a pressure acts along the normal of the deformed face",
               "leave it out, or write traction in place of pressure");
    if (const Member* sealed = present("sealed"); sealed != nullptr && !on_cavity)
        refuse(sealed->place, path + "sealed", "a face has no openings to seal", "leave it out");
}

}  // namespace

void add_load_keys(Schema& schema, const Node& root, const Node& defaults, std::string_view source,
                   Examples& examples) {
    for (const Member& load : members_of(defaults, "loads"))
        for (const char* value : {"pressure", "traction", "along"})
            if (const Node* usual = find(load.value, value)) examples["loads." + load.key + "." + value] = usual->text;
    const auto& loads = members_of(root, "loads");
    if (loads.empty()) refuse_no_loads(schema, root, defaults, source);
    schema.names["loads"] = all_names(schema.faces);
    for (const Member& load : loads) {
        const std::string face = resolve_face(schema.faces, load.key), path = "loads." + load.key;
        if (face.empty()) continue;  // collect() refuses it with the nearest name
        const bool on_cavity = face == cavity_name;
        refuse_mixed_kinds(load, on_cavity);
        if (find_member(load.value, "traction") != nullptr) {
            schema.keys.push_back(load_traction_key(load.key));
            schema.keys.push_back(load_along_key(load.key));
            examples.try_emplace(path + ".along", "y");
            continue;
        }
        schema.keys.push_back(load_pressure_key(load.key));
        examples.try_emplace(path + ".pressure", "30 kPa");
        if (!on_cavity) {
            schema.names[path] = {"traction"};  // "did you mean"; the key itself is there once it is written
            continue;
        }
        const Node* sealed = find_path(defaults, path + ".sealed");
        schema.keys.push_back(load_sealed_key(load.key, sealed == nullptr ? "true" : sealed->text));
    }
}

Loads loads_of(std::span<const Item> items, const FaceNames& faces, const Values& values) {
    Loads loads;
    std::vector<std::string> loaded;
    for (const Item& item : items) {
        const std::string pressed = name_between(item.key.path, "loads.", ".pressure");
        const std::string name = pressed.empty() ? name_between(item.key.path, "loads.", ".traction") : pressed;
        if (name.empty()) continue;
        const std::string face = resolve_face(faces, name);
        if (item.entry.number == 0)
            throw values.refuse(item.key.path, "a load of 0 gives no path",
                                pressed.empty() ? "write the traction at full load, for example 30 kPa"
                                                : "write the pressure at full load, for example 30 kPa");
        if (std::find(loaded.begin(), loaded.end(), face) != loaded.end())
            throw values.refuse(item.key.path, "face " + core::quoted(face) + " is loaded twice",
                                "keep one of its names");
        loaded.push_back(face);
        if (pressed.empty()) {
            const std::string along = "loads." + name + ".along";
            check_direction(values, along);
            loads.tractions.push_back({face, item.entry.number, values.text(along)});
            continue;
        }
        model::PressureLoad load{.target = face, .pressure_Pa = item.entry.number};
        const std::string sealed = "loads." + name + ".sealed";
        if (values.has(sealed)) load.sealed = values.text(sealed) == "true";
        loads.pressures.push_back(std::move(load));
    }
    return loads;
}

}  // namespace soft::design
