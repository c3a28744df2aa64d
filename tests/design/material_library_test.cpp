#include "design/material_library.hpp"

#include <gtest/gtest.h>

#include <set>

#include "design/fitted.hpp"
#include "material/catalogue.hpp"
#include "material/stability.hpp"
#include "sample.hpp"

namespace {

using namespace soft::design;
using namespace soft::design::sample;

std::string pipe_of(const std::string& text) {
    return "family: pipe\nmaterial: " + text + "\nloads: {cavity: {pressure: 1 kPa}}\n";
}

TEST(MaterialLibrary, EverySiliconeIsALawOverTwoRangesWithItsLicence) {
    ASSERT_EQ(material_files().size(), 19u);
    for (const MaterialFile& file : material_files()) {
        EXPECT_TRUE(holds(std::string{file.yaml}, "Open Database License")) << file.name;
        EXPECT_TRUE(holds(std::string{file.yaml}, "10.1089/soro.2019.0115")) << file.name;
        for (const std::string law : {"yeoh", "neo-hookean"}) {
            std::set<double> ranges;
            for (const MaterialSet& set : material_sets(file))
                if (set.law == law) ranges.insert(set.strain);
            EXPECT_GE(ranges.size(), 2u) << file.name;
        }
    }
}

TEST(MaterialLibrary, EverySetIsADesignAndStableInEveryModeWhereItsDataAre) {
    for (const MaterialFile& file : material_files())
        for (const MaterialSet& set : material_sets(file)) {
            const Design design = read(pipe_of("{name: " + std::string{file.name} + ", law: " + set.law +
                                               ", range: " + set.strain_text + "}"));
            const auto rubber =
                soft::material::make_rubber({.law = design.material.law,
                                             .constants = soft::material::Constants{design.material.constants.begin(),
                                                                                    design.material.constants.end()}});
            const double end = 1.0 + set.strain, I1 = end * end + 2.0 / end;
            for (const auto& limit : soft::material::stability_limits(rubber)) {
                const double l = limit.stretch;
                const double there = limit.mode == soft::material::Mode::uniaxial ? l * l + 2.0 / l
                                     : limit.mode == soft::material::Mode::equibiaxial
                                         ? 2.0 * l * l + 1.0 / (l * l * l * l)
                                         : l * l + 1.0 + 1.0 / (l * l);
                EXPECT_GT(there, 0.99 * I1)
                    << file.name << " " << set.strain_text;  // the last row is before the range's end
            }
        }
}

TEST(MaterialLibrary, TheNarrowestRangeThatCoversTheWishIsTaken) {
    const auto range = [](const std::string& text) { return read(pipe_of(text)).values.text("material.fit.range"); };
    EXPECT_TRUE(holds(range("dragon-skin-20"), ":300 %"));
    EXPECT_TRUE(holds(range("{name: dragon-skin-20, range: 50 %}"), ":109.091 %"));
    EXPECT_TRUE(holds(range("{name: dragon-skin-20, range: 3.5}"), ":897.727 %"));
    EXPECT_TRUE(holds(range("rtv615"), ":170.4"));  // its data end before the usual range
}

TEST(MaterialLibrary, ConstantsOfDragonSkin20AreThoseOfTheNotesOfTheData) {
    // neo-Hookean C1 = mu/2 over e <= 1.10 and to 8.977, an independent fit with five decimals in MPa
    const auto mu = [](const std::string& range) {
        return read(pipe_of("{name: dragon-skin-20, law: neo-hookean, range: " + range + "}"))
            .material.constants.at("mu")[0];
    };
    EXPECT_NEAR(mu("110 %") / 2e6, 0.08267, 0.5e-5);
    EXPECT_NEAR(mu("897 %") / 2e6, 0.19719, 0.5e-5);
}

TEST(MaterialLibrary, OtherKeysStandBesideTheNameAndSetReachesThem) {
    const Design design = read(pipe_of("{name: ecoflex-00-30, density: 1070 kg/m^3, kappa: 10 MPa}"));
    EXPECT_EQ(design.material.density_kg_m3, 1070.0);
    EXPECT_EQ(design.material.bulk_modulus_Pa, 10e6);
    const Override overrides[] = {{"material.range", "100%"}};
    const Design changed = read_design(pipe_of("dragon-skin-20"), "p.yaml", families(), overrides);
    EXPECT_TRUE(holds(changed.values.text("material.fit.range"), ":109.091 %"));
    EXPECT_EQ(read(changed.effective_yaml).effective_yaml, changed.effective_yaml);
}

TEST(MaterialLibrary, SolveCanTakeAnotherSet) {
    const Design design = read(pipe_of("dragon-skin-20"));
    const Override overrides[] = {{"material", "{name: dragon-skin-20, range: 110 %}"}};
    const SolveChanges changes = apply_overrides(design.effective_yaml, overrides);
    EXPECT_EQ(changes.material.constants, read(pipe_of("{name: dragon-skin-20, range: 110 %}")).material.constants);
}

TEST(MaterialLibrary, WhatItDoesNotHaveIsRefusedAtItsPlace) {
    EXPECT_TRUE(holds(
        refusal(pipe_of("{name: dragon-skin-20, range: 2000 %}")),
        "p.yaml:2:41: material.range: the data of dragon-skin-20 end before 2000 %; ranges: 110 %, 300 %, 897.7 %"));
    EXPECT_TRUE(holds(refusal(pipe_of("{name: dragon-skin-20, law: gent}")),
                      "material.law: dragon-skin-20 has no constants of 'gent'; known: yeoh, neo-hookean"));
    EXPECT_TRUE(holds(refusal(pipe_of("{law: neo-hookean, mu: 1 kPa, fit: {rang: 3}}")),
                      "material.fit.rang: unknown key; did you mean 'range'?"));
}

TEST(MaterialLibrary, APathIsToldWhenItLeavesTheDataAndWhenANarrowerSetCoversIt) {
    const std::string yaml = read(pipe_of("dragon-skin-20")).effective_yaml;
    EXPECT_TRUE(holds(fit_advice(yaml, 4.5).value_or(""), "beyond the data its constants were fitted to"));
    EXPECT_TRUE(holds(fit_advice(yaml, 4.5).value_or(""), "range: 897.7 %"));
    EXPECT_FALSE(fit_advice(yaml, 3.5));
    EXPECT_FALSE(fit_advice(yaml, 1.5));  // solve takes the narrower set by itself
    const std::string stated = read(pipe_of("{name: dragon-skin-20, range: 300 %}")).effective_yaml;
    EXPECT_TRUE(holds(fit_advice(stated, 1.5).value_or(""), "range: 110 %"));
    EXPECT_FALSE(fit_advice(read(pipe_of("{law: neo-hookean, mu: 1 kPa}")).effective_yaml, 9.0));
    const std::string own =
        read(pipe_of("{law: neo-hookean, mu: 1 kPa, fit: {largest_I1: 5.3, range: '0:110 %'}}")).effective_yaml;
    EXPECT_TRUE(holds(fit_advice(own, 3.0).value_or(""), "beyond the data"));
}

TEST(MaterialLibrary, AConstantThatSolveIsGivenIsNotReplacedByAnotherSet) {
    const Override overrides[] = {{"material.c1", "50 kPa"}};
    const SolveChanges changes = apply_overrides(read(pipe_of("dragon-skin-20")).effective_yaml, overrides);
    EXPECT_FALSE(fitting_set(changes.effective_yaml, 1.5));
}

TEST(MaterialLibrary, ASetThatFitsTheStretchIsOfferedWhereTheRangeIsLeftOpen) {
    const auto range_at = [](const std::string& text, double stretch) -> std::string {
        std::string yaml = read(pipe_of(text)).effective_yaml;
        const auto set = fitting_set(yaml, stretch);
        if (!set) return "kept";
        const SolveChanges changes = apply_overrides(yaml, std::span{&set->change, 1});
        EXPECT_EQ(changes.material.density_kg_m3, read(pipe_of(text)).material.density_kg_m3);
        EXPECT_EQ(changes.material.bulk_modulus_Pa, read(pipe_of(text)).material.bulk_modulus_Pa);
        EXPECT_FALSE(fitting_set(changes.effective_yaml, stretch)) << "it stays open, and the set is the one that fits";
        return fitted_material(changes.effective_yaml).value().range;
    };
    EXPECT_EQ(range_at("dragon-skin-20", 1.5), "4.46:109.091 %");
    EXPECT_EQ(range_at("dragon-skin-20", 3.5), "kept");
    EXPECT_EQ(range_at("dragon-skin-20", 4.5), "4.46:897.727 %");
    EXPECT_EQ(range_at("dragon-skin-20", 30.0), "4.46:897.727 %");  // none covers it: the widest
    EXPECT_EQ(range_at("{name: dragon-skin-20, law: neo-hookean, density: 1080 kg/m^3, kappa: 9 MPa}", 1.5),
              "4.46:109.091 %");
    EXPECT_EQ(range_at("{name: dragon-skin-20, range: 300 %}", 1.5), "kept");
    EXPECT_EQ(range_at("{name: dragon-skin-20, c1: 50 kPa}", 1.5), "kept");  // constants of one's own go with one set
    EXPECT_EQ(range_at("{law: neo-hookean, mu: 1 kPa, fit: {largest_I1: 5.3}}", 1.5), "kept");
}

}  // namespace
