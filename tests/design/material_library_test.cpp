#include "design/material_library.hpp"

#include <gtest/gtest.h>

#include <set>

#include "design/fitted.hpp"
#include "material/catalogue.hpp"
#include "material/homogeneous.hpp"
#include "material/stability.hpp"
#include "sample.hpp"

namespace {

using namespace soft::design;
using namespace soft::design::sample;

std::string pipe_of(const std::string& text) {
    return "family: pipe\nmaterial: " + text + "\nloads: {cavity: {pressure: 1 kPa}}\n";
}

soft::material::AnyRubber rubber_of(const Design& design) {
    return soft::material::make_rubber(
        {.law = design.material.law,
         .constants = soft::material::Constants{design.material.constants.begin(), design.material.constants.end()}});
}

TEST(MaterialLibrary, EverySiliconeHasTwoLawsOverTwoRangesAndALicence) {
    ASSERT_EQ(material_files().size(), 19u);
    for (const MaterialFile& file : material_files()) {
        EXPECT_TRUE(contains(std::string{file.yaml}, "Open Database License")) << file.name;
        EXPECT_TRUE(contains(std::string{file.yaml}, "10.1089/soro.2019.0115")) << file.name;
        for (const std::string law : {"yeoh", "neo-hookean"}) {
            std::set<double> ranges;
            for (const MaterialSet& set : material_sets(file))
                if (set.law == law) ranges.insert(set.strain);
            EXPECT_GE(ranges.size(), 2u) << file.name;
        }
    }
}

TEST(MaterialLibrary, EverySetIsAValidDesignAndStableWithinItsData) {
    for (const MaterialFile& file : material_files())
        for (const MaterialSet& set : material_sets(file)) {
            const Design design = read(pipe_of("{name: " + std::string{file.name} + ", law: " + set.law +
                                               ", range: " + set.strain_text + "}"));
            const auto rubber = rubber_of(design);
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

TEST(MaterialLibrary, NameAloneSelectsALawOverTheWholeTestThatIsStableAtEveryStretch) {
    for (const MaterialFile& file : material_files()) {
        const Design design = read(pipe_of(std::string{file.name}));
        double widest = 0;
        for (const MaterialSet& set : material_sets(file)) widest = std::max(widest, set.strain);
        const FittedMaterial fitted = fitted_material(design.effective_yaml).value();
        EXPECT_TRUE(fitted.covers(1.0 + 0.995 * widest)) << file.name;  // the last row is before the range's end
        EXPECT_FALSE(fitted.max_error.empty()) << file.name;
        // dW/dI1 = c1 + 2 c2 x + 3 c3 x^2 + a (1 - exp(-b x)) is positive and does not fall: stable in every mode.
        for (const auto& [name, values] : design.material.constants)
            EXPECT_GE(values.at(0), 0.0) << file.name << " " << name;
        EXPECT_TRUE(soft::material::stability_limits(rubber_of(design), {0.05, 40.0}).empty()) << file.name;
        EXPECT_TRUE(design.warnings.empty()) << file.name;
    }
}

TEST(MaterialLibrary, NameAloneReproducesTheTestFromSmallStrainsToItsEnd) {
    // Rows of the test data (Marechal et al. 2021): engineering strain, engineering stress in MPa. The largest errors over the whole
    // tests of the first and the last material are 9.8 and 14 %.
    struct Row {
        const char* name;
        double strain, stress_MPa;
    };
    for (const auto& [name, strain, stress_MPa] :
         {Row{"dragon-skin-20", 0.318183333, 0.092346667}, Row{"dragon-skin-20", 0.522726667, 0.158616667},
          Row{"dragon-skin-20", 1.0, 0.31836}, Row{"dragon-skin-20", 3.0, 1.194473333},
          Row{"dragon-skin-20", 8.0, 3.812013333}, Row{"dragon-skin-30", 0.31818, 0.1394},
          Row{"dragon-skin-30", 1.00000333, 0.43712333}, Row{"dragon-skin-30", 3.02272667, 1.54289},
          Row{"dragon-skin-30", 5.0, 2.78986333}, Row{"ecoflex-00-30", 0.31818, 0.01116},
          Row{"ecoflex-00-30", 1.02272, 0.02953}, Row{"ecoflex-00-30", 8.0, 0.34079}}) {
        const auto mode = soft::material::Mode::uniaxial;
        const auto state = soft::material::homogeneous_state(rubber_of(read(pipe_of(name))), mode, 1.0 + strain);
        EXPECT_NEAR(soft::material::nominal_stress_Pa(state.value(), mode) / (1e6 * stress_MPa), 1.0, 0.1)
            << name << " " << strain;
    }
}

TEST(MaterialLibrary, SelectsTheNarrowestRangeThatCoversTheRequest) {
    const auto range = [](const std::string& text) { return read(pipe_of(text)).values.text("material.fit.range"); };
    EXPECT_TRUE(contains(range("{name: dragon-skin-20, range: 300 %}"), ":300 %"));
    EXPECT_TRUE(contains(range("{name: dragon-skin-20, law: neo-hookean}"), ":300 %"));
    EXPECT_TRUE(contains(range("{name: dragon-skin-20, range: 50 %}"), ":109.091 %"));
    EXPECT_TRUE(contains(range("{name: dragon-skin-20, range: 3.5}"), ":897.727 %"));
    EXPECT_TRUE(contains(range("{name: rtv615, law: neo-hookean}"), ":170.4"));  // its data end before 300 %
}

TEST(MaterialLibrary, ConstantsOfDragonSkin20MatchAnIndependentFit) {
    // neo-Hookean C1 = mu/2 over e <= 1.10 and to 8.977, an independent fit with five decimals in MPa
    const auto mu = [](const std::string& range) {
        return read(pipe_of("{name: dragon-skin-20, law: neo-hookean, range: " + range + "}"))
            .material.constants.at("mu")[0];
    };
    EXPECT_NEAR(mu("110 %") / 2e6, 0.08267, 0.5e-5);
    EXPECT_NEAR(mu("897 %") / 2e6, 0.19719, 0.5e-5);
}

TEST(MaterialLibrary, OtherKeysCanBeGivenWithTheNameAndOverridden) {
    const Design design = read(pipe_of("{name: ecoflex-00-30, density: 1070 kg/m^3, kappa: 10 MPa}"));
    EXPECT_EQ(design.material.density_kg_m3, 1070.0);
    EXPECT_EQ(design.material.bulk_modulus_Pa, 10e6);
    const Override overrides[] = {{"material.range", "100%"}};
    const Design changed = read_design(pipe_of("dragon-skin-20"), "p.yaml", families(), overrides);
    EXPECT_TRUE(contains(changed.values.text("material.fit.range"), ":109.091 %"));
    EXPECT_EQ(read(changed.effective_yaml).effective_yaml, changed.effective_yaml);
}

TEST(MaterialLibrary, AnEntryMayHaveViscousConstants) {
    const MaterialFile file{"known",
                            "sets:\n  - range: 100 %\n    law: yeoh\n    c1: 20 kPa\n    kappa: incompressible\n"
                            "    viscoelastic: {moduli: [0.2, 0.1], times: [0.5 s, 10 s]}\n"
                            "    softening: {r: 2, m: 10 kPa}\n    fit: {max_I1: 4, source: a test}\n"};
    Node root = parse_yaml(pipe_of("none"), "pipe.yaml");
    put(root, "material", material_sets(file).front().block);
    const Design of_entry = read(write_yaml(root));
    ASSERT_TRUE(of_entry.material.inelastic);
    EXPECT_EQ(of_entry.material.inelastic->times_s, (std::vector<double>{0.5, 10}));
    EXPECT_EQ(of_entry.material.inelastic->softening->m_Pa, 10e3);
    const Design by_name = read(pipe_of("{name: dragon-skin-20, viscoelastic: {moduli: 0.2, times: 3 s}}"));
    ASSERT_TRUE(by_name.material.inelastic);
    EXPECT_EQ(by_name.material.inelastic->moduli, std::vector<double>{0.2});
}

TEST(MaterialLibrary, SolveCanSelectAnotherSet) {
    const Design design = read(pipe_of("dragon-skin-20"));
    const Override overrides[] = {{"material", "{name: dragon-skin-20, range: 110 %}"}};
    const Design changes = read_built(design.effective_yaml, {overrides[0]});
    EXPECT_EQ(changes.material.constants, read(pipe_of("{name: dragon-skin-20, range: 110 %}")).material.constants);
}

TEST(MaterialLibrary, UnknownRangeLawAndKeyAreRejectedAtTheirLocation) {
    EXPECT_TRUE(contains(
        refusal(pipe_of("{name: dragon-skin-20, range: 2000 %}")),
        "p.yaml:2:41: material.range: the data of dragon-skin-20 end before 2000 %; ranges: 110 %, 300 %, 897.7 %"));
    EXPECT_TRUE(contains(refusal(pipe_of("{name: dragon-skin-20, law: gent}")),
                         "material.law: dragon-skin-20 has no constants of 'gent'; known: yeoh, neo-hookean"));
    EXPECT_TRUE(contains(refusal(pipe_of("{law: neo-hookean, mu: 1 kPa, fit: {rang: 3}}")),
                         "material.fit.rang: unknown key; did you mean 'range'?"));
}

TEST(MaterialLibrary, StretchBeyondTheDataIsReportedAndANarrowerRangeIsSuggested) {
    const auto advice = [](const std::string& material, double stretch) {
        return fit_range_advice(read(pipe_of(material)).effective_yaml, stretch).value_or("");
    };
    EXPECT_TRUE(
        contains(advice("dragon-skin-20", 11.0), "beyond the data its constants were fitted to (11.362:897.727 %"));
    for (const double stretch : {1.05, 1.5, 3.5, 9.5}) EXPECT_EQ(advice("dragon-skin-20", stretch), "") << stretch;
    EXPECT_TRUE(contains(advice("{name: dragon-skin-20, range: 300 %}", 1.5), "range: 110 %"));
    EXPECT_TRUE(contains(advice("{name: dragon-skin-20, range: 300 %}", 4.5), "range: 897.7 %"));
    EXPECT_EQ(advice("{law: neo-hookean, mu: 1 kPa}", 9.0), "");
    EXPECT_TRUE(contains(advice("{law: neo-hookean, mu: 1 kPa, fit: {max_I1: 5.3, range: '0:110 %'}}", 3.0),
                         "beyond the data"));
}

}  // namespace
