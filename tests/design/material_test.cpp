#include <gtest/gtest.h>

#include "material/catalogue.hpp"
#include "sample.hpp"

namespace {

using namespace soft::design;
using namespace soft::design::sample;
namespace model = soft::model;

/// A pipe of a material, such as "law: yeoh, c1: 1 kPa"; text appended to it starts at 4:1.
std::string pipe_of(const std::string& material) {
    return "family: pipe\nmaterial: {" + material + "}\nloads: {cavity: {pressure: 1 kPa}}\n";
}

void expect_refused(const std::string& text, std::string_view start, std::string_view part = {}) {
    const std::string line = refusal(text);
    EXPECT_EQ(line.find(start), 0u) << line;
    EXPECT_TRUE(contains(line, part)) << line;
}

/// The material with the example parameters of a law.
std::string example_of(const soft::material::LawInfo& law) {
    std::string text = "law: " + std::string{law.name};
    for (const auto& parameter : law.parameters)
        text += ", " + std::string{parameter.name} + ": " + std::string{parameter.example};
    if (law.bulk == soft::material::Bulk::finite) text += ", kappa: 16.44 MPa";
    return text;
}

TEST(Material, EveryLawIsReadWithItsExamplesAndReproducedByTheEffectiveDesign) {
    for (const auto& law : soft::material::laws()) {
        const std::string text = pipe_of(example_of(law)) + (law.mixed ? "" : "mesh: {formulation: displacement}\n");
        const Design design = read(text);
        EXPECT_EQ(design.material.law, law.name);
        EXPECT_EQ(design.material.constants.size(), law.parameters.size()) << law.name;
        const Design again = read(design.effective_yaml);
        EXPECT_EQ(again.effective_yaml, design.effective_yaml) << law.name;
        EXPECT_EQ(again.material.constants, design.material.constants) << law.name;
        EXPECT_EQ(again.material.bulk_modulus_Pa, design.material.bulk_modulus_Pa) << law.name;
        const std::string explained = explain_design(text, "p.yaml", families(), {});
        EXPECT_EQ(read(explained).effective_yaml, design.effective_yaml) << explained;
        for (const auto& parameter : law.parameters)
            EXPECT_TRUE(contains(explained, std::string{parameter.meaning})) << explained;
    }
}

TEST(Material, MissingConstantsAreReportedWithAnExample) {
    for (const auto& law : soft::material::laws())
        for (const auto& parameter : law.parameters) {
            if (!parameter.fallback.empty()) continue;
            std::string text = example_of(law);
            const auto start = text.find(", " + std::string{parameter.name} + ": ");
            auto end = text.find(", ", start + 2);
            if (text.find('[', start) < end)
                end = text.find("], ", start) == std::string::npos ? end : text.find("], ", start) + 1;
            if (text.find('[', start) < end && text.find("], ", start) == std::string::npos) end = std::string::npos;
            text.erase(start, end == std::string::npos ? end : end - start);
            expect_refused(pipe_of(text), "p.yaml:2:1: material." + std::string{parameter.name} + ": missing (",
                           "add " + std::string{parameter.name} + ": " + std::string{parameter.example});
        }
}

TEST(Material, ListsKeepTheirOrderAndUnits) {
    const Design design = read(pipe_of("law: ogden, mu: [0.63MPa, 1.2 kPa, -0.01 MPa], alpha: [1.3, 5, -2]"));
    EXPECT_EQ(design.material.constants.at("mu"), (std::vector<double>{0.63e6, 1.2e3, -0.01e6}));
    EXPECT_EQ(design.material.constants.at("alpha"), (std::vector<double>{1.3, 5, -2}));
    EXPECT_TRUE(contains(design.effective_yaml, "  mu: [0.63 MPa, 1.2 kPa, -0.01 MPa]\n  alpha: [1.3, 5, -2]\n"))
        << design.effective_yaml;
    const Design single = read(pipe_of("law: ogden, mu: 0.1 MPa, alpha: [2]"));
    EXPECT_EQ(single.material.constants.at("mu"), std::vector<double>{0.1e6});
    EXPECT_TRUE(contains(single.effective_yaml, "  mu: 0.1 MPa\n  alpha: 2\n")) << single.effective_yaml;
}

TEST(Material, ListsCanBeOverriddenAndChangedBySolve) {
    const std::vector<Override> changes = {{"material.mu", "[0.5 MPa, 2 kPa]"}};
    const std::string text = pipe_of("law: ogden, mu: [0.63 MPa, 1.2 kPa], alpha: [1.3, 5]");
    EXPECT_EQ(read(text, changes).material.constants.at("mu"), (std::vector<double>{0.5e6, 2e3}));
    const Design solve = read_built(read(text).effective_yaml, changes);
    EXPECT_EQ(solve.material.constants.at("mu"), (std::vector<double>{0.5e6, 2e3}));
    EXPECT_TRUE(contains(solve.effective_yaml, "  mu: [0.5 MPa, 2 kPa]\n")) << solve.effective_yaml;
    EXPECT_EQ(refusal(text, {{"material.mu", "[0.5 MPa, 2]"}}).find("--set material.mu: '2' has no unit"), 0u);
    // Another law as a whole.
    const Design other = read_built(read(text).effective_yaml, {{"material", "{law: yeoh, c1: 80 kPa}"}});
    EXPECT_EQ(other.material.law, "yeoh");
    EXPECT_EQ(other.material.constants.at("c3"), std::vector<double>{0.0});
}

TEST(Material, ErrorsInAListAreReportedAtTheirLocation) {
    expect_refused(pipe_of("law: ogden, mu: [1 kPa, 2], alpha: [1, 2]"), "p.yaml:2:36: material.mu: '2' has no unit");
    expect_refused(pipe_of("law: ogden, mu: [1 kPa, [2 kPa]], alpha: [1, 2]"),
                   "p.yaml:2:36: material.mu: a list of single");
    expect_refused(pipe_of("law: ogden, mu: [], alpha: [1, 2]"), "p.yaml:2:28: material.mu: the list is empty");
    expect_refused(pipe_of("law: ogden, mu: 1 kPa, alpha: [1, 2, 3, 4, 5]"),
                   "p.yaml:2:42: material.alpha: 5 values are too many");
    expect_refused(pipe_of("law: neo-hookean, mu: [1 kPa]"), "p.yaml:2:34: material.mu: a single value is needed");
}

TEST(Material, InconsistentConstantsAreRejectedAtTheirKey) {
    expect_refused(pipe_of("law: ogden, mu: [1 kPa, 2 kPa], alpha: [1]"),
                   "p.yaml:2:51: material.alpha: mu has 2 values and alpha 1; write one exponent");
    expect_refused(pipe_of("law: ogden, mu: 1 kPa, alpha: -2"), "p.yaml:2:28: material.mu: the initial shear modulus");
    expect_refused(pipe_of("law: neo-hookean-compressible, mu: 3 kPa, kappa: 2 kPa"),
                   "p.yaml:2:61: material.kappa: 2000 Pa is too small");
    expect_refused(pipe_of("law: mooney-rivlin, c10: 1 kPa, c01: -1 kPa"), "p.yaml:2:37: material.c10: ");
    expect_refused(pipe_of("law: arruda-boyce, mu: 1 kPa, locking_stretch: 0.9"),
                   "p.yaml:2:59: material.locking_stretch: 0.9");
}

TEST(Material, YoungAndPoissonReplaceShearAndBulkModulus) {
    // mu = E/(2 (1 + nu)), kappa = E/(3 (1 - 2 nu)).
    const Design design = read(pipe_of("law: saint-venant-kirchhoff, young: 0.9 MPa, poisson: 0.45"));
    EXPECT_NEAR(design.material.constants.at("mu").front(), 0.9e6 / 2.9, 1e-9);
    EXPECT_NEAR(*design.material.bulk_modulus_Pa, 0.9e6 / 0.3, 1e-6);
    EXPECT_EQ(read(design.effective_yaml).effective_yaml, design.effective_yaml);
    EXPECT_TRUE(contains(design.effective_yaml, "  young: 0.9 MPa\n  poisson: 0.45\n")) << design.effective_yaml;
    EXPECT_FALSE(read(pipe_of("law: linear-elastic, young: 0.9 MPa, poisson: 0.5")).material.bulk_modulus_Pa);
    expect_refused(pipe_of("law: saint-venant-kirchhoff, young: 0.9 MPa, poisson: 0.5"),
                   "p.yaml:2:66: material.poisson: the law saint-venant-kirchhoff has no incompressible form");
    expect_refused(pipe_of("law: linear-elastic, young: 0.9 MPa, kappa: 1 MPa"),
                   "p.yaml:2:49: material.kappa: cannot be combined with 'young'",
                   "give young and poisson, or mu and kappa");
    expect_refused(pipe_of("law: linear-elastic, young: 0.9 MPa"), "p.yaml:2:1: material.poisson: missing",
                   "add poisson: 0.49");
    expect_refused(pipe_of("law: neo-hookean, young: 0.9 MPa, poisson: 0.4"),
                   "p.yaml:2:30: material.young: unknown key");
    expect_refused(pipe_of("law: linear-elastic, young: 0.9 MPa, poisson: 0.6"),
                   "p.yaml:2:58: material.poisson: 0.6 is out of range");
}

TEST(Material, VolumetricIsRejectedForLawsThatDoNotUseIt) {
    EXPECT_EQ(read(pipe_of("law: neo-hookean-compressible, mu: 1 kPa, kappa: 9 kPa")).material.volumetric,
              model::Volumetric::log);
    EXPECT_EQ(read(pipe_of("law: yeoh, c1: 1 kPa, volumetric: mixed")).material.volumetric, model::Volumetric::mixed);
    expect_refused(pipe_of("law: saint-venant-kirchhoff, mu: 1 kPa, kappa: 9 kPa, volumetric: log"),
                   "p.yaml:2:66: material.volumetric: the law saint-venant-kirchhoff defines its own", "leave it out");
}

TEST(Material, LawsWithoutAnIncompressibleFormRequireTheBulkModulus) {
    expect_refused(pipe_of("law: saint-venant-kirchhoff, mu: 1 kPa"),
                   "p.yaml:2:1: material.kappa: missing (bulk modulus; the law has no", "add kappa: 16.44 MPa");
    expect_refused(pipe_of("law: kraken, mu: 1 kPa, kappa: incompressible"), "p.yaml:2:43: material.kappa:");
}

TEST(Material, LawsAreRejectedInUnsupportedFormulations) {
    const std::string kraken = pipe_of("law: kraken, mu: 0.1644 MPa, kappa: 16.44 MPa");
    expect_refused(kraken, "p.yaml:2:17: material.law: the law kraken is a stress without an energy",
                   "use formulation displacement");
    expect_refused(kraken + "mesh: {formulation: mixed}\n",
                   "p.yaml:4:21: mesh.formulation: the law kraken is a stress");
    expect_refused(kraken + "mesh: {formulation: f-bar, order: 1}\n",
                   "p.yaml:4:21: mesh.formulation: the law kraken has no F-bar");
    expect_refused(pipe_of("law: linear-elastic, young: 1 MPa, poisson: 0.5") + "mesh: {formulation: displacement}\n",
                   "p.yaml:4:21: mesh.formulation: ", "mixed");
}

TEST(Material, FibreFrameFollowsFromTheGeometryKeys) {
    const std::string fibres = pipe_of("law: holzapfel-gasser-ogden, mu: 0.1 MPa, k1: 0.5 MPa, k2: 1, angle: 30 deg");
    FamilyKeys family = sample::pipe();
    family.revolution_key = "skew_radius";
    family.geometry.push_back(
        {.path = "geometry.skew_radius", .kind = Kind::length, .fallback = "0 mm", .meaning = "radius", .min = 0});
    const std::vector<FamilyKeys> families{family};
    const auto frame = [&](const std::string& geometry) {
        return read_design(fibres + geometry, "p.yaml", families, {}).material.fiber_frame;
    };
    EXPECT_EQ(frame(""), model::FiberFrame::cartesian);
    EXPECT_EQ(frame("geometry: {skew_radius: 0 mm}\n"), model::FiberFrame::cartesian);
    EXPECT_EQ(frame("geometry: {skew_radius: 5 mm}\n"), model::FiberFrame::cylindrical);
}

TEST(Material, FibreFrameIsCylindricalForABodyOfRevolution) {
    const std::string fibres = "law: holzapfel-gasser-ogden, mu: 0.1 MPa, k1: 0.5 MPa, k2: 1, angle: 30 deg";
    EXPECT_EQ(read(pipe_of(fibres)).material.fiber_frame, model::FiberFrame::cylindrical);
    EXPECT_EQ(read(pipe_of(fibres + ", frame: cartesian")).material.fiber_frame, model::FiberFrame::cartesian);
    EXPECT_NEAR(read(pipe_of(fibres)).material.constants.at("angle").front(), 0.52359877559829887, 1e-15);
    EXPECT_EQ(read(pipe_of(fibres)).material.constants.at("families").front(), 2.0);
}

TEST(Material, UnstableLawsAndInitialStressTriggerWarnings) {
    const auto has = [](const Design& design, std::string_view words) {
        for (const std::string& warning : design.warnings)
            if (contains(warning, words)) return true;
        return false;
    };
    // c10/|c01| = 9: uniaxial limit 3.
    EXPECT_TRUE(has(read(pipe_of("law: mooney-rivlin, c10: 90 kPa, c01: -10 kPa")),
                    "material: mooney-rivlin is unstable beyond a stretch of uniaxial 3,"));
    EXPECT_TRUE(has(read(pipe_of("law: mooney-rivlin, c10: 90 kPa, c01: -10 kPa")),
                    "(Drucker stability, checked from 0.3 to 5)"));
    EXPECT_FALSE(has(read(pipe_of("law: mooney-rivlin, c10: 90 kPa, c01: 10 kPa")), "unstable"));
    EXPECT_TRUE(
        has(read(pipe_of("law: kraken, mu: 0.1644 MPa, kappa: 16.44 MPa") + "mesh: {formulation: displacement}\n"),
            "the undeformed state of kraken has the initial stress mu = 164.4 kPa"));
}

}  // namespace
