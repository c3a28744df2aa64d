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

constexpr std::string_view usual_law = "yeoh";
/// Walls of soft actuators seldom pass a stretch of 4.
constexpr std::string_view usual_strain = "300 %";
/// Of a set that solve may replace.
constexpr std::string_view by_stretch = "by stretch";

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

double largest_I1_of(const MaterialSet& set) {
    const Node& limit = *find_path(set.block, "fit.largest_I1");
    return ratio_of(limit.text, limit.place);
}

std::vector<const Member*> constants_of(const MaterialSet& set) {
    std::vector<const Member*> constants;
    for (const Member& member : set.block.members)
        if (member.key != "law" && member.key != "kappa" && member.key != "fit") constants.push_back(&member);
    return constants;
}

/// Whether the constants of the design are those of a set.
bool is_in_use(const std::vector<MaterialSet>& sets, const FittedMaterial& fitted, const Node& design) {
    const auto value_of = [](const Node& node) {
        return core::quantity_or_throw(node.text, core::Dimension::pressure, ExitCode::bad_input, node.place);
    };
    return std::ranges::any_of(sets, [&](const MaterialSet& set) {
        return set.law == fitted.law && largest_I1_of(set) == fitted.largest_I1 &&
               std::ranges::all_of(constants_of(set), [&](const Member* constant) {
                   const Node* used = find_path(design, "material." + constant->key);
                   return used != nullptr && value_of(*used) == value_of(constant->value);
               });
    });
}

std::string choice_by_stretch() { return ", fit: {choice: " + std::string{by_stretch} + "}"; }

bool is_chosen_by_stretch(std::string_view effective_yaml) {
    const Node root = parse_yaml(effective_yaml, "/design");
    const Node* choice = find_path(root, "material.fit.choice");
    return choice != nullptr && choice->text == by_stretch;
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
    if (section == main_material && !wish.strain &&
        std::ranges::none_of(constants_of(set),
                             [&](const Member* constant) { return find(material, constant->key) != nullptr; }))
        put(block, "fit.choice", scalar_node(std::string{by_stretch}, wish.place));
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

std::optional<FittedMaterial> fitted_material(std::string_view effective_yaml) {
    const Node root = parse_yaml(effective_yaml, "/design");
    const Node* limit = find_path(root, "material.fit.largest_I1");
    if (limit == nullptr) return std::nullopt;
    const Node& material = *find(root, "material");
    const Node& fit = *find(material, "fit");
    return FittedMaterial{.name = text_of(fit, "name"),
                          .law = text_of(material, "law"),
                          .range = text_of(fit, "range"),
                          .largest_I1 = ratio_of(limit->text, limit->place)};
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
    if (better != nullptr && !is_chosen_by_stretch(effective_yaml) && largest_I1_of(*better) < fitted->largest_I1)
        return "material: " + reached + ", well within the data its constants were fitted to" + take + " alone";
    return std::nullopt;
}

std::optional<FittingSet> fitting_set(std::string_view effective_yaml, double stretch) {
    const auto fitted = fitted_material(effective_yaml);
    const MaterialFile* file = fitted ? find_material(fitted->name) : nullptr;
    if (file == nullptr || !is_chosen_by_stretch(effective_yaml)) return std::nullopt;
    const std::vector<MaterialSet> sets = material_sets(*file);
    const MaterialSet* set = narrowest(sets, fitted->law, stretch - 1.0);
    if (set == nullptr) set = widest(sets, fitted->law);
    if (set == nullptr || largest_I1_of(*set) == fitted->largest_I1) return std::nullopt;
    const Node root = parse_yaml(effective_yaml, "/design");
    if (!is_in_use(sets, *fitted, root))
        return std::nullopt;  // a constant was changed since: it goes with no other set
    std::string text =
        "{name: " + fitted->name + ", law: " + set->law + ", range: " + set->strain_text + choice_by_stretch();
    const Node& material = *find(root, "material");
    for (const Member& member : material.members)
        if (find(set->block, member.key) == nullptr || member.key == "kappa")
            text += ", " + member.key + ": " + member.value.text;
    return FittingSet{.change = {"material", text + "}"},
                      .text = fitted->name + " over " + set->strain_text + " of strain",
                      .is_wider = largest_I1_of(*set) > fitted->largest_I1};
}

bool is_change_of_set(std::string_view override_text) {
    return override_text.starts_with("material=") && override_text.find(choice_by_stretch()) != std::string_view::npos;
}

}  // namespace soft::design
