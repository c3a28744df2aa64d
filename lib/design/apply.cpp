#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/loads.hpp"
#include "design/materials.hpp"
#include "design/read_parts.hpp"

namespace soft::design {
namespace {

constexpr std::string_view case_source = "/design";  // the group of the case that holds the text

/// Sections that solve may still change; the mesh and its named faces depend on none of them.
constexpr std::array<std::string_view, 4> changeable = {"material", "loads", "path", "solver"};

void check_changeable(const Override& change) {
    const std::string section = change.path.substr(0, change.path.find('.'));
    if (std::find(changeable.begin(), changeable.end(), section) != changeable.end()) return;
    const auto& known = section_notes();
    const bool exists =
        std::any_of(known.begin(), known.end(), [&](const SectionNote& s) { return s.name == section; });
    const std::string place = "--set " + change.path;
    if (exists)
        throw Error(ExitCode::usage, place,
                    core::quoted(section) + " is built into the case and solve cannot change it",
                    "give the same --set to mesh-gen; solve changes material, loads, path, solver");
    throw Error(ExitCode::bad_input, place, "unknown key", "solve changes material, loads, path, solver");
}

/// The names the case has: its load targets stand in for the faces, which a design alone does not list.
Schema schema_of(const Node& original, const Node& changed, Examples& examples) {
    Schema schema;
    if (const Node* loads = find(original, "loads"))
        for (const Member& load : loads->members) schema.faces.faces.push_back(load.key);
    const Node* model = find(original, "model");
    const bool of_revolution = model != nullptr && model->text == "axisymmetric";
    add_material_keys(schema, changed, case_source, examples, of_revolution ? "cylindrical" : "cartesian");
    add_load_keys(schema, changed, Node{}, case_source, examples);
    add_path_keys(schema, changed);
    auto solver = solver_keys();
    schema.keys.insert(schema.keys.end(), solver.begin(), solver.end());
    schema.names["solver"];
    return schema;
}

/// The mesh turned the direction of a traction into a vector, so only its size can still change.
std::vector<TractionChange> traction_changes(const Node& original, std::span<const Design::TractionRequest> tractions,
                                             const Values& values) {
    std::vector<const Member*> built;  // in the order of Case::tractions
    for (const Member& load : members_of(original, "loads"))
        if (find(load.value, "traction") != nullptr) built.push_back(&load);
    std::vector<TractionChange> changes;
    for (const Design::TractionRequest& traction : tractions) {
        const std::string path = "loads." + traction.face, remedy = "give the same --set to mesh-gen";
        const auto own = std::find_if(built.begin(), built.end(), [&](const Member* m) { return m->key == traction.face; });
        if (own == built.end())
            throw values.refuse(path + ".traction", "the case has no traction on this face", remedy);
        if (find((*own)->value, "along")->text != traction.along)
            throw values.refuse(path + ".along", "the direction is built into the case", remedy);
        const double built_Pa = check_value(load_traction_key(traction.face), *find((*own)->value, "traction"), {}).entry.number;
        changes.push_back({static_cast<std::size_t>(own - built.begin()), traction.traction_Pa / built_Pa});
    }
    return changes;
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
    Node changed = original;
    for (const Override& change : overrides) check_changeable(change);
    override_tree(changed, overrides);
    Examples examples;
    const Schema schema = schema_of(original, changed, examples);
    const std::vector<Item> items = collect(only_changeable(changed), schema, case_source, examples);
    const Values values = values_of(items);
    SolveChanges changes;
    changes.material = material_of(values);
    Loads loads = loads_of(items, schema.faces, values);
    changes.loads = std::move(loads.pressures);
    changes.tractions = traction_changes(original, loads.tractions, values);
    changes.path = path_of(items, values);
    changes.solver = solver_of(values);
    const Node canonical = tree_of(items);
    for (const std::string_view section : changeable) put(changed, section, *find(canonical, section));
    changes.effective_yaml = write_yaml(changed);
    return changes;
}

Override parse_override(std::string_view argument) {
    const auto equals = argument.find('=');
    const std::string place = "--set " + core::one_line(argument);
    const std::string remedy = "write --set key.path=value, for example --set geometry.wall=2.5mm";
    if (equals == std::string_view::npos) throw Error(ExitCode::usage, place, "no '=' in it", remedy);
    Override change{std::string{core::trimmed(argument.substr(0, equals))},
                    std::string{core::trimmed(argument.substr(equals + 1))}};
    const bool hole =
        change.path.starts_with('.') || change.path.ends_with('.') || change.path.find("..") != std::string::npos;
    if (change.path.empty() || hole) throw Error(ExitCode::usage, place, "no key path before '='", remedy);
    if (change.value.empty()) throw Error(ExitCode::usage, place, "no value after '='", remedy);
    if (change.path.starts_with("load.")) change.path.replace(0, 4, "loads." + std::string{cavity_name});
    return change;
}

}  // namespace soft::design
