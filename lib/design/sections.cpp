#include "design/sections.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "design/common_keys.hpp"

namespace soft::design {
namespace {

using model::MeasuredObject;

void check_output_name(const Member& output) {
    if (!is_valid_name(output.key))
        refuse(output.location, "outputs." + output.key, "not a name of an output", valid_name_rule);
    const auto& taken = until_quantities();
    constexpr std::array others{"volume",   "step",        "stage",     "time",        "load",
                                "traction", "load_factor", "stiffness", "load_is_held"};
    if (std::find(taken.begin(), taken.end(), output.key) != taken.end() || std::ranges::count(others, output.key) > 0)
        refuse(output.location, "outputs." + output.key, "the name is reserved for a quantity of every path",
               "choose another name");
    for (const char* word : {"first", "path", "none"})  // words of path.controlled and of until
        if (output.key == word)
            refuse(output.location, "outputs." + output.key, "the name is reserved for a word of the group path",
                   "choose another name");
}

/// Components of a support in the coordinates of the model (axisymmetric: x, r).
std::array<bool, 3> components_of(const std::string& component, const Values& values, const std::string& path) {
    const bool axisymmetric = values.text("model") == "axisymmetric", plane = values.text("model") == "plane-strain";
    if (component == "fixed")
        return axisymmetric || plane ? std::array{true, true, false} : std::array{true, true, true};
    if (component == "x") return {true, false, false};
    if (plane && component != "y")
        throw values.refuse(path, "a plane strain model has the components x and y", "use x, y or fixed");
    // r on a solid fixes y and z, so that only x is free.
    if (component == "r") return axisymmetric ? std::array{false, true, false} : std::array{false, true, true};
    if (axisymmetric) throw values.refuse(path, "an axisymmetric model has the components x and r", "use r, or fixed");
    return component == "y" ? std::array{false, true, false} : std::array{false, false, true};
}

/// nullptr for an unknown word.
const model::MeasureInfo* find_measure(std::string_view word) {
    const auto found = std::ranges::find(model::measures, word, &model::MeasureInfo::name);
    return found == model::measures.end() ? nullptr : &*found;
}

std::string single_face(const Item& item, const FaceNames& faces, const Values& values) {
    if (item.list.size() != 1)
        throw values.refuse(item.key.path, "an output is measured on one face", "write one output per face");
    return resolve_face(faces, item.list.front());
}

/// Rotations and moments need an axis; for a plane section the only one is z.
void check_axis(const Values& values, const std::string& output) {
    const std::string &model = values.text("model"), &along = values.text(output + ".along");
    if (model == "axisymmetric")
        throw values.refuse(output + ".measure", "the section of a body of revolution neither bends nor twists",
                            "measure: displacement, radial or force, or model: solid");
    if (model == "plane-strain" && along != "z")
        throw values.refuse(output + ".along", "in plane strain faces turn about z", "write along: z");
    if (along == "r") throw values.refuse(output + ".along", "r is not an axis of rotation", "use axis, x, y or z");
}

/// Rejects keys that an output of an obstacle does not have.
void refuse_with_obstacle(const Member& output, const model::MeasureInfo* info) {
    const std::string path = "outputs." + output.key;
    for (const char* other : {"face", "point"})
        if (const Member* member = find_member(output.value, other))
            refuse(member->location, path + "." + other, "the output has an obstacle already",
                   "give a face, a point or an obstacle");
    const Member* along = find_member(output.value, "along");
    if (along != nullptr && info != nullptr && info->along == model::Along::none)
        refuse(along->location, path + ".along", "this measure has no direction", "leave it out");
}

/// Adds the keys of an output of an obstacle.
void add_contact_output_keys(Schema& schema, const Member& output, const model::MeasureInfo* info) {
    refuse_with_obstacle(output, info);
    std::vector<std::string> obstacles = schema.faces.obstacles;
    obstacles.emplace_back(model::self_contact);
    schema.keys.push_back(output_obstacle_key(output.key, std::move(obstacles)));
    schema.keys.push_back(output_measure_key(output.key, MeasuredObject::obstacle, info));
    if (info != nullptr && info->along == model::Along::none) return;
    Key along = output_along_key(output.key, "axis");
    along.choices = obstacle_directions();
    schema.keys.push_back(std::move(along));
}

/// Rejects keys of an output that only a face can have.
void refuse_with_point(const Member& output) {
    const std::string path = "outputs." + output.key;
    if (const Member* face = find_member(output.value, "face"))
        refuse(face->location, path + ".face", "the output has a point already", "give a face or a point, not both");
    const Member* measure = find_member(output.value, "measure");
    if (measure != nullptr && measure->value.text != "displacement")
        refuse(measure->location, path + ".measure", "only the displacement of a point is measured",
               "measure: displacement, or a face in place of the point");
    const Member* along = find_member(output.value, "along");
    if (along != nullptr && along->value.text == "normal")
        refuse(along->location, path + ".along", "a point has no normal", "use axis, x, y, z or r");
}

std::vector<double> point_of(const Item& item, const Values& values) {
    std::vector<double> point_m = values.numbers(item.key.path);
    const std::string& model = values.text("model");
    const bool solid = model != "axisymmetric" && model != "plane-strain";
    const std::size_t wanted = solid ? 3 : 2;
    if (point_m.size() != wanted)
        throw values.refuse(
            item.key.path,
            std::to_string(point_m.size()) + " coordinates where the model has " + std::to_string(wanted),
            solid                     ? "[x, y, z], such as [10 mm, 0 mm, 5 mm]"
            : model == "axisymmetric" ? "[x, r], such as [10 mm, 0 mm]"
                                      : "[x, y], such as [10 mm, 0 mm]");
    return point_m;
}

/// The displacement of an obstacle, a force on it, or an area or a pressure of contact.
void check_contact_measure(const Values& values, const Design::OutputRequest& output) {
    const std::string path = "outputs." + output.name;
    if (output.obstacle != model::self_contact) {
        if (model::info_of(output.measure).along != model::Along::none)
            check_obstacle_direction(values, path + ".along");
        return;
    }
    if (output.measure == model::Measure::displacement)
        throw values.refuse(path + ".measure", "only an obstacle has a displacement",
                            "use area or pressure, or name an obstacle");
    if (output.measure == model::Measure::force)
        throw values.refuse(path + ".measure", "the forces of self-contact cancel each other",
                            "use area or pressure, or name an obstacle");
    if (values.text("contact.self") == "false")
        throw values.refuse(path + ".obstacle", "contact.self is false, so there is no self-contact",
                            "use contact: {self: true}");
}

void check_measure(const Values& values, const std::string& output, const model::MeasureInfo& measure) {
    const std::string &model = values.text("model"), along = output + ".along", &word = values.text(along);
    if (measure.along == model::Along::axis)
        check_axis(values, output);
    else if (measure.along == model::Along::distance_axis &&
             (model == "plane-strain" || word == "r" || word == "normal"))
        throw values.refuse(along, "it is the axis from which the distance is taken",
                            "use axis, x, y or z, in a solid or axisymmetric model");
    else
        check_direction(values, along);
    if (measure.along == model::Along::force_direction && word == "r")
        throw values.refuse(along, "forces along r cancel around the circumference", "use axis, x or normal");
    if (measure.solid_only && (model == "axisymmetric" || model == "plane-strain"))
        throw values.refuse(output + ".measure", "a section has no such measure", "measure: bend, or model: solid");
    if (measure.reaction && values.has("dynamics.duration") && values.text("dynamics.duration") != "none")
        throw values.refuse(output + ".measure", "a reaction is measured on a static path",
                            "leave out dynamics, or measure: displacement");
}

}  // namespace

const std::vector<Member>& members_of(const Node& root, std::string_view path) {
    static const std::vector<Member> none;
    const Node* node = find_path(root, path);
    return node == nullptr ? none : node->members;
}

std::string name_between(const std::string& path, std::string_view prefix, std::string_view suffix) {
    if (!path.starts_with(prefix) || !path.ends_with(suffix) || path.size() <= prefix.size() + suffix.size()) return {};
    return path.substr(prefix.size(), path.size() - prefix.size() - suffix.size());
}

void check_direction(const Values& values, const std::string& path) {
    const std::string& model = values.text("model");
    std::string along = values.text(path);
    if (along.starts_with('-')) along.erase(0, 1);
    if (model == "axisymmetric" && (along == "y" || along == "z"))
        throw values.refuse(path, "an axisymmetric model has the directions x and r", "use axis, x or r");
    if (model == "plane-strain" && (along == "z" || along == "r"))
        throw values.refuse(path, "a plane strain model has the directions x and y", "use axis, x, y or normal");
}

void check_obstacle_direction(const Values& values, const std::string& path) {
    const std::string &model = values.text("model"), &along = values.text(path);
    if (model == "axisymmetric" && along != "axis" && along != "x")
        throw values.refuse(path, "an obstacle of an axisymmetric model has the direction x", "use axis or x");
    if (model == "plane-strain" && along == "z")
        throw values.refuse(path, "a plane strain model has the directions x and y", "use axis, x or y");
}

void add_support_keys(Schema& schema, const Node& root) {
    const auto& components = support_components();
    schema.names["supports"] = components;
    for (const Member& support : members_of(root, "supports")) {
        if (std::find(components.begin(), components.end(), support.key) != components.end()) {
            schema.keys.push_back(support_key(support.key));
        } else if (!resolve_face(schema.faces, support.key).empty()) {
            refuse(support.location, "supports." + support.key, "a face is given where a component is needed",
                   "write fixed: " + support.key);
        }
    }
}

void add_output_keys(Schema& schema, const Node& root, const Node& defaults) {
    for (const Member& output : members_of(root, "outputs")) {
        check_output_name(output);
        const Node* measure = find(output.value, "measure");
        const model::MeasureInfo* info = find_measure(measure == nullptr ? "displacement" : measure->text);
        if (find(output.value, "obstacle") != nullptr) {
            add_contact_output_keys(schema, output, info);
            continue;
        }
        const bool is_point = find(output.value, "point") != nullptr;
        if (is_point) refuse_with_point(output);
        schema.keys.push_back(is_point ? output_point_key(output.key) : output_face_key(output.key));
        if (info != nullptr && info->object == MeasuredObject::obstacle)
            refuse(
                measure->location, "outputs." + output.key + ".measure", "only contact has this measure",
                "write obstacle: NAME, or obstacle: self, in place of the " + std::string{is_point ? "point" : "face"});
        schema.keys.push_back(output_measure_key(output.key, MeasuredObject::face, info));
        const bool bend = measure != nullptr && measure->text == "bend";
        if (bend) schema.keys.push_back(output_reference_key(output.key));
        if (const Member* reference = find_member(output.value, "reference"); reference != nullptr && !bend)
            refuse(reference->location, "outputs." + output.key + ".reference",
                   "only a bend is measured from another face", "leave it out, or write measure: bend");
        const Node* along = find_path(defaults, "outputs." + output.key + ".along");
        schema.keys.push_back(output_along_key(output.key, info == nullptr || !info->has_default_axis ? ""
                                                           : along == nullptr                         ? "axis"
                                                                                                      : along->text));
    }
}

std::vector<model::Support> supports_of(std::span<const Item> items, const FaceNames& faces, const Values& values) {
    std::vector<model::Support> supports;
    for (const Item& item : items) {
        const std::string component = name_between(item.key.path, "supports.", "");
        if (component.empty()) continue;
        const auto fixed = components_of(component, values, item.key.path);
        for (const std::string& name : item.list) {
            const std::string face = resolve_face(faces, name);
            auto support =
                std::find_if(supports.begin(), supports.end(), [&](const model::Support& s) { return s.face == face; });
            if (support == supports.end()) support = supports.insert(supports.end(), {.face = face});
            for (std::size_t i = 0; i < fixed.size(); ++i) support->fixed[i] = support->fixed[i] || fixed[i];
        }
    }
    return supports;
}

std::vector<Design::OutputRequest> outputs_of(std::span<const Item> items, const FaceNames& faces,
                                              const Values& values) {
    std::vector<Design::OutputRequest> outputs;
    for (const Item& item : items) {
        const std::string at_point = name_between(item.key.path, "outputs.", ".point");
        const std::string of_obstacle = name_between(item.key.path, "outputs.", ".obstacle");
        const std::string name = !at_point.empty()      ? at_point
                                 : !of_obstacle.empty() ? of_obstacle
                                                        : name_between(item.key.path, "outputs.", ".face");
        if (name.empty()) continue;
        const model::MeasureInfo& measure = *find_measure(values.text("outputs." + name + ".measure"));
        if (!of_obstacle.empty()) {
            const bool directed = measure.along != model::Along::none;
            outputs.push_back({name, "", directed ? values.text("outputs." + name + ".along") : "", measure.measure});
            outputs.back().obstacle = item.entry.text;
            check_contact_measure(values, outputs.back());
            continue;
        }
        Design::OutputRequest output{name,
                                     at_point.empty() ? single_face(item, faces, values) : "",
                                     values.text("outputs." + name + ".along"),
                                     measure.measure,
                                     {},
                                     {}};
        if (!at_point.empty()) output.point_m = point_of(item, values);
        check_measure(values, "outputs." + name, measure);
        for (const Item& other : items)
            if (other.key.path == "outputs." + name + ".reference")
                output.reference = single_face(other, faces, values);
        if (!output.face.empty() && output.reference == output.face)
            throw values.refuse("outputs." + name + ".reference", "a face has no bend relative to itself",
                                "name the fixed face");
        outputs.push_back(std::move(output));
    }
    return outputs;
}

}  // namespace soft::design
