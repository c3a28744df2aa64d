#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "core/table.hpp"

namespace soft::core {
namespace {

TEST(ParseHeading, FindsTheUnitInEveryCommonNotation) {
    for (const std::string_view name :
         {"Pressure (kPa)", "Pressure [kPa]", "Pressure_kPa", "Pressure / kPa", "Pressure/kPa", "Pressure in kPa",
          "Pressure, kPa", "Pressure kPa", " Pressure( kPa ) "}) {
        const Heading heading = parse_heading(name);
        EXPECT_EQ(heading.quantity, "Pressure") << name;
        EXPECT_EQ(heading.unit, "kPa") << name;
    }
}

TEST(ParseHeading, LeavesANameWithoutAUnitUnchanged) {
    EXPECT_EQ(parse_heading("tip displacement").quantity, "tip displacement");
    EXPECT_EQ(parse_heading("tip displacement").unit, "");
    EXPECT_EQ(parse_heading("kPa").unit, "");  // a unit alone is not a quantity
    EXPECT_EQ(parse_heading("stretch_p99").quantity, "stretch_p99");
    EXPECT_EQ(parse_heading("Voltage (V)").quantity, "Voltage");
    EXPECT_EQ(parse_heading("Voltage (V)").unit, "");  // not a unit that core/units defines
    EXPECT_EQ(parse_heading("pressure (gauge) kPa").quantity, "pressure (gauge)");
    EXPECT_EQ(parse_heading("").quantity, "");
}

TEST(DimensionOf, ReturnsTheDimensionOfKnownUnits) {
    EXPECT_EQ(dimension_of("psi"), core::Dimension::pressure);
    EXPECT_EQ(dimension_of("cm"), core::Dimension::length);
    EXPECT_EQ(dimension_of("deg"), core::Dimension::angle);
    EXPECT_EQ(dimension_of("N"), core::Dimension::force);
    EXPECT_EQ(dimension_of("Nmm"), core::Dimension::moment);
    EXPECT_EQ(dimension_of("1/m"), core::Dimension::curvature);
    EXPECT_EQ(dimension_of(""), std::nullopt);
    EXPECT_EQ(dimension_of("furlong"), std::nullopt);
}

TEST(Numbers, AreRejectedIfACommaMayBeAThousandsSeparator) {
    const auto refusal = [](std::string_view text) {
        try {
            static_cast<void>(numbers(read_table(text, "m.csv"), 0));
        } catch (const Error& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    const std::string words =
        "m.csv:2: column 1 'p_Pa': '1,400' has a decimal comma or a thousands separator; write it without the comma";
    EXPECT_EQ(refusal("p_Pa,e_mm\n\"1,400\",20\n"), words);
    EXPECT_EQ(refusal("p_Pa;e_mm\n1,400;20.5\n"), words) << "the other column has decimal points";
    EXPECT_EQ(numbers(read_table("p_Pa;e_mm\n1,400;20,5\n", "m.csv"), 0), (std::vector<double>{1.4}));
    EXPECT_EQ(numbers(read_table("p_Pa,e_mm\n\"0,400\",20\n", "m.csv"), 0), (std::vector<double>{0.4}));
}

TEST(ValuesSI, ConvertsByTheDefinitionsOfTheUnits) {
    const Table table = read_table("psi,bar,in\n1,1,1\n10,\"0,5\",2\n", "m.csv");
    const auto psi = values_SI(table, 0, "psi", core::Dimension::pressure);
    EXPECT_DOUBLE_EQ(psi[1], 68947.57293168361);  // 1 psi = 4.4482216152605 N / (25.4 mm)^2
    EXPECT_EQ(values_SI(table, 1, "bar", core::Dimension::pressure)[1], 50000.0);
    EXPECT_DOUBLE_EQ(values_SI(table, 2, "in", core::Dimension::length)[1], 0.0508);
}

TEST(Values, NumberMustFillTheCellAndBeFinite) {
    EXPECT_EQ(numbers(read_table("a;b\n +1.5e-3 ;1\n", "m.csv"), 0), (std::vector<double>{1.5e-3}));
    for (const std::string cell : {"1.5x", "nan", "inf", "1.234,5", "1,2,3", "--1", "0x10", "1e999"})
        EXPECT_THROW((void)numbers(read_table("a;b\n" + cell + ";1\n2;3\n", "m.csv"), 0), Error) << cell;
}

TEST(Values, RejectACellWithItsLineAndColumn) {
    const Table table = read_table("Pressure (kPa),note\n1,start\n,end\n3x,\n", "m.csv");
    const auto refusal = [](auto read) {
        try {
            read();
        } catch (const Error& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    EXPECT_EQ(refusal([&] { (void)values_SI(table, 0, "kPa", core::Dimension::pressure); }),
              "m.csv:3: column 1 'Pressure (kPa)': the cell is empty; put # before lines that are not data");
    EXPECT_EQ(refusal([&] { (void)numbers(table, 1); }),
              "m.csv:2: column 2 'note': 'start' is not a number; put # before lines that are not data");
}

}  // namespace
}  // namespace soft::core
