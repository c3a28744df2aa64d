#include "design/material_library.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/text.hpp"
#include "core/units.hpp"
#include "design/fitted.hpp"
#include "design/materials.hpp"

namespace soft::design {
namespace {

/// The law of a name alone, with its widest set.
constexpr std::string_view default_law = "yeoh";
/// Default range of the other laws, which fit a whole test badly: walls of soft actuators rarely exceed a stretch of 4.
constexpr std::string_view default_strain = "300 %";

std::vector<std::string> names() {
    std::vector<std::string> list;
    for (const MaterialFile& file : material_files()) list.emplace_back(file.name);
    return list;
}

std::string text_of(const Node& map, std::string_view key) {
    const Node* node = find(map, key);
    return node == nullptr ? std::string{} : node->text;
}

double ratio_of(std::string_view text, std::string_view location) {
    return core::quantity_or_throw(text, core::Dimension::ratio, ExitCode::bad_input, location);
}

/// Sets all locations to that of the material name, the only one in the user's design.
void set_location(Node& node, const std::string& location) {
    node.location = location;
    for (Node& item : node.items) set_location(item, location);
    for (Member& member : node.members) {
        member.location = location;
        set_location(member.value, location);
    }
}

std::string ranges_of(const std::vector<MaterialSet>& sets, std::string_view law) {
    std::vector<std::string> ranges;
    for (const MaterialSet& set : sets)
        if (set.law == law) ranges.push_back(set.strain_text);
    return core::join(ranges);
}

const MaterialSet* narrowest(const std::vector<MaterialSet>& sets, std::string_view law, double strain) {
    const auto found =
        std::ranges::find_if(sets, [&](const MaterialSet& set) { return set.law == law && set.strain >= strain; });
    return found == sets.end() ? nullptr : &*found;
}

const MaterialSet* widest(const std::vector<MaterialSet>& sets, std::string_view law) {
    const MaterialSet* found = nullptr;
    for (const MaterialSet& set : sets)
        if (set.law == law && (found == nullptr || set.strain > found->strain)) found = &set;
    return found;
}

double max_I1_of(const MaterialSet& set) {
    const Node& limit = *find_path(set.block, "fit.max_I1");
    return ratio_of(limit.text, limit.location);
}

struct MaterialRequest {
    std::string section;  // "material", "materials.cap"
    std::string name, location;
    std::optional<Node> law, strain;  // as written
};

const MaterialSet& select_set(const std::vector<MaterialSet>& sets, const MaterialRequest& request) {
    const std::string law = request.law ? request.law->text : std::string{default_law};
    const std::string ranges = ranges_of(sets, law);
    if (ranges.empty()) {
        std::vector<std::string> laws;
        for (const MaterialSet& set : sets)
            if (std::ranges::find(laws, set.law) == laws.end()) laws.push_back(set.law);
        refuse(request.law->location, request.section + ".law",
               request.name + " has no constants of " + core::quoted(law), core::did_you_mean(law, laws));
    }
    if (!request.strain && law == default_law) return *widest(sets, law);
    const double strain =
        request.strain ? ratio_of(request.strain->text, request.strain->location + ": " + request.section + ".range")
                       : ratio_of(default_strain, default_strain);
    if (const MaterialSet* set = narrowest(sets, law, strain)) return *set;
    if (request.strain)
        refuse(request.strain->location, request.section + ".range",
               "the data of " + request.name + " end before " + request.strain->text, "ranges: " + ranges);
    return *widest(sets, law);
}

MaterialRequest request_of(const Node& material, const std::string& section) {
    if (material.kind == Node::Kind::scalar) return {section, material.text, material.location, {}, {}};
    const Node& name = *find(material, "name");
    if (name.kind != Node::Kind::scalar)
        refuse(name.location, section + ".name", "a single value is needed here", "name: dragon-skin-20");
    MaterialRequest request{section, name.text, name.location, {}, {}};
    if (const Node* law = find(material, "law")) request.law = *law;
    if (const Node* strain = find(material, "range"); strain != nullptr && strain->kind == Node::Kind::scalar)
        request.strain = *strain;
    return request;
}

}  // namespace

const MaterialFile* find_material(std::string_view name) {
    const auto files = material_files();
    const auto found = std::ranges::find(files, name, &MaterialFile::name);
    return found == files.end() ? nullptr : &*found;
}

std::vector<MaterialSet> material_sets(const MaterialFile& file) {
    const Node root = parse_yaml(file.yaml, std::string{file.name} + ".yaml");
    std::vector<MaterialSet> sets;
    for (const Node& entry : find(root, "sets")->items) {
        MaterialSet set{text_of(entry, "law"), 0, text_of(entry, "range"), entry};
        set.strain = ratio_of(set.strain_text, file.name);
        std::erase_if(set.block.members, [](const Member& member) { return member.key == "range"; });
        put(set.block, "fit.name", scalar_node(std::string{file.name}, entry.location));
        sets.push_back(std::move(set));
    }
    return sets;
}

namespace {

void name_to_key(Node& root, const std::string& section) {
    const Node* written = find_path(std::as_const(root), section);
    if (written == nullptr || written->kind != Node::Kind::scalar) return;
    Node name = *written, group;
    group.kind = Node::Kind::map;
    group.location = name.location;
    group.members.push_back({"name", name.location, std::move(name)});
    put(root, section, std::move(group));
}

void name_to_material(Node& root, const std::string& section) {
    const Node* written = find_path(std::as_const(root), section);
    if (written == nullptr) return;
    const bool is_name = written->kind == Node::Kind::scalar;
    if (!is_name && (written->kind != Node::Kind::map || find(*written, "name") == nullptr)) return;
    const Node material = *written;
    const MaterialRequest request = request_of(material, section);
    const MaterialFile* file = find_material(request.name);
    if (file == nullptr)
        refuse(request.location, section + ".name", "no silicone is called " + core::quoted(request.name),
               core::did_you_mean(request.name, names()) + "; or write {law: neo-hookean, mu: 0.1644 MPa}");
    const std::vector<MaterialSet> sets = material_sets(*file);
    const MaterialSet& set = select_set(sets, request);
    Node block = set.block;
    set_location(block, request.location);
    for (const Member& member : material.members) {
        if (member.key == "name" || member.key == "range") continue;
        if (member.key == "fit")
            for (const Member& of_data : member.value.members) put(block, "fit." + of_data.key, of_data.value);
        else
            put(block, member.key, member.value);
    }
    put(root, section, std::move(block));
}

/// "material" and the existing "materials.<name>".
std::vector<std::string> sections_of(const Node& root) {
    std::vector<std::string> sections{std::string{main_material}};
    for (const Member& own : members_of(root, materials_group))
        if (own.key.find('.') == std::string::npos) sections.push_back(std::string{materials_group} + "." + own.key);
    return sections;
}

}  // namespace

void expand_material_names(Node& root) {
    for (const std::string& section : sections_of(root)) name_to_key(root, section);
}

void resolve_material_names(Node& root) {
    for (const std::string& section : sections_of(root)) name_to_material(root, section);
}

std::optional<FittedMaterial> fitted_material(std::string_view effective_yaml, std::string_view section) {
    const Node root = parse_yaml(effective_yaml, "/design");
    const Node* limit = find_path(root, std::string{section} + ".fit.max_I1");
    if (limit == nullptr) return std::nullopt;
    const Node& material = *find_path(root, section);
    const Node& fit = *find(material, "fit");
    return FittedMaterial{.name = text_of(fit, "name"),
                          .law = text_of(material, "law"),
                          .range = text_of(fit, "range"),
                          .max_error = text_of(fit, "max_error"),
                          .max_I1 = ratio_of(limit->text, limit->location)};
}

std::optional<std::string> fit_range_advice(std::string_view effective_yaml, double stretch) {
    const auto fitted = fitted_material(effective_yaml);
    if (!fitted || !(stretch > 1.0)) return std::nullopt;
    const MaterialFile* file = find_material(fitted->name);
    const std::vector<MaterialSet> sets = file == nullptr ? std::vector<MaterialSet>{} : material_sets(*file);
    const MaterialSet* better = narrowest(sets, fitted->law, stretch - 1.0);
    const std::string take = better == nullptr ? ""
                                               : "; material: {name: " + fitted->name + ", law: " + better->law +
                                                     ", range: " + better->strain_text + "} was fitted there";
    const std::string reached = "the rubber reaches a stretch of " + core::rounded_text(stretch, 3);
    if (!fitted->covers(stretch))
        return "material: " + reached + ", beyond the data its constants were fitted to (" + fitted->range +
               " of strain)" + take;
    const bool fits_whole_test =
        fitted->law == default_law && better != nullptr && max_I1_of(*widest(sets, default_law)) == fitted->max_I1;
    if (better != nullptr && !fits_whole_test && max_I1_of(*better) < fitted->max_I1)
        return "material: " + reached + ", well within the data its constants were fitted to" + take + " alone";
    return std::nullopt;
}

}  // namespace soft::design
