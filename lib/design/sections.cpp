#include "design/sections.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/materials.hpp"

namespace soft::design {
namespace {

const std::vector<Member>& members_of(const Node& root, std::string_view path) {
    static const std::vector<Member> none;
    const Node* node = find_path(root, path);
    return node == nullptr ? none : node->members;
}

bool has_cavity(const FaceNames& faces) { return resolve_face(faces, cavity_name) == cavity_name; }

/// Middle of "loads.<name>.pressure"; empty if the path is no such.
std::string name_between(const std::string& path, std::string_view prefix, std::string_view suffix) {
    if (!path.starts_with(prefix) || !path.ends_with(suffix) || path.size() <= prefix.size() + suffix.size()) return {};
    return path.substr(prefix.size(), path.size() - prefix.size() - suffix.size());
}

[[noreturn]] void refuse_law(const Node& law) {
    const auto reserved = reserved_law_names();
    const std::string available = core::join(law_names());
    if (std::find(reserved.begin(), reserved.end(), law.text) != reserved.end())
        refuse(law.place, "material.law", "law " + core::quoted(law.text) + " is not in this version",
               "available: " + available);
    refuse(law.place, "material.law", "no law is called " + core::quoted(law.text),
           core::did_you_mean(law.text, law_names()));
}

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
    const bool axisymmetric = values.text("model") == "axisymmetric";
    if (component == "fixed") return axisymmetric ? std::array{true, true, false} : std::array{true, true, true};
    if (component == "x") return {true, false, false};
    // Radial on a solid: y and z together, which leaves only x free.
    if (component == "r") return axisymmetric ? std::array{false, true, false} : std::array{false, true, true};
    if (axisymmetric) throw values.refuse(path, "an axisymmetric model has the components x and r", "use r, or fixed");
    return component == "y" ? std::array{false, true, false} : std::array{false, false, true};
}

}  // namespace

void add_material_keys(Schema& schema, const Node& root, std::string_view source, Examples& examples) {
    const Node* material = find(root, "material");
    if (material == nullptr || material->kind == Node::Kind::empty)
        refuse(material == nullptr ? std::string{source} + ":1:1" : material->place, "material", "missing (the rubber)",
               "add material: {law: neo-hookean, mu: 0.1644 MPa}");
    if (material->kind == Node::Kind::scalar)
        refuse(material->place, "material", "materials by name are not in this version",
               "write {law: neo-hookean, mu: 0.1644 MPa}");
    const Key law_key_ = law_key();
    examples[law_key_.path] = core::join(law_names(), " | ");
    schema.keys.push_back(law_key_);
    const Node* name = find(*material, "law");
    if (name != nullptr && name->kind == Node::Kind::scalar) {
        const Law* law = find_law(name->text);
        if (law == nullptr) refuse_law(*name);
        for (const Constant& constant : law->constants) {
            schema.keys.push_back(constant.key);
            schema.keys.back().path = "material." + constant.key.path;
            examples[schema.keys.back().path] = constant.example;
        }
    }
    schema.keys.push_back(kappa_key());
    schema.keys.push_back(volumetric_key());
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

void add_load_keys(Schema& schema, const Node& root, const Node& defaults, std::string_view source,
                   Examples& examples) {
    for (const Member& load : members_of(defaults, "loads"))
        if (const Node* pressure = find(load.value, "pressure"))
            examples["loads." + load.key + ".pressure"] = pressure->text;
    const auto& loads = members_of(root, "loads");
    if (loads.empty()) {
        const bool cavity = has_cavity(schema.faces);
        const auto& usual = members_of(defaults, "loads");
        const std::string target = !usual.empty() ? usual.front().key : cavity ? std::string{cavity_name} : "face";
        const Member* section = find_member(root, "loads");
        refuse(section == nullptr ? std::string{source} + ":1:1" : section->place, "loads",
               "missing (what drives the actuator)", "add loads: {" + target + ": {pressure: 30 kPa}}");
    }
    schema.names["loads"] = all_names(schema.faces);
    for (const Member& load : loads) {
        const std::string face = resolve_face(schema.faces, load.key);
        if (face.empty()) continue;  // collect() refuses it with the nearest name
        schema.keys.push_back(load_pressure_key(load.key));
        examples.try_emplace(schema.keys.back().path, "30 kPa");
        if (face != cavity_name) {
            if (const Member* sealed = find_member(load.value, "sealed"))
                refuse(sealed->place, "loads." + load.key + ".sealed", "a face has no openings to seal",
                       "leave it out");
            continue;
        }
        const Node* sealed = find_path(defaults, "loads." + load.key + ".sealed");
        schema.keys.push_back(load_sealed_key(load.key, sealed == nullptr ? "true" : sealed->text));
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
        return resolve_face(schema.faces, load.key) == cavity_name;
    });
    schema.keys.push_back(control_key(cavity ? "volume" : "pressure"));
    std::vector<std::string> ends = until_quantities();
    for (const Member& output : members_of(root, "outputs")) ends.push_back(output.key);
    for (const Member& until : members_of(root, "path.until"))
        if (std::find(ends.begin(), ends.end(), until.key) != ends.end()) schema.keys.push_back(until_key(until.key));
    schema.names["path.until"] = std::move(ends);
}

