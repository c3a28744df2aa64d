/// Materials with constants in the ranges of silicones and their fits, and loads that exceed the limit load of most designs.
#include <algorithm>
#include <array>
#include <functional>

#include "../material/examples.hpp"
#include "core/text.hpp"
#include "draw_parts.hpp"

namespace soft::campaign {
namespace {

constexpr double min_modulus_kPa = 10, max_modulus_kPa = 1000;  // initial shear modulus: gels to filled grades
/// Full pressure in units of modulus / slenderness, which is about the limit pressure of a thin neo-Hookean shell.
constexpr double min_load = 0.1, max_load = 30;

std::string list(const std::vector<double>& values) {
    std::vector<std::string> texts;
    for (const double value : values) texts.push_back(number(value));
    return "[" + core::join(texts) + "]";
}

std::string pressures(const std::vector<double>& values_kPa) {
    std::vector<std::string> texts;
    for (const double value : values_kPa) texts.push_back(kPa(value));
    return "[" + core::join(texts) + "]";
}

Settings mu_alone(Dice&, double mu) { return {{"mu", kPa(mu)}}; }

Settings mooney_rivlin(Dice& dice, double mu) {
    const double share = dice.between(0.5, 1), c = mu / 2;
    Settings settings{{"c10", kPa(c * share)}, {"c01", kPa(c * (1 - share))}};
    if (dice.chance(0.4))
        for (const char* key : {"c20", "c11", "c02"}) settings.emplace_back(key, kPa(c * dice.between(-0.01, 0.04)));
    return settings;
}

Settings yeoh(Dice& dice, double mu) {
    const double c = mu / 2;
    return {{"c1", kPa(c)}, {"c2", kPa(c * dice.between(-0.03, 0.1))}, {"c3", kPa(c * dice.between(-2e-4, 5e-3))}};
}

Settings ogden(Dice& dice, double mu) {
    const int terms = dice.whole(1, 3);
    static constexpr std::array low{1.2, 2.0, -4.0}, high{2.5, 7.0, -1.0};
    std::vector<double> mus, alphas;
    for (int i = 0; i < terms; ++i) {
        alphas.push_back(dice.between(low.at(static_cast<std::size_t>(i)), high.at(static_cast<std::size_t>(i))));
        mus.push_back(2 * mu / alphas.back() * (i == 0 ? 1 : dice.between(0, 0.1)));
    }
    return {{"mu", pressures(mus)}, {"alpha", list(alphas)}};
}

Settings gent(Dice& dice, double mu) { return {{"mu", kPa(mu)}, {"jm", number(dice.between_logs(3, 200))}}; }

Settings arruda_boyce(Dice& dice, double mu) {
    return {{"mu", kPa(mu)}, {"locking_stretch", number(dice.between_logs(1.3, 7))}};
}

Settings holzapfel_gasser_ogden(Dice& dice, double mu) {
    return {{"mu", kPa(mu)},
            {"k1", kPa(mu * dice.between_logs(0.1, 10))},
            {"k2", number(dice.between_logs(0.1, 5))},
            {"angle", number(dice.between(0, 90)) + " deg"},
            {"families", "2"}};
}

/// The example of the catalogue, scaled to the modulus.
Settings example(const material::LawInfo& law, double mu) {
    material::Constants constants = material::example_constants(law.name);
    const double scale = mu / material::initial_shear_modulus_Pa(material::make_unchecked_rubber(law.name, constants));
    Settings settings;
    for (const material::Parameter& parameter : law.parameters) {
        std::string text{parameter.example};
        if (parameter.quantity == material::Quantity::pressure) {
            std::vector<double>& values = constants.at(std::string(parameter.name));
            for (double& value : values) value *= scale;
            text = parameter.max_count == 1 ? kPa(values.front()) : pressures(values);
        }
        settings.emplace_back(parameter.name, text);
    }
    return settings;
}

struct Law {
    std::string_view name;
    std::function<Settings(Dice&, double mu_kPa)> constants;
    double weight;
    bool needs_kappa = false;
};

/// All laws of the catalogue; those without an entry with the constants of their example.
const std::vector<Law>& laws() {
    static const std::vector<Law> all = [] {
        std::vector<Law> laws{{"neo-hookean", mu_alone, 16},
                              {"neo-hookean-compressible", mu_alone, 8},
                              {"mooney-rivlin", mooney_rivlin, 13},
                              {"yeoh", yeoh, 15},
                              {"ogden", ogden, 15},
                              {"gent", gent, 9},
                              {"arruda-boyce", arruda_boyce, 9},
                              {"holzapfel-gasser-ogden", holzapfel_gasser_ogden, 6},
                              {"saint-venant-kirchhoff", mu_alone, 3, true},
                              {"linear-elastic", mu_alone, 2, true},
                              {"kraken", mu_alone, 2, true}};
        for (const material::LawInfo& law : material::laws())
            if (std::ranges::find(laws, law.name, &Law::name) == laws.end())
                laws.push_back({law.name, [&law](Dice&, double mu) { return example(law, mu); }, 8,
                                law.bulk == material::Bulk::finite});
        return laws;
    }();
    return all;
}

const Law& draw_law(Dice& dice) {
    double all = 0;
    for (const Law& law : laws()) all += law.weight;
    double left = dice.between(0, all);
    for (const Law& law : laws())
        if ((left -= law.weight) < 0) return law;
    return laws().front();
}

const std::vector<std::string> silicones{"dragon-skin-20",    "ecoflex-00-30",  "ecoflex-00-50",
                                         "mold-star-16-fast", "platsil-gel-10", "rtv615"};

/// All kinds of cavity loads. `p`: full pressure.
Load cavity_load(Dice& dice, const Shape& shape, double p) {
    const std::string cavity = shape.cavities.front();
    const bool one = shape.cavities.size() == 1;
    std::string group = one ? "{cavity: " : "{cavities: {" + cavity + ": ", end = one ? "}" : "}}";
    if (shape.family == "two-spheres") end = ", right: {shares: left}" + end;
    const auto loads = [&](const std::string& what) { return group + what + end; };
    const auto pressed = [&](double pressure) { return loads("{pressure: " + kPa(pressure) + "}"); };
    const double kind = dice.between(0, 1);
    if (kind < 0.42) {
        const std::string sealed = dice.chance(0.3) && shape.family != "two-spheres" ? ", sealed: false" : "";
        return {"cavity pressure", {{"loads", loads("{pressure: " + kPa(p) + sealed + "}")}}};
    }
    if (kind < 0.56) return {"vacuum", {{"loads", pressed(-p)}}};
    if (kind < 0.66)
        return {"volume", {{"loads", loads("{volume_ratio: " + number(dice.between_logs(1.2, 40)) + "}")}}};
    if (kind < 0.70)
        return {"less volume", {{"loads", loads("{volume_ratio: " + number(dice.between(0.02, 0.9)) + "}")}}};
    if (kind < 0.78)
        return {"gas",
                {{"loads", loads("{mass: " + number(1.204 * shape.gas_mL * dice.between_logs(0.05, 10)) + " mg}")}}};
    if (kind < 0.90) {
        Settings settings{{"loads", pressed(p)},
                          {"path.stages", "{inflate: {loads: " + pressed(0.3 * p) + "}, hold: {}, vent: {loads: " +
                                              pressed(0) + "}, vacuum: {loads: " + pressed(-0.3 * p) + "}}"}};
        return {"stages", std::move(settings)};
    }
    if (shape.load_faces.empty()) return {"cavity pressure", {{"loads", pressed(p)}}};
    std::string both = pressed(p);
    both.insert(both.size() - 1, ", " + shape.load_faces.front() +
                                     ": {force: " + number(p * 1e-3 * dice.between(-20, 20)) + " N, along: axis}");
    return {"pressure and force", {{"loads", both}}};
}

Load face_load(Dice& dice, const Shape& shape, double p) {
    if (!shape.load_faces.empty() && (shape.pressure_faces.empty() || dice.chance(0.6))) {
        const std::string face = shape.load_faces.front(),
                          along = dice.one_of(std::vector<std::string>{"x", "y", "axis"});
        const std::string direction = shape.model == "axisymmetric" ? "axis" : shape.model == "quarter" ? "x" : along;
        if (dice.chance(0.4))
            return {"motion",
                    {{"loads",
                      "{" + face + ": {displacement: " + mm(dice.between(-30, 60)) + ", along: " + direction + "}}"}}};
        return {"traction",
                {{"loads", "{" + face + ": {traction: " + kPa(dice.between(-p, p)) + ", along: " + direction + "}}"}}};
    }
    const double sign = dice.chance(0.5) ? 1 : -1;
    return {"face pressure",
            {{"loads", "{" + dice.one_of(shape.pressure_faces) + ": {pressure: " + kPa(sign * p) + "}}"}}};
}

}  // namespace

std::string number(double value) { return core::rounded_text(value, 5); }
std::string mm(double value) { return number(value) + " mm"; }
std::string kPa(double value) { return number(value) + " kPa"; }

DrawnMaterial draw_material(Dice& dice, const Shape& shape) {
    DrawnMaterial material;
    if (dice.chance(0.06)) {
        const std::string name = dice.one_of(silicones);
        return {name, 100, {{"material", name}}};
    }
    const Law& law = draw_law(dice);
    material.law = law.name;
    material.mu_kPa = dice.between_logs(min_modulus_kPa, max_modulus_kPa);
    material.settings.emplace_back("material.law", law.name);
    for (const auto& [key, value] : law.constants(dice, material.mu_kPa))
        material.settings.emplace_back("material." + key, value);
    const double kind = dice.between(0, 1);
    const double ratio = kind < 0.65 ? dice.between_logs(20, 5000) : dice.between(1, 20);
    const bool bounded = law.needs_kappa || kind > 0.35;
    const bool is_kraken = material.law == "kraken", is_linear = material.law == "linear-elastic";
    if (bounded) material.settings.emplace_back("material.kappa", kPa(material.mu_kPa * ratio));
    if (bounded && !is_linear && !is_kraken && dice.chance(0.4))
        material.settings.emplace_back("material.volumetric",
                                       dice.one_of(std::vector<std::string>{"quadratic", "log", "mixed"}));
    if (is_kraken || (bounded && ratio < 20 && dice.chance(0.3)))
        material.settings.emplace_back("mesh.formulation", "displacement");
    else if (bounded && !is_linear && shape.table_text.empty() && shape.model != "solid" && shape.family != "pneunet" &&
             dice.chance(0.05))
        material.settings.insert(material.settings.end(), {{"mesh.formulation", "f-bar"}, {"mesh.order", "1"}});
    if (dice.chance(0.04)) material.settings.emplace_back("mesh.cells", "simplices");
    return material;
}

Load draw_motion_or_tiny_load(Dice& dice, Shape& shape, const DrawnMaterial& material) {
    if (!shape.load_faces.empty() && dice.chance(0.65)) {
        double max_mm = 2;
        if (shape.family == "rod") {  // from flat pads to slender rods
            const double length = dice.between_logs(2, 60);
            max_mm = 0.1 * length;
            shape.settings.emplace_back("geometry.length", mm(length));
            shape.settings.emplace_back("mesh.size", mm(std::max(length, 4.0) / dice.whole(1, 4)));
        }
        const double way = (dice.chance(0.5) ? 1 : -1) * max_mm * dice.between_logs(1e-4, 1);
        const std::string along = shape.model == "axisymmetric" || dice.chance(0.7) ? "axis" : "x";
        return {
            "small motion",
            {{"loads", "{" + shape.load_faces.front() + ": {displacement: " + mm(way) + ", along: " + along + "}}"}}};
    }
    const double p = (dice.chance(0.5) ? 1 : -1) * material.mu_kPa / shape.slenderness * dice.between_logs(1e-12, 1e-8);
    const std::string pressure = "{pressure: " + kPa(p) + "}";
    if (!shape.cavities.empty() && shape.family != "two-spheres")
        return {
            "tiny load",
            {{"loads", shape.cavities.size() == 1 ? "{cavity: " + pressure + "}"
                                                  : "{cavities: {" + shape.cavities.front() + ": " + pressure + "}}"}}};
    if (!shape.pressure_faces.empty())
        return {"tiny load", {{"loads", "{" + dice.one_of(shape.pressure_faces) + ": " + pressure + "}"}}};
    return draw_load(dice, shape, material);
}

Load draw_load(Dice& dice, const Shape& shape, const DrawnMaterial& material) {
    const double p = material.mu_kPa / shape.slenderness * dice.between_logs(min_load, max_load);
    const bool on_cavity = !shape.cavities.empty() && !dice.chance(0.12);
    Load load = on_cavity || (shape.pressure_faces.empty() && shape.load_faces.empty()) ? cavity_load(dice, shape, p)
                                                                                        : face_load(dice, shape, p);
    if (load.kind == "traction" && dice.chance(0.2)) {
        load.kind = "gravity";
        load.settings = {
            {"loads", "{gravity: {acceleration: " + number(dice.between_logs(10, 3000)) + " m/s^2, along: -x}}"},
            {"material.density", "1080 kg/m^3"}};
    }
    const double control = dice.between(0, 1);
    const bool by_pressure = load.kind == "cavity pressure" || load.kind == "vacuum" || load.kind == "face pressure";
    if (by_pressure && control < 0.12) load.settings.emplace_back("path.control", "pressure");
    if (by_pressure && control > 0.94) load.settings.emplace_back("path.control", "arc-length");
    if (by_pressure && on_cavity && control > 0.88 && control < 0.94)
        load.settings.emplace_back("path.control", "volume");
    if (dice.chance(0.05)) load.settings.emplace_back("path.branch", "follow");
    if (dice.chance(0.3)) load.settings.emplace_back("path.stretch_limit", number(dice.between(3, 8)));
    return load;
}

}  // namespace soft::campaign
