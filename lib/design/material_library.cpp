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

/// Its widest set is that of a name alone.
constexpr std::string_view usual_law = "yeoh";
/// Of the other laws, which fit a whole test badly: walls of soft actuators seldom pass a stretch of 4.
constexpr std::string_view usual_strain = "300 %";

std::vector<std::string> names() {
    std::vector<std::string> list;
    for (const MaterialFile& file : material_files()) list.emplace_back(file.name);
    return list;
}

std::string text_of(const Node& map, std::string_view key) {
    const Node* node = find(map, key);
    return node == nullptr ? std::string{} : node->text;
}

double ratio_of(std::string_view text, std::string_view place) {
    return core::quantity_or_throw(text, core::Dimension::ratio, ExitCode::bad_input, place);
}

/// Every place in it is that of the name: the user knows no other.
void place_all(Node& node, const std::string& place) {
    node.place = place;
    for (Node& item : node.items) place_all(item, place);
    for (Member& member : node.members) {
        member.place = place;
        place_all(member.value, place);
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
    return ratio_of(limit.text, limit.place);
}

struct Wish {
    std::string section;  // "material", "materials.cap"
    std::string name, place;
    std::optional<Node> law, strain;  // as written
};

const MaterialSet& chosen(const std::vector<MaterialSet>& sets, const Wish& wish) {
    const std::string law = wish.law ? wish.law->text : std::string{usual_law};
    const std::string ranges = ranges_of(sets, law);
    if (ranges.empty()) {
        std::vector<std::string> laws;
        for (const MaterialSet& set : sets)
            if (std::ranges::find(laws, set.law) == laws.end()) laws.push_back(set.law);
        refuse(wish.law->place, wish.section + ".law", wish.name + " has no constants of " + core::quoted(law),
               core::did_you_mean(law, laws));
    }
    if (!wish.strain && law == usual_law) return *widest(sets, law);
    const double strain = wish.strain ? ratio_of(wish.strain->text, wish.strain->place + ": " + wish.section + ".range")
                                      : ratio_of(usual_strain, usual_strain);
    if (const MaterialSet* set = narrowest(sets, law, strain)) return *set;
    if (wish.strain)
        refuse(wish.strain->place, wish.section + ".range",
               "the data of " + wish.name + " end before " + wish.strain->text, "ranges: " + ranges);
    return *widest(sets, law);
}

Wish wish_of(const Node& material, const std::string& section) {
    if (material.kind == Node::Kind::scalar) return {section, material.text, material.place, {}, {}};
    const Node& name = *find(material, "name");
    if (name.kind != Node::Kind::scalar)
        refuse(name.place, section + ".name", "a single value is needed here", "name: dragon-skin-20");
    Wish wish{section, name.text, name.place, {}, {}};
    if (const Node* law = find(material, "law")) wish.law = *law;
    if (const Node* strain = find(material, "range"); strain != nullptr && strain->kind == Node::Kind::scalar)
        wish.strain = *strain;
    return wish;
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
        put(set.block, "fit.name", scalar_node(std::string{file.name}, entry.place));
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
    group.place = name.place;
    group.members.push_back({"name", name.place, std::move(name)});
    put(root, section, std::move(group));
}

void name_to_material(Node& root, const std::string& section) {
    const Node* written = find_path(std::as_const(root), section);
    if (written == nullptr) return;
    const bool is_name = written->kind == Node::Kind::scalar;
    if (!is_name && (written->kind != Node::Kind::map || find(*written, "name") == nullptr)) return;
    const Node material = *written;
    const Wish wish = wish_of(material, section);
    const MaterialFile* file = find_material(wish.name);
    if (file == nullptr)
        refuse(wish.place, section + ".name", "no silicone is called " + core::quoted(wish.name),
               core::did_you_mean(wish.name, names()) + "; or write {law: neo-hookean, mu: 0.1644 MPa}");
    const std::vector<MaterialSet> sets = material_sets(*file);
    const MaterialSet& set = chosen(sets, wish);
    Node block = set.block;
    place_all(block, wish.place);
    for (const Member& member : material.members) {
        if (member.key == "name" || member.key == "range") continue;
        if (member.key == "fit")
            for (const Member& of_data : member.value.members) put(block, "fit." + of_data.key, of_data.value);
        else
            put(block, member.key, member.value);
    }
    put(root, section, std::move(block));
}

/// "material" and "materials.<name>", as far as they are there.
std::vector<std::string> sections_of(const Node& root) {
    std::vector<std::string> sections{std::string{main_material}};
    for (const Member& own : members_of(root, materials_group))
        if (own.key.find('.') == std::string::npos) sections.push_back(std::string{materials_group} + "." + own.key);
    return sections;
}

}  // namespace

void names_to_keys(Node& root) {
    for (const std::string& section : sections_of(root)) name_to_key(root, section);
}

void names_to_materials(Node& root) {
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
                          .max_I1 = ratio_of(limit->text, limit->place)};
}

std::optional<std::string> fit_advice(std::string_view effective_yaml, double stretch) {
    const auto fitted = fitted_material(effective_yaml);
    if (!fitted || !(stretch > 1.0)) return std::nullopt;
    const MaterialFile* file = find_material(fitted->name);
    const std::vector<MaterialSet> sets = file == nullptr ? std::vector<MaterialSet>{} : material_sets(*file);
    const MaterialSet* better = narrowest(sets, fitted->law, stretch - 1.0);
    const std::string take = better == nullptr ? ""
                                               : "; material: {name: " + fitted->name + ", law: " + better->law +
                                                     ", range: " + better->strain_text + "} was fitted there";
    const std::string reached = "the rubber reaches a stretch of " + core::rounded_text(stretch, 3);
    if (!fitted->holds(stretch))
        return "material: " + reached + ", beyond the data its constants were fitted to (" + fitted->range +
               " of strain)" + take;
    const bool fits_whole_test =
        fitted->law == usual_law && better != nullptr && max_I1_of(*widest(sets, usual_law)) == fitted->max_I1;
    if (better != nullptr && !fits_whole_test && max_I1_of(*better) < fitted->max_I1)
        return "material: " + reached + ", well within the data its constants were fitted to" + take + " alone";
    return std::nullopt;
}

}  // namespace soft::design
