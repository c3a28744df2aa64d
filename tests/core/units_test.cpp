#include "core/units.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <locale>
#include <numbers>

namespace {

using namespace soft::core;

double si(std::string_view text, Dimension dimension) {
    const auto parsed = parse_quantity(text, dimension);
    const auto* refusal = std::get_if<Refusal>(&parsed);
    EXPECT_EQ(refusal, nullptr) << text << ": " << (refusal ? refusal->problem : "");
    return refusal ? 0.0 : std::get<double>(parsed);
}

Refusal refused(std::string_view text, Dimension dimension) {
    const auto parsed = parse_quantity(text, dimension);
    EXPECT_TRUE(std::holds_alternative<Refusal>(parsed)) << text;
    return std::holds_alternative<Refusal>(parsed) ? std::get<Refusal>(parsed) : Refusal{};
}

TEST(Units, PrefixesGiveTheDoubleNearestToTheDecimalValue) {
    EXPECT_EQ(si("3 mm", Dimension::length), 3e-3);
    EXPECT_EQ(si("9.25 mm", Dimension::length), 9.25e-3);
    EXPECT_EQ(si("0.1644 MPa", Dimension::pressure), 164400.0);  // 0.1644 * 1e6 is another double
    EXPECT_EQ(si("16.44 MPa", Dimension::pressure), 16440000.0);
    EXPECT_EQ(si("0.07 um", Dimension::length), 0.07e-6);
    EXPECT_EQ(si("1.05 bar", Dimension::pressure), 105000.0);
    EXPECT_EQ(si("1080 kg/m^3", Dimension::density), 1080.0);
    EXPECT_EQ(si("1.08 g/cm^3", Dimension::density), 1080.0);
    EXPECT_EQ(si("50 mg", Dimension::mass), 5e-5);
    EXPECT_EQ(si("9.81 m/s^2", Dimension::acceleration), 9.81);
    EXPECT_EQ(si("50 ms", Dimension::time), 0.05);
    EXPECT_EQ(si("2 kHz", Dimension::rate), 2000.0);
    EXPECT_EQ(si("0.5 1/s", Dimension::rate), 0.5);
    EXPECT_EQ(si("1e8 Pa.s/m^3", Dimension::flow_resistance), 1e8);
    EXPECT_EQ(si("0.1 kPa.s/mL", Dimension::flow_resistance), 1e8);  // 100 Pa s over 1e-6 m^3
    EXPECT_EQ(si("2.5 mJ", Dimension::energy), 2.5e-3);
    EXPECT_EQ(si("10 mL", Dimension::volume), 1e-5);
    EXPECT_EQ(si("10 mm^2", Dimension::area), 1e-5);
    EXPECT_EQ(si("150 %", Dimension::ratio), 1.5);
    EXPECT_EQ(si("20 mN", Dimension::force), 0.02);
    EXPECT_EQ(si("3 N.mm", Dimension::moment), 3e-3);
    EXPECT_EQ(si("0.2 1/cm", Dimension::curvature), 20.0);
}

TEST(Units, FactorsThatAreNotPowersOfTenFollowTheirDefinitions) {
    EXPECT_DOUBLE_EQ(si("30 deg", Dimension::angle), std::numbers::pi / 6);
    EXPECT_DOUBLE_EQ(si("2 in", Dimension::length), 0.0508);
    EXPECT_DOUBLE_EQ(si("1.5 min", Dimension::time), 90.0);
    EXPECT_DOUBLE_EQ(si("1 psi", Dimension::pressure), 4.4482216152605 / (0.0254 * 0.0254));
    EXPECT_DOUBLE_EQ(si("1 ksi", Dimension::pressure),
                     1e3 * si("1 lbf", Dimension::force) / si("1 in^2", Dimension::area));
    EXPECT_DOUBLE_EQ(si("1 in^3", Dimension::volume), 0.0254 * 0.0254 * 0.0254);
    EXPECT_DOUBLE_EQ(si("2 atm", Dimension::pressure), 202650.0);
    EXPECT_DOUBLE_EQ(si("1 ft", Dimension::length), 12 * 0.0254);
    EXPECT_DOUBLE_EQ(si("1 mmHg", Dimension::pressure), 133.322387415);  // NIST SP 811
    EXPECT_DOUBLE_EQ(si("10 inHg", Dimension::pressure), si("254 mmHg", Dimension::pressure));
    EXPECT_DOUBLE_EQ(si("760 Torr", Dimension::pressure), si("1 atm", Dimension::pressure));
    EXPECT_DOUBLE_EQ(si("1 kgf/cm^2", Dimension::pressure),
                     si("1 kgf", Dimension::force) / si("1 cm^2", Dimension::area));
    EXPECT_DOUBLE_EQ(si("2 kgf/mm^2", Dimension::pressure), 2e6 * 9.80665);
    EXPECT_DOUBLE_EQ(si("1000 gf", Dimension::force), 9.80665);
    EXPECT_DOUBLE_EQ(si("981 cm/s^2", Dimension::acceleration), 9.81);
    EXPECT_DOUBLE_EQ(si("9810 mm/s^2", Dimension::acceleration), 9.81);
}

TEST(Units, AcceptsBlanksSignsAndExponents) {
    EXPECT_EQ(si("40kPa", Dimension::pressure), 40000.0);
    EXPECT_EQ(si("  +4.0e1   kPa ", Dimension::pressure), 40000.0);
    EXPECT_EQ(si("-.5E-2 m", Dimension::length), -0.005);
    EXPECT_EQ(si("5. mm", Dimension::length), 0.005);
}

TEST(Units, AsciiAndUnicodeSpellingsAreEquivalent) {
    EXPECT_EQ(si("7 µm", Dimension::length), si("7 um", Dimension::length));
    EXPECT_EQ(si("7 mm³", Dimension::volume), si("7 mm^3", Dimension::volume));
    EXPECT_EQ(si("7 kN/m²", Dimension::pressure), 7000.0);
    EXPECT_EQ(si("0.05 N/mm2", Dimension::pressure), 50000.0);
    EXPECT_EQ(si("1080 kg/m3", Dimension::density), 1080.0);
    EXPECT_EQ(si("1e8 Pa.s/m³", Dimension::flow_resistance), 1e8);
    EXPECT_FALSE(std::holds_alternative<double>(parse_quantity("1 N/mm4", Dimension::pressure)));
    EXPECT_FALSE(std::holds_alternative<double>(parse_quantity("1 mm22", Dimension::area)));
    EXPECT_EQ(si("90°", Dimension::angle), si("90 deg", Dimension::angle));
}

TEST(Units, BareNumberIsRejectedWithAnExampleUnit) {
    const Refusal refusal = refused("3", Dimension::length);
    EXPECT_NE(refusal.problem.find("has no unit"), std::string::npos);
    EXPECT_NE(refusal.remedy.find("3 mm"), std::string::npos);
}

TEST(Units, WrongDimensionIsReportedWithBothNames) {
    const Refusal refusal = refused("3 kPa", Dimension::length);
    EXPECT_NE(refusal.problem.find("a pressure where a length"), std::string::npos) << refusal.problem;
    EXPECT_NE(refused("3 rad", Dimension::area).problem.find("an angle where an area"), std::string::npos);
    EXPECT_NE(refused("3 Hz", Dimension::time).problem.find("a rate where a time"), std::string::npos);
    EXPECT_NE(refused("3 mm", Dimension::ratio).problem.find("a length where a ratio"), std::string::npos);
}

TEST(Units, MisspeltUnitGetsASuggestion) {
    EXPECT_NE(refused("3 KPA", Dimension::pressure).remedy.find("3 kPa"), std::string::npos);
    EXPECT_NE(refused("3 milimetre", Dimension::length).remedy.find("mm"), std::string::npos);
    EXPECT_NE(refused("3,5 mm", Dimension::length).remedy.find("3.5 mm"), std::string::npos);
}

TEST(Units, TextThatIsNotAFiniteDecimalNumberIsRejected) {
    for (const char* text : {"nan", "inf mm", "-inf", "0x10 mm", "", "   ", "mm", "- 3 mm", "1e400 m",
                             "1e99999999999 m", "+-3 mm", "3 mm mm", "..5 mm", "e5 mm", "3 mm\n4 mm"})
        refused(text, Dimension::length);
    refused("1e300 GPa", Dimension::pressure);
}

/// A locale facet that makes all streams of the process use decimal commas.
struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
};

