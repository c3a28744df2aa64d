#include "design/materials.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "design/common_keys.hpp"
#include "design/setting.hpp"

namespace soft::design {
namespace {

using model::Material;

constexpr std::string_view example_material = "{law: neo-hookean, mu: 0.1644 MPa}";

/// Path of a key in a section, which is "material" or "materials.<name>".
std::string at(const std::string& section, std::string_view key) { return section + "." + std::string{key}; }

Kind kind_of_quantity(material::Quantity quantity) {
    switch (quantity) {
        case material::Quantity::pressure: return Kind::pressure;
        case material::Quantity::ratio: return Kind::ratio;
        case material::Quantity::angle: return Kind::angle;
        case material::Quantity::count: return Kind::count;
    }
    return Kind::ratio;
}

[[noreturn]] void refuse_law(const Node& law, const std::string& section) {
    refuse(law.location, at(section, "law"), "no law is called " + core::quoted(law.text),
           core::did_you_mean(law.text, law_names()) + " (mesh-gen --list-materials)");
}

/// young and poisson, in place of mu and kappa.
std::vector<Key> young_poisson_keys(const material::LawInfo& law) {
    const bool incompressible = law.bulk == material::Bulk::selectable;
    return {value_key("young", Kind::pressure, above(0), "Young's modulus, in place of mu and kappa"),
            value_key("poisson", Kind::ratio, {-1, 0.5, true},
                      incompressible ? "Poisson's ratio; 0.5 is incompressible"
                                     : "Poisson's ratio below 0.5; the law has no incompressible form")};
}

Setting<Material> bulk_setting() {
    return or_word("incompressible",
                   quantity("kappa", &Material::bulk_modulus_Pa, Kind::pressure, above(0), "bulk modulus"));
}

Key bulk_key(const material::LawInfo& law) {
    if (law.bulk == material::Bulk::selectable) return bulk_setting().key;
    return value_key("kappa", Kind::pressure, above(0), "bulk modulus; the law has no incompressible form");
}

/// The settings that do not depend on the law.
const Settings<Material>& common_settings() {
    static const Settings<Material> settings{
        or_word("none", quantity("density", &Material::density_kg_m3, Kind::density, above(0),
                                 "mass density of the undeformed rubber, for gravity and dynamics")),
        choice("strain", &Material::strain, {{"finite", model::Strain::finite}, {"small", model::Strain::small}},
               "finite: the law as it is; small: Hooke's law with its moduli, linear in the displacements")};
    return settings;
}

Setting<Material> volumetric_setting() {
    using model::Volumetric;
    return choice("volumetric", &Material::volumetric,
                  {{"quadratic", Volumetric::quadratic}, {"log", Volumetric::log}, {"mixed", Volumetric::mixed}},
                  "energy of a change of volume J: kappa/2 (J - 1)^2, kappa/2 (ln J)^2 or kappa/4 (J^2 - 1 - 2 ln J)");
}

Setting<Material> frame_setting() {
    return choice("frame", &Material::fiber_frame,
                  {{"cylindrical", model::FiberFrame::cylindrical}, {"cartesian", model::FiberFrame::cartesian}},
                  "plane of the fibres: x and the hoop direction about x (cylindrical), or x and y (cartesian)");
}

/// A material section of the tree.
struct MaterialSection {
    const std::string& section;
    const Node& material;
};

/// Whether the design gives young and poisson; a combination with mu and kappa is rejected.
bool has_young_poisson(const MaterialSection& written, const material::LawInfo& law) {
    if (!law.takes_young_poisson) return false;
    const Member *young = nullptr, *other = nullptr;
    for (const Member& member : written.material.members) {
        if (member.key == "young" || member.key == "poisson") young = &member;
        if (member.key == "mu" || member.key == "kappa") other = &member;
    }
    if (young != nullptr && other != nullptr)
        refuse(other->location, at(written.section, other->key), "cannot be combined with " + core::quoted(young->key),
               "give young and poisson, or mu and kappa");
    return young != nullptr;
}

/// Adds the keys of `fit` that the design contains. They have no defaults, so that none appear in the effective design.
void add_fit_keys(Schema& schema, const MaterialSection& written) {
    const Node* fit = find(written.material, "fit");
    if (fit == nullptr) return;
    const std::string fit_path = at(written.section, "fit");
    static const std::vector<std::string> texts = {"name", "range", "max_error", "rmse_kPa", "r2",      "stress",
                                                   "rows", "flags", "source",    "sha256",   "protocol"};
    schema.names[fit_path] = texts;
    for (const Member& member : fit->members) {
        const std::string path = at(fit_path, member.key);
        if (std::ranges::find(texts, member.key) != texts.end())
            schema.keys.push_back(value_key(path, Kind::text, {}, "description of the test data of the constants"));
        if (member.key == "max_I1")
            schema.keys.push_back(
                value_key(path, Kind::ratio, at_least(3), "largest I1 of the test data; solve warns beyond it"));
    }
    schema.names[fit_path].emplace_back("max_I1");
}

constexpr const char *viscoelastic = "viscoelastic", *softening = "softening", *constants_key = "constants";
constexpr int max_branches = 8;

/// Adds the keys of the inelastic effects that the design has; without them the rubber is elastic.
void add_inelastic_keys(Schema& schema, const MaterialSection& written) {
    const auto add = [&](Key key, int max_count = 1) {
        key.path = at(written.section, key.path);
        key.max_count = max_count;
        schema.keys.push_back(std::move(key));
    };
    schema.names[written.section].insert(schema.names[written.section].end(), {viscoelastic, softening});
    if (find(written.material, viscoelastic) != nullptr) {
        add(choice_key(constants_key, "long-term", {"long-term", "instantaneous"},
                       "what the constants of the law describe: very slow or very fast loading"));
        add(value_key("viscoelastic.moduli", Kind::ratio, at_least(0),
                      "stiffness of each Maxwell element, relative to the long-term stiffness"),
            max_branches);
        add(value_key("viscoelastic.times", Kind::time, {1e-9, 1e12}, "relaxation time of each Maxwell element"),
            max_branches);
    }
    if (find(written.material, softening) == nullptr) return;
    add(value_key("softening.r", Kind::ratio, above(1), "Ogden-Roxburgh r: the stress falls at most to 1 - 1/r"));
    add(value_key("softening.m", Kind::pressure, above(0), "Ogden-Roxburgh m: energy of the transition"));
    add(with_default("0", value_key("softening.beta", Kind::ratio, at_least(0),
                                    "Ogden-Roxburgh beta: growth of the transition with the largest energy")));
}

std::optional<material::Inelastic> inelastic_of(const Values& values, const std::string& section) {
    material::Inelastic inelastic;
    if (const std::string moduli = at(section, "viscoelastic.moduli"); values.has(moduli)) {
        inelastic.moduli = values.numbers(moduli);
        inelastic.times_s = values.numbers(at(section, "viscoelastic.times"));
        inelastic.instantaneous = values.text(at(section, constants_key)) == "instantaneous";
    }
    if (values.has(at(section, "softening.r")))
        inelastic.softening = {values.number(at(section, "softening.r")), values.number(at(section, "softening.m")),
                               values.number(at(section, "softening.beta"))};
    if (inelastic.moduli.empty() && !inelastic.softening) return std::nullopt;
    return inelastic;
}

void add_law_keys(Schema& schema, const MaterialSection& written, const material::LawInfo& law, Examples& examples,
                  std::string_view default_frame) {
    const auto add = [&](Key key, std::string_view example = {}) {
        key.path = at(written.section, key.path);
        if (!example.empty()) examples[key.path] = example;
        schema.keys.push_back(std::move(key));
    };
    if (has_young_poisson(written, law)) {
        for (const Key& key : young_poisson_keys(law)) add(key, key.path == "young" ? "0.49 MPa" : "0.49");
    } else {
        for (const material::Parameter& parameter : law.parameters) add(parameter_key(parameter), parameter.example);
        add(bulk_key(law), "16.44 MPa");
    }
    if (law.takes_volumetric) {
        add(volumetric_setting().key);
        // With ln J this law is the standard compressible neo-Hookean law of the textbooks.
        if (law.name == material::NeoHookeanCompressible::info().name) schema.keys.back().fallback = "log";
    } else if (const Member* volumetric = find_member(written.material, "volumetric")) {
        refuse(volumetric->location, at(written.section, "volumetric"),
               "the law " + std::string{law.name} + " defines its own volumetric energy", "leave it out");
    }
    for (const Setting<Material>& setting : common_settings()) add(setting.key);
    add_inelastic_keys(schema, written);
    add_fit_keys(schema, written);
    if (!law.fibers) return;
    add(frame_setting().key);
    schema.keys.back().fallback = default_frame;
}

/// Converts an error about a parameter of the law to an error at the key of that parameter.
Error error_at_key(const Values& values, const std::string& section, const Error& error) {
    const std::string_view line = error.what();
    const auto colon = line.find(": ");
    std::string path = at(section, line.substr(0, colon));
    if (!values.has(path)) path = at(section, values.has(at(section, "poisson")) ? "poisson" : "law");
    return values.refuse(path, line.substr(colon == std::string_view::npos ? 0 : colon + 2));
}

Material from_young_poisson(const Values& values, Material material) {
    const double young_Pa = values.number(at(material.source, "young")),
                 poisson = values.number(at(material.source, "poisson"));
    material.constants["mu"] = {young_Pa / (2.0 * (1.0 + poisson))};
    if (poisson < 0.5) material.bulk_modulus_Pa = young_Pa / (3.0 * (1.0 - 2.0 * poisson));
    return material;
}

void add_section_keys(Schema& schema, const MaterialSection& written, Examples& examples,
                      std::string_view default_frame) {
    schema.keys.push_back(choice_key(at(written.section, "law"), "", law_names(), "constitutive law of the rubber"));
    examples[schema.keys.back().path] = core::join(law_names(), " | ");
    const Node* name = find(written.material, "law");
    if (name == nullptr || name->kind != Node::Kind::scalar) return;  // collect() reports the missing law
    const material::LawInfo* law = material::find_law(name->text);
    if (law == nullptr) refuse_law(*name, written.section);
    add_law_keys(schema, written, *law, examples, default_frame);
}

/// The same characters are allowed for cell regions in mesh files.
bool is_region_name(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
}

}  // namespace

std::vector<std::string> law_names() {
    std::vector<std::string> names;
    for (const material::LawInfo& law : material::laws()) names.emplace_back(law.name);
    return names;
}

Key parameter_key(const material::Parameter& parameter) {
    return {.path = std::string{parameter.name},
            .kind = kind_of_quantity(parameter.quantity),
            .fallback = std::string{parameter.fallback},
            .meaning = std::string{parameter.meaning},
            .min = parameter.min,
            .max = parameter.max,
            .min_open = parameter.min_open,
            .max_count = parameter.max_count};
}

void add_material_keys(Schema& schema, const Node& root, std::string_view source, Examples& examples,
                       std::string_view default_frame) {
    const Node* material = find(root, main_material);
    if (material == nullptr || material->kind == Node::Kind::empty)
        refuse(material == nullptr ? std::string{source} + ":1:1" : material->location, "material",
               "missing (the rubber)", "add material: " + std::string{example_material});
    add_section_keys(schema, {std::string{main_material}, *material}, examples, default_frame);
    schema.names[std::string{materials_group}];
    for (const Member& own : members_of(root, materials_group)) {
        const std::string section = at(std::string{materials_group}, own.key);
        if (!is_region_name(own.key))
            refuse(own.location, section, "not a name of a material", "letters, digits, _ and -");
        if (own.value.kind == Node::Kind::empty)
            refuse(own.location, section, "has no value", "write " + own.key + ": " + std::string{example_material});
        add_section_keys(schema, {section, own.value}, examples, default_frame);
    }
}

Material material_of(const Values& values, const std::string& section) {
    const auto path = [&](std::string_view key) { return at(section, key); };
    Settings<Material> settings = common_settings();
    for (const auto& setting : {bulk_setting(), volumetric_setting(), frame_setting()}) settings.push_back(setting);
    Material material = read_settings(settings, values, section);
    material.name = "rubber";
    material.source = section;
    material.law = values.text(path("law"));
    if (values.has(path("young"))) {
        material = from_young_poisson(values, std::move(material));
    } else {
        for (const material::Parameter& parameter : material::find_law(material.law)->parameters)
            material.constants[std::string{parameter.name}] = values.numbers(path(parameter.name));
    }
    material.inelastic = inelastic_of(values, section);
    try {
        static_cast<void>(model::make_rubber(material));
    } catch (const Error& error) {
        throw error_at_key(values, section, error);
    }
    return material;
}

std::map<std::string, model::Material, std::less<>> materials_of(const Values& values) {
    std::map<std::string, Material, std::less<>> materials;
    for (const std::string& name : values.names_below(materials_group)) {
        Material& material = materials[name] = material_of(values, at(std::string{materials_group}, name));
        material.name = name;
    }
    return materials;
}

std::vector<std::string> material_sections(const Values& values) {
    std::vector<std::string> sections{std::string{main_material}};
    for (const std::string& name : values.names_below(materials_group))
        sections.push_back(at(std::string{materials_group}, name));
    return sections;
}

void require_density(const Values& values, std::string_view needed_by) {
    for (const std::string& section : material_sections(values))
        if (values.text(at(section, "density")) == "none")
            throw values.refuse(needed_by,
                                section == main_material ? "the rubber has no density" : section + " has no density",
                                "add " + section + ": {density: 1080 kg/m^3}, that of the undeformed rubber");
}

void check_law_formulation(const Values& values, const Material& material) {
    static const std::map<std::string, model::Formulation> forms = {{"displacement", material::Form::displacement},
                                                                    {"mixed", material::Form::mixed},
                                                                    {"f-bar", material::Form::f_bar}};
    constexpr const char* formulation = "mesh.formulation";
    if (!values.has(formulation)) return;
    const std::string reason =
        material::explain_incompatibility(model::make_rubber(material), forms.at(values.text(formulation)));
    if (!reason.empty())
        throw values.refuse(values.given(formulation) ? formulation : at(material.source, "law"), reason);
}

void check_formulation(const Values& values) {
    const auto has_value = [&](const char* path, std::string_view word) {
        return values.has(path) && values.text(path) == word;
    };
    constexpr const char* formulation = "mesh.formulation";
    const bool first_order = values.has("mesh.order") && values.text("mesh.order") == "1";
    const bool second_order = values.has("mesh.order") && values.text("mesh.order") == "2";
    if (has_value(formulation, "mixed") && first_order)
        throw values.refuse(values.given("mesh.order") ? "mesh.order" : formulation,
                            "first-order cells have no stable pair with a pressure (formulation: mixed)",
                            "order: 2, or formulation: f-bar for quadrilaterals and hexahedra");
    if (has_value(formulation, "f-bar")) {
        if (second_order)
            throw values.refuse(formulation, "f-bar is for first-order cells",
                                "add order: 1, or take formulation: mixed");
        if (has_value("mesh.cells", "simplices"))
            throw values.refuse(formulation,
                                "f-bar does nothing for triangles and tetrahedra: their change of volume is constant",
                                "cells: auto, or formulation: mixed with order: 2");
    }
    if (!values.has(formulation) || has_value(formulation, "mixed")) return;
    for (const std::string& section : material_sections(values))
        if (const std::string kappa = section + ".kappa"; has_value(kappa.c_str(), "incompressible"))
            throw values.refuse(formulation, values.text(formulation) + " needs a finite bulk modulus",
                                "formulation: mixed, or a value for " + kappa);
}

}  // namespace soft::design
