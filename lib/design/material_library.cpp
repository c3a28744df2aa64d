#include "design/material_library.hpp"

#include <algorithm>
#include <optional>

#include "core/text.hpp"
#include "core/units.hpp"
#include "design/fitted.hpp"

namespace soft::design {
namespace {

constexpr std::string_view usual_law = "yeoh";
/// Walls of soft actuators seldom pass a stretch of 4.
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

struct Wish {
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
        refuse(wish.law->place, "material.law", wish.name + " has no constants of " + core::quoted(law),
               core::did_you_mean(law, laws));
    }
    const double strain = wish.strain ? ratio_of(wish.strain->text, wish.strain->place + ": material.range")
                                      : ratio_of(usual_strain, usual_strain);
    if (const MaterialSet* set = narrowest(sets, law, strain)) return *set;
    if (wish.strain)
        refuse(wish.strain->place, "material.range", "the data of " + wish.name + " end before " + wish.strain->text,
               "ranges: " + ranges);
    return *std::find_if(sets.rbegin(), sets.rend(), [&](const MaterialSet& set) { return set.law == law; });
}

Wish wish_of(const Node& material) {
    if (material.kind == Node::Kind::scalar) return {material.text, material.place, {}, {}};
    const Node& name = *find(material, "name");
    if (name.kind != Node::Kind::scalar)
        refuse(name.place, "material.name", "a single value is needed here", "name: dragon-skin-20");
    Wish wish{name.text, name.place, {}, {}};
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

void name_to_key(Node& root) {
    const Node* written = find(root, "material");
    if (written == nullptr || written->kind != Node::Kind::scalar) return;
    Node name = *written, group;
    group.kind = Node::Kind::map;
    group.place = name.place;
    group.members.push_back({"name", name.place, std::move(name)});
    put(root, "material", std::move(group));
}

void name_to_material(Node& root) {
    const Node* written = find(root, "material");
    if (written == nullptr) return;
    const bool is_name = written->kind == Node::Kind::scalar;
    if (!is_name && (written->kind != Node::Kind::map || find(*written, "name") == nullptr)) return;
    const Node material = *written;
    const Wish wish = wish_of(material);
    const MaterialFile* file = find_material(wish.name);
    if (file == nullptr)
        refuse(wish.place, "material.name", "no silicone is called " + core::quoted(wish.name),
               core::did_you_mean(wish.name, names()) + "; or write {law: neo-hookean, mu: 0.1644 MPa}");
    const std::vector<MaterialSet> sets = material_sets(*file);
    Node block = chosen(sets, wish).block;
    place_all(block, wish.place);
    for (const Member& member : material.members)
        if (member.key != "name" && member.key != "range") put(block, member.key, member.value);
    put(root, "material", std::move(block));
}

std::optional<std::string> fit_advice(std::string_view effective_yaml, double stretch) {
    const Node root = parse_yaml(effective_yaml, "/design");
    const Node* limit = find_path(root, "material.fit.largest_I1");
    if (limit == nullptr || !(stretch > 1.0)) return std::nullopt;
    const double least_I1 = stretch * stretch + 2.0 / stretch;
    const Node* name = find_path(root, "material.fit.name");
    const MaterialFile* file = name == nullptr ? nullptr : find_material(name->text);
    const std::vector<MaterialSet> sets = file == nullptr ? std::vector<MaterialSet>{} : material_sets(*file);
    const MaterialSet* better = narrowest(sets, text_of(*find(root, "material"), "law"), stretch - 1.0);
    const std::string take = better == nullptr ? ""
                                               : "; material: {name: " + name->text + ", law: " + better->law +
                                                     ", range: " + better->strain_text + "} was fitted there";
    const std::string reached = "the rubber reaches a stretch of " + core::rounded_text(stretch, 3);
    if (least_I1 > ratio_of(limit->text, limit->place))
        return "material: " + reached + ", beyond the data its constants were fitted to (" +
               text_of(*find_path(root, "material.fit"), "range") + " of strain)" + take;
    if (better == nullptr) return std::nullopt;
    const Node* better_I1 = find_path(better->block, "fit.largest_I1");
    if (ratio_of(better_I1->text, name->text) < ratio_of(limit->text, limit->place))
        return "material: " + reached + ", well within the data its constants were fitted to" + take + " alone";
    return std::nullopt;
}

}  // namespace soft::design