TEST(Units, AreIndependentOfTheLocale) {
    const std::string c_locale = std::setlocale(LC_ALL, nullptr);
    const std::locale before = std::locale::global(std::locale{std::locale::classic(), new DecimalComma});
    static_cast<void>(std::setlocale(LC_ALL, "de_DE.UTF-8"));  // has an effect only if the locale is installed
    EXPECT_EQ(si("2.5 mm", Dimension::length), 2.5e-3);
    EXPECT_EQ(quantity_text(2.5e-3, Dimension::length), "2.5 mm");
    std::locale::global(before);
    std::setlocale(LC_ALL, c_locale.c_str());
}

TEST(Units, CountsAreWholeNumbers) {
    EXPECT_EQ(std::get<long>(parse_count(" 10 ")), 10);
    for (const char* text : {"10.0", "1e3", "", "ten", "10 mm", "99999999999999999999"})
        EXPECT_TRUE(std::holds_alternative<Refusal>(parse_count(text))) << text;
}

TEST(Units, TidyingKeepsTheQuantityAndIsIdempotent) {
    EXPECT_EQ(tidy_quantity("40kPa"), "40 kPa");
    EXPECT_EQ(tidy_quantity(" +4.0e1   kPa"), "4.0e1 kPa");
    EXPECT_EQ(tidy_quantity(tidy_quantity("40kPa")), "40 kPa");
    EXPECT_EQ(tidy_quantity("1.5"), "1.5");
    EXPECT_EQ(quantity_parts("40kPa").number, "40");
    EXPECT_EQ(quantity_parts("40kPa").unit, "kPa");
    EXPECT_EQ(quantity_parts("1.5").number, "1.5");
    EXPECT_EQ(quantity_parts("1.5").unit, "");
}

