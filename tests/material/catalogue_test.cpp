#include "material/catalogue.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <set>

#include "core/error.hpp"
#include "samples.hpp"

namespace soft::material {
namespace {

using namespace sample;

/// The message "location: problem; remedy" of a rejected rubber.
std::string refusal(const Description& description) {
    try {
        static_cast<void>(make_rubber(description));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        return error.what();
    }
    ADD_FAILURE() << "accepted " << description.law;
    return {};
}

TEST(Catalogue, EveryLawIsFoundByNameAndHasADescription) {
    std::set<std::string_view> names;
    for (const LawInfo& law : laws()) {
        EXPECT_TRUE(names.insert(law.name).second) << law.name;
        EXPECT_EQ(find_law(law.name), &law);
        EXPECT_FALSE(law.energy.empty() || law.validity.empty() || law.source.empty()) << law.name;
        const AnyRubber rubber = make_rubber(description_of(law.name));
        EXPECT_EQ(info_of(rubber).name, law.name);
        EXPECT_GT(initial_shear_modulus_Pa(rubber), 0.0);
        for (const Parameter& parameter : law.parameters) {
            EXPECT_FALSE(parameter.meaning.empty() || parameter.example.empty()) << law.name << parameter.name;
            EXPECT_FALSE(parameter.meaning.ends_with('.')) << law.name << parameter.name;
            // make_rubber ignores the unit of a default value, so the unit must be the SI unit.
            if (parameter.fallback.empty()) continue;
            double value = -1;
            const auto* end = parameter.fallback.data() + parameter.fallback.size();
            const auto [rest, error] = std::from_chars(parameter.fallback.data(), end, value);
            EXPECT_EQ(error, std::errc{}) << law.name << parameter.name;
            const std::string_view unit{rest, static_cast<std::size_t>(end - rest)};
            EXPECT_EQ(unit, parameter.quantity == Quantity::pressure ? " Pa" : "") << law.name << parameter.name;
        }
    }
    EXPECT_EQ(find_law("rubber"), nullptr);
}

TEST(Catalogue, RejectsInvalidDescriptionsWithTheNameOfTheConstant) {
    const auto starts = [](const Description& description, std::string_view start) {
        const std::string line = refusal(description);
        EXPECT_TRUE(line.starts_with(start)) << line;
    };
    starts({.law = "neo-hokean"}, "law: no law is called 'neo-hokean'; did you mean 'neo-hookean'?");
    starts({.law = "neo-hookean"}, "mu: the law neo-hookean needs this constant; for example 0.1644 MPa");
    starts({.law = "neo-hookean", .constants = {{"mu", {0.0}}}}, "mu: 0 (SI) is outside its range");
    starts({.law = "neo-hookean", .constants = {{"mu", {std::nan("")}}}}, "mu: nan (SI) is outside its range");
    starts({.law = "neo-hookean", .constants = {{"mu", {1.0, 2.0}}}}, "mu: 2 values are too many");
    starts({.law = "neo-hookean", .constants = {{"mu", {1.0}}, {"c10", {1.0}}}},
           "c10: the law neo-hookean has no such");
    starts({.law = "kraken", .constants = {{"mu", {1.0}}}}, "kappa: the law kraken has no incompressible form");
    starts({.law = "saint-venant-kirchhoff", .constants = {{"mu", {1.0}}}}, "kappa: ");
    starts({.law = "neo-hookean-compressible", .constants = {{"mu", {3e5}}}, .bulk_modulus_Pa = 2e5},
           "kappa: 2e+05 Pa is too small");
    starts({.law = "ogden", .constants = {{"mu", {1.0, 2.0}}, {"alpha", {2.0}}}}, "alpha: mu has 2 values and alpha 1");
    starts({.law = "ogden", .constants = {{"mu", {1.0}}, {"alpha", {0.0}}}}, "alpha: an exponent of 0");
    starts({.law = "ogden", .constants = {{"mu", {1.0}}, {"alpha", {-2.0}}}}, "mu: the initial shear modulus");
    starts({.law = "ogden", .constants = {{"mu", {1, 1, 1, 1, 1}}, {"alpha", {1, 1, 1, 1, 1}}}},
           "mu: 5 values are too many");
    starts({.law = "mooney-rivlin", .constants = {{"c10", {1.0}}, {"c01", {-1.0}}}}, "c10: the initial shear modulus");
    starts({.law = "arruda-boyce", .constants = {{"mu", {1.0}}, {"locking_stretch", {1.0}}}},
           "locking_stretch: 1 (SI)");
}

TEST(Catalogue, ReturnsTheBulkModulusOfTheEnergy) {
    EXPECT_FALSE(bulk_modulus_Pa(make_rubber({.law = "yeoh", .constants = constants_of("yeoh")})));
    EXPECT_DOUBLE_EQ(*bulk_modulus_Pa(make_rubber(description_of("yeoh"))), kappa_Pa);
    // The compressible neo-Hookean energy has K = kappa - 2 mu/3.
    EXPECT_DOUBLE_EQ(*bulk_modulus_Pa(make_rubber(description_of("neo-hookean-compressible"))),
                     kappa_Pa - 2 * mu_Pa / 3);
}

TEST(Catalogue, ReportsUnsupportedFormulations) {
    for (const LawInfo& law : laws()) {
        const AnyRubber rubber = make_rubber(description_of(law.name));
        EXPECT_EQ(explain_incompatibility(rubber, Form::displacement), "") << law.name;
        EXPECT_EQ(explain_incompatibility(rubber, Form::mixed).empty(), law.mixed) << law.name;
        EXPECT_EQ(explain_incompatibility(rubber, Form::f_bar).empty(), law.f_bar) << law.name;
        if (law.bulk == Bulk::finite) continue;
        const AnyRubber incompressible = make_rubber(description_of(law.name, std::nullopt));
        EXPECT_EQ(explain_incompatibility(incompressible, Form::mixed), "") << law.name;
        EXPECT_NE(explain_incompatibility(incompressible, Form::displacement).find("use formulation mixed"),
                  std::string::npos)
            << law.name;
        EXPECT_NE(explain_incompatibility(incompressible, Form::f_bar), "") << law.name;
    }
    EXPECT_NE(explain_incompatibility(make_rubber(description_of("kraken")), Form::mixed).find("kraken"),
              std::string::npos);
}

}  // namespace
}  // namespace soft::material
