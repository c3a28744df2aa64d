#include "design/sections.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "design/common_keys.hpp"

namespace soft::design {
namespace {

void check_output_name(const Member& output) {
    constexpr std::size_t longest = 40;
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const bool fine = is_letter(output.key.front()) && output.key.size() <= longest &&
                      std::all_of(output.key.begin(), output.key.end(),
                                  [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; });
    if (!fine)
        refuse(output.place, "outputs." + output.key, "not a name of an output",
               "letters, digits and _, a letter first, at most 40");
    const auto& taken = until_quantities();
    if (std::find(taken.begin(), taken.end(), output.key) != taken.end() || output.key == "volume" ||
        output.key == "step")
        refuse(output.place, "outputs." + output.key, "the name is that of a quantity every path has",
               "call the output otherwise");
}

/// Components of a support in the model's own coordinates (axisymmetric: x, r).
std::array<bool, 3> components_of(const std::string& component, const Values& values, const std::string& path) {
    const bool axisymmetric = values.text("model") == "axisymmetric", plane = values.text("model") == "plane-strain";
    if (component == "fixed")
        return axisymmetric || plane ? std::array{true, true, false} : std::array{true, true, true};
    if (component == "x") return {true, false, false};
    if (plane && component != "y")
        throw values.refuse(path, "a plane strain model has the components x and y", "use x, y or fixed");
    // Radial on a solid: y and z together, which leaves only x free.
    if (component == "r") return axisymmetric ? std::array{false, true, false} : std::array{false, true, true};
    if (axisymmetric) throw values.refuse(path, "an axisymmetric model has the components x and r", "use r, or fixed");
    return component == "y" ? std::array{false, true, false} : std::array{false, false, true};
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
    if (!values.has("model")) return;  // what solve changes: the direction is that of the case
    const std::string& model = values.text("model");
    const std::string& along = values.text(path);
    if (model == "axisymmetric" && (along == "y" || along == "z"))
        throw values.refuse(path, "an axisymmetric model has the directions x and r", "use axis, x or r");
    if (model == "plane-strain" && (along == "z" || along == "r"))
        throw values.refuse(path, "a plane strain model has the directions x and y", "use axis, x, y or normal");
}

void add_support_keys(Schema& schema, const Node& root) {
    const auto& components = support_components();
    schema.names["supports"] = components;
    for (const Member& support : members_of(root, "supports")) {
        if (std::find(components.begin(), components.end(), support.key) != components.end()) {
            schema.keys.push_back(support_key(support.key));
        } else if (!resolve_face(schema.faces, support.key).empty()) {
            refuse(support.place, "supports." + support.key, "a face stands where a component is needed",
                   "write fixed: " + support.key);
        }
    }
}

void add_output_keys(Schema& schema, const Node& root, const Node& defaults) {
    for (const Member& output : members_of(root, "outputs")) {
        check_output_name(output);
        schema.keys.push_back(output_face_key(output.key));
        const Node* along = find_path(defaults, "outputs." + output.key + ".along");
        schema.keys.push_back(output_along_key(output.key, along == nullptr ? "axis" : along->text));
    }
}

void add_path_keys(Schema& schema, const Node& root) {
    const auto& loads = members_of(root, "loads");
    const bool cavity = std::any_of(loads.begin(), loads.end(), [&](const Member& load) {
        return resolve_face(schema.faces, load.key) == cavity_name && find_member(load.value, "pressure") != nullptr;
    });
    schema.keys.push_back(control_key(cavity ? "volume" : "pressure"));
    std::vector<std::string> ends = until_quantities();
    for (const Member& output : members_of(root, "outputs")) ends.push_back(output.key);
    for (const Member& until : members_of(root, "path.until"))
        if (std::find(ends.begin(), ends.end(), until.key) != ends.end()) schema.keys.push_back(until_key(until.key));
    schema.names["path.until"] = std::move(ends);
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
        const std::string name = name_between(item.key.path, "outputs.", ".face");
        if (name.empty()) continue;
        if (item.list.size() != 1)
            throw values.refuse(item.key.path, "an output is measured on one face", "make one output a face");
        const std::string along = "outputs." + name + ".along";
        check_direction(values, along);
        outputs.push_back({name, resolve_face(faces, item.list.front()), values.text(along)});
    }
    return outputs;
}

model::PathSettings path_of(std::span<const Item> items, const Values& values) {
    static const std::map<std::string, model::Control> controls = {{"pressure", model::Control::pressure},
                                                                   {"volume", model::Control::volume},
                                                                   {"displacement", model::Control::displacement},
                                                                   {"arc-length", model::Control::arc_length}};
    const bool cavity = values.has("loads." + std::string{cavity_name} + ".pressure");
    const bool pressed = std::any_of(items.begin(), items.end(), [](const Item& item) {
        return !name_between(item.key.path, "loads.", ".pressure").empty();
    });
    model::PathSettings path;
    path.control = controls.at(values.text("path.control"));
    if (path.control == model::Control::volume && !cavity)
        throw values.refuse("path.control", "no cavity is loaded, so there is no volume to prescribe", "use pressure");
    for (const Item& item : items) {
        const std::string quantity = name_between(item.key.path, "path.until.", "");
        if (quantity.empty()) continue;
        if (item.entry.number == 0)
            throw values.refuse(item.key.path, "0 is where the path starts", "write where it shall end");
        if (quantity == "volume_ratio" && !cavity)
            throw values.refuse(item.key.path, "no cavity is loaded, so there is no volume", "use pressure or steps");
        if (quantity == "pressure" && !pressed)
            throw values.refuse(item.key.path, "no load is a pressure", "use an output or steps");
        path.until.push_back({quantity, item.entry.number});
    }
    return path;
}

model::SolverSettings solver_of(const Values& values) {
    return {.residual_tolerance = values.number("solver.residual_tolerance"),
            .newton_limit = values.count("solver.newton_limit"),
            .first_step = values.number("solver.first_step"),
            .largest_step = values.number("solver.largest_step"),
            .smallest_step = values.number("solver.smallest_step"),
            .step_limit = values.count("solver.step_limit"),
            .step_accuracy = values.number("solver.step_accuracy")};
}

}  // namespace soft::design
