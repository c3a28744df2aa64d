#include "design/materials.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "design/common_keys.hpp"

namespace soft::design {
namespace {

constexpr std::string_view usual_material = "{law: neo-hookean, mu: 0.1644 MPa}";
constexpr const char *kappa_path = "material.kappa", *young_path = "material.young", *poisson_path = "material.poisson",
                     *volumetric_path = "material.volumetric", *frame_path = "material.frame",
                     *density_path = "material.density", *strain_path = "material.strain", *fit_path = "material.fit";

Kind kind_of(material::Quantity quantity) {
    switch (quantity) {
        case material::Quantity::pressure: return Kind::pressure;
        case material::Quantity::ratio: return Kind::ratio;
        case material::Quantity::angle: return Kind::angle;
        case material::Quantity::count: return Kind::count;
    }
    return Kind::ratio;
}

[[noreturn]] void refuse_law(const Node& law) {
    refuse(law.place, "material.law", "no law is called " + core::quoted(law.text),
           core::did_you_mean(law.text, law_names()) + " (mesh-gen --list-materials)");
}

Key young_key() {
    return {.path = young_path,
            .kind = Kind::pressure,
            .meaning = "Young's modulus, in place of mu and kappa",
            .min = 0,
            .min_open = true};
}

Key poisson_key(const material::LawInfo& law) {
    const bool incompressible = law.bulk == material::Bulk::selectable;
    return {.path = poisson_path,
            .kind = Kind::ratio,
            .meaning = incompressible ? "Poisson's ratio; 0.5 is incompressible"
                                      : "Poisson's ratio below 0.5; the law has no incompressible form",
            .min = -1,
            .max = 0.5,
            .min_open = true};
}

Key density_key() {
    return {.path = density_path,
            .kind = Kind::density,
            .fallback = "none",
            .meaning = "of the undeformed rubber, for gravity and dynamics",
            .min = 0,
            .min_open = true,
            .choices = {"none"}};
}

Key strain_key() {
    return {.path = strain_path,
            .kind = Kind::choice,
            .fallback = "finite",
            .meaning = "finite: the law as it is; small: Hooke's law with its moduli, linear in the displacements",
            .choices = {"finite", "small"}};
}

Key bulk_key(const material::LawInfo& law) {
    Key key = kappa_key();
    if (law.bulk == material::Bulk::selectable) return key;
    key.fallback.clear();
    key.choices.clear();
    key.meaning = "bulk modulus; the law has no incompressible form";
    return key;
}

/// Whether the design states young and poisson; a mixture with mu and kappa is refused.
bool has_young_poisson(const Node& material, const material::LawInfo& law) {
    if (!law.takes_young_poisson) return false;
    const Member *young = nullptr, *other = nullptr;
    for (const Member& member : material.members) {
        if (member.key == "young" || member.key == "poisson") young = &member;
        if (member.key == "mu" || member.key == "kappa") other = &member;
    }
    if (young != nullptr && other != nullptr)
        refuse(other->place, "material." + other->key, "stands beside " + core::quoted(young->key),
               "give young and poisson, or mu and kappa");
    return young != nullptr;
}

/// What fit-material says of the data; only what is there, so that no default stands in an effective design.
void add_fit_keys(Schema& schema, const Node& material) {
    const Node* fit = find(material, "fit");
    if (fit == nullptr) return;
    static const std::vector<std::string> texts = {"name", "choice", "range",  "rmse_kPa", "r2",      "stress",
                                                   "rows", "flags",  "source", "sha256",   "protocol"};
    schema.names[fit_path] = texts;
    for (const Member& member : fit->members) {
        const std::string path = std::string{fit_path} + "." + member.key;
        if (std::ranges::find(texts, member.key) != texts.end())
            schema.keys.push_back({.path = path, .kind = Kind::text, .meaning = "of the data behind the constants"});
        if (member.key == "largest_I1")
            schema.keys.push_back({.path = path, .kind = Kind::ratio, .meaning = "where the data end; solve warns beyond", .min = 3});
    }
    schema.names[fit_path].emplace_back("largest_I1");
}

void add_law_keys(Schema& schema, const Node& material, const material::LawInfo& law, Examples& examples,
                  std::string_view usual_frame) {
    if (has_young_poisson(material, law)) {
        schema.keys.push_back(young_key());
        schema.keys.push_back(poisson_key(law));
        examples[young_path] = "0.49 MPa";
        examples[poisson_path] = "0.49";
    } else {
        for (const material::Parameter& parameter : law.parameters) {
            schema.keys.push_back(parameter_key(parameter));
            examples[schema.keys.back().path] = parameter.example;
        }
        schema.keys.push_back(bulk_key(law));
        examples[kappa_path] = "16.44 MPa";
    }
    if (law.takes_volumetric) {
        schema.keys.push_back(volumetric_key());
        // With ln J this law is the one of the textbooks.
        if (law.name == material::NeoHookeanCompressible::info().name) schema.keys.back().fallback = "log";
    } else if (const Member* volumetric = find_member(material, "volumetric")) {
        refuse(volumetric->place, volumetric_path,
               "the law " + std::string{law.name} + " states its own change of volume", "leave it out");
    }
    schema.keys.push_back(density_key());
    schema.keys.push_back(strain_key());
    add_fit_keys(schema, material);
    if (law.fibers)
        schema.keys.push_back(
            {.path = frame_path,
             .kind = Kind::choice,
             .fallback = std::string{usual_frame},
             .meaning = "fibres lie in the surface of x and the hoop direction about x, or of x and y",
             .choices = {"cylindrical", "cartesian"}});
}

/// An error whose place is a parameter of the law, at that key.
Error at_its_key(const Values& values, const Error& error) {
    const std::string_view line = error.what();
    const auto colon = line.find(": ");
    std::string path = "material." + std::string{line.substr(0, colon)};
    if (!values.has(path)) path = values.has(poisson_path) ? poisson_path : "material.law";
    return values.refuse(path, line.substr(colon == std::string_view::npos ? 0 : colon + 2));
}

model::Material from_young_poisson(const Values& values, model::Material material) {
    const double young_Pa = values.number(young_path), poisson = values.number(poisson_path);
    material.constants["mu"] = {young_Pa / (2.0 * (1.0 + poisson))};
    if (poisson < 0.5) material.bulk_modulus_Pa = young_Pa / (3.0 * (1.0 - 2.0 * poisson));
    return material;
}

}  // namespace

std::vector<std::string> law_names() {
    std::vector<std::string> names;
    for (const material::LawInfo& law : material::laws()) names.emplace_back(law.name);
    return names;
}

Key parameter_key(const material::Parameter& parameter) {
    return {.path = "material." + std::string{parameter.name},
            .kind = kind_of(parameter.quantity),
            .fallback = std::string{parameter.fallback},
            .meaning = std::string{parameter.meaning},
            .min = parameter.min,
            .max = parameter.max,
            .min_open = parameter.min_open,
            .most = parameter.most};
}

void add_material_keys(Schema& schema, const Node& root, std::string_view source, Examples& examples,
                       std::string_view usual_frame) {
    const Node* material = find(root, "material");
    if (material == nullptr || material->kind == Node::Kind::empty)
        refuse(material == nullptr ? std::string{source} + ":1:1" : material->place, "material", "missing (the rubber)",
               "add material: " + std::string{usual_material});
    const Key key = law_key();
    examples[key.path] = core::join(law_names(), " | ");
    schema.keys.push_back(key);
    const Node* name = find(*material, "law");
    if (name == nullptr || name->kind != Node::Kind::scalar) return;  // collect() asks for it
    const material::LawInfo* law = material::find_law(name->text);
    if (law == nullptr) refuse_law(*name);
    add_law_keys(schema, *material, *law, examples, usual_frame);
}

model::Material material_of(const Values& values) {
    static const std::map<std::string, model::Volumetric> volumetrics = {{"quadratic", model::Volumetric::quadratic},
                                                                         {"log", model::Volumetric::log},
                                                                         {"mixed", model::Volumetric::mixed}};
    model::Material material;
    material.name = "rubber";
    material.law = values.text("material.law");
    if (values.has(young_path)) {
        material = from_young_poisson(values, std::move(material));
    } else {
        for (const material::Parameter& parameter : material::find_law(material.law)->parameters)
            material.constants[std::string{parameter.name}] = values.numbers("material." + std::string{parameter.name});
        if (values.text(kappa_path) != "incompressible") material.bulk_modulus_Pa = values.number(kappa_path);
    }
    if (values.text(density_path) != "none") material.density_kg_m3 = values.number(density_path);
    if (values.has(volumetric_path)) material.volumetric = volumetrics.at(values.text(volumetric_path));
    if (values.text(strain_path) == "small") material.strain = model::Strain::small;
    if (values.has(frame_path) && values.text(frame_path) == "cylindrical")
        material.fiber_frame = model::FiberFrame::cylindrical;
    try {
        static_cast<void>(model::make_rubber(material));
    } catch (const Error& error) {
        throw at_its_key(values, error);
    }
    return material;
}

void check_law_formulation(const Values& values, const model::Material& material) {
    static const std::map<std::string, model::Formulation> forms = {{"displacement", material::Form::displacement},
                                                                {"mixed", material::Form::mixed},
                                                                {"f-bar", material::Form::f_bar}};
    constexpr const char* formulation = "mesh.formulation";
    if (!values.has(formulation)) return;
    const std::string reason = material::why_not(model::make_rubber(material), forms.at(values.text(formulation)));
    if (!reason.empty()) throw values.refuse(values.given(formulation) ? formulation : "material.law", reason);
}

}  // namespace soft::design