model::Material material_of(const Values& values) {
    model::Material material;
    material.name = "rubber";
    material.law = values.text("material.law");
    for (const Constant& constant : find_law(material.law)->constants)
        material.constants[constant.key.path] = {values.number("material." + constant.key.path)};
    if (values.text("material.kappa") != "incompressible") material.bulk_modulus_Pa = values.number("material.kappa");
    const std::string& volumetric = values.text("material.volumetric");
    material.volumetric = volumetric == "log"     ? model::Volumetric::log
                          : volumetric == "mixed" ? model::Volumetric::mixed
                                                  : model::Volumetric::quadratic;
    return material;
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

std::vector<model::PressureLoad> loads_of(std::span<const Item> items, const FaceNames& faces, const Values& values) {
    std::vector<model::PressureLoad> loads;
    for (const Item& item : items) {
        const std::string name = name_between(item.key.path, "loads.", ".pressure");
        if (name.empty()) continue;
        model::PressureLoad load{.target = resolve_face(faces, name), .pressure_Pa = item.entry.number};
        if (load.pressure_Pa == 0)
            throw values.refuse(item.key.path, "a load of 0 gives no path",
                                "write the pressure at full load, for example 30 kPa");
        const bool twice = std::any_of(loads.begin(), loads.end(),
                                       [&](const model::PressureLoad& other) { return other.target == load.target; });
        if (twice)
            throw values.refuse(item.key.path, "face " + core::quoted(load.target) + " is loaded twice",
                                "keep one of its names");
        const std::string sealed = "loads." + name + ".sealed";
        if (values.has(sealed)) load.sealed = values.text(sealed) == "true";
        loads.push_back(std::move(load));
    }
    return loads;
}

std::vector<Design::OutputRequest> outputs_of(std::span<const Item> items, const FaceNames& faces,
                                              const Values& values) {
    std::vector<Design::OutputRequest> outputs;
    for (const Item& item : items) {
        const std::string name = name_between(item.key.path, "outputs.", ".face");
        if (name.empty()) continue;
        if (item.list.size() != 1)
            throw values.refuse(item.key.path, "an output is measured on one face", "make one output a face");
        const std::string& along = values.text("outputs." + name + ".along");
        if (values.text("model") == "axisymmetric" && (along == "y" || along == "z"))
            throw values.refuse("outputs." + name + ".along", "an axisymmetric model has the directions x and r",
                                "use axis, x or r");
        outputs.push_back({name, resolve_face(faces, item.list.front()), along});
    }
    return outputs;
}

model::PathSettings path_of(std::span<const Item> items, const Values& values) {
    static const std::map<std::string, model::Control> controls = {{"pressure", model::Control::pressure},
                                                                   {"volume", model::Control::volume},
                                                                   {"displacement", model::Control::displacement},
                                                                   {"arc-length", model::Control::arc_length}};
    const bool cavity = values.has("loads." + std::string{cavity_name} + ".pressure");
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
