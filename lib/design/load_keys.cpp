#include "design/load_keys.hpp"

#include <array>

#include "core/units.hpp"
#include "design/common_keys.hpp"

namespace soft::design {
namespace {

using model::Prescription;

constexpr std::array<SupplyWord, 5> words{{{"pressure", Prescription::pressure},
                                           {"volume", Prescription::volume},
                                           {"volume_ratio", Prescription::volume_ratio},
                                           {"mass", Prescription::mass},
                                           {"valve", Prescription::closed}}};

std::string at(When when) { return when == When::full_load ? " at full load" : " at the stage's end"; }

std::string si_text(double value, core::Dimension dimension) { return core::quantity_text(value, dimension); }

}  // namespace

std::span<const SupplyWord> supply_words() { return words; }

Key supply_key(const std::string& load, const SupplyWord& word, When when) {
    Key key{.path = load + "." + std::string{word.name}};
    switch (word.what) {
        case Prescription::pressure:
            key.kind = Kind::pressure;
            key.meaning = "gauge pressure" + at(when) +
                          "; positive acts against the surface and inflates a cavity; a cavity may "
                          "have volume, volume_ratio, mass or valve instead";
            break;
        case Prescription::volume:
            key.kind = Kind::volume;
            key.meaning = "enclosed volume" + at(when) + ", of all cavities that share the gas";
            key.min = 0;
            key.min_open = true;
            break;
        case Prescription::volume_ratio:
            key.kind = Kind::ratio;
            key.meaning =
                "enclosed volume over its undeformed value" + at(when) + ", of all cavities that share the gas";
            key.min = 0;
            key.min_open = true;
            break;
        case Prescription::mass:
            key.kind = Kind::mass;
            key.meaning = "mass of gas injected" + at(when) +
                          " since the start of the path, in addition to the gas that fills the undeformed cavity";
            break;
        case Prescription::closed:
            key.kind = Kind::choice;
            key.meaning = "closed: the mass of gas in the cavity stays constant";
            key.choices = {"closed"};
            break;
    }
    return key;
}

Key shares_key(const std::string& load, std::vector<std::string> cavities) {
    return {.path = load + ".shares",
            .kind = Kind::choice,
            .meaning = "cavity whose gas this one shares: one pressure, and the volumes add up",
            .choices = std::move(cavities)};
}

Key sealed_key(const std::string& load, std::string fallback) {
    return {.path = load + ".sealed",
            .kind = Kind::flag,
            .fallback = std::move(fallback),
            .meaning = "the pressure also pushes on the plugs of the openings and on every closed inner face"};
}

Key plug_thrust_key(const std::string& load) {
    return {
        .path = load + ".plug_thrust",
        .kind = Kind::flag,
        .fallback = "true",
        .meaning =
            "the plugs of a sealed cavity transmit their force to the actuator; false: a fixture or the supply line carries it"};
}

Key shape_key(const std::string& load) {
    return {.path = load + ".acts_on",
            .kind = Kind::choice,
            .fallback = "deformed",
            .meaning = "configuration on which the pressure acts; undeformed makes it a dead load",
            .choices = {"deformed", "undeformed"}};
}

std::vector<Key> gas_keys(const std::string& load) {
    const model::Gas gas;
    const std::string path = load + ".gas.";
    return {
        {.path = path + "ambient",
         .kind = Kind::pressure,
         .fallback = si_text(gas.ambient_Pa, core::Dimension::pressure),
         .meaning = "absolute ambient pressure; mass, valve and line alone use the gas properties",
         .min = 0,
         .min_open = true},
        {.path = path + "density",
         .kind = Kind::density,
         .fallback = si_text(gas.ambient_density_kg_m3, core::Dimension::density),
         .meaning = "density of the gas at ambient pressure; default: air at 20 degrees Celsius",
         .min = 0,
         .min_open = true},
        {.path = path + "dead_volume",
         .kind = Kind::volume,
         .fallback = "0 mL",
         .meaning = "volume of the tubing, filled with the same gas",
         .min = 0},
        {.path = path + "process",
         .kind = Kind::choice,
         .fallback = "isothermal",
         .meaning =
             "relation of absolute pressure and density: isothermal, proportional (the gas keeps the temperature of its surroundings: "
             "slow filling, also from a supply at that temperature), or adiabatic, to the power 1.4 (the gas in the cavity "
             "and the injected gas are compressed from the ambient state without heat exchange: a closed "
             "valve in a rapid motion)",
         .choices = {"isothermal", "adiabatic"}}};
}

Key traction_key(const std::string& load, When when) {
    return {.path = load + ".traction",
            .kind = Kind::pressure,
            .meaning = "force per undeformed area" + at(when) + "; its direction stays fixed in space"};
}

Key force_key(const std::string& load, When when) {
    return {.path = load + ".force",
            .kind = Kind::force,
            .meaning = "dead force on the whole face of the whole actuator" + at(when) +
                       ", spread evenly over the undeformed face; its direction stays fixed in space"};
}

Key traction_along_key(const std::string& load) {
    return {
        .path = load + ".along",
        .kind = Kind::choice,
        .meaning =
            "direction of a positive traction or force; normal points out of the undeformed face, axis is the direction in which the "
            "actuator gets longer",
        .choices = directions()};
}

Key acceleration_key(const std::string& load, When when) {
    return {.path = load + ".acceleration",
            .kind = Kind::acceleration,
            .meaning = "force per mass of the rubber" + at(when) + "; needs material.density"};
}

Key gravity_along_key(const std::string& load, std::string fallback) {
    return {.path = load + ".along",
            .kind = Kind::choice,
            .fallback = std::move(fallback),
            .meaning = "direction of gravity; axis is the direction in which the actuator gets longer",
            .choices = {"x", "y", "z", "axis", "-x", "-y", "-z", "-axis"}};
}

Key displacement_key(const std::string& load, When when) {
    return {.path = load + ".displacement",
            .kind = Kind::length,
            .meaning = "prescribed motion of the whole face" + at(when) + "; its other components stay free"};
}

Key motion_along_key(const std::string& load) {
    return {
        .path = load + ".along",
        .kind = Kind::choice,
        .meaning = "prescribed displacement component; normal or axis only where parallel to a coordinate direction",
        .choices = directions()};
}

}  // namespace soft::design
