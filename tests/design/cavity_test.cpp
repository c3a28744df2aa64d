/// Loads of a cavity, and several cavities by name.
#include <gtest/gtest.h>

#include "sample.hpp"

namespace {

using namespace soft;
using namespace soft::design;
using namespace soft::design::sample;
using model::Prescription;

/// A family with three cavities.
FamilyKeys lungs() {
    FamilyKeys family = pipe();
    family.name = "lungs";
    family.faces = {"fixed", "left", "right", "middle", "outer"};
    family.aliases = {{"port", "left"}};
    family.cavities = {"left", "right", "middle"};
    family.defaults =
        "supports: {fixed: fixed}\nloads: {cavities: {left: {volume_ratio: 10}, right: {shares: left}}}\noutputs: {}\n";
    return family;
}

const std::vector<FamilyKeys>& all_lungs() {
    static const std::vector<FamilyKeys> all = {lungs()};
    return all;
}

const std::string head = "family: lungs\nmaterial: {law: neo-hookean, mu: 100 kPa}\n";

Design read_lungs(const std::string& loads, const std::vector<Override>& overrides = {}) {
    return read_design(head + loads, "p.yaml", all_lungs(), overrides);
}

std::string lungs_refusal(const std::string& loads) {
    try {
        static_cast<void>(read_lungs(loads));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    return "accepted";
}

Design with_load(const std::string& load) {
    return read("family: pipe\nmaterial: {law: neo-hookean, mu: 100 kPa}\nloads: {cavity: {" + load + "}}\n");
}
std::string load_refusal(const std::string& load) {
    return refusal("family: pipe\nmaterial: {law: neo-hookean, mu: 100 kPa}\nloads: {cavity: {" + load + "}}\n");
}

TEST(Supply, CanBeAPressureAVolumeAMassOrAClosedValve) {
    struct Row {
        const char* load;
        Prescription what;
        double value;
    };
    for (const Row& row :
         {Row{"pressure: -2 kPa", Prescription::pressure, -2000}, Row{"volume: 40 mL", Prescription::volume, 4e-5},
          Row{"volume_ratio: 3", Prescription::volume_ratio, 3}, Row{"mass: 50 mg", Prescription::mass, 5e-5}}) {
        const Design design = with_load(row.load);
        EXPECT_EQ(supply(design).what, row.what) << row.load;
        EXPECT_EQ(supply(design).value, row.value) << row.load;
        EXPECT_EQ(read(design.effective_yaml).effective_yaml, design.effective_yaml);
    }
    const Design shut = read(
        "family: pipe\nmaterial: {law: neo-hookean, mu: 100 kPa}\nloads: {cavity: {valve: closed}, outer: {pressure: 9 kPa}}\n");
    EXPECT_EQ(supply(shut).what, Prescription::closed);
    EXPECT_EQ(shut.path.stages.at(0).supplies.at(1).value, 9000.0);
}

TEST(Supply, GasIsAirByDefault) {
    const model::Gas usual = with_load("mass: 50 mg").loads.at(0).gas, air;
    EXPECT_EQ(usual.ambient_Pa, air.ambient_Pa);
    EXPECT_EQ(usual.ambient_density_kg_m3, air.ambient_density_kg_m3);
    EXPECT_EQ(usual.dead_volume_m3, air.dead_volume_m3);
    EXPECT_EQ(usual.exponent, air.exponent);
    const model::Gas other =
        with_load("mass: 50 mg, gas: {ambient: 90 kPa, dead_volume: 5 mL, process: adiabatic, density: 1.1 kg/m^3}")
            .loads.at(0)
            .gas;
    EXPECT_EQ(other.ambient_Pa, 90000.0);
    EXPECT_EQ(other.ambient_density_kg_m3, 1.1);
    EXPECT_EQ(other.dead_volume_m3, 5e-6);
    EXPECT_EQ(other.exponent, 1.4);  // air, diatomic: 7/5
}

TEST(Supply, SecondPrescriptionAndZeroLoadAreRejected) {
    EXPECT_TRUE(
        contains(load_refusal("pressure: 3 kPa, mass: 5 mg"),
                 "p.yaml:3:35: loads.cavity.mass: the load has a pressure already; keep one of pressure, volume, "));
    EXPECT_TRUE(contains(load_refusal("mass: 0 mg"),
                         "loads.cavity.mass: a load of 0 gives no path; write the mass at full load"));
    EXPECT_TRUE(contains(load_refusal("volume_ratio: 1"), "loads.cavity.volume_ratio: 1 is where the path starts"));
    EXPECT_TRUE(contains(load_refusal("volume: 0 mL"), "loads.cavity.volume: 0 mL is out of range"));
    EXPECT_TRUE(contains(load_refusal("valve: open"), "loads.cavity.valve: 'open' is not a valid value"));
    EXPECT_TRUE(
        contains(load_refusal("valve: closed"), "loads.cavity.valve: closed valves alone do not load the actuator"));
    EXPECT_TRUE(contains(load_refusal("mass: 50 mg, gas: {proces: adiabatic}"), "did you mean 'process'?"));
    EXPECT_TRUE(contains(load_refusal("sealed: false"), "loads.cavity.pressure: missing"));
    EXPECT_TRUE(
        contains(load_refusal("preshure: 3 kPa"), "loads.cavity.preshure: unknown key; did you mean 'pressure'?"));
    EXPECT_TRUE(
        contains(load_refusal("displacement: 3 mm"), "loads.cavity.displacement: a cavity is loaded by a pressure"));
}

TEST(Supply, CanBeAMassForAnUnsealedCavity) {
    EXPECT_FALSE(with_load("mass: 50 mg, sealed: false").loads.at(0).sealed);
}

TEST(Supply, OfGasIsRejectedForFaces) {
    for (const char* load :
         {"volume: 3 mL", "volume_ratio: 3", "mass: 3 mg", "valve: closed", "shares: cavity", "gas: {}"})
        EXPECT_TRUE(contains(refusal("family: pipe\nmaterial: {law: neo-hookean, mu: 100 kPa}\nloads: {outer: {" +
                                     std::string{load} + "}}\n"),
                             "a face encloses no gas; write pressure"))
            << load;
}

TEST(Cavities, CanShareTheirGas) {
    const Design design =
        read_lungs("loads: {cavities: {right: {shares: left}, port: {mass: 3 mg}, middle: {pressure: 1 kPa}}}\n");
    ASSERT_EQ(design.loads.size(), 2u);
    EXPECT_EQ(design.loads[0].name, "left");
    EXPECT_EQ(design.loads[0].targets, (std::vector<std::string>{"left", "right"}));
    EXPECT_EQ(design.loads[1].name, "middle");
    EXPECT_EQ(design.path.stages.at(0).supplies.at(0).what, Prescription::mass);
    EXPECT_EQ(read_design(design.effective_yaml, "e", all_lungs(), {}).effective_yaml, design.effective_yaml);
}

TEST(Cavities, TemplateContainsTheDefaultCavitiesOfTheFamily) {
    const Design design = read_design(template_yaml(lungs()), "t", all_lungs(), {});
    ASSERT_EQ(design.loads.size(), 1u);
    EXPECT_EQ(design.loads[0].targets, (std::vector<std::string>{"left", "right"}));
    EXPECT_EQ(supply(design).what, Prescription::volume_ratio);
    EXPECT_EQ(supply(design).value, 10.0);
}

TEST(Cavities, NameOfASingleCavityIsEquivalentToTheShortForm) {
    const Design design = read(
        "family: pipe\nmaterial: {law: neo-hookean, mu: 100 kPa}\nloads: {cavities: {cavity: {pressure: 1 kPa}}}\n");
    EXPECT_EQ(design.loads.at(0).name, "cavity");
    EXPECT_TRUE(contains(refusal("family: pipe\nmaterial: {law: neo-hookean, mu: 100 kPa}\n"
                                 "loads: {cavity: {pressure: 2 kPa}, cavities: {cavity: {pressure: 1 kPa}}}\n"),
                         "loads.cavities.cavity.pressure: face 'cavity' is loaded twice"));
}

TEST(Cavities, InvalidSharingIsRejected) {
    const auto refused = [](const std::string& cavities) {
        return lungs_refusal("loads: {cavities: {" + cavities + "}}\n");
    };
    EXPECT_TRUE(contains(refused("left: {pressure: 1 kPa}, right: {shares: right}"),
                         "loads.cavities.right.shares: a cavity cannot share its own gas; name another cavity"));
    EXPECT_TRUE(contains(refused("left: {pressure: 1 kPa}, right: {shares: middle}"),
                         "loads.cavities.right.shares: cavity 'middle' has no load; add it under loads.cavities"));
    EXPECT_TRUE(
        contains(refused("left: {pressure: 1 kPa}, right: {shares: left}, middle: {shares: right}"),
                 "loads.cavities.middle.shares: 'right' itself shares the gas of another cavity; write shares: left"));
    EXPECT_TRUE(contains(refused("left: {pressure: 1 kPa}, right: {shares: letf}"), "did you mean 'left'?"));
    EXPECT_TRUE(contains(refused("left: {pressure: 1 kPa}, right: {shares: left, sealed: true}"),
                         "loads.cavities.right.sealed: a cavity that shares its gas has no supply of its own"));
    EXPECT_TRUE(contains(refused("left: {pressure: 1 kPa}, right: {shares: left, mass: 1 mg}"),
                         "loads.cavities.right.mass: the load has a shares already"));
    EXPECT_TRUE(contains(refused("letf: {pressure: 1 kPa}"),
                         "p.yaml:3:20: loads.cavities.letf: unknown key; did you mean 'left'?"));
}

TEST(Cavities, ShortFormIsRejectedForSeveralCavities) {
    EXPECT_TRUE(
        contains(lungs_refusal("loads: {cavity: {pressure: 1 kPa}}\n"),
                 "p.yaml:3:9: loads.cavity: the cavities are left, right, middle; write cavities: {left: {...}}"));
    EXPECT_TRUE(contains(lungs_refusal("loads: {left: {pressure: 1 kPa}}\n"),
                         "loads.left: the cavities are left, right, middle"));
    EXPECT_TRUE(
        contains(lungs_refusal(""),
                 "loads: missing (what drives the actuator); add loads: {cavities: {left: {pressure: 30 kPa}}}"));
    EXPECT_TRUE(contains(lungs_refusal("loads: {cavities: {}}\n"), "loads: missing (what drives the actuator)"));
    EXPECT_TRUE(
        contains(refusal("family: bar\nmaterial: {law: neo-hookean, mu: 1 kPa}\nloads: {cavity: {pressure: 1 kPa}}\n"),
                 "loads.cavity: there is no cavity to load; faces: fixed, end"));
}

TEST(Cavities, SolveCanChangeTheirGasAndAddOne) {
    const std::string effective =
        read_lungs("loads: {cavities: {left: {mass: 3 mg}, right: {shares: left}}}\n").effective_yaml;
    const std::vector<Override> changes = {{"loads.cavities.left.gas.dead_volume", "7 mL"},
                                           {"loads.cavities.right", "{pressure: 2 kPa}"}};
    const Design part = read_built(effective, changes, all_lungs());
    ASSERT_EQ(part.loads.size(), 2u);
    EXPECT_EQ(part.loads[0].gas.dead_volume_m3, 7e-6);
    EXPECT_EQ(part.loads[1].targets, std::vector<std::string>{"right"});
    EXPECT_EQ(part.effective_yaml, read_design(effective, "e", all_lungs(), changes).effective_yaml);
    EXPECT_EQ(read_built(effective, {{"loads.cavities.middle", "{pressure: 2 kPa}"}}, all_lungs()).loads.size(), 2U);
}

}  // namespace
