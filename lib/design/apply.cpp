#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/dynamics_keys.hpp"
#include "design/load_keys.hpp"
#include "design/load_names.hpp"
#include "design/material_library.hpp"
#include "design/materials.hpp"
#include "design/read_parts.hpp"
#include "design/solver_keys.hpp"
#include "design/time_function_keys.hpp"

namespace soft::design {
namespace {

constexpr std::string_view case_source = "/design";  // the dataset of the case that contains the effective design

/// Sections that solve may change; the mesh and its named faces do not depend on them.
constexpr std::array<std::string_view, 6> changeable = {"material", "materials", "loads", "path", "dynamics", "solver"};
constexpr std::string_view changeable_remedy = "solve can change material, materials, loads, path, dynamics, solver";

void check_changeable(const Override& change) {
    const std::string section = change.path.substr(0, change.path.find('.'));
    if (std::find(changeable.begin(), changeable.end(), section) != changeable.end()) return;
    const auto& known = section_notes();
    const bool exists =
        std::any_of(known.begin(), known.end(), [&](const SectionNote& s) { return s.name == section; });
    const std::string location = "--set " + change.path;
    if (exists)
        throw Error(ExitCode::usage, location,
                    core::quoted(section) + " is built into the case and solve cannot change it",
                    "give the same --set to mesh-gen; " + std::string{changeable_remedy});
    throw Error(ExitCode::bad_input, location, "unknown key", changeable_remedy);
}

/// The face names of the case. The loaded faces replace the full list of faces, which a design alone does not contain; the
/// effective design contains the aliases.
FaceNames faces_of(const Node& original) {
    FaceNames faces;
    for (const Member& name : members_of(original, "names")) faces.aliases[name.key] = name.value.text;
    const auto add = [&](const std::string& name) {
        const auto alias = faces.aliases.find(name);
        faces.faces.push_back(alias == faces.aliases.end() ? name : alias->second);
    };
    for (const Member& load : members_of(original, "loads")) {
        if (load.key == cavities_group || load.key == gravity_name) continue;
        add(load.key);
        if (load.key == cavity_name) faces.cavities.push_back(load.key);
    }
    for (const Member& cavity : members_of(original, "loads." + std::string{cavities_group})) {
        add(cavity.key);
        faces.cavities.push_back(faces.faces.back());
    }
    std::erase_if(faces.aliases, [&](const auto& alias) {  // remove aliases of faces that the case does not load
        return std::ranges::find(faces.faces, alias.second) == faces.faces.end();
    });
    return faces;
}

/// Schema, loads and stages of the tree, with the face names of the case.
struct Part {
    Schema schema;
    Examples examples;
    std::vector<LoadEntry> loads;
    std::vector<StageEntry> stages;
};
Part part_of(const Node& root, FaceNames faces) {
    Part part;
    part.schema.faces = std::move(faces);
    part.schema.dynamic = is_dynamic(root);
    const Node* model = find(root, "model");
    const bool of_revolution = model != nullptr && model->text == "axisymmetric";
    // For a solid the design does not determine whether the body is axisymmetric; mesh-gen has written the fibre frame if there are fibres.
    add_material_keys(part.schema, root, case_source, part.examples, of_revolution ? "cylindrical" : "");
    part.loads = add_load_keys(part.schema, root, Node{}, case_source, part.examples);
    part.stages = add_path_keys(part.schema, root, part.loads);
    for (const auto& keys : {dynamics_keys(), solver_keys()})
        part.schema.keys.insert(part.schema.keys.end(), keys.begin(), keys.end());
    for (const char* section : {"dynamics", "solver"}) part.schema.names[section];
    return part;
}

/// mesh-gen has converted the direction of a load to a vector, so only its magnitude can change.
std::vector<ScaledLoad> scaled(LoadKind kind, const Part& built, const Values& was, const Part& part,
                               const Values& values) {
    const std::string remedy = "give the same --set to mesh-gen";
    std::vector<const LoadEntry*> own;  // in the order of the case's list
    for (const LoadEntry& load : built.loads)
        if (load.kind == kind) own.push_back(&load);
    std::vector<ScaledLoad> loads;
    for (const LoadEntry& load : part.loads) {
        if (load.kind != kind) continue;
        const auto same = std::ranges::find(own, load.name, [](const LoadEntry* entry) { return entry->name; });
        const auto word = [](const LoadEntry& entry) { return entry.value.substr(entry.path.size() + 1); };
        if (same == own.end() || word(**same) != word(load))
            throw values.refuse(load.value,
                                "the case has no " + word(load) + (kind == LoadKind::gravity ? "" : " on this face"),
                                remedy);
        if (was.text((*same)->path + ".along") != values.text(load.path + ".along"))
            throw values.refuse(load.path + ".along", "the direction is built into the case", remedy);
        loads.push_back({static_cast<std::size_t>(same - own.begin()),
                         values.number(load.value) / was.number((*same)->value), time_function_of(values, load.path)});
    }
    return loads;
}

/// The assignment of materials to regions is stored in the case, so materials cannot be added.
void check_same_materials(const Node& original, const Node& changed) {
    std::vector<std::string> known;
    for (const Member& own : members_of(original, materials_group)) known.push_back(own.key);
    for (const Member& own : members_of(changed, materials_group))
        if (std::ranges::find(known, own.key) == known.end())
            refuse(own.location, std::string{materials_group} + "." + own.key, "the case has no such material",
                   known.empty() ? "give the same --set to mesh-gen" : core::did_you_mean(own.key, known));
}

Node only_changeable(const Node& root) {
    Node part;
    part.kind = Node::Kind::map;
    for (const Member& member : root.members)
        if (std::find(changeable.begin(), changeable.end(), member.key) != changeable.end())
            part.members.push_back(member);
    return part;
}

}  // namespace

SolveChanges apply_overrides(std::string_view effective_yaml, std::span<const Override> overrides) {
    const Node original = parse_yaml(effective_yaml, case_source);
    const FaceNames faces = faces_of(original);
    Node changed = original;
    for (const Override& change : overrides) check_changeable(change);
    override_tree(changed, in_names_of(original, overrides, faces));
    check_same_materials(original, changed);
    resolve_material_names(changed);
    fill_empty_until(changed);
    const Part built = part_of(original, faces), part = part_of(changed, faces);
    const Values was = values_of(collect(only_changeable(original), built.schema, case_source, built.examples));
    const std::vector<Item> items = collect(only_changeable(changed), part.schema, case_source, part.examples);
    const Values values = values_of(items);
    std::vector<std::string> outputs;
    for (const Member& output : members_of(original, "outputs")) outputs.push_back(output.key);
    SolveChanges changes;
    changes.material = material_of(values);
    changes.materials = materials_of(values);
    Loads loads = loads_of(part.loads, values);
    const Node* formulation = find_path(original, "mesh.formulation");
    changes.dynamics = dynamics_of(
        {part.loads, items, formulation == nullptr ? std::string_view{} : std::string_view{formulation->text}}, values);
    changes.path = path_of({part.stages, part.loads, loads, outputs}, items, values);
    changes.loads = std::move(loads.pressures);
    changes.tractions = scaled(LoadKind::traction, built, was, part, values);
    changes.body_forces = scaled(LoadKind::gravity, built, was, part, values);
    changes.motions = scaled(LoadKind::motion, built, was, part, values);
    changes.solver = solver_of(values);
    const Node canonical = tree_of(items);
    for (const std::string_view section : changeable)
        if (const Node* made = find(canonical, section)) put(changed, section, *made);
    changes.effective_yaml = write_yaml(changed);
    return changes;
}

Override parse_override(std::string_view argument) {
    const auto equals = argument.find('=');
    const std::string location = "--set " + core::one_line(argument);
    const std::string remedy = "write --set key.path=value, for example --set geometry.wall=2.5mm";
    if (equals == std::string_view::npos) throw Error(ExitCode::usage, location, "no '=' in it", remedy);
    Override change{std::string{core::trimmed(argument.substr(0, equals))},
                    std::string{core::trimmed(argument.substr(equals + 1))}};
    const bool hole =
        change.path.starts_with('.') || change.path.ends_with('.') || change.path.find("..") != std::string::npos;
    if (change.path.empty() || hole) throw Error(ExitCode::usage, location, "no key path before '='", remedy);
    if (change.value.empty()) throw Error(ExitCode::usage, location, "no value after '='", remedy);
    if (change.path.starts_with("load.")) change.path.replace(0, 4, "loads." + std::string{cavity_name});
    return change;
}

}  // namespace soft::design