TEST(Units, MessagesUseSuitableUnits) {
    EXPECT_EQ(quantity_text(0.003, Dimension::length), "3 mm");
    EXPECT_EQ(quantity_text(1.5, Dimension::length), "1.5 m");
    EXPECT_EQ(quantity_text(5e-5, Dimension::length), "50 um");
    EXPECT_EQ(quantity_text(164400, Dimension::pressure), "164.4 kPa");
    EXPECT_EQ(quantity_text(-500, Dimension::pressure), "-500 Pa");
    EXPECT_EQ(quantity_text(0, Dimension::length), "0 m");
    EXPECT_EQ(quantity_text(0, Dimension::pressure), "0 Pa");
    EXPECT_EQ(quantity_text(1e-12, Dimension::length), "1e-06 um");
    EXPECT_EQ(quantity_text(70285.1e-9, Dimension::volume), "70.2851 mL");
    EXPECT_EQ(quantity_text(0.05, Dimension::time), "50 ms");
    EXPECT_EQ(quantity_text(2e8, Dimension::flow_resistance), "200 Pa.s/mL");
    EXPECT_EQ(quantity_text(1e3, Dimension::rate), "1000 1/s");
}

TEST(Units, ThrowingFormReportsExitCodeAndLocation) {
    try {
        static_cast<void>(quantity_or_throw("3", Dimension::pressure, soft::ExitCode::usage, "--at pressure"));
        FAIL();
    } catch (const soft::Error& error) {
        EXPECT_EQ(error.code(), soft::ExitCode::usage);
        EXPECT_EQ(std::string{error.what()}.find("--at pressure: '3' has no unit"), 0u) << error.what();
    }
}

}  // namespace
