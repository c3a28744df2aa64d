#include "design/obstacles.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/load_names.hpp"
#include "design/sections.hpp"
#include "design/setting.hpp"

namespace soft::design {
namespace {

using model::ContactSettings;

constexpr std::string_view contact_section = "contact";
constexpr Range friction_range{0, 5};

const Settings<ContactSettings>& contact_settings() {
    static const Settings<ContactSettings> settings{
        flag("self", &ContactSettings::self, "contact of the actuator with itself and with its mirror images"),
        number("friction", &ContactSettings::friction, friction_range,
               "coefficient of Coulomb friction, of the actuator with itself and with obstacles that have no other"),
        number("distance", &ContactSettings::distance, {1e-4, 0.1},
               "distance at which surfaces begin to act on each other, as a share of the size of their facets")};
    return settings;
}

std::string obstacle_path(const std::string& name) { return std::string{obstacles_section} + "." + name; }

void check_name(const Member& obstacle, const FaceNames& faces) {
    const std::string path = obstacle_path(obstacle.key);
    constexpr std::array reserved{cavity_name, cavities_group, gravity_name, model::self_contact};
    if (!is_valid_name(obstacle.key)) refuse(obstacle.location, path, "not a name of an obstacle", valid_name_rule);
    if (!resolve_face(faces, obstacle.key).empty())
        refuse(obstacle.location, path, "a face of the actuator has this name", "choose another name");
    if (std::ranges::find(reserved, obstacle.key) != reserved.end())
        refuse(obstacle.location, path, "the name is reserved", "choose another name");
}

const ObstacleKeys& shape_of(const Member& obstacle, std::span<const ObstacleKeys> shapes) {
    const std::string path = obstacle_path(obstacle.key);
    const ObstacleKeys* found = nullptr;
    std::vector<std::string> words;
    for (const ObstacleKeys& shape : shapes) {
        words.push_back(shape.name);
        const Member* own = find_member(obstacle.value, shape.name);
        if (own == nullptr) continue;
        if (found != nullptr)
            refuse(own->location, path + "." + shape.name, "the obstacle is a " + found->name + " already",
                   "write two obstacles");
        found = &shape;
    }
    if (found != nullptr) return *found;
    for (const Member& member : obstacle.value.members)
        refuse(member.location, path + "." + member.key, "unknown key", core::did_you_mean(member.key, words));
    refuse(obstacle.location, path, "the shape of the obstacle is missing", "add " + core::join(words, " | "));
}

}  // namespace

std::vector<Key> contact_keys() { return keys_of(contact_settings(), std::string{contact_section}); }

std::vector<Key> obstacle_keys(const std::string& name, const ObstacleKeys& shape) {
    std::vector<Key> keys = shape.keys;
    keys.push_back(
        or_word("auto", value_key("friction", Kind::ratio, friction_range,
                                  "coefficient of Coulomb friction with this obstacle; auto: contact.friction")));
    for (Key& key : keys) key.path.insert(0, obstacle_path(name) + ".");
    return keys;
}

void add_obstacle_keys(Schema& schema, const Node& root, std::span<const ObstacleKeys> shapes) {
    for (const Member& obstacle : members_of(root, obstacles_section)) {
        check_name(obstacle, schema.faces);
        for (Key& key : obstacle_keys(obstacle.key, shape_of(obstacle, shapes))) schema.keys.push_back(std::move(key));
        schema.faces.obstacles.push_back(obstacle.key);
    }
    for (Key& key : contact_keys()) schema.keys.push_back(std::move(key));
    schema.names[std::string{obstacles_section}];
}

model::ContactSettings contact_of(const Values& values) {
    return read_settings(contact_settings(), values, std::string{contact_section});
}

std::vector<Design::ObstacleRequest> obstacles_of(std::span<const Item> items, std::span<const ObstacleKeys> shapes,
                                                  const Values& values) {
    std::vector<Design::ObstacleRequest> obstacles;
    for (const Item& item : items)
        for (const ObstacleKeys& shape : shapes) {
            const std::string first_key = "." + shape.keys.front().path;
            const std::string name = name_between(item.key.path, std::string{obstacles_section} + ".", first_key);
            if (!name.empty() && values.has(item.key.path)) obstacles.push_back({name, shape.name});
        }
    return obstacles;
}

}  // namespace soft::design
