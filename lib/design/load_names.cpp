#include "design/load_names.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "design/sections.hpp"

namespace soft::design {
namespace {

bool is_cavity(const FaceNames& faces, std::string_view name) {
    return std::ranges::find(faces.cavities, name) != faces.cavities.end();
}

[[noreturn]] void refuse_short_form(const Member& member, const std::string& path, const FaceNames& faces) {
    refuse(member.location, path, "the cavities are " + core::join(faces.cavities),
           "write cavities: {" + faces.cavities.front() + ": {...}}");
}

}  // namespace

std::vector<NamedLoad> named_loads(const Node& root, const std::string& section, const FaceNames& faces) {
    std::vector<NamedLoad> loads;
    for (const Member& member : members_of(root, section)) {
        const std::string path = section + "." + member.key, face = resolve_face(faces, member.key);
        const bool of_cavity = face.empty() && (member.key == cavities_group || member.key == cavity_name);
        if (of_cavity && faces.cavities.empty())
            refuse(member.location, path, "there is no cavity to load", "faces: " + core::join(all_names(faces)));
        if (member.key == cavities_group && face.empty()) {
            for (const Member& cavity : member.value.members)
                if (const std::string name = resolve_face(faces, cavity.key); is_cavity(faces, name))
                    loads.push_back({path + "." + cavity.key, name, LoadTarget::cavity, &cavity});
        } else if (is_cavity(faces, face) || (face.empty() && member.key == cavity_name && !faces.cavities.empty())) {
            if (faces.cavities.size() > 1) refuse_short_form(member, path, faces);
            loads.push_back({path, faces.cavities.front(), LoadTarget::cavity, &member});
        } else if (!face.empty()) {
            loads.push_back({path, face, LoadTarget::face, &member});
        } else if (member.key == gravity_name) {
            loads.push_back({path, std::string{gravity_name}, LoadTarget::gravity, &member});
        } else if (std::ranges::find(faces.obstacles, member.key) != faces.obstacles.end()) {
            loads.push_back({path, member.key, LoadTarget::obstacle, &member});
        }
    }
    return loads;
}

void add_load_names(Schema& schema, const std::string& section) {
    std::vector<std::string> names;
    const FaceNames& faces = schema.faces;
    if (faces.cavities.size() == 1) names.emplace_back(cavity_name);
    if (!faces.cavities.empty()) {
        names.emplace_back(cavities_group);
        schema.names[section + "." + std::string{cavities_group}] = faces.cavities;
    }
    for (const std::string& name : all_names(faces))
        if (!is_cavity(faces, resolve_face(faces, name))) names.push_back(name);
    names.insert(names.end(), faces.obstacles.begin(), faces.obstacles.end());
    names.emplace_back(gravity_name);
    schema.names[section] = std::move(names);
}

std::vector<Override> in_names_of(const Node& root, std::span<const Override> overrides, const FaceNames& faces) {
    std::vector<Override> renamed(overrides.begin(), overrides.end());
    constexpr std::string_view start = "loads.";
    for (Override& change : renamed) {
        if (!change.path.starts_with(start)) continue;
        const std::size_t end = std::min(change.path.find('.', start.size()), change.path.size());
        const std::string name = change.path.substr(start.size(), end - start.size()), face = resolve_face(faces, name);
        const auto& loads = members_of(root, "loads");
        if (face.empty() || std::ranges::find(loads, name, &Member::key) != loads.end()) continue;
        const auto same =
            std::ranges::find(loads, face, [&](const Member& load) { return resolve_face(faces, load.key); });
        if (same != loads.end()) change.path.replace(start.size(), name.size(), same->key);
    }
    return renamed;
}

}  // namespace soft::design
