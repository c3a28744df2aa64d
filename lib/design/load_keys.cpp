#include "design/load_keys.hpp"

#include "core/text.hpp"
#include "design/common_keys.hpp"

namespace soft::design {
namespace {

using model::DeadLoadKind, model::Gas, model::PressureLoad, model::Prescription;

constexpr double adiabatic_exponent = 1.4;  // ratio of the specific heats of air
constexpr const char *acts_on = "acts_on", *line_resistance = "line.resistance";

Key direction_key(std::string meaning) { return choice_key("along", "", directions(), std::move(meaning)); }

Key signed_direction_key(std::string meaning) {
    std::vector<std::string> choices = directions();
    for (const std::string& direction : directions()) choices.push_back("-" + direction);
    return choice_key("along", "", std::move(choices), std::move(meaning));
}

std::vector<LoadForm> cavity_forms() {
    using enum LoadKind;
    constexpr LoadTarget cavity = LoadTarget::cavity;
    return {
        {.target = cavity,
         .kind = gas,
         .magnitude = value_key("pressure", Kind::pressure, {},
                                "gauge pressure @; positive acts against the surface and inflates a cavity; a cavity "
                                "may have volume, volume_ratio, mass or valve instead"),
         .example = "30 kPa"},
        {.target = cavity,
         .kind = gas,
         .magnitude =
             value_key("volume", Kind::volume, above(0), "enclosed volume @, of all cavities that share the gas"),
         .example = "100 mL",
         .what = Prescription::volume},
        {.target = cavity,
         .kind = gas,
         .magnitude = value_key("volume_ratio", Kind::ratio, above(0),
                                "enclosed volume over its undeformed value @, of all cavities that share the gas"),
         .example = "3",
         .what = Prescription::volume_ratio},
        {.target = cavity,
         .kind = gas,
         .magnitude = value_key("mass", Kind::mass, {},
                                "mass of gas injected @ since the start of the path, in addition to the gas that "
                                "fills the undeformed cavity"),
         .example = "50 mg",
         .what = Prescription::mass},
        {.target = cavity,
         .kind = gas,
         .magnitude = choice_key("valve", "", {"closed"}, "closed: the mass of gas in the cavity stays constant"),
         .example = "closed",
         .what = Prescription::closed},
        {.target = cavity,
         .kind = shared_gas,
         .magnitude =
             choice_key("shares", "", {}, "cavity whose gas this one shares: one pressure, and the volumes add up"),
         .example = "",
         .takes_time_function = false}};
}

std::vector<LoadForm> other_forms() {
    using enum LoadKind;
    const Key traction_along = signed_direction_key(
        "direction of a positive traction or force; normal points out of the undeformed face, axis is the direction in "
        "which the actuator gets longer");
    return {{.target = LoadTarget::face,
             .kind = face_pressure,
             .magnitude = cavity_forms().front().magnitude,
             .example = "30 kPa"},
            {.target = LoadTarget::face,
             .kind = dead_load,
             .magnitude = value_key("traction", Kind::pressure, {},
                                    "force per undeformed area @; its direction stays fixed in space"),
             .example = "30 kPa",
             .along = traction_along,
             .dead_load = DeadLoadKind::traction},
            {.target = LoadTarget::face,
             .kind = dead_load,
             .magnitude = value_key("force", Kind::force, {},
                                    "dead force on the whole face of the whole actuator @, spread evenly over the "
                                    "undeformed face; its direction stays fixed in space"),
             .example = "2 N",
             .along = traction_along,
             .dead_load = DeadLoadKind::force},
            {.target = LoadTarget::face,
             .kind = motion,
             .magnitude = value_key("displacement", Kind::length, {},
                                    "prescribed motion of the whole face @; its other components stay free"),
             .example = "10 mm",
             .along = direction_key("prescribed displacement component; normal or axis only where parallel to a "
                                    "coordinate direction"),
             .takes_time_function = false},
            {.target = LoadTarget::gravity,
             .kind = dead_load,
             .magnitude = value_key("acceleration", Kind::acceleration, {},
                                    "force per mass of the rubber @; needs material.density"),
             .example = "9.81 m/s^2",
             .along = choice_key("along", "", {"x", "y", "z", "axis", "-x", "-y", "-z", "-axis"},
                                 "direction of gravity; axis is the direction in which the actuator gets longer"),
             .dead_load = DeadLoadKind::gravity},
            {.target = LoadTarget::obstacle,
             .kind = motion,
             .magnitude = value_key("displacement", Kind::length, {},
                                    "prescribed displacement of the obstacle @; it does not rotate"),
             .example = "5 mm",
             .along = choice_key("along", "", obstacle_directions(), "direction of the displacement of an obstacle")}};
}

Settings<Gas> gas_settings() {
    return {
        quantity("gas.ambient", &Gas::ambient_Pa, Kind::pressure, above(0),
                 "absolute ambient pressure; mass, valve and line alone use the gas properties"),
        quantity("gas.density", &Gas::ambient_density_kg_m3, Kind::density, above(0),
                 "density of the gas at ambient pressure; default: air at 20 degrees Celsius"),
        in_unit("mL", quantity("gas.dead_volume", &Gas::dead_volume_m3, Kind::volume, at_least(0),
                               "volume of the tubing, filled with the same gas")),
        choice("gas.process", &Gas::exponent, {{"isothermal", 1.0}, {"adiabatic", adiabatic_exponent}},
               "relation of absolute pressure and density: isothermal, proportional (the gas keeps the temperature "
               "of its surroundings: slow filling, also from a supply at that temperature), or adiabatic, to the "
               "power 1.4 (the gas in the cavity and the injected gas are compressed from the ambient state without "
               "heat exchange: rapid changes)")};
}

const Settings<PressureLoad>& pressure_settings() {
    static const Settings<PressureLoad> settings = [] {
        Settings<PressureLoad> all{
            flag(
                "sealed", &PressureLoad::sealed,
                "the pressure also pushes on the plugs of the openings and on every closed inner face; imported: false "
                "unless it is stated"),
            flag(
                "plug_thrust", &PressureLoad::plug_thrust,
                "the plugs of a sealed cavity transmit their force to the actuator; false: a fixture or the supply line "
                "carries it"),
            choice(acts_on, &PressureLoad::shape,
                   {{"deformed", model::LoadShape::deformed}, {"undeformed", model::LoadShape::undeformed}},
                   "configuration on which the pressure acts; undeformed makes it a dead load")};
        for (Setting<Gas>& setting : gas_settings()) all.push_back(inside(&PressureLoad::gas, std::move(setting)));
        all.push_back(or_word(
            "none",
            Setting<PressureLoad>{
                value_key(
                    line_resistance, Kind::flow_resistance, above(0),
                    "flow resistance of the tube between the source, whose pressure is the time function, and the "
                    "cavity: pressure drop per volume flow at ambient pressure; none: the time function is the "
                    "pressure in the cavity"),
                [](const Values& values, const std::string& path, PressureLoad& load) {
                    if (values.number(path) > 0) load.line = model::SupplyLine{values.number(path)};
                }}));
        return all;
    }();
    return settings;
}

}  // namespace

std::span<const LoadForm> load_forms() {
    static const std::vector<LoadForm> forms = [] {
        std::vector<LoadForm> all = cavity_forms();
        for (LoadForm& form : other_forms()) all.push_back(std::move(form));
        return all;
    }();
    return forms;
}

std::vector<std::string> words_of(LoadTarget target) {
    std::vector<std::string> words;
    for (const LoadForm& form : load_forms())
        if (form.target == target) words.push_back(form.word());
    return words;
}

std::string form_list(LoadTarget target) {
    std::vector<std::string> keys;
    for (const LoadForm& form : load_forms())
        if (form.target == target) keys.push_back("{" + form.word() + (form.along.path.empty() ? "}" : ", along}"));
    const std::string last = keys.back();
    keys.pop_back();
    return keys.empty() ? last : core::join(keys) + " or " + last;
}

const LoadForm& form_of(LoadTarget target, std::string_view word) {
    return *std::ranges::find_if(load_forms(), [&](const LoadForm& form) {
        return form.target == target && (word.empty() || form.word() == word);
    });
}

Key magnitude_key(const std::string& load, const LoadForm& form, When when) {
    Key key = form.magnitude;
    key.path.insert(0, load + ".");
    if (const std::size_t at = key.meaning.find('@'); at != std::string::npos)
        key.meaning.replace(at, 1, when == When::full_load ? "at full load" : "at the stage's end");
    return key;
}

Key along_key(const std::string& load, const LoadForm& form) {
    Key key = form.along;
    key.path.insert(0, load + ".");
    return key;
}

std::vector<Key> pressure_keys(const std::string& load, LoadTarget target, bool dynamic) {
    Settings<PressureLoad> settings = pressure_settings();
    std::erase_if(settings, [&](const Setting<PressureLoad>& setting) {
        const std::string& name = setting.key.path;
        return (target == LoadTarget::face && name != acts_on) || (!dynamic && name == line_resistance);
    });
    return keys_of(settings, load);
}

PressureLoad pressure_settings_of(const Values& values, const std::string& load) {
    return read_settings(pressure_settings(), values, load);
}

}  // namespace soft::design
